import assert from 'node:assert/strict';
import { test } from 'node:test';
import { explainDifference, shrinkImage, sizeFactor } from '../../../js/compare/index.mjs';
import { draw, flat, noise, square } from './support.mjs';

const SIZE = 32;
/** A disk with a soft edge, coloured, on nothing. */
const disk = draw(SIZE, SIZE, (x, y) => {
  const alpha = Math.round(255 * Math.min(1, Math.max(0, 12.5 - Math.hypot(x - 15.5, y - 15.5)) / 3));
  return [200, 120 + y, 40 + x, alpha];
});
const mapped = (image, f) => draw(image.width, image.height, (x, y) => f(...image.data.subarray((y * image.width + x) * 4, (y * image.width + x) * 4 + 4)));
const causes = (expected, actual) => explainDifference(expected, actual).map(({ cause }) => cause);

test('a background that one of the two has', () => {
  const onWhite = mapped(disk, (r, g, b, a) => [r, g, b].map((c) => Math.round((c * a) / 255 + 255 - a)).concat(255));
  const [hint] = explainDifference(disk, onWhite);
  assert.deepEqual(
    [hint.cause, hint.message],
    ['background', 'the expected picture is transparent where the actual one shows #ffffff: draw both on one background'],
  );
  assert.match(explainDifference(onWhite, disk)[0].message, /^the actual picture is transparent where the expected one shows #ffffff/);
  assert.deepEqual(
    causes(
      mapped(disk, (r, g, b, a) => [b, r, g, a]),
      onWhite,
    ),
    [],
    'another drawing on a background is another drawing',
  );
});

test('premultiplied colours, and alpha alone', () => {
  const premultiplied = mapped(disk, (r, g, b, a) => [...[r, g, b].map((c) => Math.round((c * a) / 255)), a]);
  assert.match(explainDifference(disk, premultiplied)[0].message, /^the colours of the actual picture are multiplied by its alpha/);
  assert.match(explainDifference(premultiplied, disk)[0].message, /^the colours of the expected picture/);
  const binary = mapped(disk, (r, g, b, a) => [r, g, b, a >= 128 ? 255 : 0]);
  assert.deepEqual(causes(disk, binary), ['alpha']);
});

test('nothing is explained where the drawing differs, or nothing does', () => {
  assert.deepEqual(causes(disk, disk), []);
  assert.deepEqual(
    causes(
      disk,
      mapped(disk, (r, g, b, a) => [g, r, b, a]),
    ),
    [],
  );
  assert.deepEqual(causes(noise(SIZE, SIZE, 1), noise(SIZE, SIZE, 2)), []);
  assert.deepEqual(causes(square(SIZE), square(SIZE, 101)), []);
});

test('pictures of dense screens are known by their size', () => {
  const size = (width, height) => ({ width, height });
  assert.deepEqual(sizeFactor(size(100, 50), size(200, 100)), { larger: 'actual', factor: 2 });
  assert.deepEqual(sizeFactor(size(300, 300), size(100, 100)), { larger: 'expected', factor: 3 });
  assert.equal(sizeFactor(size(101, 67), size(152, 101)).larger, 'actual', '1.5, each side rounded by itself');
  for (const [a, b] of [
    [size(10, 10), size(10, 10)],
    [size(10, 10), size(20, 10)],
    [size(10, 20), size(20, 10)],
    [size(100, 100), size(200, 190)],
  ])
    assert.equal(sizeFactor(a, b), null);
});

test('shrinking takes the mean of what a pixel covers, weighed by alpha', () => {
  const pixels = [
    [10, 0, 0, 255],
    [30, 0, 0, 255],
    [200, 0, 0, 0],
    [0, 100, 0, 255],
  ];
  const image = draw(4, 2, (x) => pixels[x]);
  assert.deepEqual([...shrinkImage(image, { width: 2, height: 1 }).data], [20, 0, 0, 255, 0, 100, 0, 128]);
  // Three pixels to two: each covers one and a half.
  const row = draw(3, 1, (x) => [[0, 90, 180][x], 0, 0, 255]);
  assert.deepEqual([...shrinkImage(row, { width: 2, height: 1 }).data], [30, 0, 0, 255, 150, 0, 0, 255]);
  assert.equal(shrinkImage(row, { width: 3, height: 1 }), row);
  const grey = shrinkImage(flat(13, 7, [77, 77, 77, 255]), { width: 5, height: 3 });
  assert.deepEqual([...new Set(grey.data)], [77, 255]);
  for (const size of [
    { width: 4, height: 1 },
    { width: 0, height: 1 },
    { width: 1.5, height: 1 },
  ]) {
    assert.throws(() => shrinkImage(row, size), { code: 'E_OPTION', message: /from 1x1 to 3x1/ });
  }
});
