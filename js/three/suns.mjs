import { luminance } from '../shot/luminance.mjs';
import { HALF_MAX, HALF_MAX_BITS } from './half.mjs';

/** Most suns of one map: what lies close together is one. */
const MOST = 8;

/** Texels no farther from its middle are one sun, radians. */
const FIRST_RADIUS = (4 * Math.PI) / 180;

/** As renderer/ibl/suns.cpp has both. */
const SMALL_OVER_MEAN = 100;
const MOST_SMALL = 3;

/** What was made of a texture, as long as it lives: whole, and without its small lights. */
const made = [new WeakMap(), new WeakMap()];

/** The lights of a scene that are suns of its environment. */
const ofScenes = new WeakMap();

/** @param {import('three').Scene} scene @param {import('three').DirectionalLight[]} lights of all suns that it has now */
export const keepSuns = (scene, lights) => ofScenes.set(scene, lights);

/**
 * Colours times intensities of a scene's suns, as three.js uploads them: shaders know the suns among the directional lights by these.
 * @param {import('three').Scene} scene
 * @returns {import('three').Color[]}
 */
export const sunColors = (scene) => (ofScenes.get(scene) ?? []).map(({ color, intensity }) => color.clone().multiplyScalar(intensity));

/**
 * An environment as half floats, which is what three.js prefilters, and what of it these do not hold as lights of their own:
 * renderer/ibl/suns.h does the same on the server.
 * @param {typeof import('three')} THREE
 * @param {import('three').Texture} source - Equirectangular. Of FloatType it has all its light; of HalfFloatType, which the loaders
 *   give by default, what halves do not hold is lost already.
 * @param {boolean} [smallToo] - Small lights of any radiance are suns too, and the texture is without them.
 * @returns {{texture: import('three').Texture, suns: {direction: number[], irradiance: number[]}[]}} `direction` to the sun as the
 *   map has it, unit; `irradiance` on a surface that faces it, linear Rec.709.
 */
export function environmentOf(THREE, source, smallToo = false) {
  const results = made[Number(smallToo)];
  const known = results.get(source);
  if (known?.version === source.version) return known;
  const result = { version: source.version, texture: source, suns: [] };
  const isFloat = source.type === THREE.FloatType && source.image?.data instanceof Float32Array;
  const isHalf = source.type === THREE.HalfFloatType && source.image?.data instanceof Uint16Array;
  if (source.format === THREE.RGBAFormat && (isFloat || (isHalf && smallToo))) {
    const map = mapOf(THREE, source);
    const small = smallToo ? takeSmall(map) : [];
    result.suns = [...small, ...sunsOf(map)];
    if (isFloat || small.length > 0) result.texture = asHalves(THREE, source, map.data);
  }
  if (result.texture !== source) {
    source.addEventListener('dispose', function release() {
      source.removeEventListener('dispose', release);
      result.texture.dispose();
      results.delete(source);
    });
  }
  results.set(source, result);
  return result;
}

/** Whether a map of halves has a texel that is as bright as a half can be: it may have been brighter. */
export const isCut = ({ image }) => image?.data instanceof Uint16Array && image.data.includes(HALF_MAX_BITS);

function asHalves(THREE, { image: { width, height }, colorSpace, minFilter, magFilter, wrapS, wrapT, flipY, mapping }, data) {
  const halves = Uint16Array.from(data, (value) => THREE.DataUtils.toHalfFloat(Math.min(value, HALF_MAX)));
  const texture = new THREE.DataTexture(halves, width, height, THREE.RGBAFormat, THREE.HalfFloatType, mapping, wrapS, wrapT, magFilter, minFilter);
  return Object.assign(texture, { colorSpace, flipY, generateMipmaps: false, needsUpdate: true });
}

/** A map as floats of its own, RGBA. */
function mapOf(THREE, { image: { width, height, data }, flipY }) {
  const isHalf = data instanceof Uint16Array;
  return { width, height, flipY, data: isHalf ? Float32Array.from(data, (bits) => THREE.DataUtils.fromHalfFloat(bits)) : data.slice() };
}

/** Directions and solid angles of the texels, from the top row down, and where each begins in the data. */
function* texelsOf({ width, height, flipY }) {
  for (let y = 0; y < height; y++) {
    const row = (flipY ? y : height - 1 - y) * width * 4;
    const [top, bottom, theta] = [y, y + 1, y + 0.5].map((edge) => (Math.PI * edge) / height);
    yield { row, theta, solidAngle: ((2 * Math.PI) / width) * (Math.cos(top) - Math.cos(bottom)) };
  }
}

function directionOf({ width }, x, theta) {
  const phi = ((x + 0.5) / width - 0.5) * 2 * Math.PI;
  return [Math.sin(theta) * Math.cos(phi), Math.cos(theta), Math.sin(theta) * Math.sin(phi)];
}

/** What the texels have above the largest half. Infinity says no more than that a half did not hold it. */
function excessOf(map) {
  const list = [];
  for (const { row, theta, solidAngle } of texelsOf(map)) {
    for (let x = 0; x < map.width; x++) {
      const excess = [0, 1, 2].map((c) => map.data[row + x * 4 + c]).map((value) => (value > HALF_MAX && value < Infinity ? value - HALF_MAX : 0));
      if (excess.every((value) => value === 0)) continue;
      list.push({ direction: directionOf(map, x, theta), irradiance: excess.map((value) => value * solidAngle) });
    }
  }
  return list;
}

const dot = (a, b) => a.reduce((sum, value, i) => sum + value * b[i], 0);

/** Each texel goes to the first sun within the radius of it; null where there are too many suns then. */
function gathered(texels, radius, most) {
  const suns = [];
  for (const { direction, irradiance } of texels) {
    let sun = suns.find((candidate) => dot(candidate.direction, direction) >= Math.cos(radius));
    if (!sun && suns.length === most) return null;
    if (!sun) suns.push((sun = { direction, irradiance: [0, 0, 0], sum: [0, 0, 0] }));
    const weight = luminance(irradiance);
    sun.irradiance = sun.irradiance.map((value, i) => value + irradiance[i]);
    sun.sum = sun.sum.map((value, i) => value + weight * direction[i]);
    const length = Math.hypot(...sun.sum);
    if (length > 0) sun.direction = sun.sum.map((value) => value / length);
  }
  return suns.map(({ direction, irradiance }) => ({ direction, irradiance }));
}

function sunsOf(map) {
  const texels = excessOf(map);
  let suns = null;
  for (let radius = FIRST_RADIUS; !suns; radius *= 2) suns = gathered(texels, Math.min(radius, Math.PI), MOST);
  return suns;
}

/** Small lights as suns, and the map without them; none where there are many. */
function takeSmall(map) {
  const { width, data } = map;
  let sum = 0;
  for (const { row, solidAngle } of texelsOf(map)) {
    let ofRow = 0;
    for (let i = row; i < row + width * 4; i += 4) ofRow += luminance(data, i);
    sum += ofRow * solidAngle;
  }
  const threshold = (SMALL_OVER_MEAN * sum) / (4 * Math.PI);
  const texels = [];
  for (const { row, theta, solidAngle } of texelsOf(map)) {
    for (let i = row; i < row + width * 4; i += 4) {
      const whole = luminance(data, i);
      if (!(whole > threshold && whole < Infinity)) continue;
      const share = 1 - Math.min(threshold / whole, HALF_MAX / Math.max(data[i], data[i + 1], data[i + 2]));
      const irradiance = [0, 1, 2].map((c) => data[i + c] * share * solidAngle);
      texels.push({ i, share, direction: directionOf(map, (i - row) / 4, theta), irradiance });
    }
  }
  const suns = gathered(texels, FIRST_RADIUS, MOST_SMALL) ?? [];
  if (suns.length > 0) for (const { i, share } of texels) for (let c = 0; c < 3; c++) data[i + c] *= 1 - share;
  return suns;
}
