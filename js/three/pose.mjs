/** Mixer of each model that stands in a pose. */
const mixers = new WeakMap();

/**
 * Puts a model into a pose, or back as the file stands: an AnimationMixer with one action that plays once and clamps, so that
 * a time before the start or after the end shows the start or the end.
 *
 * @param {{scene: import('three').Object3D, animations?: import('three').AnimationClip[]}} model - What GLTFLoader gave.
 * @param {{animation: number, time: number} | null} pose - Of a resolved shot: index, seconds; null = as the file stands.
 * @param {{THREE: typeof import('three')}} three
 * @throws {Error} When the model has no such animation.
 */
export function applyPose(model, pose, { THREE }) {
  mixers.get(model.scene)?.stopAllAction();
  mixers.delete(model.scene);
  if (pose) {
    const clip = model.animations?.[pose.animation];
    if (!clip) throw new Error(`shot.pose.animation: the model has ${model.animations?.length ?? 0} animations, not one of index ${pose.animation}`);
    const mixer = new THREE.AnimationMixer(model.scene);
    const action = mixer.clipAction(clip).setLoop(THREE.LoopOnce);
    action.clampWhenFinished = true;
    action.play();
    mixer.setTime(pose.time);
    mixers.set(model.scene, mixer);
  }
  model.scene.updateMatrixWorld(true);
  // three.js measures a skinned mesh once; in another pose it would be sorted and culled by where it was.
  model.scene.traverse((object) => {
    if (object.isSkinnedMesh) Object.assign(object, { boundingBox: null, boundingSphere: null });
  });
}
