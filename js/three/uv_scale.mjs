import { materialIndexOf, primitiveOf } from './variant.mjs';

/**
 * Metres that one unit of u and one of v cover on surfaces: medians by area, of a mesh and then of all, as the server measures them (renderer/asset/scene/uv_scale.cpp).
 */

/** The value that half of the area has at most. */
function median(values) {
  values.sort((a, b) => a.metres - b.metres);
  const total = values.reduce((sum, { area }) => sum + area, 0);
  let sum = 0;
  for (const { metres, area } of values) {
    sum += area;
    if (sum * 2 >= total) return metres;
  }
  return values.at(-1).metres;
}

/**
 * Metres along u and along v on a triangle: the lengths of the derivatives of its points. Not finite where it has no area in the texture.
 * @param {number[]} p - An edge, metres. @param {number[]} q - Another one from the same corner.
 * @param {number[]} a - The same edges in texture coordinates. @param {number[]} b
 */
function uvMetres(p, q, a, b) {
  const determinant = a[0] * b[1] - a[1] * b[0];
  const length = (of) => Math.hypot(...p.map((_, i) => of(i) / determinant));
  return [length((i) => b[1] * p[i] - a[1] * q[i]), length((i) => a[0] * q[i] - b[0] * p[i])];
}

const minus = (a, b) => a.map((x, i) => x - b[i]);
const cross = (p, q) => [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];

/**
 * @param {Iterable<import('three').Mesh>} meshes - World matrices up to date.
 * @param {typeof import('three')} THREE
 * @returns {[number, number] | null} null where none has texture coordinates
 */
export function metresPerUv(meshes, THREE) {
  const scales = [...meshes].map((mesh) => scaleOf(mesh, THREE)).filter(Boolean);
  const along = (axis) => median(scales.map(({ metres, area }) => ({ metres: metres[axis], area })));
  return scales.length > 0 ? [along(0), along(1)] : null;
}

/** Of the triangles of one mesh. */
function scaleOf(mesh, THREE) {
  const { attributes, index } = mesh.geometry;
  if (!mesh.isMesh || !attributes.uv) return null;
  const [u, v] = [[], []];
  const points = pointsOf(mesh, THREE);
  const uvs = Array.from({ length: attributes.uv.count }, (_, i) => [attributes.uv.getX(i), attributes.uv.getY(i)]);
  const count = index?.count ?? attributes.position.count;
  for (let i = 0; i + 2 < count; i += 3) {
    const [k, l, m] = [i, i + 1, i + 2].map((at) => index?.getX(at) ?? at);
    const [p, q] = [minus(points[l], points[k]), minus(points[m], points[k])];
    const [alongU, alongV] = uvMetres(p, q, minus(uvs[l], uvs[k]), minus(uvs[m], uvs[k]));
    const area = Math.hypot(...cross(p, q)) / 2;
    // A triangle without area in the texture says nothing of its size.
    if (!(alongU > 0 && alongV > 0 && area > 0) || !Number.isFinite(alongU + alongV)) continue;
    u.push({ metres: alongU, area });
    v.push({ metres: alongV, area });
  }
  return u.length > 0 ? { metres: [median(u), median(v)], area: u.reduce((sum, { area }) => sum + area, 0) } : null;
}

/** Its vertices in world space, in its pose; of instances the first. */
function pointsOf(mesh, THREE) {
  const matrix = mesh.matrixWorld.clone();
  if (mesh.isInstancedMesh) {
    const place = new THREE.Matrix4();
    mesh.getMatrixAt(0, place);
    matrix.multiply(place);
  }
  const point = new THREE.Vector3();
  return Array.from({ length: mesh.geometry.attributes.position.count }, (_, i) => mesh.getVertexPosition(i, point).applyMatrix4(matrix).toArray());
}

/** Meshes of a model that wear a material of the file in any variant. @returns {import('three').Mesh[]} */
export function wearersOf(model, index) {
  const meshes = [];
  model.scene.traverse((object) => {
    if (!object.isMesh) return;
    const mappings = primitiveOf(model.parser, object)?.extensions?.KHR_materials_variants?.mappings ?? [];
    if (materialIndexOf(model.parser, object, '') === index || mappings.some(({ material }) => material === index)) meshes.push(object);
  });
  return meshes;
}
