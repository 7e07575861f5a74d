/**
 * The wearer: a smooth torso, neck, shoulders and two arms in A-pose as one signed distance field.
 * It only carries the cloth and is never drawn. Metres, +Y up, front towards +Z.
 */

// y, half width, half depth, centre z of the torso's elliptical sections.
const TORSO = [
  [-0.3, 0.182, 0.1, -0.004],
  [0.0, 0.186, 0.106, -0.004],
  [0.12, 0.178, 0.104, -0.002],
  [0.26, 0.16, 0.097, 0.002],
  [0.38, 0.166, 0.106, 0.006],
  [0.5, 0.182, 0.118, 0.004],
  [0.57, 0.176, 0.108, -0.006],
  [0.63, 0.144, 0.084, -0.014],
  [0.68, 0.085, 0.062, -0.018],
  [0.72, 0.055, 0.05, -0.016],
];

/** `angle` in degrees from straight down: where the arms come to rest, and where dressing starts. */
export const ARM = { shoulder: [0.172, 0.606, -0.012], angle: 33, raisedAngle: 68, length: 0.5, radius: 0.05, taper: 0.012 };

function torsoSection(y) {
  const last = TORSO.length - 1;
  const clamped = Math.min(TORSO[last][0], Math.max(TORSO[0][0], y));
  let i = 0;
  while (i < last - 1 && TORSO[i + 1][0] < clamped) i++;
  const [a, b] = [TORSO[i], TORSO[i + 1]];
  const t = (clamped - a[0]) / (b[0] - a[0]);
  const slopes = [i, i + 1].map((k) => {
    const [before, after] = [TORSO[Math.max(0, k - 1)], TORSO[Math.min(last, k + 1)]];
    return (column) => ((after[column] - before[column]) / (after[0] - before[0])) * (b[0] - a[0]);
  });
  const [h00, h10, h01, h11] = [2 * t ** 3 - 3 * t * t + 1, t ** 3 - 2 * t * t + t, 3 * t * t - 2 * t ** 3, t ** 3 - t * t];
  return [1, 2, 3].map((c) => h00 * a[c] + h10 * slopes[0](c) + h01 * b[c] + h11 * slopes[1](c));
}

function torsoDistance(x, y, z) {
  const [halfWidth, halfDepth, centre] = torsoSection(y);
  const k0 = Math.hypot(x / halfWidth, (z - centre) / halfDepth);
  const k1 = Math.hypot(x / halfWidth ** 2, (z - centre) / halfDepth ** 2);
  const radial = k1 > 0 ? (k0 * (k0 - 1)) / k1 : -halfDepth;
  const above = y - TORSO.at(-1)[0];
  return above > 0 ? Math.hypot(Math.max(radial, 0), above) + Math.min(radial, 0) : radial;
}

function coneDistance(p, a, b, radiusA, radiusB) {
  const [dx, dy, dz] = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
  const t = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy + (p[2] - a[2]) * dz) / (dx * dx + dy * dy + dz * dz);
  const s = Math.min(1, Math.max(0, t));
  return Math.hypot(p[0] - a[0] - s * dx, p[1] - a[1] - s * dy, p[2] - a[2] - s * dz) - (radiusA + (radiusB - radiusA) * s);
}

function blend(a, b, radius) {
  const h = Math.max(0, radius - Math.abs(a - b)) / radius;
  return Math.min(a, b) - (h * h * radius) / 4;
}

/** Unit direction of the left (+X) arm; the right one mirrors it. */
export function armDirection(angle = ARM.angle) {
  const radians = (angle * Math.PI) / 180;
  return [Math.sin(radians), -Math.cos(radians), 0.03];
}

/**
 * Signed distance (approximate away from the skin) to the wearer.
 * @param {number} worldX - Metres; so are y, z and the result.
 * @param {number} [armAngle] - Degrees from straight down.
 */
export function bodyDistance(worldX, y, z, armAngle = ARM.angle) {
  // The weight rests on one leg: hips a little to the left, the chest a little to the right.
  const x = worldX - 0.012 * Math.cos(4.6 * (y - 0.05));
  const side = x < 0 ? -1 : 1;
  // The two arms differ by a degree or two, as nobody stands symmetrically.
  const direction = armDirection(armAngle + (side > 0 ? 1.2 : -0.6));
  const p = [x * side, y, z];
  const hand = ARM.shoulder.map((c, i) => c + direction[i] * ARM.length);
  const arm = coneDistance(p, ARM.shoulder, hand, ARM.radius, ARM.radius - ARM.taper);
  const yoke = coneDistance(p, [0.04, 0.668, -0.016], [0.166, 0.616, -0.014], 0.046, 0.046);
  const neck = coneDistance(p, [0, 0.65, -0.024], [0, 0.82, 0.004], 0.056, 0.052);
  return blend(blend(blend(torsoDistance(x, y, z), yoke, 0.05), arm, 0.035), neck, 0.03);
}

/**
 * Sample the body on a grid, rescaled so that the field's slope near the skin is 1.
 * @param {number} cell - Metres.
 * @param {number} [armAngle] - Degrees from straight down.
 * @returns {(x, y, z, gradient: Float64Array) => number} Trilinear reader of the distance (metres) that
 *   also writes its gradient; outside of the grid the distance is 1 m and the gradient 0.
 */
export function bakeBody(cell = 0.009, armAngle = ARM.angle) {
  const low = [-0.56, -0.16, -0.24];
  const size = [1.12, 1.01, 0.48].map((extent) => Math.ceil(extent / cell) + 1);
  const field = new Float64Array(size[0] * size[1] * size[2]);
  const h = 0.002;
  const slopeAt = (x, y, z, d) =>
    Math.hypot(bodyDistance(x + h, y, z, armAngle) - d, bodyDistance(x, y + h, z, armAngle) - d, bodyDistance(x, y, z + h, armAngle) - d) / h;
  let at = 0;
  for (let k = 0; k < size[2]; k++) {
    for (let j = 0; j < size[1]; j++) {
      for (let i = 0; i < size[0]; i++, at++) {
        const [x, y, z] = [low[0] + i * cell, low[1] + j * cell, low[2] + k * cell];
        const d = bodyDistance(x, y, z, armAngle);
        field[at] = Math.abs(d) > 0.025 ? d : d / Math.max(0.7, slopeAt(x, y, z, d));
      }
    }
  }
  return gridReader(field, low, size, cell);
}

/**
 * The wearer lowering both arms from `raisedAngle` to `angle`, as blended key poses.
 * @param {number} keys - Poses, >= 2.
 * @returns {(progress: number) => Function} Reader as of `bakeBody` at a progress of 0..1.
 */
export function bakeLowering(keys = 5, cell = 0.016) {
  const poses = Array.from({ length: keys }, (_, i) => bakeBody(cell, ARM.raisedAngle + ((ARM.angle - ARM.raisedAngle) * i) / (keys - 1)));
  const other = new Float64Array(3);
  return (progress) => {
    const place = Math.min(keys - 1.000001, Math.max(0, progress) * (keys - 1));
    const key = Math.floor(place);
    const share = place - key;
    return (x, y, z, gradient) => {
      const d = poses[key](x, y, z, gradient);
      const next = poses[key + 1](x, y, z, other);
      for (let c = 0; c < 3; c++) gradient[c] += (other[c] - gradient[c]) * share;
      return d + (next - d) * share;
    };
  };
}

function gridReader(field, low, size, cell) {
  const [nx, ny, nz] = size;
  const [sy, sz] = [nx, nx * ny];
  return (x, y, z, gradient) => {
    const [fx, fy, fz] = [(x - low[0]) / cell, (y - low[1]) / cell, (z - low[2]) / cell];
    const [i, j, k] = [Math.floor(fx), Math.floor(fy), Math.floor(fz)];
    if (i < 0 || j < 0 || k < 0 || i >= nx - 1 || j >= ny - 1 || k >= nz - 1) {
      gradient[0] = gradient[1] = gradient[2] = 0;
      return 1;
    }
    const [u, v, w] = [fx - i, fy - j, fz - k];
    const o = i + j * sy + k * sz;
    const [c000, c100, c010, c110] = [field[o], field[o + 1], field[o + sy], field[o + sy + 1]];
    const [c001, c101, c011, c111] = [field[o + sz], field[o + sz + 1], field[o + sz + sy], field[o + sz + sy + 1]];
    const [x00, x10, x01, x11] = [c000 + (c100 - c000) * u, c010 + (c110 - c010) * u, c001 + (c101 - c001) * u, c011 + (c111 - c011) * u];
    const [y0, y1] = [x00 + (x10 - x00) * v, x01 + (x11 - x01) * v];
    const near = (c100 - c000) * (1 - v) + (c110 - c010) * v;
    const far = (c101 - c001) * (1 - v) + (c111 - c011) * v;
    gradient[0] = (near + (far - near) * w) / cell;
    gradient[1] = ((x10 - x00) * (1 - w) + (x11 - x01) * w) / cell;
    gradient[2] = (y1 - y0) / cell;
    return y0 + (y1 - y0) * w;
  };
}
