import { Outline } from '../shot/outline.mjs';
import { camerasOf } from './cameras.mjs';

/**
 * What resolveShot needs to know of a model that GLTFLoader gave, measured as the server measures it: so that both frame
 * it alike. The model's world matrices must be up to date and it must stand as it was loaded.
 *
 * @param {{scene: import('three').Object3D, parser?: object}} model - What GLTFLoader gave.
 * @param {{THREE: typeof import('three')}} three
 * @returns {{bounds: {min: number[], max: number[]} | null, outline: number[][], cameras: object[],
 *   variants: string[]}} metres, world space
 */
export function factsOf(model, { THREE }) {
  const outline = new Outline();
  const box = new THREE.Box3();
  const point = new THREE.Vector3();
  model.scene.updateMatrixWorld(true);
  model.scene.traverse((object) => {
    const position = object.geometry?.attributes.position;
    if (!position) return;
    for (const i of drawnVertices(object.geometry, position.count)) {
      point.fromBufferAttribute(position, i).applyMatrix4(object.matrixWorld);
      box.expandByPoint(point);
      outline.add(point.x, point.y, point.z);
    }
  });
  const variants = model.parser?.json.extensions?.KHR_materials_variants?.variants ?? [];
  return {
    bounds: box.isEmpty() ? null : { min: box.min.toArray(), max: box.max.toArray() },
    outline: outline.points(),
    cameras: model.parser ? camerasOf(model, box, THREE) : [],
    variants: variants.map((variant) => variant.name),
  };
}

/** Each drawn vertex once. */
const drawnVertices = (geometry, count) => (geometry.index ? new Set(geometry.index.array) : Array(count).keys());
