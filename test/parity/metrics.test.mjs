import assert from 'node:assert/strict';
import { test } from 'node:test';
import { difference, premultiply } from './metrics.mjs';

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
  assert.deepEqual(result.interior, { pixels: 28 * 28, max: 0, p999: 0, atLeast1: 0, atLeast2: 0, worst: [18, 18] });
  assert.equal(result.edge.pixels, 36 * 36 - 28 * 28, 'the band has 2 pixels on both sides');
  assert.ok(result.pass);
});

test('a difference within 2 pixels of the silhouette counts as edge', () => {
  const actual = picture();
  actual[at(17, 30)] = 200;
  const result = compare(actual);
  assert.deepEqual([result.interior.max, result.edge.max, result.pass], [0, 100, true]);
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
  const actual = picture();
  actual[at(5, 5)] = 9;
  assert.equal(compare(actual).interior.max, 0);
  assert.equal(compare(actual, { background: true }).interior.max, 9);
});

test('a picture without an object does not pass', () => {
  const empty = new Uint8Array(SIZE * SIZE * 4);
  assert.equal(compare(empty, { mask: empty, expected: empty }).pass, false);
});

test('a picture of another size is an error', () => {
  assert.throws(() => compare(new Uint8Array(4)), /expected 16384 bytes, got 4/);
});

test('premultiply undoes the rounded division for every alpha and colour', () => {
  for (let alpha = 1; alpha < 256; alpha++) {
    for (let c = 0; c <= alpha; c++) {
      const straight = Math.round((c * 255) / alpha);
      assert.equal(premultiply(Uint8Array.of(straight, 0, 0, alpha))[0], c);
    }
  }
});
