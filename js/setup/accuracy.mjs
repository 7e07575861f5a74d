import path from 'node:path';
import { setUp } from './index.mjs';
import { main, ROOT, runShown } from './step.mjs';

// npm run accuracy [-- SIZE PATHS]: all set-up, then test/accuracy/run.mjs.

const PRESET = 'dev';

await main(async () => {
  await setUp({ groups: ['build', 'run', 'test'], presets: [PRESET] });
  return runShown(process.execPath, ['test/accuracy/run.mjs', ...process.argv.slice(2)], { env: { TELAR_BUILD_DIR: path.join(ROOT, 'out', PRESET) } });
});
