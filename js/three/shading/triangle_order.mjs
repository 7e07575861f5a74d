// Nets and sheer cloth show what lies behind them, their own folds too: their triangles are drawn far to near, as
// renderer/pass/plan/triangle_order.h draws them. The order is an index for each mesh, which its geometry has while that is drawn.

/**
 * What was put in order of each mesh, for each camera that sees it and each group, by where that begins in its index.
 * @type {WeakMap<import('three').Mesh, WeakMap<import('three').Camera, Map<number, Order>>>}
 */
const orders = new WeakMap();

function orderOf(object, camera, start) {
  if (!orders.has(object)) orders.set(object, new WeakMap());
  const ofMesh = orders.get(object);
  if (!ofMesh.has(camera)) ofMesh.set(camera, new Map());
  const ofCamera = ofMesh.get(camera);
  if (!ofCamera.has(start)) ofCamera.set(start, { index: null, of: [] });
  return ofCamera.get(start);
}

/** Geometries that are drawn by an index in place of their own. @type {WeakMap<import('three').BufferGeometry, {own: object | null, shown: object}>} */
const lent = new WeakMap();

/**
 * @typedef {object} Order
 * @property {import('three').BufferAttribute} index - Of all that the mesh draws.
 * @property {unknown[]} of - What it was made of.
 */

/** Whether a material draws the triangles of an object far to near. */
export const isOrdered = (material, object) =>
  material.isFabricMaterial &&
  material.transparent &&
  !(material.transmission > 0) &&
  object.isMesh === true &&
  !object.isInstancedMesh &&
  !object.isBatchedMesh;

/** The index of a geometry, whatever it is drawn by. */
const ownIndex = (geometry) => (lent.get(geometry)?.shown === geometry.index ? lent.get(geometry).own : geometry.index);

/** Has a geometry drawn by an index until its mesh is drawn. Who looks at it then finds its own: pickers keep places in it. */
function lend(geometry, shown, object) {
  lent.set(geometry, { own: ownIndex(geometry), shown });
  geometry.index = shown;
  const { onAfterRender } = object;
  const giveBack = () => {
    geometry.index = ownIndex(geometry);
    lent.delete(geometry);
    if (object.onAfterRender === drawn) object.onAfterRender = onAfterRender;
  };
  const drawn = (...draw) => {
    giveBack();
    object.onAfterRender(...draw);
  };
  object.onAfterRender = drawn;
  // A draw that throws does not come to its end.
  queueMicrotask(giveBack);
}

/**
 * Has three.js draw the triangles of a mesh far to near.
 * @param {typeof import('three')} THREE
 * @param {unknown[]} draw - Arguments of Material.onBeforeRender.
 */
export function drawFarToNear(THREE, [, , camera, geometry, object, group]) {
  const index = ownIndex(geometry);
  const { drawRange } = geometry;
  const { position } = geometry.attributes;
  const total = (index ?? position).count;
  const start = Math.max(drawRange.start, group?.start ?? 0);
  const end = Math.min(drawRange.start + drawRange.count, group ? group.start + group.count : total, total);
  const order = orderOf(object, camera, group?.start ?? 0);
  const view = [camera.isOrthographicCamera, ...object.modelViewMatrix.elements];
  const of = [geometry, index, index?.version, position, position.version, start, end, ...view, ...poseOf(object)];
  if (of.length !== order.of.length || of.some((part, i) => part !== order.of[i])) {
    order.index = indexOf(THREE, order.index, index, total);
    putInOrder(order.index.array, start, nearnessOf(seenFrom(THREE, object), camera, order.index.array.subarray(start, end)));
    order.index.needsUpdate = true;
    order.of = of;
  }
  lend(geometry, order.index, object);
}

/** What moves a mesh's vertices beside its place: morph targets and their weights, joints and what hangs on them. */
function poseOf({ geometry: { morphAttributes, attributes }, morphTargetInfluences = [], skeleton, bindMatrix }) {
  const versions = [...(morphAttributes.position ?? []), attributes.skinIndex, attributes.skinWeight].map((attribute) => attribute?.version);
  return [...versions, ...morphTargetInfluences, ...(skeleton ? [...skeleton.boneMatrices, ...bindMatrix.elements] : [])];
}

/** A copy of a geometry's index, in place of the last one where that is as long. */
function indexOf(THREE, last, index, total) {
  const copy = last?.count === total ? last : new THREE.BufferAttribute(new Uint32Array(total), 1).setUsage(THREE.DynamicDrawUsage);
  for (let i = 0; i < total; i++) copy.array[i] = index ? index.getX(i) : i;
  return copy;
}

/** Places of a mesh's vertices from the camera, three numbers each. */
function seenFrom(THREE, object) {
  const { count } = object.geometry.attributes.position;
  const seen = new Float32Array(3 * count);
  const vertex = new THREE.Vector3();
  for (let i = 0; i < count; i++)
    object
      .getVertexPosition(i, vertex)
      .applyMatrix4(object.modelViewMatrix)
      .toArray(seen, 3 * i);
  return seen;
}

/** Of each triangle's middle: how near it is, by the distance from the eye, or along the view where there is none. */
function nearnessOf(seen, camera, corners) {
  const near = new Float32Array(Math.floor(corners.length / 3));
  for (let part = 0; part < near.length; part++) {
    const [a, b, c] = [3 * corners[3 * part], 3 * corners[3 * part + 1], 3 * corners[3 * part + 2]];
    const z = (seen[a + 2] + seen[b + 2] + seen[c + 2]) / 3;
    const x = (seen[a] + seen[b] + seen[c]) / 3;
    const y = (seen[a + 1] + seen[b + 1] + seen[c + 1]) / 3;
    near[part] = camera.isOrthographicCamera ? z : -(x * x + y * y + z * z);
  }
  return near;
}

/** Triangles of one place stay as the file has them. @param {number} start - Of the first one's corners in the index. */
function putInOrder(indices, start, near) {
  const own = indices.slice(start, start + 3 * near.length);
  // Numbers alone are sorted many times faster than by a function: nearness first, then the place.
  const ranks = Float64Array.from(rankedBits(near), (bits, part) => bits * near.length + part).sort();
  ranks.forEach((rank, place) => {
    const part = rank % near.length;
    for (let i = 0; i < 3; i++) indices[start + 3 * place + i] = own[3 * part + i];
  });
}

/** Integers in the order of floats: as many bits as leave room for a place in 53. */
function rankedBits(values) {
  const more = Math.max(0, Math.ceil(Math.log2(values.length)) - 21);
  return new Uint32Array(values.buffer).map((bits) => ((bits >>> 31 ? ~bits : bits | 0x80000000) >>> 0) >>> more);
}
