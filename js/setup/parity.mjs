import path from 'node:path';
import { setUp } from './index.mjs';
import { main, ROOT, runShown } from './step.mjs';

// npm run parity [-- OPTION... FILTER...]: all set-up, then the gate of test/parity/run.mjs, which names its options.

const PRESET = 'dev';

await main(async () => {
  await setUp({ groups: ['build', 'run', 'test'], presets: [PRESET] });
  return runShown(process.execPath, ['test/parity/run.mjs', ...process.argv.slice(2)], { env: { TELAR_BUILD_DIR: path.join(ROOT, 'out', PRESET) } });
});
