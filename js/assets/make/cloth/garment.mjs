import { lengthOf } from './pattern.mjs';
import { meshPanel } from './panel_mesh.mjs';
import { seeded } from '../random.mjs';

const segmentKey = (panel, segment) => `${panel}.${segment}`;

// Both sides of a seam get the same number of intervals, so that they are sewn point to point.
function segmentCounts(pattern, spacing) {
  const lengths = new Map();
  for (const { name, segments } of pattern.panels) {
    for (const [segment, points] of Object.entries(segments)) lengths.set(segmentKey(name, segment), lengthOf(points));
  }
  const counts = new Map([...lengths].map(([key, length]) => [key, Math.max(2, Math.round(length / spacing))]));
  for (const [panelA, segmentA, panelB, segmentB] of pattern.seams) {
    const [a, b] = [segmentKey(panelA, segmentA), segmentKey(panelB, segmentB)];
    const shared = Math.max(counts.get(a), counts.get(b));
    counts.set(a, shared).set(b, shared);
  }
  return counts;
}

/**
 * The neck rib: a strip as long as the neckline times `ribStretch` (a rib is sewn in stretched), its
 * lower edge sewn to the neckline, its ends to each other. It starts at the wearer's left shoulder and runs
 * over the front; x falls along it, so that the piece is not mirrored when seen from outside.
 */
function ribMesh(size, intervals, necklineLength, rows) {
  const length = necklineLength * size.ribStretch;
  const points = [];
  for (let row = 0; row <= rows; row++) {
    for (let i = 0; i <= intervals; i++) points.push([(1 - i / intervals) * length, (row / rows) * size.ribHeight]);
  }
  const triangles = [];
  const stride = intervals + 1;
  for (let row = 0; row < rows; row++) {
    for (let i = 0; i < intervals; i++) {
      const a = row * stride + i;
      triangles.push(a, a + stride + 1, a + 1, a, a + stride, a + stride + 1);
    }
  }
  const edge = (first, step, count) => Array.from({ length: count }, (_, i) => first + i * step);
  const ranges = { bottom: edge(0, 1, stride), top: edge(rows * stride, 1, stride), start: edge(0, stride, rows + 1), end: edge(intervals, stride, rows + 1) };
  return { name: 'neck_rib', points, triangles: Uint32Array.from(triangles), ranges, length, rows, intervals };
}

function weld(panels, pairs) {
  const offsets = [];
  let total = 0;
  for (const panel of panels) {
    offsets.push(total);
    total += panel.points.length;
  }
  const parent = Uint32Array.from({ length: total }, (_, i) => i);
  const root = (i) => {
    while (parent[i] !== i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const [panelA, a, panelB, b] of pairs) {
    const [ra, rb] = [root(offsets[panelA] + a), root(offsets[panelB] + b)];
    if (ra !== rb) parent[Math.max(ra, rb)] = Math.min(ra, rb);
  }
  const ids = new Map();
  panels.forEach((panel, p) => {
    panel.particle = Uint32Array.from(panel.points, (_, i) => {
      const key = root(offsets[p] + i);
      if (!ids.has(key)) ids.set(key, ids.size);
      return ids.get(key);
    });
  });
  return ids.size;
}

/**
 * Mesh all pattern pieces and sew them.
 * @param {object} pattern - From `tshirtPattern`.
 * @param {number} spacing - Metres between cloth particles.
 * @param {number} seed - Of the lattice's jitter.
 * @returns {{panels: object[], particleCount: number}} Each panel's `particle[i]` is the shared particle
 *   of its point i; sewn points share one.
 */
export function sewGarment(pattern, spacing, seed) {
  const counts = segmentCounts(pattern, spacing);
  const random = seeded(seed);
  const panels = pattern.panels.map((panel) => {
    const own = Object.fromEntries(Object.keys(panel.segments).map((s) => [s, counts.get(segmentKey(panel.name, s))]));
    return meshPanel(panel, { counts: own, spacing, random });
  });
  const index = Object.fromEntries(panels.map((panel, i) => [panel.name, i]));
  const neckline = [...panels[0].ranges.neck, ...[...panels[1].ranges.neck].reverse().slice(1)];
  const necklineLength = lengthOf(pattern.panels[0].segments.neck) + lengthOf(pattern.panels[1].segments.neck);
  const ribRows = Math.max(2, Math.round(pattern.size.ribHeight / spacing));
  const rib = ribMesh(pattern.size, neckline.length - 1, necklineLength, ribRows);
  panels.push(rib);
  const pairs = [];
  for (const [panelA, segmentA, panelB, segmentB, reversed] of pattern.seams) {
    const a = panels[index[panelA]].ranges[segmentA];
    const b = panels[index[panelB]].ranges[segmentB];
    a.forEach((point, i) => pairs.push([index[panelA], point, index[panelB], reversed ? b.at(-1 - i) : b[i]]));
  }
  const frontCount = panels[0].ranges.neck.length;
  neckline.forEach((point, i) => pairs.push([panels.length - 1, rib.ranges.bottom[i], i < frontCount ? 0 : 1, point]));
  rib.ranges.start.forEach((point, i) => pairs.push([panels.length - 1, point, panels.length - 1, rib.ranges.end[i]]));
  return { panels, particleCount: weld(panels, pairs) };
}
