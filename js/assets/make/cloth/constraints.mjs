/**
 * What the cloth resists: stretch along each triangle edge, bending across each inner edge.
 * Bending is the quadratic energy of an isometric surface: linear in positions, zero when flat.
 * src: Wardetzky, Bergou, Harmon, Zorin, Grinspun 2007, "Discrete quadratic curvature energies"
 */

/** Jersey of 220 g/m2 in heavy combed cotton. Stiffnesses are per width; SI units. */
export const CLOTH = {
  areaDensity: 0.22,
  stretch: 160,
  bending: 2.4e-6,
  hemFactor: 30,
  seamFactor: 10,
  ribFactor: 16,
};

function cotangent(a, b, c) {
  // At corner a of the triangle with edge lengths |ab| = c, |ac| = b, |bc| = a.
  const s = (a + b + c) / 2;
  const area = Math.sqrt(Math.max(1e-18, s * (s - a) * (s - b) * (s - c)));
  return (b * b + c * c - a * a) / (4 * area);
}

function hemShare(panel, i, size) {
  const hem = panel.ranges.hem;
  if (!hem) return 0;
  return panel.points[i][1] - panel.points[hem[0]][1] < size.hemHeight * 1.05 ? 1 : 0;
}

function collectEdges(garment, size, visit) {
  for (const panel of garment.panels) {
    const { triangles, points, particle } = panel;
    const distance = (i, j) => Math.hypot(points[i][0] - points[j][0], points[i][1] - points[j][1]);
    for (let t = 0; t < triangles.length; t += 3) {
      for (let k = 0; k < 3; k++) {
        const [i, j, o] = [triangles[t + k], triangles[t + ((k + 1) % 3)], triangles[t + ((k + 2) % 3)]];
        const lengths = { edge: distance(i, j), toFirst: distance(o, i), toSecond: distance(o, j) };
        const doubled = hemShare(panel, i, size) && hemShare(panel, j, size) ? 1 : 0;
        visit({ first: particle[i], second: particle[j], opposite: particle[o], lengths, panel, doubled });
      }
    }
  }
}

function gatherEdges(garment, size) {
  const edges = new Map();
  collectEdges(garment, size, (half) => {
    const [low, high] = half.first < half.second ? [half.first, half.second] : [half.second, half.first];
    const key = low * garment.particleCount + high;
    const edge = edges.get(key) ?? { low, high, halves: [] };
    const { toFirst, toSecond, edge: rest } = half.lengths;
    const swap = half.first !== low;
    edge.halves.push({
      opposite: half.opposite,
      rest,
      toLow: swap ? toSecond : toFirst,
      toHigh: swap ? toFirst : toSecond,
      panel: half.panel,
      doubled: half.doubled,
    });
    edges.set(key, edge);
  });
  return [...edges.values()];
}

function triangleArea(a, b, c) {
  const s = (a + b + c) / 2;
  return Math.sqrt(Math.max(1e-18, s * (s - a) * (s - b) * (s - c)));
}

function bendingOf(edge) {
  const [p, q] = edge.halves;
  const cots = [p, q].map((h) => ({
    low: cotangent(h.toHigh, h.toLow, h.rest),
    high: cotangent(h.toLow, h.toHigh, h.rest),
    area: triangleArea(h.rest, h.toLow, h.toHigh),
  }));
  const weights = [cots[0].high + cots[1].high, cots[0].low + cots[1].low, -(cots[0].low + cots[0].high), -(cots[1].low + cots[1].high)];
  let factor = 1;
  if (p.panel !== q.panel) factor = CLOTH.seamFactor;
  if (p.doubled && q.doubled) factor = CLOTH.hemFactor;
  if (p.panel.name === 'neck_rib' && q.panel.name === 'neck_rib') factor = CLOTH.ribFactor;
  const stiffness = (3 * CLOTH.bending * factor) / (cots[0].area + cots[1].area);
  return { particles: [edge.low, edge.high, p.opposite, q.opposite], weights, stiffness };
}

/**
 * @param {object} garment - From `sewGarment`.
 * @param {object} size - Measures in metres.
 * @returns Flat arrays: stretch pairs with rest length and stiffness (N/m), bending quadruples with
 *   weights and stiffness, and the mass of each particle (kg).
 */
export function buildConstraints(garment, size) {
  const edges = gatherEdges(garment, size);
  const stretchPairs = new Uint32Array(edges.length * 2);
  const rest = new Float64Array(edges.length);
  const stretchStiffness = new Float64Array(edges.length);
  const bends = [];
  edges.forEach((edge, i) => {
    stretchPairs.set([edge.low, edge.high], i * 2);
    rest[i] = edge.halves.reduce((sum, half) => sum + half.rest, 0) / edge.halves.length;
    const ribbed = edge.halves.every((half) => half.panel.name === 'neck_rib');
    stretchStiffness[i] = CLOTH.stretch * (ribbed ? 0.8 : 1) * (edge.halves.length === 2 ? 1 : 0.6) * (edge.halves[0].doubled ? 2 : 1);
    if (edge.halves.length === 2) bends.push(bendingOf(edge));
  });
  const mass = new Float64Array(garment.particleCount);
  for (const edge of edges) {
    for (const half of edge.halves) {
      const share = (triangleArea(half.rest, half.toLow, half.toHigh) * CLOTH.areaDensity * (half.doubled ? 2 : 1)) / 9;
      for (const particle of [edge.low, edge.high, half.opposite]) mass[particle] += share;
    }
  }
  return {
    stretchPairs,
    rest,
    stretchStiffness,
    mass,
    bendParticles: Uint32Array.from(bends.flatMap((b) => b.particles)),
    bendWeights: Float64Array.from(bends.flatMap((b) => b.weights)),
    bendStiffness: Float64Array.from(bends, (b) => b.stiffness),
  };
}
