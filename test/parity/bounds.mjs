import { Matrix4, Quaternion, Vector3 } from 'three';

const GLB_MAGIC = 0x46546c67;

/** glTF JSON of a .glb's or .gltf's bytes. */
export function readDocument(bytes) {
  const isGlb = bytes.readUInt32LE(0) === GLB_MAGIC;
  const text = isGlb ? bytes.subarray(20, 20 + bytes.readUInt32LE(12)) : bytes;
  return JSON.parse(text.toString('utf8'));
}

/**
 * World-space box of a glTF document's default scene, from the min and max of its POSITION accessors.
 * @param {object} json - glTF document
 * @returns {{min: number[], max: number[]}} metres
 */
export function boundsOf(json) {
  const bounds = { min: [Infinity, Infinity, Infinity], max: [-Infinity, -Infinity, -Infinity] };
  for (const root of json.scenes[json.scene ?? 0].nodes) addNode(json, root, new Matrix4(), bounds);
  return bounds;
}

function addNode(json, index, parent, bounds) {
  const node = json.nodes[index];
  const world = parent.clone().multiply(localMatrix(node));
  for (const primitive of json.meshes?.[node.mesh]?.primitives ?? []) {
    addAccessor(json.accessors[primitive.attributes.POSITION], world, bounds);
  }
  for (const child of node.children ?? []) addNode(json, child, world, bounds);
}

function localMatrix({ matrix, translation = [0, 0, 0], rotation = [0, 0, 0, 1], scale = [1, 1, 1] }) {
  if (matrix) return new Matrix4().fromArray(matrix);
  return new Matrix4().compose(new Vector3(...translation), new Quaternion(...rotation), new Vector3(...scale));
}

/** Largest value of a normalised integer by glTF component type. */
const NORMALIZED_MAX = { 5120: 127, 5121: 255, 5122: 32767, 5123: 65535 };

function addAccessor({ min, max, normalized, componentType }, world, bounds) {
  const unit = normalized ? NORMALIZED_MAX[componentType] : 1;
  for (let corner = 0; corner < 8; corner++) {
    const point = min.map((low, axis) => (corner & (1 << axis) ? max[axis] : low) / unit);
    const at = new Vector3(...point).applyMatrix4(world).toArray();
    bounds.min = bounds.min.map((c, i) => Math.min(c, at[i]));
    bounds.max = bounds.max.map((c, i) => Math.max(c, at[i]));
  }
}
