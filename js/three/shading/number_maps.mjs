import { CORE_TEXTURES, LAYERS, texturesOf } from '../../material/table.mjs';

const TEXTURES = [...CORE_TEXTURES, ...LAYERS.flatMap(texturesOf)];

/** Maps of three.js whose colours are numbers. Alpha is one everywhere. @type {string[]} */
const NUMBER_MAPS = ['metalnessMap', ...TEXTURES.filter(({ three, srgb, channels }) => three && !srgb && channels !== 'a').map(({ three }) => `${three}Map`)];

/** Of a texture that is decoded as a colour, one that is not. */
const made = new WeakMap();

/**
 * GLTFLoader has one texture for all uses of an image, and decodes sRGB wherever one of them is a colour.
 * @param {typeof import('three')} THREE
 * @param {import('three').Texture | null} texture
 * @returns {import('three').Texture | null} That, or one of the same texels as the file has them.
 */
export function asNumbers(THREE, texture) {
  if (texture?.colorSpace !== THREE.SRGBColorSpace) return texture;
  if (!made.has(texture)) {
    const numbers = Object.assign(texture.clone(), { colorSpace: THREE.NoColorSpace });
    texture.addEventListener('dispose', () => numbers.dispose());
    made.set(texture, numbers);
  }
  return made.get(texture);
}

/** Puts asNumbers() in place of a material's maps. @param {typeof import('three')} THREE @param {import('three').Material} material */
export function readNumbers(THREE, material) {
  for (const name of NUMBER_MAPS) if (material[name]) material[name] = asNumbers(THREE, material[name]);
}
