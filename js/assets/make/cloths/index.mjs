import { readFileSync } from 'node:fs';
import sharp from 'sharp';
import { CONSTRUCTIONS } from './constructions.mjs';
import { mapPixels } from './maps.mjs';
import { squareGlb } from './square_glb.mjs';

/**
 * js/assets/cloths: each preset of cloth as a glTF file of its own, a square of 10 cm with the preset's material and the maps of its
 * construction in true size. `materials` of a shot puts them on garments.
 */

const SIDE_CM = 10;
const SIZE = 256;

export const PRESETS = JSON.parse(readFileSync(new URL('../../fabric_presets.json', import.meta.url), 'utf8'));

/** @param {(u: number, v: number) => number[]} pixel - Channels in 0..1. @returns {Promise<Buffer>} PNG */
function image(size, pixel) {
  const channels = pixel(0, 0).length;
  const texels = Buffer.alloc(size * size * channels);
  for (let y = 0; y < size; y++) {
    for (let x = 0; x < size; x++) {
      pixel((x + 0.5) / size, (y + 0.5) / size).forEach((value, c) => {
        texels[(y * size + x) * channels + c] = Math.round(Math.min(Math.max(value, 0), 1) * 255);
      });
    }
  }
  // A palette (which "effort" asks for) gives holes any colour, and mip levels mix it with that of the threads.
  const packed = channels === 4 ? { compressionLevel: 9 } : { compressionLevel: 9, effort: 10 };
  return sharp(texels, { raw: { width: size, height: size, channels } })
    .png(packed)
    .toBuffer();
}

/** @returns {Promise<Record<string, Buffer>>} PNG by the name of the texture */
async function mapsOf({ field, threads, size = SIZE, weave, shaded, glossy, holes, sheer }) {
  const make = (kind) => image(size, mapPixels[kind](field, size, threads));
  return {
    normalTexture: await make('normal'),
    ...(weave && { weaveTexture: await make('weave') }),
    ...((holes || sheer) && { baseColorTexture: await make('cover') }),
    ...(shaded && { baseColorTexture: await make('color') }),
    ...(glossy && { metallicRoughnessTexture: await make('roughness') }),
  };
}

/** The preset's glTF material with its textures: indices of `names`. */
function materialOf(name, { weave, holes, sheer, threads }, names) {
  const texture = (key) => ({ index: names.indexOf(key) });
  const inCore = ['baseColorTexture', 'metallicRoughnessTexture'].filter((key) => names.includes(key));
  const { extensions = {}, pbrMetallicRoughness, ...rest } = structuredClone(PRESETS[name].material);
  const fabric = { ...extensions.TELAR_materials_fabric };
  if (weave) fabric.weave = { ...fabric.weave, threadsPerUv: [threads, threads], weaveTexture: texture('weaveTexture') };
  const all = { ...extensions, ...(Object.keys(fabric).length > 0 && { TELAR_materials_fabric: fabric }) };
  return {
    name,
    doubleSided: true,
    ...rest,
    ...(holes && { alphaMode: 'MASK' }),
    ...(sheer && { alphaMode: 'BLEND' }),
    pbrMetallicRoughness: { ...pbrMetallicRoughness, ...Object.fromEntries(inCore.map((key) => [key, texture(key)])) },
    normalTexture: texture('normalTexture'),
    ...(Object.keys(all).length > 0 && { extensions: all }),
  };
}

/** @returns {Promise<Uint8Array>} GLB */
export async function makeCloth(name) {
  const construction = CONSTRUCTIONS[name];
  const maps = await mapsOf(construction);
  const names = Object.keys(maps);
  const perCm = construction.perCm ?? PRESETS[name].threadsPerCm;
  const repeats = perCm.map((count) => (count * SIDE_CM) / construction.threads);
  return squareGlb({ name, side: SIDE_CM / 100, repeats, material: materialOf(name, construction, names), images: Object.values(maps) });
}
