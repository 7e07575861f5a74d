/**
 * Cloth against cloth: particles that are far apart on the cloth are kept `radius` apart in space.
 * Pairs are searched now and then within `radius + margin` and used until the next search.
 */

// Neighbours within two edges, sorted per particle, as offsets into one list.
function twoRings(particleCount, pairs) {
  const near = Array.from({ length: particleCount }, () => []);
  for (let i = 0; i < pairs.length; i += 2) {
    near[pairs[i]].push(pairs[i + 1]);
    near[pairs[i + 1]].push(pairs[i]);
  }
  return near.map((ring, i) => {
    const all = new Set([i]);
    for (const j of ring) {
      all.add(j);
      for (const k of near[j]) all.add(k);
    }
    return all;
  });
}

export class SelfContact {
  /**
   * @param {number} particleCount
   * @param {Uint32Array} stretchPairs - Edges, two particles each.
   * @param {number} radius - Metres.
   */
  constructor(particleCount, stretchPairs, radius) {
    this.radius = radius;
    this.rings = twoRings(particleCount, stretchPairs);
    this.pairs = [];
  }

  /** Find pairs nearer than radius + margin. Cells are a hash of their integer coordinates. */
  search(positions, margin) {
    const reach = this.radius + margin;
    const count = positions.length / 3;
    const mask = 32767;
    const cellOf = (i, j, k) => (Math.imul(i, 73856093) ^ Math.imul(j, 19349663) ^ Math.imul(k, 83492791)) & mask;
    const starts = new Uint32Array(mask + 2);
    const cells = new Int32Array(count * 3);
    const hashes = new Uint32Array(count);
    for (let p = 0; p < count; p++) {
      for (let c = 0; c < 3; c++) cells[p * 3 + c] = Math.floor(positions[p * 3 + c] / reach);
      hashes[p] = cellOf(cells[p * 3], cells[p * 3 + 1], cells[p * 3 + 2]);
      starts[hashes[p] + 1]++;
    }
    for (let i = 0; i <= mask; i++) starts[i + 1] += starts[i];
    const fill = starts.slice();
    const sorted = new Uint32Array(count);
    for (let p = 0; p < count; p++) sorted[fill[hashes[p]]++] = p;
    const found = [];
    for (let p = 0; p < count; p++) this.#around(p, { positions, cells, starts, sorted, cellOf, reach, found });
    this.pairs = Uint32Array.from(found);
  }

  #around(p, { positions, cells, starts, sorted, cellOf, reach, found }) {
    const x = positions[p * 3];
    const y = positions[p * 3 + 1];
    const z = positions[p * 3 + 2];
    const ring = this.rings[p];
    for (let n = 0; n < 27; n++) {
      const i = cells[p * 3] + (n % 3) - 1;
      const j = cells[p * 3 + 1] + (Math.floor(n / 3) % 3) - 1;
      const k = cells[p * 3 + 2] + Math.floor(n / 9) - 1;
      const hash = cellOf(i, j, k);
      for (let s = starts[hash]; s < starts[hash + 1]; s++) {
        const q = sorted[s];
        // Two cells may share a hash: only the particles of this very cell count, and once.
        if (q <= p || cells[q * 3] !== i || cells[q * 3 + 1] !== j || cells[q * 3 + 2] !== k) continue;
        const dx = positions[q * 3] - x;
        const dy = positions[q * 3 + 1] - y;
        const dz = positions[q * 3 + 2] - z;
        if (dx * dx + dy * dy + dz * dz < reach * reach && !ring.has(q)) found.push(p, q);
      }
    }
  }

  /** Push pairs apart, with friction against the movement since `before`. */
  solve(positions, before, friction) {
    const { pairs, radius } = this;
    for (let i = 0; i < pairs.length; i += 2) {
      const a = pairs[i] * 3;
      const b = pairs[i + 1] * 3;
      const dx = positions[b] - positions[a];
      const dy = positions[b + 1] - positions[a + 1];
      const dz = positions[b + 2] - positions[a + 2];
      const squared = dx * dx + dy * dy + dz * dz;
      if (squared >= radius * radius || squared < 1e-16) continue;
      const push = (radius / Math.sqrt(squared) - 1) * 0.25;
      for (let c = 0; c < 3; c++) {
        const d = c === 0 ? dx : c === 1 ? dy : dz;
        const slip = (positions[b + c] - before[b + c] - positions[a + c] + before[a + c]) * friction * 0.5;
        positions[a + c] += slip - d * push;
        positions[b + c] += d * push - slip;
      }
    }
  }
}
