import path from 'node:path';
import { setUp } from './index.mjs';
import { main, ROOT, runShown } from '../machine/step.mjs';

// npm run parity, accuracy, numerics, families [-- ARGUMENTS]: all set-up, then the tool of test/ that is named first, which says what
// arguments it takes, with the build of the tests.

const PRESET = 'dev';

await main(async () => {
  await setUp({ groups: ['build', 'run', 'test'], presets: [PRESET] });
  return runShown(process.execPath, process.argv.slice(2), { env: { TELAR_BUILD_DIR: path.join(ROOT, 'out', PRESET) } });
});
