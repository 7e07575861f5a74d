// Models and shots of the checks that go the whole way from a file to a picture.
import { plane, torus } from '../fixtures/geometry.mjs';
import { GlbBuilder } from '../fixtures/glb.mjs';

/** Shadings that every check goes through. */
export const SHADINGS = ['three', 'three-r115', 'disney-2012', 'fabric'];

const CLOTH = {
  baseColor: [0.7, 0.45, 0.3, 1],
  roughness: 0.6,
  doubleSided: true,
  layers: { sheen: { sheenColorFactor: [0.3, 0.3, 0.4], sheenRoughnessFactor: 0.5 } },
};

/** The same mesh moved along z, then `scale` times as large; in its vertices, as a writer may drop a tiny translation. */
const placed = (mesh, z, scale) => ({ ...mesh, positions: mesh.positions.map((c, i) => (c + (i % 3 === 2 ? z : 0)) * scale) });

/**
 * A ring over a sheet, of cloth: they shadow each other.
 * @param {{scale?: number, offset?: number[], turn?: number}} place - scale of the vertices; where the root stands, metres;
 *   turned about +Y, degrees
 */
export async function ringOnSheet({ scale = 1, offset = [0, 0, 0], turn = 0 } = {}) {
  const glb = new GlbBuilder();
  const cloth = glb.material(CLOTH);
  const half = (turn * Math.PI) / 360;
  const parent = glb.node({ translation: offset, rotation: [0, Math.sin(half), 0, Math.cos(half)] });
  glb.add(placed(torus(0.5, 0.15), 0.25, scale), cloth, { parent });
  glb.add(placed(plane(1.6, 1.6, { cells: 8 }), -0.1, scale), cloth, { parent });
  return glb.bytes();
}

/** A red square a tenth of a millimetre before a green one. */
export async function closePlanes() {
  const glb = new GlbBuilder();
  const square = plane(1, 1);
  glb.add(square, glb.material({ baseColor: [0, 1, 0, 1], unlit: true }), {});
  glb.add(square, glb.material({ baseColor: [1, 0, 0, 1], unlit: true }), { translation: [0, 0, 1e-4] });
  return glb.bytes();
}

/** A square in z = 0 that faces +Z. */
export async function square(material = {}) {
  const glb = new GlbBuilder();
  glb.add(plane(1, 1), glb.material({ baseColor: [0.8, 0.8, 0.8, 1], roughness: 0.9, ...material }));
  return glb.bytes();
}

/** Corners of triangles `keep(number)` lets through, in an order that `rank(number)` gives. */
function trianglesOf(indices, keep, rank) {
  const numbers = Array.from({ length: indices.length / 3 }, (_, i) => i)
    .filter(keep)
    .sort((a, b) => rank(a) - rank(b));
  return numbers.flatMap((i) => indices.slice(i * 3, i * 3 + 3));
}

/** A ring in one piece; with its triangles in another order; in two meshes. */
export async function ringIn(form) {
  const glb = new GlbBuilder();
  const cloth = glb.material(CLOTH);
  const ring = torus(0.5, 0.2);
  const part = (keep, rank = (i) => i) => ({ ...ring, indices: trianglesOf(ring.indices, keep, rank) });
  const forms = {
    whole: [ring],
    permuted: [
      part(
        () => true,
        (i) => (i * 7919) % (ring.indices.length / 3),
      ),
    ],
    split: [part((i) => i % 3 === 0), part((i) => i % 3 !== 0)],
  };
  for (const mesh of forms[form]) glb.add(mesh, cloth);
  return glb.bytes();
}

/** Raw 8-bit pixels of a square picture, unless the shot says otherwise. */
export const pictureShot = (shot = {}) => ({
  size: { width: 128, height: 128 },
  background: 'white',
  output: { format: 'raw' },
  ...shot,
});

export const SUN = { type: 'directional', position: [1, 2, 3], intensity: 2, castShadow: true };
