/**
 * Reads the draped cloth at any point of the flat pattern: position and smooth normal, curved between
 * particles as in Phong tessellation.
 * src: Boubekeur & Alexa 2008, "Phong tessellation"
 */

const CURVATURE = 0.75;

/**
 * Area-weighted normals per particle, pointing out of the garment.
 * @returns {Float64Array} Unit xyz per particle.
 */
export function particleNormals(garment, positions) {
  const normals = new Float64Array(positions.length);
  for (const panel of garment.panels) {
    const flip = isMirrored(panel) ? -1 : 1;
    for (let t = 0; t < panel.triangles.length; t += 3) {
      const [a, b, c] = [0, 1, 2].map((k) => panel.particle[panel.triangles[t + k]] * 3);
      const u = [0, 1, 2].map((k) => positions[b + k] - positions[a + k]);
      const v = [0, 1, 2].map((k) => positions[c + k] - positions[a + k]);
      const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
      for (const corner of [a, b, c]) for (let k = 0; k < 3; k++) normals[corner + k] += n[k] * flip;
    }
  }
  for (let i = 0; i < normals.length; i += 3) {
    const length = Math.hypot(normals[i], normals[i + 1], normals[i + 2]) || 1;
    for (let k = 0; k < 3; k++) normals[i + k] /= length;
  }
  return normals;
}

/** The back piece is drawn as seen through the wearer, so its outside is the pattern's reverse. */
export const isMirrored = (panel) => panel.name === 'back';

export class Surface {
  /** @param {object} panel - One of `garment.panels`. */
  constructor(panel, positions, normals) {
    Object.assign(this, { panel, positions, normals });
    const xs = panel.points.map((p) => p[0]);
    const ys = panel.points.map((p) => p[1]);
    this.low = [Math.min(...xs), Math.min(...ys)];
    this.cell = 0.012;
    this.columns = Math.ceil((Math.max(...xs) - this.low[0]) / this.cell) + 1;
    this.lines = Math.ceil((Math.max(...ys) - this.low[1]) / this.cell) + 1;
    this.cells = Array.from({ length: this.columns * this.lines }, () => []);
    for (let t = 0; t < panel.triangles.length; t += 3) this.#register(t);
  }

  #cellOf(x, y) {
    const i = Math.floor((x - this.low[0]) / this.cell);
    const j = Math.floor((y - this.low[1]) / this.cell);
    return [Math.min(this.columns - 1, Math.max(0, i)), Math.min(this.lines - 1, Math.max(0, j))];
  }

  #register(t) {
    const corners = [0, 1, 2].map((k) => this.panel.points[this.panel.triangles[t + k]]);
    const [i0, j0] = this.#cellOf(Math.min(...corners.map((p) => p[0])), Math.min(...corners.map((p) => p[1])));
    const [i1, j1] = this.#cellOf(Math.max(...corners.map((p) => p[0])), Math.max(...corners.map((p) => p[1])));
    for (let j = j0; j <= j1; j++) for (let i = i0; i <= i1; i++) this.cells[j * this.columns + i].push(t);
  }

  // The triangle that holds the point, or the one that it misses by least (at a rounded outline).
  #locate(x, y) {
    const [ci, cj] = this.#cellOf(x, y);
    let best = { worst: -Infinity };
    for (let ring = 0; ring < 4 && best.worst < -0.5; ring++) {
      for (let j = Math.max(0, cj - ring); j <= Math.min(this.lines - 1, cj + ring); j++) {
        for (let i = Math.max(0, ci - ring); i <= Math.min(this.columns - 1, ci + ring); i++) {
          for (const t of this.cells[j * this.columns + i]) {
            const weights = this.#weights(t, x, y);
            const worst = Math.min(...weights);
            if (worst > best.worst) best = { worst, t, weights };
          }
        }
      }
    }
    return best;
  }

  #weights(t, x, y) {
    const { points, triangles } = this.panel;
    const [a, b, c] = [points[triangles[t]], points[triangles[t + 1]], points[triangles[t + 2]]];
    const area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    const wb = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / area;
    const wc = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area;
    return [1 - wb - wc, wb, wc];
  }

  /**
   * @param {number} x - Pattern metres.
   * @param {number} y - Pattern metres.
   * @returns {{position: number[], normal: number[]}} Metres; unit, out of the garment.
   */
  at(x, y) {
    const { t, weights } = this.#locate(x, y);
    const corners = [0, 1, 2].map((k) => this.panel.particle[this.panel.triangles[t + k]] * 3);
    const { positions, normals } = this;
    const mix = (from) => [0, 1, 2].map((c) => corners.reduce((sum, corner, k) => sum + from[corner + c] * weights[k], 0));
    const flat = mix(positions);
    const normal = mix(normals);
    const position = flat.slice();
    corners.forEach((corner, k) => {
      let off = 0;
      for (let c = 0; c < 3; c++) off += (flat[c] - positions[corner + c]) * normals[corner + c];
      for (let c = 0; c < 3; c++) position[c] -= CURVATURE * weights[k] * off * normals[corner + c];
    });
    const length = Math.hypot(...normal) || 1;
    return { position, normal: normal.map((v) => v / length) };
  }
}

/** One reader per panel, by name. */
export function garmentSurfaces(garment, positions) {
  const normals = particleNormals(garment, positions);
  return Object.fromEntries(garment.panels.map((panel) => [panel.name, new Surface(panel, positions, normals)]));
}

/**
 * Carry a drape over to a finer mesh of the same pattern.
 * @returns {Float64Array} xyz per particle of `fine`.
 */
export function transferDrape(coarse, positions, fine) {
  const surfaces = garmentSurfaces(coarse, positions);
  const sum = new Float64Array(fine.particleCount * 3);
  const count = new Float64Array(fine.particleCount);
  for (const panel of fine.panels) {
    panel.points.forEach(([x, y], i) => {
      const { position } = surfaces[panel.name].at(x, y);
      for (let c = 0; c < 3; c++) sum[panel.particle[i] * 3 + c] += position[c];
      count[panel.particle[i]]++;
    });
  }
  return sum.map((value, i) => value / count[Math.floor(i / 3)]);
}
