import assert from 'node:assert/strict';
import { test } from 'node:test';
import { arrangementOf } from '../../../js/sheet/pages/colourways.mjs';
import { roomOfDetail } from '../../../js/sheet/pages/details.mjs';

/** Of A4 across, less its margins. */
const BOX = { width: 273, height: 173 };
const WIDE = { width: 1.1, height: 0.72 };
const TALL = { width: 0.45, height: 1.2 };

const way = (count, extent, views = 2) => {
  const { columns, isStacked, ratio, width } = arrangementOf({ count, chips: 3, extents: Array(views).fill(extent), box: BOX });
  assert.ok(((views === 1 || isStacked ? 1 : views) * 1000 * extent.width) / ratio <= width, 'the pictures are as wide as a column at most');
  return [columns, isStacked, ratio];
};

test('colourways take the columns that show them largest', () => {
  // Side by side in three columns they would be 1:30, and 1:20 in one.
  assert.deepEqual(way(3, WIDE), [3, true, 15]);
  assert.deepEqual(way(1, WIDE), [1, false, 10]);
  assert.deepEqual(way(2, WIDE), [2, true, 12]);
  assert.deepEqual(way(3, TALL), [3, false, 12]);
  assert.deepEqual(way(1, TALL), [1, false, 10]);
  assert.deepEqual(way(4, WIDE, 1), [3, false, 15]);
});

test('many colourways go on to further pages, three on each at least', () => {
  const [columns, isStacked, ratio] = way(12, WIDE);
  assert.deepEqual([columns, isStacked, ratio], [3, true, 15]);
});

const details = (count, size, text = 0) =>
  roomOfDetail({ sizes: Array(count).fill(size), count, textHeight: () => text, room: { width: 174, height: 163 }, least: 50 });

test('details are as large as their page lets them; many are as large as they must be', () => {
  const square = { width: 0.08, height: 0.08 };
  const one = details(1, square);
  assert.deepEqual([one.width, one.height], [120, 120]);
  const four = details(4, square);
  assert.ok(four.width > 70 && four.height > 70, JSON.stringify(four));
  // The text takes of the height, and what is flat needs little of it: a column of its own.
  assert.ok(details(4, square, 20).height < four.height);
  assert.ok(details(2, { width: 0.12, height: 0.04 }).width > 110);
  const many = details(40, square);
  assert.deepEqual([many.width, many.height], [50, 50]);
});
