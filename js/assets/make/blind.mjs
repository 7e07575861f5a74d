import { randomInt } from 'node:crypto';
import { mkdir, rm, writeFile } from 'node:fs/promises';
import path from 'node:path';
import sharp from 'sharp';
import { createRenderer } from '../../index.mjs';
import { SCENES, shotOf } from './cloth_scenes.mjs';
import { PRESETS } from './cloths/index.mjs';

const SIDE = 256;
/** The chest from near, metres: what a zoom in a shop shows. */
const CHEST_M = 0.08;
const SUN = [{ type: 'directional', position: [-2, 2, 1.5], intensity: 1.5 }];

/** Fisher-Yates. */
function shuffled(list) {
  const out = [...list];
  for (let i = out.length - 1; i > 0; i--) {
    const j = randomInt(i + 1);
    [out[i], out[j]] = [out[j], out[i]];
  }
  return out;
}

/**
 * A test of recognition: each cloth in one colour, shuffled anew at each run, whole and beside it 8 cm of the chest, as 01.png, 02.png and so on;
 * the key lies beside the folder, so that who looks at the pictures does not see it.
 * @param {string} folder - Emptied. @param {string} keyFile - JSON: {"01.png": preset, ...}
 */
export async function blindSheet(folder, keyFile) {
  await rm(folder, { recursive: true, force: true });
  await mkdir(folder, { recursive: true });
  const renderer = await createRenderer();
  const shirt = await renderer.load(await SCENES.shirt.model());
  const key = {};
  for (const [i, preset] of shuffled(Object.keys(PRESETS)).entries()) {
    const name = `${String(i + 1).padStart(2, '0')}.png`;
    key[name] = preset;
    const views = [{ camera: SCENES.shirt.far }, { camera: { ...SCENES.shirt.near, height: CHEST_M }, lights: SUN }];
    const [whole, chest] = (
      await renderer.renderAll(
        shirt,
        views.map((view) => ({ ...shotOf(preset, SIDE), ...view })),
      )
    ).map(({ data }) => data);
    // Pixels alone: the shot that telar writes into a PNG names the cloth.
    await sharp({ create: { width: 2 * SIDE, height: SIDE, channels: 3, background: 'white' } })
      .composite([
        { input: whole, left: 0, top: 0 },
        { input: chest, left: SIDE, top: 0 },
      ])
      .png()
      .toFile(path.join(folder, name));
  }
  await renderer.close();
  await writeFile(keyFile, `${JSON.stringify(key, null, 2)}\n`);
}
