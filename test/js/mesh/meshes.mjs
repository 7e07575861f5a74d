// Meshes on which tangents are compared, unindexed or indexed: { positions, normals, uvs, indices }, typed arrays.

/** The same numbers on every machine: mulberry32. */
function randomNumbers(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t = (t + Math.imul(t ^ (t >>> 7), t | 61)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/** Grid of (columns + 1) x (rows + 1) vertices from vertex(s, t) -> [position, normal, uv], s and t in 0..1. */
function grid(columns, rows, vertex) {
  const positions = [], normals = [], uvs = [], indices = [];
  for (let j = 0; j <= rows; j++) {
    for (let i = 0; i <= columns; i++) {
      const [position, normal, uv] = vertex(i / columns, j / rows);
      positions.push(...position), normals.push(...normal), uvs.push(...uv);
      if (i === columns || j === rows) continue;
      const a = j * (columns + 1) + i, c = a + columns + 1;
      indices.push(a, c, a + 1, a + 1, c, c + 1);
    }
  }
  return { positions: Float32Array.from(positions), normals: Float32Array.from(normals), uvs: Float32Array.from(uvs), indices: Uint32Array.from(indices) };
}

function onSphere(s, t) {
  // The poles are single points, so that their triangles collapse.
  const around = 2 * Math.PI * (s === 1 ? 0 : s), down = Math.PI * t;
  const ring = t === 0 || t === 1 ? 0 : Math.sin(down);
  return [ring * Math.cos(around), Math.cos(down), ring * Math.sin(around)];
}

export const sphere = (columns, rows) => grid(columns, rows, (s, t) => [onSphere(s, t), onSphere(s, t), [s, t]]);

/** Sphere whose texture runs out and back: every edge on the meridians s = 1/2 and s = 0 is a mirror seam. */
export const mirroredSphere = (columns, rows) =>
  grid(columns, rows, (s, t) => [onSphere(s, t), onSphere(s, t), [1 - Math.abs(2 * s - 1), t]]);

/** Torus whose UVs are sheared and repeat. */
export const torus = (columns, rows) =>
  grid(columns, rows, (s, t) => {
    const u = 2 * Math.PI * (s === 1 ? 0 : s), v = 2 * Math.PI * (t === 1 ? 0 : t);
    const ring = 1 + 0.4 * Math.cos(v);
    const normal = [Math.cos(v) * Math.cos(u), Math.sin(v), Math.cos(v) * Math.sin(u)];
    return [[ring * Math.cos(u), 0.4 * Math.sin(v), ring * Math.sin(u)], normal, [5 * s + 0.7 * t, 3 * t]];
  });

/** Wavy sheet whose UVs fold over, so that orientation changes inside it and some UV triangles collapse. */
export const foldedSheet = (columns, rows) =>
  grid(columns, rows, (s, t) => {
    const height = 0.2 * Math.sin(9 * s) * Math.cos(7 * t);
    const slope = [-1.8 * Math.cos(9 * s) * Math.cos(7 * t), 1.4 * Math.sin(9 * s) * Math.sin(7 * t), 1];
    const length = Math.hypot(...slope);
    return [[s, t, height], slope.map((x) => x / length), [Math.round(40 * Math.sin(5 * s)) / 40 + 0.2 * t, Math.abs(t - 0.5)]];
  });

/**
 * Triangles between random points of small grids: vertices, edges and whole triangles coincide, collapse in space or in
 * UV, and edges belong to many triangles.
 * @param {{steps: number, normals: number}} options - positions and UVs on steps^n grid points, one of `normals` normals
 */
export function soup(seed, triangles, { steps, normals: kinds }) {
  const random = randomNumbers(seed);
  const directions = Array.from({ length: kinds }, () => {
    const z = 2 * random() - 1, around = 2 * Math.PI * random(), ring = Math.sqrt(1 - z * z);
    return [ring * Math.cos(around), ring * Math.sin(around), z];
  });
  const onGrid = () => Math.floor(random() * steps) / (steps - 1);
  const positions = [], normals = [], uvs = [], indices = [];
  for (let i = 0; i < 3 * triangles; i++) {
    positions.push(onGrid(), onGrid(), onGrid());
    normals.push(...directions[Math.floor(random() * kinds)]);
    uvs.push(onGrid(), onGrid());
    indices.push(i);
  }
  return { positions: Float32Array.from(positions), normals: Float32Array.from(normals), uvs: Float32Array.from(uvs), indices: Uint32Array.from(indices) };
}

/** Sheet of independent random heights and UVs: connected, with slivers and both orientations, nothing collapsed. */
export function roughSheet(seed, columns, rows) {
  const random = randomNumbers(seed);
  return grid(columns, rows, (s, t) => {
    const tilt = [random() - 0.5, random() - 0.5, 1], length = Math.hypot(...tilt);
    return [[s, t, 0.1 * random()], tilt.map((x) => x / length), [random(), random()]];
  });
}

/** A fan whose first and last triangles have opposite tangents, joined by two whose UVs have no area. */
export const opposedFan = () => ({
  positions: Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, -1, 1, 0, -1, 0, 0, 0, -1, 0),
  normals: Float32Array.from({ length: 18 }, (_, i) => (i % 3 === 2 ? 1 : 0)),
  uvs: Float32Array.of(0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1),
  indices: Uint32Array.of(0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5),
});
