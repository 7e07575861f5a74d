import { meteredExposure, meteredSize } from '../shot/metering.mjs';
import { hideGround } from './shadows.mjs';

/**
 * Exposes the renderer by what the scene shows, as the server does: reads a small picture without ground and background.
 *
 * @param {object} shot - Resolved, with `metering`.
 * @param {object} target - As of applyShot, all of the shot but this applied.
 * @param {import('three').Camera} target.camera
 */
export function applyMetering(shot, { THREE, renderer, scene, camera }) {
  const { width, height } = meteredSize(shot);
  const target = new THREE.WebGLRenderTarget(width, height, { type: THREE.HalfFloatType });
  const halves = new Uint16Array(width * height * 4);
  const { background } = scene;
  const last = renderer.getRenderTarget();
  const showGround = hideGround(scene);
  try {
    scene.background = null;
    renderer.setRenderTarget(target);
    renderer.clear();
    renderer.render(scene, camera);
    renderer.readRenderTargetPixels(target, 0, 0, width, height, halves);
  } finally {
    scene.background = background;
    showGround();
    renderer.setRenderTarget(last);
    target.dispose();
  }
  const pixels = Float32Array.from(halves, (half) => THREE.DataUtils.fromHalfFloat(half));
  renderer.toneMappingExposure *= meteredExposure(shot, pixels);
}
