import Delaunator from 'delaunator';
import { lengthOf } from './pattern.mjs';

/**
 * Points at equal distances along a polyline, both ends included.
 * @param {number[][]} points - [x, y].
 * @param {number} count - Intervals, >= 1.
 */
export function resample(points, count) {
  const step = lengthOf(points) / count;
  const out = [points[0]];
  let walked = 0;
  for (let i = 1; i < points.length && out.length < count; i++) {
    const [a, b] = [points[i - 1], points[i]];
    const span = Math.hypot(b[0] - a[0], b[1] - a[1]);
    while (out.length < count && walked + span >= out.length * step) {
      const t = (out.length * step - walked) / span;
      out.push([a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t]);
    }
    walked += span;
  }
  out.push(points.at(-1));
  return out;
}

function insidePolygon(polygon, x, y) {
  let inside = false;
  for (let i = 0, j = polygon.length - 1; i < polygon.length; j = i++) {
    const [xi, yi] = polygon[i];
    const [xj, yj] = polygon[j];
    if (yi > y !== yj > y && x < ((xj - xi) * (y - yi)) / (yj - yi) + xi) inside = !inside;
  }
  return inside;
}

export function distanceToPolyline(points, x, y, closed = false) {
  let best = Infinity;
  for (let i = closed ? 0 : 1; i < points.length; i++) {
    const a = points[(i + points.length - 1) % points.length];
    const [dx, dy] = [points[i][0] - a[0], points[i][1] - a[1]];
    const t = Math.min(1, Math.max(0, ((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy || 1)));
    best = Math.min(best, (x - a[0] - t * dx) ** 2 + (y - a[1] - t * dy) ** 2);
  }
  return Math.sqrt(best);
}

function boundaryOf(segments, counts) {
  const polygon = [];
  const ranges = {};
  for (const [name, points] of Object.entries(segments)) {
    const sampled = resample(points, counts[name]);
    ranges[name] = Array.from({ length: sampled.length }, (_, i) => polygon.length + i);
    polygon.push(...sampled.slice(0, -1));
  }
  for (const indices of Object.values(ranges)) indices[indices.length - 1] %= polygon.length;
  return { polygon, ranges };
}

// Rows parallel to the outline, at small distances: a seam's crease is narrower than a triangle.
function parallelRows(polygon, rows) {
  const out = [];
  const clearOf = (distance, x, y) => insidePolygon(polygon, x, y) && distanceToPolyline(polygon, x, y, true) > distance * 0.93;
  for (const distance of rows) {
    polygon.forEach((point, i) => {
      const before = polygon[(i + polygon.length - 1) % polygon.length];
      const after = polygon[(i + 1) % polygon.length];
      const [tx, ty] = [after[0] - before[0], after[1] - before[1]];
      const scale = distance / Math.hypot(tx, ty);
      const moved = [point[0] - ty * scale, point[1] + tx * scale];
      if (clearOf(distance, ...moved)) out.push(moved);
    });
  }
  return out;
}

function lattice(polygon, spacing, clearance, random) {
  const xs = polygon.map((p) => p[0]);
  const ys = polygon.map((p) => p[1]);
  const rowHeight = (spacing * Math.sqrt(3)) / 2;
  const out = [];
  let row = 0;
  for (let y = Math.min(...ys); y < Math.max(...ys); y += rowHeight, row++) {
    for (let x = Math.min(...xs) + (row % 2) * spacing * 0.5; x < Math.max(...xs); x += spacing) {
      // A regular lattice bends more easily along its rows; a small jitter hides the directions.
      const at = [x + (random() - 0.5) * spacing * 0.3, y + (random() - 0.5) * spacing * 0.3];
      if (insidePolygon(polygon, ...at) && distanceToPolyline(polygon, ...at, true) > clearance) out.push(at);
    }
  }
  return out;
}

/**
 * Triangulate one pattern piece.
 * @param {object} panel - `segments`: name -> [x, y] points, counter-clockwise outline.
 * @param {object} options
 * @param {Object<string, number>} options.counts - Intervals per segment.
 * @param {number} options.spacing - Metres between interior points.
 * @param {number[]} [options.rows] - Distances (metres) of extra rows along the outline.
 * @param {() => number} options.random - Uniform in [0, 1).
 * @returns {{name, points: number[][], triangles: Uint32Array, ranges: Object<string, number[]>, polygon}}
 *   Counter-clockwise triangles; `ranges` are the point indices along each segment.
 * @throws {Error} An outline edge is not an edge of the triangulation.
 */
export function meshPanel(panel, { counts, spacing, rows = [], random }) {
  const { polygon, ranges } = boundaryOf(panel.segments, counts);
  const clearance = (rows.length ? rows.at(-1) : 0) + spacing * 0.55;
  const points = [...polygon, ...parallelRows(polygon, rows), ...lattice(polygon, spacing, clearance, random)];
  const { triangles } = Delaunator.from(points);
  const kept = [];
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, c, b] = [triangles[i], triangles[i + 1], triangles[i + 2]];
    const [pa, pb, pc] = [points[a], points[b], points[c]];
    const area = (pb[0] - pa[0]) * (pc[1] - pa[1]) - (pb[1] - pa[1]) * (pc[0] - pa[0]);
    const [x, y] = [(pa[0] + pb[0] + pc[0]) / 3, (pa[1] + pb[1] + pc[1]) / 3];
    if (Math.abs(area) < 1e-10 || !insidePolygon(polygon, x, y)) continue;
    if (area > 0) kept.push(a, b, c);
    else kept.push(a, c, b);
  }
  const mesh = { name: panel.name, points, triangles: Uint32Array.from(kept), ranges, polygon };
  checkOutline(mesh);
  return mesh;
}

function checkOutline({ name, polygon, triangles }) {
  const edges = new Set();
  for (let i = 0; i < triangles.length; i += 3) {
    for (let k = 0; k < 3; k++) edges.add(`${triangles[i + k]}:${triangles[i + ((k + 1) % 3)]}`);
  }
  polygon.forEach((_, i) => {
    const next = (i + 1) % polygon.length;
    if (!edges.has(`${i}:${next}`)) throw new Error(`Panel ${name}: outline edge ${i}-${next} is missing; lower the spacing`);
  });
}
