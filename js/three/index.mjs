// Browser side of telar: sets up a three.js scene from the shot that the server draws.
export { applyShot, rendererParameters } from './apply_shot.mjs';
export { factsOf } from './facts.mjs';
export { applyPose } from './pose.mjs';
export { applyShading, loadFabricMaterial } from './shading.mjs';
