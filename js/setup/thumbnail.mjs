import { readFileSync } from 'node:fs';
import path from 'node:path';
import { setUp } from './index.mjs';
import { main, ROOT, runShown } from '../machine/step.mjs';

// npm run thumbnail [-- ARGUMENTS OF telar thumbnail]: all set-up, then the bundled garment, or the model that is named.

const OURS = ['js/assets/tshirt.glb', '-o', 'out/tshirt.png'];

await main(async () => {
  await setUp({ groups: ['build', 'run'], presets: ['release'] });
  const args = process.argv.slice(2);
  const namesModel = args.some((arg) => /\.(glb|gltf)$/i.test(arg));
  const { bin } = JSON.parse(readFileSync(path.join(ROOT, 'package.json'), 'utf8'));
  return runShown(process.execPath, [bin.telar, 'thumbnail', ...(namesModel ? [] : OURS), ...args]);
});
