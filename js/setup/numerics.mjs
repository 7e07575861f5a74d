import path from 'node:path';
import { setUp } from './index.mjs';
import { main, ROOT, runShown } from './step.mjs';

// npm run numerics [-- --only NAME]: all set-up, then every figure of test/numerics at its full count, into js/docs/numerics.md.

const PRESET = 'dev';

await main(async () => {
  await setUp({ groups: ['build', 'run', 'test'], presets: [PRESET] });
  return runShown(process.execPath, ['test/numerics/report.mjs', ...process.argv.slice(2)], { env: { TELAR_BUILD_DIR: path.join(ROOT, 'out', PRESET) } });
});
