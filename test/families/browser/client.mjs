// What a client of an older three.js does besides applyShot to show a shot: what that release asks every client to do, no more.
import * as THREE from 'three';

/**
 * @typedef {object} Client
 * @property {(renderer: object) => void} prepareRenderer - Once for each renderer.
 * @property {(texture: object, shot: object) => object} prepareEnvironment - Gives the texture to hand to applyShot.
 * @property {(scene: object) => void} prepareScene - Before applyShot.
 * @property {(drawn: {renderer: object, scene: object, shot: object, settings?: Settings}) => void} finishScene - After it.
 *
 * What a client sets beside the shot.
 * @typedef {object} Settings
 * @property {string} [shadowType] - Name of a constant of three.js, in place of PCFShadowMap, its default.
 * @property {boolean} [legacyLights] - Keeps the light units that 0.150 to 0.154 have by default.
 */

const revision = Number(THREE.REVISION);

/** A canvas in sRGB: `outputColorSpace`, which applyShot sets, has been there and sRGB by default since 0.152. */
const HAS_COLOR_SPACES = revision >= 152;

/** Lux and candela are the default since 0.155; clients before turned legacy lights off to have them. */
const HAS_PHYSICAL_LIGHTS = revision >= 155;

/** The environment can be turned since 0.162, and dimmed for a whole scene since 0.163. */
const HAS_ENVIRONMENT_ROTATION = revision >= 162;
const HAS_ENVIRONMENT_INTENSITY = revision >= 163;

/** Environments turned texel by texel, by texture and degrees. */
const turned = new Map();

/** @type {Client} */
export const client = {
  prepareRenderer(renderer) {
    if (!HAS_COLOR_SPACES) renderer.outputEncoding = THREE.sRGBEncoding;
  },

  prepareEnvironment(texture, { environment: { rotation } }) {
    if (HAS_ENVIRONMENT_ROTATION || rotation === 0) return texture;
    const key = `${texture.uuid} ${rotation}`;
    if (!turned.has(key)) turned.set(key, turnedBy(texture, rotation));
    return turned.get(key);
  },

  prepareScene(scene) {
    // applyShot sets these angles to 0 where a release does not know them: the texture is turned already.
    if (HAS_ENVIRONMENT_ROTATION) return;
    scene.environmentRotation = new THREE.Euler();
    scene.backgroundRotation = new THREE.Euler();
  },

  finishScene({ renderer, scene, shot, settings = {} }) {
    if (renderer.toneMapping === undefined) throw new Error(`absent: three.js 0.${revision} has no tone mapping "${shot.toneMapping}"`);
    // A background was the sRGB colour that the canvas shows, where a shot has linear ones.
    if (!HAS_COLOR_SPACES && scene.background?.isColor) scene.background.convertLinearToSRGB();
    if (!HAS_PHYSICAL_LIGHTS) renderer.useLegacyLights = settings.legacyLights === true;
    if (!HAS_ENVIRONMENT_INTENSITY) dimEnvironment(scene, shot.environment.intensity);
    if (settings.shadowType) renderer.shadowMap.type = THREE[settings.shadowType];
  },
};

/** Each material has its own factor of the environment. */
function dimEnvironment(scene, intensity) {
  scene.traverse(({ material }) => {
    for (const each of [material ?? []].flat()) if ('envMapIntensity' in each) each.envMapIntensity = intensity;
  });
}

/** The same map with its columns moved, for angles that are whole columns. */
function turnedBy(texture, degrees) {
  const { width, height, data } = texture.image;
  const columns = (degrees / 360) * width;
  if (!Number.isInteger(columns)) throw new Error(`absent: ${degrees} degrees are not whole columns of ${width}`);
  const moved = new data.constructor(data.length);
  const channels = data.length / width / height;
  for (let row = 0; row < height; row++) {
    for (let column = 0; column < width; column++) {
      const from = (row * width + ((((column + columns) % width) + width) % width)) * channels;
      for (let c = 0; c < channels; c++) moved[(row * width + column) * channels + c] = data[from + c];
    }
  }
  const result = new THREE.DataTexture(moved, width, height, texture.format, texture.type);
  for (const key of [HAS_COLOR_SPACES ? 'colorSpace' : 'encoding', 'flipY', 'minFilter', 'magFilter', 'generateMipmaps']) result[key] = texture[key];
  result.needsUpdate = true;
  return result;
}
