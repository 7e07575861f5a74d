import { fileURLToPath } from 'node:url';
import sharp from 'sharp';
import { createRenderer } from '../../index.mjs';
import { PRESETS } from './cloths/index.mjs';

const SIDE = 128;
const COLUMNS = 5;
const TSHIRT = fileURLToPath(new URL('../tshirt.glb', import.meta.url));
/** 5 cm of the chest. */
const CLOSE = { projection: 'orthographic', height: 0.05, position: [0.3, 0.6, 1], target: [0.03, 0.45, 0.1], near: 0.05, far: 3 };
const SUN = [{ type: 'directional', position: [-2, 2, 1.5], intensity: 1.5 }];

/** Each preset on the T-shirt, whole and from near, in the order of the table: js/docs/cloths.md says what one must see. */
export async function clothsPicture(out) {
  const renderer = await createRenderer();
  const tiles = [];
  for (const preset of Object.keys(PRESETS)) {
    const shot = { size: { width: SIDE, height: SIDE }, shading: 'fabric', background: '#f4f1ec', materials: { '*': { preset, color: '#8c7a66' } } };
    for (const view of [{ camera: { azimuth: 25, elevation: 8 } }, { camera: CLOSE, lights: SUN }])
      tiles.push((await renderer.render(TSHIRT, { ...shot, ...view, output: { format: 'png' } })).data);
  }
  await renderer.close();
  const width = 2 * COLUMNS * SIDE;
  const height = Math.ceil(tiles.length / (2 * COLUMNS)) * SIDE;
  await sharp({ create: { width, height, channels: 3, background: '#f4f1ec' } })
    .composite(tiles.map((input, i) => ({ input, left: (i % (2 * COLUMNS)) * SIDE, top: Math.floor(i / (2 * COLUMNS)) * SIDE })))
    .jpeg({ quality: 84 })
    .toFile(out);
}
