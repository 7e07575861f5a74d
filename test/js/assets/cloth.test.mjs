import assert from 'node:assert/strict';
import { test } from 'node:test';
import { bakeBody, bodyDistance } from '../../../js/assets/make/cloth/body.mjs';
import { sewGarment } from '../../../js/assets/make/cloth/garment.mjs';
import { lengthOf, tshirtPattern } from '../../../js/assets/make/cloth/pattern.mjs';
import { resample } from '../../../js/assets/make/cloth/panel_mesh.mjs';
import { wear } from '../../../js/assets/make/cloth/wear.mjs';
import { JERSEY, knitTile, stitchTile } from '../../../js/assets/make/textile/knit.mjs';
import { textileMaps } from '../../../js/assets/make/textile/maps.mjs';
import { seeded } from '../../../js/assets/make/random.mjs';

const COARSE = [{ spacing: 0.03, step: 1e-3, steps: 1500, damping: [2, 12], sway: 0, lowering: [0.25, 0.7] }];

test('the cap of a sleeve is as long as the armhole it is sewn into', () => {
  const { panels } = tshirtPattern();
  const [front, back, sleeve] = panels;
  const armhole = lengthOf(front.segments.armholeLeft) + lengthOf(back.segments.armholeLeft);
  const cap = lengthOf(sleeve.segments.capPlus) + lengthOf(sleeve.segments.capMinus);
  assert.ok(Math.abs(cap - armhole) < 1e-4);
});

test('resampling keeps both ends and equal distances', () => {
  const points = resample(
    [
      [0, 0],
      [1, 0],
      [1, 2],
    ],
    6,
  );
  assert.equal(points.length, 7);
  assert.deepEqual(
    [points[0], points[6]],
    [
      [0, 0],
      [1, 2],
    ],
  );
  for (let i = 1; i < points.length; i++) assert.ok(Math.abs(Math.hypot(points[i][0] - points[i - 1][0], points[i][1] - points[i - 1][1]) - 0.5) < 1e-9);
});

test('sewn panels form one surface: no edge has three triangles, only the four openings are open', () => {
  const { panels } = sewGarment(tshirtPattern(), 0.02, 1);
  const count = new Map();
  for (const { triangles, particle } of panels) {
    for (let t = 0; t < triangles.length; t += 3) {
      for (let k = 0; k < 3; k++) {
        const pair = [particle[triangles[t + k]], particle[triangles[t + ((k + 1) % 3)]]].sort((a, b) => a - b).join();
        count.set(pair, (count.get(pair) ?? 0) + 1);
      }
    }
  }
  const open = [...count].filter(([, n]) => n === 1).map(([pair]) => pair.split(',').map(Number));
  assert.ok([...count.values()].every((n) => n <= 2));
  const next = new Map();
  for (const [a, b] of open)
    for (const [from, to] of [
      [a, b],
      [b, a],
    ])
      next.set(from, [...(next.get(from) ?? []), to]);
  assert.ok([...next.values()].every((ends) => ends.length === 2));
  let loops = 0;
  const seen = new Set();
  for (const start of next.keys()) {
    if (seen.has(start)) continue;
    loops++;
    const queue = [start];
    while (queue.length) {
      const at = queue.pop();
      if (seen.has(at)) continue;
      seen.add(at);
      queue.push(...next.get(at));
    }
  }
  assert.equal(loops, 4, 'neck, two sleeves, bottom');
});

test('the baked body agrees with its formula near the skin', () => {
  const read = bakeBody();
  const gradient = new Float64Array(3);
  for (const [x, y, z] of [
    [0.1, 0.3, 0.09],
    [0, 0.5, 0.13],
    [-0.2, 0.55, 0],
    [0.05, 0.7, 0],
  ]) {
    assert.ok(Math.abs(read(x, y, z, gradient) - bodyDistance(x, y, z)) < 0.006);
  }
  assert.equal(read(2, 0, 0, gradient), 1);
});

test('a draped shirt rests, hardly stretched, outside of the body, the same each time', () => {
  const pattern = tshirtPattern();
  const { positions, residual, constraints } = wear(pattern, COARSE);
  assert.ok(residual < 0.05, `residual ${residual} m/s`);
  const { stretchPairs, rest } = constraints;
  const ratio = Array.from(rest, (length, i) => {
    const [a, b] = [stretchPairs[i * 2] * 3, stretchPairs[i * 2 + 1] * 3];
    return Math.hypot(positions[a] - positions[b], positions[a + 1] - positions[b + 1], positions[a + 2] - positions[b + 2]) / length;
  }).sort((a, b) => a - b);
  assert.ok(Math.abs(ratio[ratio.length >> 1] - 1) < 0.03);
  for (let i = 0; i < positions.length; i += 3) {
    assert.ok(bodyDistance(positions[i], positions[i + 1], positions[i + 2]) > -0.004, 'a particle lies in the body');
  }
  assert.deepEqual(wear(pattern, COARSE).positions, positions);
});

test('the knit repeats without a seam and its maps are neutral, upright and deterministic', () => {
  const tile = knitTile(JERSEY, 256, 1);
  const jump = (a, b) => Math.abs(tile.height[a] - tile.height[b]);
  let [seam, inner] = [0, 0];
  for (let row = 0; row < 256; row++) {
    seam += jump(row * 256, row * 256 + 255);
    inner += jump(row * 256 + 128, row * 256 + 127);
  }
  assert.ok(seam < inner * 1.5, 'the left edge continues the right one');
  const maps = textileMaps(tile, { factor: 2, seed: 1 });
  assert.ok(maps.baseMean > 0.82 && maps.baseMean < 0.95);
  const mean = [0, 1, 2].map((c) => maps.normal.reduce((sum, value, i) => sum + (i % 3 === c ? value : 0), 0) / (maps.normal.length / 3));
  assert.ok(Math.abs(mean[0] - 127.5) < 3 && Math.abs(mean[1] - 127.5) < 3 && mean[2] > 170);
  assert.deepEqual(knitTile(JERSEY, 256, 1).height, tile.height);
});

test('stitches stand out of the cloth on their two lines', () => {
  const tile = knitTile(JERSEY, 256, 1);
  const sewn = stitchTile(tile);
  const rows = new Set();
  sewn.height.forEach((height, i) => {
    if (height > tile.height[i]) rows.add(Math.floor(i / 256));
  });
  const lines = [...rows].map((row) => (1 - (row + 0.5) / 256) * 0.02);
  assert.ok(lines.length > 0 && lines.every((above) => Math.min(Math.abs(above - 0.0135), Math.abs(above - 0.0172)) < 4e-4));
});

test('the generator is uniform and repeats from its seed', () => {
  const [a, b] = [seeded(5), seeded(5)];
  const values = Array.from({ length: 4000 }, () => a());
  assert.ok(values.every((value) => value >= 0 && value < 1 && value === b()));
  assert.ok(Math.abs(values.reduce((sum, value) => sum + value) / 4000 - 0.5) < 0.02);
});
