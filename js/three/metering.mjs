import { lensExposure } from '../shot/lens_exposure.mjs';
import { meteredExposure, meteredSize } from '../shot/metering.mjs';
import { HALF_MAX } from './half.mjs';
import { hideGround } from './shadows.mjs';

/** Whether a picture of 32-bit floats can be drawn, with what is blended in it. */
const drawsFloats = ({ extensions }) => extensions.has('EXT_color_buffer_float') && extensions.has('EXT_float_blend');

/**
 * The light of a picture by the exposure of a lens, each capped to what a half float holds: the server's picture is, too.
 *
 * @param {ArrayLike<number>} light - RGBA, multiplied by alpha.
 * @param {number} exposure
 */
const exposed = (light, exposure) => Float32Array.from(light, (value, i) => (i % 4 === 3 ? value : Math.min(value * exposure, HALF_MAX)));

/**
 * Exposes the renderer by what the scene shows, as the server does: reads a small picture without ground and background.
 *
 * @param {object} shot - Resolved, with `metering`.
 * @param {object} target - As of applyShot, all of the shot but this applied.
 * @param {import('three').Camera} target.camera
 */
export function applyMetering(shot, { THREE, renderer, scene, camera }) {
  const { width, height } = meteredSize(shot);
  const exposure = lensExposure(shot.lens);
  // three.js draws radiance into a target, without an exposure: what a lens dims may be more than a half float holds.
  const areFloats = exposure !== 1 && drawsFloats(renderer);
  const target = new THREE.WebGLRenderTarget(width, height, { type: areFloats ? THREE.FloatType : THREE.HalfFloatType });
  const texels = new (areFloats ? Float32Array : Uint16Array)(width * height * 4);
  const { background } = scene;
  const last = renderer.getRenderTarget();
  const showGround = hideGround(scene);
  try {
    scene.background = null;
    renderer.setRenderTarget(target);
    renderer.clear();
    renderer.render(scene, camera);
    renderer.readRenderTargetPixels(target, 0, 0, width, height, texels);
  } finally {
    scene.background = background;
    showGround();
    renderer.setRenderTarget(last);
    target.dispose();
  }
  const light = areFloats ? texels : Float32Array.from(texels, (half) => Math.min(THREE.DataUtils.fromHalfFloat(half), HALF_MAX));
  renderer.toneMappingExposure *= meteredExposure(shot, exposed(light, exposure));
}
