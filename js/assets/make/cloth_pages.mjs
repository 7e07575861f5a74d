import { mkdir } from 'node:fs/promises';
import path from 'node:path';
import sharp from 'sharp';
import { createRenderer } from '../../index.mjs';
import { ballOf, SCENES, shotOf, SKIES } from './cloth_scenes.mjs';
import { CONSTRUCTIONS } from './cloths/constructions.mjs';
import { PRESETS } from './cloths/index.mjs';

const SIDE = 128;
const COLUMNS = 2 * Object.keys(SCENES).length;

/** Pictures in rows. @param {Buffer[]} tiles - PNG. */
function sheet(tiles, side, columns) {
  const place = (i) => ({ left: (i % columns) * side, top: Math.floor(i / columns) * side });
  return sharp({ create: { width: columns * side, height: Math.ceil(tiles.length / columns) * side, channels: 3, background: 'white' } }).composite(
    tiles.map((input, i) => ({ input, ...place(i) })),
  );
}

/**
 * js/docs/cloths/PRESET.webp: a row a sky, from left to right the shirt, 5 cm of it, the drape, 5 cm, the ball, 4 cm.
 * @param {string} folder
 * @param {string[]} [presets] - All of them, unless named.
 */
export async function clothPages(folder, presets = []) {
  await mkdir(folder, { recursive: true });
  const renderer = await createRenderer({ timeoutMs: null });
  const models = await Promise.all(Object.values(SCENES).map(async ({ model, ...cameras }) => ({ model: await renderer.load(await model()), cameras })));
  const skies = Object.values(SKIES).map((make) => make());
  for (const preset of presets.length > 0 ? presets : Object.keys(PRESETS)) {
    const tiles = [];
    for (const environment of skies) {
      for (const { model, cameras } of models) {
        const shots = [cameras.far, cameras.near].map((camera) => ({ ...shotOf(preset, SIDE), camera, environment }));
        tiles.push(...(await renderer.renderAll(model, shots)).map(({ data }) => data));
      }
    }
    await sheet(tiles, SIDE, COLUMNS)
      .webp({ quality: 76, effort: 6 })
      .toFile(path.join(folder, `${preset}.webp`));
  }
  await renderer.close();
}

const SWATCH = 80;
const SWATCH_COLUMNS = 7;

/** Of balls: threads are seen on the small one, stripes, cords and flowers on the large one. */
const RADII_M = { fine: 0.022, coarse: 0.06 };

/** Fields of what is wider than 2 mm, or in millimetres. */
const isCoarse = (preset) => {
  const [per] = CONSTRUCTIONS[preset].perCm ?? PRESETS[preset].threadsPerCm;
  return per < 5 || per === 10;
};

/** From the upper left, so that relief shows. */
const LAMP = [{ type: 'directional', position: [-1.4, 1.6, 1.2], intensity: 1.5 }];

/** js/view/page/cloths.webp: what the picker of `telar view` shows, in the order of the table, seven in a row. */
export async function clothSwatches(out) {
  const renderer = await createRenderer({ timeoutMs: null });
  const tiles = [];
  for (const preset of Object.keys(PRESETS)) {
    const radius = RADII_M[isCoarse(preset) ? 'coarse' : 'fine'];
    const camera = { ...SCENES.ball.far, height: 1.17 * radius };
    const { data } = await renderer.render(await ballOf(radius), { ...shotOf(preset, SWATCH), quality: 'medium', camera, lights: LAMP });
    tiles.push(data);
  }
  await renderer.close();
  await sheet(tiles, SWATCH, SWATCH_COLUMNS).webp({ quality: 80, effort: 6 }).toFile(out);
}
