import { readFileSync } from 'node:fs';
import path from 'node:path';
import { setUp } from './index.mjs';
import { nameModels } from './named_models.mjs';
import { main, ROOT, runShown } from '../machine/step.mjs';

// npm run thumbnail [-- ARGUMENTS OF telar thumbnail]: all set-up, then the bundled garment, or what is named.

const OURS = ['js/assets/tshirt.glb', '-o', 'out/tshirt.png'];

await main(async () => {
  await setUp({ groups: ['build', 'run'], presets: ['release'] });
  const args = process.argv.slice(2);
  const { bin } = JSON.parse(readFileSync(path.join(ROOT, 'package.json'), 'utf8'));
  return runShown(process.execPath, [bin.telar, 'thumbnail', ...(nameModels(args) ? [] : OURS), ...args]);
});
