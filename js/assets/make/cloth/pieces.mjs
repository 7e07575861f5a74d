import { meshPanel, resample, distanceToPolyline } from './panel_mesh.mjs';
import { lengthOf } from './pattern.mjs';
import { isMirrored } from './surface.mjs';
import { LABEL } from '../textile/label.mjs';
import { seeded } from '../random.mjs';

/**
 * The drawn pieces. Each has: name, part (glTF node), textile, positions, normals and tangents (metres),
 * uv (metres on the flat pattern, v down), flat (chart coordinates in metres for the occlusion atlas)
 * and indices. Every face is drawn from one side: cloth has an outside and an inside, `THICKNESS` apart.
 */

const THICKNESS = 0.0011;
const OUTER_SPACING = 0.008;
const INNER_SPACING = 0.012;
const SEAM_ROWS = [0.0016, 0.0042];
const EDGE_STEP = 0.0065;

// The panel ends a little below the upper edge of its hem, which lies over it.
const HEM_OVERLAP = 0.0016;

/** Profile of a turned hem: [height above the edge, distance out of the cloth], metres, outside first. */
const HEM_PROFILE = [
  [0.0205, -0.0005],
  [0.02, 0.0003],
  [0.0192, 0.0007],
  [0.0182, 0.0006],
  [0.0172, 0.0002],
  [0.0162, 0.0006],
  [0.0155, 0.0007],
  [0.0145, 0.0006],
  [0.0135, 0.0002],
  [0.0125, 0.0006],
  [0.0105, 0.0009],
  [0.006, 0.001],
  [0.0022, 0.0009],
  [0.0006, 0.0005],
  [0, -0.0004],
  [0.0006, -0.0014],
  [0.003, -0.0019],
  [0.01, -0.0019],
  [0.0195, -0.0017],
  [0.0206, -0.0009],
];

/** The same for the neck rib, whose edge is a fold: the profile runs from the seam over the fold. */
const RIB_PROFILE = [
  [-0.0002, -0.0012],
  [0.0006, -0.0002],
  [0.0016, 0.0007],
  [0.004, 0.0012],
  [0.0085, 0.0014],
  [0.014, 0.0014],
  [0.018, 0.0012],
  [0.0202, 0.0007],
  [0.0212, 0],
  [0.0208, -0.0008],
  [0.018, -0.0014],
  [0.01, -0.0017],
  [0.002, -0.0016],
  [-0.0004, -0.0013],
];

/** Twin-needle tape below the rib: [distance from the neckline, distance out of the cloth]. */
const TAPE_PROFILE = [
  [0.0004, -0.0006],
  [0.0012, 0.0004],
  [0.0022, 0.0009],
  [0.0035, 0.0011],
  [0.0055, 0.0011],
  [0.0068, 0.0009],
  [0.0078, 0.0004],
  [0.0088, -0.0008],
];

const offset = ({ position, normal }, distance) => position.map((value, c) => value + normal[c] * distance);

function cutHem(panel, height) {
  const segments = { ...panel.segments };
  const lowest = segments.hem[0][1];
  const raise = (points) =>
    points.map((point, i) => {
      const other = points[i === 0 ? points.length - 1 : 0];
      if (point[1] > lowest + 1e-9) return point;
      const t = height / (other[1] - point[1]);
      return [point[0] + (other[0] - point[0]) * t, point[1] + height];
    });
  for (const [name, points] of Object.entries(segments)) {
    if (name.startsWith('side') || name.startsWith('under')) segments[name] = raise(points);
  }
  const sides = Object.entries(segments)
    .filter(([name]) => name.startsWith('side') || name.startsWith('under'))
    .map(([, points]) => points);
  const corners = sides
    .flat()
    .filter((p) => Math.abs(p[1] - lowest - height) < 1e-9)
    .sort((a, b) => a[0] - b[0]);
  segments.hem = [corners[0], corners.at(-1)];
  return { ...panel, segments };
}

function countsFor(pattern, spacing) {
  const counts = {};
  for (const { name, segments } of pattern.panels) {
    for (const [segment, points] of Object.entries(segments)) counts[`${name}.${segment}`] = Math.max(2, Math.round(lengthOf(points) / spacing));
  }
  for (const [a, sa, b, sb] of pattern.seams) {
    counts[`${a}.${sa}`] = counts[`${b}.${sb}`] = Math.max(counts[`${a}.${sa}`], counts[`${b}.${sb}`]);
  }
  return counts;
}

// A sewn edge is drawn in by its thread, and the layers of the allowance raise a soft ridge beside it.
function seamRelief(distance) {
  return -0.0011 * Math.exp(-((distance / 0.0018) ** 2)) + 0.0005 * Math.exp(-(((distance - 0.0045) / 0.0025) ** 2));
}

const isSewn = (segment) => segment !== 'hem';

function layPanel(panel, mesh, surface, inside) {
  const mirrored = isMirrored(panel);
  const sewn = Object.entries(panel.segments)
    .filter(([name]) => isSewn(name))
    .map(([, points]) => points);
  const positions = [];
  const uv = [];
  const flat = [];
  for (const [x, y] of mesh.points) {
    const distance = Math.min(...sewn.map((points) => distanceToPolyline(points, x, y)));
    positions.push(...offset(surface.at(x, y), inside ? -THICKNESS : seamRelief(distance)));
    uv.push(mirrored ? -x : x, -y);
    flat.push(x, y);
  }
  const indices = Array.from(mesh.triangles);
  if (mirrored !== inside) reverse(indices);
  return { positions, uv, flat, indices };
}

function reverse(indices) {
  for (let i = 0; i < indices.length; i += 3) [indices[i + 1], indices[i + 2]] = [indices[i + 2], indices[i + 1]];
}

function closeSeams(meshes, pieces, seams) {
  for (const [a, sa, b, sb, reversed] of seams) {
    const [rangeA, rangeB] = [meshes[a].ranges[sa], meshes[b].ranges[sb]];
    rangeA.forEach((i, n) => {
      const j = reversed ? rangeB.at(-1 - n) : rangeB[n];
      for (let c = 0; c < 3; c++) {
        const middle = (pieces[a].positions[i * 3 + c] + pieces[b].positions[j * 3 + c]) / 2;
        pieces[a].positions[i * 3 + c] = pieces[b].positions[j * 3 + c] = middle;
      }
    });
  }
}

function panelPieces(pattern, surfaces, { inside, spacing, rows }) {
  const cut = { ...pattern, panels: pattern.panels.map((panel) => cutHem(panel, pattern.size.hemHeight - HEM_OVERLAP)) };
  const counts = countsFor(cut, spacing);
  const random = seeded(inside ? 31 : 29);
  const meshes = {};
  const pieces = {};
  for (const panel of cut.panels) {
    const own = Object.fromEntries(Object.keys(panel.segments).map((s) => [s, counts[`${panel.name}.${s}`]]));
    meshes[panel.name] = meshPanel(panel, { counts: own, spacing, rows, random });
    pieces[panel.name] = layPanel(panel, meshes[panel.name], surfaces[panel.name], inside);
  }
  closeSeams(meshes, pieces, pattern.seams);
  return Object.entries(pieces).map(([name, piece]) => ({ ...piece, name: inside ? `${name}_inside` : name, part: name, textile: 'jersey' }));
}

/**
 * Sweep a profile along a line of the pattern.
 * @param {number} columns - Intervals along.
 * @param {number[][]} profile - [across, out] metres.
 * @param {(share: number, across: number) => {at, along}} place - `at` from `Surface.at`, `along` metres.
 */
function sweep(columns, profile, place) {
  const [positions, uv, flat, indices] = [[], [], [], []];
  let walked = 0;
  profile.forEach(([across, out], row) => {
    if (row) walked += Math.hypot(across - profile[row - 1][0], out - profile[row - 1][1]);
    for (let i = 0; i <= columns; i++) {
      const { at, along } = place(i / columns, across);
      positions.push(...offset(at, out));
      uv.push(along, -across);
      flat.push(Math.abs(along), walked);
      if (row === 0 || i === columns) continue;
      const [a, b] = [(row - 1) * (columns + 1) + i, row * (columns + 1) + i];
      indices.push(a, b, b + 1, a, b + 1, a + 1);
    }
  });
  return { positions, uv, flat, indices, rows: profile.length, stride: columns + 1 };
}

function hemPiece(panel, surface) {
  const [left, right] = panel.segments.hem;
  const width = right[0] - left[0];
  const side = Object.entries(panel.segments).find(([name]) => name === 'sideLeft' || name === 'underPlus')[1];
  const slope = (side[1][0] - side[0][0]) / (side[1][1] - side[0][1]);
  const sign = isMirrored(panel) ? -1 : 1;
  const piece = sweep(Math.round(width / EDGE_STEP), HEM_PROFILE, (share, across) => {
    const t = share * 2 - 1;
    const x = sign * t * (right[0] + slope * across);
    return { at: surface.at(x, left[1] + across), along: t * right[0] + width };
  });
  const body = panel.name === 'front' || panel.name === 'back';
  const part = body ? 'hem_bottom' : `hem_${panel.name}`;
  return { ...piece, name: body ? `hem_${panel.name}` : part, part, textile: 'stitched' };
}

// Bands are sewn on in the round: where two ends meet, they share position and normal.
function joinEnds(a, lastA, b, lastB) {
  for (let row = 0; row < a.rows; row++) {
    const i = row * a.stride + (lastA ? a.stride - 1 : 0);
    const j = row * b.stride + (lastB ? b.stride - 1 : 0);
    for (const attribute of ['positions', 'normals']) {
      const middle = [0, 1, 2].map((c) => (a[attribute][i * 3 + c] + b[attribute][j * 3 + c]) / 2);
      const length = attribute === 'normals' ? Math.hypot(...middle) : 1;
      for (let c = 0; c < 3; c++) a[attribute][i * 3 + c] = b[attribute][j * 3 + c] = middle[c] / length;
    }
  }
}

function bandPieces(pattern, rib, surfaces) {
  const hems = pattern.panels.map((panel) => addNormals(hemPiece(panel, surfaces[panel.name])));
  const tapes = pattern.panels.slice(0, 2).map((panel) => addNormals(tapePiece(panel, surfaces[panel.name])));
  const neck = addNormals(ribPiece(rib, surfaces.neck_rib));
  joinEnds(hems[0], false, hems[1], true);
  joinEnds(hems[0], true, hems[1], false);
  joinEnds(tapes[0], false, tapes[1], false);
  joinEnds(tapes[0], true, tapes[1], true);
  for (const ring of [hems[2], hems[3], neck]) joinEnds(ring, false, ring, true);
  return [...hems, neck, ...tapes];
}

function ribPiece(rib, surface) {
  const columns = Math.round(rib.length / 0.0045);
  const piece = sweep(columns, RIB_PROFILE, (share, across) => ({ at: surface.at(share * rib.length, across), along: share * rib.length }));
  reverse(piece.indices);
  return { ...piece, name: 'neck_rib', part: 'neck_rib', textile: 'rib' };
}

function tapePiece(panel, surface) {
  const curve = panel.segments.neck;
  const columns = Math.round(lengthOf(curve) / 0.005);
  const line = resample(curve, columns);
  const length = lengthOf(curve);
  const piece = sweep(columns, TAPE_PROFILE, (share, across) => {
    const i = Math.round(share * columns);
    const [before, after] = [line[Math.max(0, i - 1)], line[Math.min(columns, i + 1)]];
    const [tx, ty] = [after[0] - before[0], after[1] - before[1]];
    const scale = across / Math.hypot(tx, ty);
    return { at: surface.at(line[i][0] - ty * scale, line[i][1] + tx * scale), along: share * length };
  });
  if (isMirrored(panel)) piece.indices = piece.indices.slice();
  else reverse(piece.indices);
  if (isMirrored(panel)) piece.uv = piece.uv.map((value, i) => (i % 2 ? value : -value));
  // The tape borrows the two stitch lines of the hem's textile, which lie 15.35 mm above its edge.
  piece.uv = piece.uv.map((value, i) => (i % 2 ? -0.01535 + 0.0044 + value : value));
  return { ...piece, name: `neck_tape_${panel.name}`, part: 'neck_tape', textile: 'stitched' };
}

function addNormals(piece) {
  const { positions: p, indices } = piece;
  const normals = new Float64Array(p.length);
  for (let t = 0; t < indices.length; t += 3) {
    const [a, b, c] = [indices[t] * 3, indices[t + 1] * 3, indices[t + 2] * 3];
    const u = [0, 1, 2].map((k) => p[b + k] - p[a + k]);
    const v = [0, 1, 2].map((k) => p[c + k] - p[a + k]);
    const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    for (const corner of [a, b, c]) for (let k = 0; k < 3; k++) normals[corner + k] += n[k];
  }
  for (let i = 0; i < normals.length; i += 3) {
    const length = Math.hypot(normals[i], normals[i + 1], normals[i + 2]) || 1;
    for (let k = 0; k < 3; k++) normals[i + k] /= length;
  }
  return { ...piece, positions: Float64Array.from(p), normals };
}

/**
 * Tangents along +u, for a normal map whose green points up the picture (against v).
 * @returns The piece with `tangents`: unit xyz and the handedness w per vertex.
 */
function addTangents(piece) {
  const { positions: p, normals, uv, indices } = piece;
  const count = p.length / 3;
  const [along, down] = [new Float64Array(count * 3), new Float64Array(count * 3)];
  for (let t = 0; t < indices.length; t += 3) {
    const [a, b, c] = [indices[t], indices[t + 1], indices[t + 2]];
    const [u1, v1, u2, v2] = [uv[b * 2] - uv[a * 2], uv[b * 2 + 1] - uv[a * 2 + 1], uv[c * 2] - uv[a * 2], uv[c * 2 + 1] - uv[a * 2 + 1]];
    const orientation = Math.sign(u1 * v2 - u2 * v1);
    for (let k = 0; k < 3; k++) {
      const [e1, e2] = [p[b * 3 + k] - p[a * 3 + k], p[c * 3 + k] - p[a * 3 + k]];
      for (const corner of [a, b, c]) {
        along[corner * 3 + k] += (e1 * v2 - e2 * v1) * orientation;
        down[corner * 3 + k] += (e2 * u1 - e1 * u2) * orientation;
      }
    }
  }
  const tangents = new Float64Array(count * 4);
  for (let i = 0; i < count; i++)
    tangents.set(frameAt(normals.subarray(i * 3, i * 3 + 3), along.subarray(i * 3, i * 3 + 3), down.subarray(i * 3, i * 3 + 3)), i * 4);
  return { ...piece, tangents };
}

function frameAt(n, along, down) {
  const lean = n[0] * along[0] + n[1] * along[1] + n[2] * along[2];
  const flat = [0, 1, 2].map((c) => along[c] - lean * n[c]);
  const length = Math.hypot(...flat) || 1;
  const [x, y, z] = flat.map((value) => value / length);
  const up = [n[1] * z - n[2] * y, n[2] * x - n[0] * z, n[0] * y - n[1] * x];
  return [x, y, z, up[0] * down[0] + up[1] * down[1] + up[2] * down[2] > 0 ? -1 : 1];
}

// Sewn inside the back, just below the rib; it faces the neck opening.
function labelPiece(size, surface) {
  const base = size.length - size.backNeckDrop - 0.0035 - LABEL.height;
  const profile = [
    [0, -0.0014],
    [0.0006, -0.0029],
    [LABEL.height - 0.0006, -0.0029],
    [LABEL.height, -0.0014],
  ];
  const piece = sweep(10, profile, (share, across) => ({ at: surface.at((share - 0.5) * LABEL.width, base + across), along: share * LABEL.width }));
  reverse(piece.indices);
  return { ...piece, name: 'neck_label', part: 'neck_label', textile: 'label' };
}

/**
 * @param {object} pattern - From `tshirtPattern`.
 * @param {object} garment - The sewn garment that was draped.
 * @param {Object<string, Surface>} surfaces - From `garmentSurfaces`.
 * @returns {object[]} Pieces as described at the top of this file.
 */
export function cutPieces(pattern, garment, surfaces) {
  const rib = garment.panels.find((panel) => panel.name === 'neck_rib');
  return [
    ...panelPieces(pattern, surfaces, { inside: false, spacing: OUTER_SPACING, rows: SEAM_ROWS }).map(addNormals),
    ...panelPieces(pattern, surfaces, { inside: true, spacing: INNER_SPACING, rows: [] }).map(addNormals),
    ...bandPieces(pattern, rib, surfaces),
    addNormals(labelPiece(pattern.size, surfaces.back)),
  ].map(addTangents);
}
