/** Largest number that a half float holds, and its bits. */
const HALF_MAX = 65504;
const HALF_MAX_BITS = 0x7bff;

/** Most suns of one map: what lies close together is one. */
const MOST = 8;

/** Texels no farther from its middle are one sun, radians. */
const FIRST_RADIUS = (4 * Math.PI) / 180;

/** What was made of a texture, as long as it lives. */
const made = new WeakMap();

/**
 * An environment as half floats, which is what three.js prefilters, and what of it these do not hold as lights of their own:
 * renderer/ibl/suns.h does the same on the server.
 * @param {typeof import('three')} THREE
 * @param {import('three').Texture} source - Equirectangular. Of FloatType it has suns; of HalfFloatType, which the loaders give
 *   by default, they are lost already.
 * @returns {{texture: import('three').Texture, suns: {direction: number[], irradiance: number[]}[]}} `direction` to the sun as the
 *   map has it, unit; `irradiance` on a surface that faces it, linear Rec.709.
 */
export function environmentOf(THREE, source) {
  const known = made.get(source);
  if (known?.version === source.version) return known;
  const isFloat = source.type === THREE.FloatType && source.image?.data instanceof Float32Array && source.format === THREE.RGBAFormat;
  const result = { version: source.version, texture: source, suns: [] };
  if (isFloat) {
    result.suns = sunsOf(source);
    result.texture = asHalves(THREE, source);
    source.addEventListener('dispose', function release() {
      source.removeEventListener('dispose', release);
      result.texture.dispose();
      made.delete(source);
    });
  }
  made.set(source, result);
  return result;
}

/** Whether a map of halves has a texel that is as bright as a half can be: it may have been brighter. */
export const isCut = ({ image }) => image?.data instanceof Uint16Array && image.data.includes(HALF_MAX_BITS);

function asHalves(THREE, { image: { width, height, data }, colorSpace, minFilter, magFilter, wrapS, wrapT, flipY, mapping }) {
  const halves = Uint16Array.from(data, (value) => THREE.DataUtils.toHalfFloat(Math.min(value, HALF_MAX)));
  const texture = new THREE.DataTexture(halves, width, height, THREE.RGBAFormat, THREE.HalfFloatType, mapping, wrapS, wrapT, magFilter, minFilter);
  return Object.assign(texture, { colorSpace, flipY, generateMipmaps: false, needsUpdate: true });
}

/** Relative luminance of linear Rec.709. */
const luminance = ([r, g, b]) => 0.2126 * r + 0.7152 * g + 0.0722 * b;

/** What the texels have above the largest half, from the top row down. Infinity says no more than that a half did not hold it. */
function excessOf({ image: { width, height, data }, flipY }) {
  const list = [];
  for (let y = 0; y < height; y++) {
    const row = (flipY ? y : height - 1 - y) * width * 4;
    const [top, bottom, theta] = [y, y + 1, y + 0.5].map((edge) => (Math.PI * edge) / height);
    const solidAngle = ((2 * Math.PI) / width) * (Math.cos(top) - Math.cos(bottom));
    for (let x = 0; x < width; x++) {
      const excess = [0, 1, 2].map((c) => data[row + x * 4 + c]).map((value) => (value > HALF_MAX && value < Infinity ? value - HALF_MAX : 0));
      if (excess.every((value) => value === 0)) continue;
      const phi = ((x + 0.5) / width - 0.5) * 2 * Math.PI;
      list.push({
        direction: [Math.sin(theta) * Math.cos(phi), Math.cos(theta), Math.sin(theta) * Math.sin(phi)],
        irradiance: excess.map((value) => value * solidAngle),
      });
    }
  }
  return list;
}

const dot = (a, b) => a.reduce((sum, value, i) => sum + value * b[i], 0);

/** Each texel goes to the first sun within the radius of it; null where there are too many suns then. */
function gathered(texels, radius) {
  const suns = [];
  for (const { direction, irradiance } of texels) {
    let sun = suns.find((candidate) => dot(candidate.direction, direction) >= Math.cos(radius));
    if (!sun && suns.length === MOST) return null;
    if (!sun) suns.push((sun = { direction, irradiance: [0, 0, 0], sum: [0, 0, 0] }));
    const weight = luminance(irradiance);
    sun.irradiance = sun.irradiance.map((value, i) => value + irradiance[i]);
    sun.sum = sun.sum.map((value, i) => value + weight * direction[i]);
    const length = Math.hypot(...sun.sum);
    if (length > 0) sun.direction = sun.sum.map((value) => value / length);
  }
  return suns.map(({ direction, irradiance }) => ({ direction, irradiance }));
}

function sunsOf(texture) {
  const texels = excessOf(texture);
  let suns = null;
  for (let radius = FIRST_RADIUS; !suns; radius *= 2) suns = gathered(texels, Math.min(radius, Math.PI));
  return suns;
}
