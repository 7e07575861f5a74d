import { Outline } from '../shot/outline.mjs';
import { recallAssociations } from './associations.mjs';
import { camerasOf } from './cameras.mjs';
import { visitDrawnPoints } from './drawn_points.mjs';
import { isLeftOut } from './ghost.mjs';
import { measurePart } from './part.mjs';
import { applyPose } from './pose.mjs';

/**
 * What resolveShot needs to know of a model that GLTFLoader gave, measured as the server measures it: so that both frame
 * it alike. The model's world matrices must be up to date. It is measured in the pose, and keeps it.
 *
 * @param {{scene: import('three').Object3D, parser?: object, animations?: object[]}} model - What GLTFLoader gave.
 * @param {object} options
 * @param {typeof import('three')} options.THREE
 * @param {{animation: number, time: number} | null} [options.pose] - Of the shot, as `resolvePose(shot, {animations:
 *   model.animations})` gives it; null = as the file stands.
 * @param {object} [options.frame] - The shot's `camera.frame`: where it names a node or a material, that is measured too.
 * @param {string} [options.variant] - The shot's `variant`, in which a material is looked for.
 * @param {object[]} [options.ghost] - The shot's `ghost`: what it leaves out does not count.
 * @returns {{bounds: {min: number[], max: number[]} | null, outline: number[][], cameras: object[], variants: string[],
 *   animations: {name: string, duration: number}[], part?: object}} metres, world space, seconds
 */
export function factsOf(model, { THREE, pose = null, frame, variant = '', ghost = [] }) {
  recallAssociations(model);
  const outline = new Outline();
  const [box, shown] = [new THREE.Box3(), new THREE.Box3()];
  applyPose(model, pose, { THREE });
  model.scene.traverse((object) => {
    if (!object.geometry?.attributes.position) return;
    const isShown = !isLeftOut(model, object, { ghost, variant });
    visitDrawnPoints(object, THREE, (point) => {
      box.expandByPoint(point);
      if (!isShown) return;
      shown.expandByPoint(point);
      outline.add(point.x, point.y, point.z);
    });
  });
  const variants = model.parser?.json.extensions?.KHR_materials_variants?.variants ?? [];
  return {
    bounds: shown.isEmpty() ? null : { min: shown.min.toArray(), max: shown.max.toArray() },
    outline: outline.points(),
    cameras: model.parser ? camerasOf(model, box, THREE) : [],
    variants: variants.map((variant) => variant.name),
    animations: (model.animations ?? []).map(({ name, duration }) => ({ name, duration })),
    ...(typeof frame === 'object' && frame !== null && { part: measurePart(model, frame, { THREE, variant, ghost }) }),
  };
}
