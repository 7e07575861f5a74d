import assert from 'node:assert/strict';
import { test } from 'node:test';
import { difference, interiorDistances, premultiply, withinCoverage } from './metrics.mjs';

const SIZE = 64;

/** Opaque grey square in the middle half of the frame, transparent around. */
function picture() {
  const pixels = new Uint8Array(SIZE * SIZE * 4);
  for (let y = 16; y < 48; y++) for (let x = 16; x < 48; x++) pixels.set([100, 100, 100, 255], (y * SIZE + x) * 4);
  return pixels;
}

const at = (x, y) => (y * SIZE + x) * 4;
const compare = (actual, options = {}) =>
  difference({ expected: picture(), mask: picture(), actual, width: SIZE, height: SIZE, background: false, ...options });

test('equal pictures pass, and the interior is the square less 2 pixels a side', () => {
  const result = compare(picture());
  assert.deepEqual(result.interior, { pixels: 28 * 28, max: 0, mean: 0, p999: 0, atLeast1: 0, atLeast2: 0, worst: [18, 18] });
  assert.deepEqual([result.edge.pixels, result.edge.flip.mean], [32 * 32 - 28 * 28, 0]);
  assert.ok(result.pass);
});

test('a difference within 2 pixels of the silhouette counts as edge', () => {
  const actual = picture();
  actual[at(17, 30)] = 200;
  const result = compare(actual);
  assert.deepEqual([result.interior.max, result.edge.max], [0, 100]);
});

test('edges are judged by what a person sees: a frayed side fails, one pixel a little off does not', () => {
  const frayed = picture();
  for (let y = 16; y < 48; y++) frayed.set([255, 255, 255, 255], at(16, y));
  const { pass, verdict, edge } = compare(frayed);
  assert.deepEqual([pass, verdict.checks.map((check) => check.pass)], [false, [true, true, false]]);
  assert.ok(edge.flip.mean > 0.01);
  const one = picture();
  one[at(16, 30)] = 104;
  assert.ok(compare(one).edge.flip.mean > 0);
  assert.ok(compare(one).pass);
});

test('an object whose alpha is below 255 has an interior all the same', () => {
  const glass = picture().map((value) => Math.round(value / 3));
  assert.equal(compare(glass, { expected: glass, mask: glass }).interior.pixels, 28 * 28);
});

test('distances from a third picture are of the same interior', () => {
  const [far, near] = [picture(), picture()];
  far[at(30, 30)] = 140;
  near[at(31, 31)] = 107;
  near[at(16, 16)] = 200;
  const pictures = { expected: picture(), mask: picture(), actual: near, width: SIZE, height: SIZE, background: false };
  const found = interiorDistances(pictures, far, [picture(), near]);
  assert.deepEqual(
    found.map(({ pixels, max, mean }) => [pixels, max, mean]),
    [
      [784, 40, 40 / 784],
      [784, 40, 47 / 784],
    ],
  );
});

test('one interior pixel off by 3 fails, by 2 does not as long as 99.9 % are within 1', () => {
  const one = picture();
  one[at(30, 31) + 1] = 103;
  assert.deepEqual([compare(one).interior.max, compare(one).interior.worst, compare(one).pass], [3, [30, 31], false]);
  one[at(30, 31) + 1] = 102;
  // 1 of 784 pixels is 0.13 %: more than the 0.1 % that the percentile leaves out.
  assert.deepEqual([compare(one).interior.p999, compare(one).pass], [2, false]);
});

test('alpha counts as a channel', () => {
  const actual = picture();
  actual[at(30, 30) + 3] = 250;
  assert.equal(compare(actual).interior.max, 5);
});

test('pixels beside the object are judged where a background is drawn', () => {
  const before = picture();
  for (let i = 0; i < before.length; i += 4) if (before[i + 3] === 0) before.set([20, 30, 40, 255], i);
  const actual = before.slice();
  actual[at(5, 5)] = 29;
  const result = compare(actual, { expected: before, background: true });
  assert.deepEqual([result.interior.max, result.interior.worst, result.edge.pixels], [9, [5, 5], 36 * 36 - 28 * 28]);
});

test('a picture without an object does not pass', () => {
  const empty = new Uint8Array(SIZE * SIZE * 4);
  assert.equal(compare(empty, { mask: empty, expected: empty }).pass, false);
});

test('a picture of another size is an error', () => {
  assert.throws(() => compare(new Uint8Array(4)), /expected 16384 bytes, got 4/);
});

test('a colour above its coverage is cut to it', () => {
  assert.deepEqual(withinCoverage(Uint8Array.of(200, 40, 128, 128, 9, 0, 255, 255)), Uint8Array.of(128, 40, 128, 128, 9, 0, 255, 255));
});

test('premultiply undoes the rounded division for every alpha and colour', () => {
  for (let alpha = 1; alpha < 256; alpha++) {
    for (let c = 0; c <= alpha; c++) {
      const straight = Math.round((c * 255) / alpha);
      assert.equal(premultiply(Uint8Array.of(straight, 0, 0, alpha))[0], c);
    }
  }
});
