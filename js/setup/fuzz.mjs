import { main, runShown } from '../machine/step.mjs';
import { setUp } from './index.mjs';

// npm run fuzz [-- TARGET... --seconds N]: all set-up, then test/fuzz/run.mjs, which builds its targets.

await main(async () => {
  await setUp({ groups: ['build', 'run', 'test', 'fuzz'], presets: [] });
  return runShown(process.execPath, ['test/fuzz/run.mjs', ...process.argv.slice(2)]);
});
