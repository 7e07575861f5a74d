import { mkdir, writeFile } from 'node:fs/promises';
import { createRenderer } from '../../index.mjs';

// The README's pictures: the bundled garment in each of its colours. npm run pictures

const ASSETS = new URL('..', import.meta.url);
const COLOURS = ['natural', 'terracotta', 'indigo'];

const renderer = await createRenderer();
const model = await renderer.load(new URL('tshirt.glb', ASSETS));
const frames = await renderer.renderAll(model, COLOURS.map((variant) => ({
  size: { width: 480, height: 480 },
  camera: { azimuth: 22, elevation: 6 },
  background: '#f4f1ec',
  variant,
})));
await mkdir(new URL('readme/', ASSETS), { recursive: true });
for (const [i, { data }] of frames.entries()) {
  await writeFile(new URL(`readme/${COLOURS[i]}.png`, ASSETS), data);
  console.log(`js/assets/readme/${COLOURS[i]}.png  ${data.length} bytes`);
}
await renderer.close();
