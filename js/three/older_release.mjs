import { revisionOf, warnOnce } from './release.mjs';

// What a client of an older three.js has to do to show a shot, where newer ones have a property for it.

/** A canvas in sRGB: `outputColorSpace`, sRGB by default, has been there since 0.152, and backgrounds are linear colours since. */
const COLOR_SPACES_SINCE = 152;

/** Lux and candela are the default since 0.155; legacy lights, which stood before, could be turned off since 0.150. */
const PHYSICAL_LIGHTS_SINCE = 155;

/** The environment can be turned since 0.162, and dimmed for a whole scene since 0.163. */
const ENVIRONMENT_ROTATION_SINCE = 162;
const ENVIRONMENT_INTENSITY_SINCE = 163;

/** @param {typeof import('three')} THREE @param {import('three').WebGLRenderer} renderer */
export function applyOlderOutput(THREE, renderer) {
  const revision = revisionOf(THREE);
  if (revision < COLOR_SPACES_SINCE) renderer.outputEncoding = THREE.sRGBEncoding;
  if (revision < PHYSICAL_LIGHTS_SINCE) renderer.useLegacyLights = false;
}

/**
 * A linear colour as scene.background takes it.
 * @param {typeof import('three')} THREE
 * @param {import('three').Color} color
 */
export const backgroundColor = (THREE, color) => (revisionOf(THREE) < COLOR_SPACES_SINCE ? color.convertLinearToSRGB() : color);

/**
 * Turns the texels of an environment where a scene cannot turn it.
 * @param {typeof import('three')} THREE
 * @param {import('three').Texture} environment - Equirectangular.
 * @param {number} degrees
 * @returns {import('three').Texture} As given where nothing is to be turned.
 */
export function environmentTurned(THREE, environment, degrees) {
  if (revisionOf(THREE) >= ENVIRONMENT_ROTATION_SINCE || degrees === 0) return environment;
  const columns = (degrees / 360) * environment.image.width;
  const whole = Math.round(columns);
  if (Math.abs(columns - whole) > 1e-6) warnOfColumns(THREE, degrees, (360 / environment.image.width) * (whole - columns));
  return columnsMoved(THREE, environment, whole);
}

const warnOfColumns = (THREE, degrees, off) =>
  warnOnce(
    `three.js 0.${revisionOf(THREE)} cannot turn an environment: ${degrees} degrees are no whole columns of the map, and it is turned by ${off.toFixed(3)} more`,
  );

/** Maps with their columns moved, by map and columns; each goes with its map. */
const moved = new WeakMap();

function columnsMoved(THREE, source, columns) {
  if (!moved.has(source)) {
    moved.set(source, new Map());
    source.addEventListener('dispose', () => {
      for (const { texture } of moved.get(source)?.values() ?? []) texture.dispose();
      moved.delete(source);
    });
  }
  const known = moved.get(source);
  if (known.get(columns)?.version !== source.version) known.set(columns, { version: source.version, texture: withColumnsMoved(THREE, source, columns) });
  return known.get(columns).texture;
}

function withColumnsMoved(THREE, { image: { width, height, data }, format, type, ...source }, columns) {
  if (!data)
    throw new Error(
      'shot.environment.rotation: this release of three.js turns only environments whose texels are at hand, as loaders of .hdr and .exr give them',
    );
  const channels = data.length / width / height;
  const result = new data.constructor(data.length);
  const first = ((columns % width) + width) % width;
  for (let row = 0; row < height; row++) {
    const [begin, split, end] = [0, first, width].map((column) => (row * width + column) * channels);
    result.set(data.subarray(split, end), begin);
    result.set(data.subarray(begin, split), begin + end - split);
  }
  const texture = new THREE.DataTexture(result, width, height, format, type);
  for (const key of ['colorSpace', 'encoding', 'flipY', 'minFilter', 'magFilter', 'generateMipmaps']) if (key in source) texture[key] = source[key];
  return Object.assign(texture, { needsUpdate: true });
}

/**
 * Gives each material the factor of the environment where a scene has none. With one of its own per scene, materials keep theirs.
 * @param {typeof import('three')} THREE
 * @param {import('three').Scene} scene
 * @param {number} intensity
 */
export function dimEnvironment(THREE, scene, intensity) {
  if (revisionOf(THREE) >= ENVIRONMENT_INTENSITY_SINCE) return;
  scene.traverse(({ material }) => {
    for (const each of [material ?? []].flat()) if ('envMapIntensity' in each) each.envMapIntensity = intensity;
  });
}
