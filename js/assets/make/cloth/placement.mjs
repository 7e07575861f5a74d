import { ARM, armDirection } from './body.mjs';

/**
 * Where each pattern point starts: body panels on a barrel around the torso, sleeves rolled around
 * the arms, the rib standing up from the neckline. Sewn points start at the mean of their pieces.
 */

function shoulderLine(size, x) {
  const [sx, sy] = size.shoulder;
  const t = Math.min(1, Math.max(0, (Math.abs(x) - size.halfNeck) / (sx - size.halfNeck)));
  return size.length + (sy - size.length) * t;
}

function placeBody(size, sign) {
  return ([x, y]) => {
    const rise = Math.min(1, Math.max(0, (shoulderLine(size, x) - y) / 0.2));
    const depth = 0.165 * Math.sqrt(1 - (1 - rise) ** 2);
    const across = Math.sqrt(Math.max(0, 1 - (x / (size.halfChest + 0.002)) ** 2));
    return [x * 0.94, y, sign * (depth * across + 0.004) - 0.01 * (1 - rise)];
  };
}

function placeSleeve(size, side) {
  const direction = armDirection(ARM.raisedAngle);
  const upper = [-direction[1], direction[0], 0];
  const radius = size.halfBicep / Math.PI;
  const [sx, sy] = size.shoulder;
  const start = (sx - ARM.shoulder[0]) * direction[0] + (sy - ARM.shoulder[1]) * direction[1];
  return ([s, y]) => {
    const along = start - y;
    const roll = s / radius;
    const [c, across] = [Math.cos(roll) * radius, -Math.sin(roll) * radius * side];
    const at = ARM.shoulder.map((base, i) => base + direction[i] * along + upper[i] * c);
    return [at[0] * side, at[1], at[2] + across];
  };
}

/**
 * @param {object} garment - From `sewGarment`.
 * @param {object} size - Measures in metres.
 * @param {() => number} random - Breaks the symmetry by fractions of a millimetre.
 * @returns {Float64Array} xyz per particle, metres.
 */
export function placeGarment(garment, size, random) {
  const places = { front: placeBody(size, 1), back: placeBody(size, -1), sleeve_left: placeSleeve(size, 1), sleeve_right: placeSleeve(size, -1) };
  const sum = new Float64Array(garment.particleCount * 3);
  const count = new Float64Array(garment.particleCount);
  for (const panel of garment.panels) {
    if (!places[panel.name]) continue;
    panel.points.forEach((point, i) => {
      const at = places[panel.name](point);
      const particle = panel.particle[i];
      for (let c = 0; c < 3; c++) sum[particle * 3 + c] += at[c] + (random() - 0.5) * 6e-4;
      count[particle]++;
    });
  }
  for (let i = 0; i < sum.length; i++) sum[i] /= count[Math.floor(i / 3)] || 1;
  placeRib(garment, sum);
  return sum;
}

// Each column of the rib rises from its neckline point and leans towards the neck's axis.
function placeRib(garment, positions) {
  const rib = garment.panels.find((panel) => panel.name === 'neck_rib');
  const stride = rib.intervals + 1;
  for (let row = 1; row <= rib.rows; row++) {
    for (let i = 0; i < rib.intervals; i++) {
      const base = rib.particle[i] * 3;
      const to = rib.particle[row * stride + i] * 3;
      const rise = rib.points[row * stride][1];
      const shrink = 1 - rise * 4;
      positions[to] = positions[base] * shrink;
      positions[to + 1] = positions[base + 1] + rise * 0.8;
      positions[to + 2] = (positions[base + 2] + 0.01) * shrink - 0.01;
    }
  }
}
