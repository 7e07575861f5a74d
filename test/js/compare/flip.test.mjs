import assert from 'node:assert/strict';
import { test } from 'node:test';
import { flipMap } from '../../../js/compare/flip.mjs';
import { flipByFormula } from './flip_by_formula.mjs';
import { draw, flat, noise } from './support.mjs';

// Where the expected values come from: flat pictures have no features and pass each filter unchanged, so that FLIP is the
// redistributed colour error alone, worked out below by hand; everything else is held against flip_by_formula.mjs.

const map = (a, b, ppd) => flipMap(a.data, b.data, a.width, a.height, ppd);
const near = (found, wanted, by) => assert.ok(Math.abs(found - wanted) <= by, `${found}, not ${wanted}`);

test('equal pictures: 0 everywhere', () => {
  assert.deepEqual(map(noise(20, 16, 5), noise(20, 16, 5)), new Float32Array(320));
});

test('flat green against flat blue: 1, the largest colour error there is', () => {
  for (const error of map(flat(9, 7, [0, 255, 0, 255]), flat(9, 7, [0, 0, 255, 255]))) near(error, 1, 1e-6);
});

test('flat black against flat white: L* differs by 100 and nothing else does', () => {
  // CIELAB of green and blue to three decimals, from any table of sRGB colours, with a* and b* times L*/100.
  const green = [87.735, -86.183 * 0.87735, 83.18 * 0.87735];
  const blue = [32.297, 79.188 * 0.32297, -107.86 * 0.32297];
  const most = (Math.abs(green[0] - blue[0]) + Math.hypot(green[1] - blue[1], green[2] - blue[2])) ** 0.7;
  const wanted = 0.95 + ((100 ** 0.7 - 0.4 * most) / (0.6 * most)) * 0.05;
  near(wanted, 0.9674, 1e-4);
  for (const error of map(flat(9, 7, [0, 0, 0, 255]), flat(9, 7, [255, 255, 255, 255]))) near(error, wanted, 1e-4);
});

const disc = (radius, inside, outside) => draw(24, 19, (x, y) => (Math.hypot(x - 11, y - 9) < radius ? inside : outside));
const PICTURES = {
  noise: [noise(24, 19, 1), noise(24, 19, 2), 67],
  'an edge moved by a pixel': [disc(6, [200, 30, 40, 255], [90, 100, 110, 255]), disc(7, [200, 30, 40, 255], [90, 100, 110, 255]), 67],
  'one bright point': [flat(24, 19, [20, 20, 20, 255]), draw(24, 19, (x, y) => (x === 12 && y === 8 ? [255, 255, 255, 255] : [20, 20, 20, 255])), 67],
  'a change at the border, seen from nearby': [flat(24, 19, [0, 90, 200, 255]), draw(24, 19, (x) => [x < 2 ? 60 : 0, 90, 200, 255]), 30],
};
for (const [name, [expected, actual, ppd]] of Object.entries(PICTURES)) {
  test(`the paper's formulas, taken literally: ${name}`, () => {
    const wanted = flipByFormula(expected, actual, ppd);
    assert.ok(Math.max(...wanted) > 0.05, 'there is something to see');
    // The two take slightly different constants for sRGB: fractions here, chromaticities there.
    map(expected, actual, ppd).forEach((error, p) => near(error, wanted[p], 5e-4));
  });
}

test('only the surroundings of a difference are worked out, with the same result', () => {
  for (const [x, y] of [
    [40, 30],
    [0, 0],
    [79, 59],
    [3, 58],
  ]) {
    const [plain, spot] = [noise(80, 60, 3), noise(80, 60, 3)];
    spot.data.set([255, 0, 255, 255], (y * 80 + x) * 4);
    const found = map(plain, spot);
    // A second difference in each corner makes the box the whole frame; far from them nothing may change.
    const corners = { ...spot, data: Uint8Array.from(spot.data) };
    for (const at of [0, 79, 59 * 80, 60 * 80 - 1]) corners.data[at * 4 + 1] ^= 0x80;
    const whole = map(plain, corners);
    const far = (p) => [p % 80, Math.floor(p / 80)].every((c, axis) => c > 10 && c < [69, 49][axis]);
    found.forEach((error, p) => {
      if (far(p)) assert.equal(error, whole[p], `${p}`);
    });
    assert.ok(found[y * 80 + x] > 0.1);
    assert.ok(found.every((error, p) => error === 0 || Math.max(Math.abs((p % 80) - x), Math.abs(Math.floor(p / 80) - y)) <= 10));
  }
});
