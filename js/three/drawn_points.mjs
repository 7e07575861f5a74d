/**
 * Above so many vertices over all instances of a mesh, the corners of each instance's box stand for its vertices.
 * The same number as in renderer/asset/geometry/drawn_points.h, so that browser and server frame alike.
 */
const INSTANCED_VERTICES_MAX = 2 ** 20;

/**
 * Calls back with each point, in world space, that bounds what an object draws: its vertices morphed and skinned, in each of
 * its places.
 * @param {import('three').Object3D} object - With a geometry; world matrices are up to date.
 * @param {typeof import('three')} THREE
 * @param {(point: import('three').Vector3) => void} visit - The point is used again for the next.
 */
export function visitDrawnPoints(object, THREE, visit) {
  if (isCollapsed(object.matrixWorld, THREE)) return;
  const point = new THREE.Vector3();
  if (!object.isInstancedMesh) {
    for (const index of drawnVertices(object.geometry)) visit(vertexOf(object, index, point, THREE).applyMatrix4(object.matrixWorld));
    return;
  }
  const positions = Array.from(drawnVertices(object.geometry), (index) => vertexOf(object, index, new THREE.Vector3(), THREE));
  const points = positions.length * object.count <= INSTANCED_VERTICES_MAX ? positions : cornersOf(positions, THREE);
  const matrix = new THREE.Matrix4();
  for (let i = 0; i < object.count; i++) {
    object.getMatrixAt(i, matrix);
    if (!matrix.elements.every(Number.isFinite)) continue;
    matrix.premultiply(object.matrixWorld);
    for (const position of points) visit(point.copy(position).applyMatrix4(matrix));
  }
}

/** Whether the matrix squeezes every body to a line or a point, or is not finite: then nothing is to be seen. */
function isCollapsed(matrix, THREE) {
  const [x, y, z] = [0, 1, 2].map((column) => new THREE.Vector3().setFromMatrixColumn(matrix, column));
  const spansPlane = [
    [x, y],
    [y, z],
    [z, x],
  ].some(([a, b]) => new THREE.Vector3().crossVectors(a, b).length() > 0);
  return !spansPlane || !matrix.elements.every(Number.isFinite);
}

/** Each drawn vertex once. */
const drawnVertices = ({ index, attributes }) => (index ? new Set(index.array) : Array(attributes.position.count).keys());

function cornersOf(positions, THREE) {
  const { min, max } = new THREE.Box3().setFromPoints(positions);
  return Array.from({ length: 8 }, (_, corner) => new THREE.Vector3(...['x', 'y', 'z'].map((axis, i) => ((corner >> i) & 1 ? max : min)[axis])));
}

/** A vertex in the object's own space. Lines and points have no method for it. */
function vertexOf(object, index, target, THREE) {
  return object.isMesh ? object.getVertexPosition(index, target) : THREE.Mesh.prototype.getVertexPosition.call(object, index, target);
}
