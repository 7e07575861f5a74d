import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import '../api/support/real.mjs';
import { contactSheet, layoutOf } from '../../../js/cli/contact_sheet.mjs';
import { groupOf, itemsOf } from '../../../js/cli/sheet_items.mjs';
import { ellipsized } from '../../../js/cli/text_width.mjs';
import { encodePng, readImage } from '../../../js/compare/index.mjs';
import { draw, flat } from '../compare/support.mjs';

const folder = mkdtempSync(path.join(tmpdir(), 'telar-sheet-'));
const at = (name) => path.join(folder, name);
const RED = [200, 30, 30, 255];
before(async () => {
  writeFileSync(at('red.png'), await encodePng(flat(640, 640, RED)));
  writeFileSync(at('disk.png'), await encodePng(draw(100, 100, (x, y) => (Math.hypot(x - 50, y - 50) < 30 ? [0, 0, 255, 255] : [0, 0, 0, 0]))));
});
after(() => rmSync(folder, { recursive: true }));

const sheetOf = async (items, group = 1) => readImage(await contactSheet(items, { group, limits: {} }));
const pixel = ({ width, data }, x, y) => [...data.subarray((y * width + x) * 4, (y * width + x) * 4 + 4)];
/** Pixels darker than a grey in a box. */
const ink = (image, left, top, width, height) => {
  let count = 0;
  for (let y = top; y < top + height; y++) for (let x = left; x < left + width; x++) count += pixel(image, x, y)[1] < 110 ? 1 : 0;
  return count;
};
const [MARGIN, CELL, GAP] = [48, 320, 24];

test('pictures stand on cards in a grid, names under them', async () => {
  const sheet = await sheetOf([
    { name: 'First', detail: 'navy  ·  front', file: at('red.png') },
    { name: 'Second', detail: 'navy  ·  back', file: at('disk.png') },
    { name: 'Third', detail: '', error: 'not drawn (E_JSON)' },
  ]);
  assert.equal(sheet.width, 2 * MARGIN + 3 * CELL + 2 * GAP);
  const centre = (i) => [MARGIN + i * (CELL + GAP) + CELL / 2, MARGIN + CELL / 2];
  assert.deepEqual(pixel(sheet, ...centre(0)), RED);
  assert.deepEqual(pixel(sheet, MARGIN + 2, MARGIN + 2), RED, 'a picture of 640 pixels is shrunk to its card');
  assert.deepEqual(pixel(sheet, ...centre(1)), [0, 0, 255, 255]);
  const card = [245, 244, 242, 255];
  assert.deepEqual(pixel(sheet, MARGIN + CELL + GAP + 112, MARGIN + 112), card, 'a transparent corner of a small picture, which is not enlarged');
  assert.deepEqual(pixel(sheet, MARGIN - 2, MARGIN - 2), [255, 255, 255, 255]);
  const caption = (i) => [MARGIN + i * (CELL + GAP), MARGIN + CELL + 8, CELL, 24];
  for (const i of [0, 1, 2]) assert.ok(ink(sheet, ...caption(i)) > 40, `a name under picture ${i}`);
  assert.notEqual(ink(sheet, ...caption(0)), ink(sheet, ...caption(1)));
  const blank = await sheetOf([
    { name: '', file: at('disk.png') },
    { name: 'x', file: at('disk.png') },
  ]);
  assert.equal(ink(blank, ...caption(0)), 0, 'without a name there is none');
  const marked = (image, [x, y]) => {
    let count = 0;
    for (let dy = -12; dy < 12; dy++) for (let dx = -80; dx < 80; dx++) count += pixel(image, x + dx, y + dy)[0] < 200 ? 1 : 0;
    return count;
  };
  assert.ok(marked(sheet, centre(2)) > 100, 'the error code stands on the empty card');
});

test('the same pictures give the same bytes', async () => {
  const items = [
    { name: 'a', file: at('red.png') },
    { name: 'b', file: at('disk.png') },
  ];
  assert.deepEqual(await contactSheet(items, { group: 1, limits: {} }), await contactSheet(items, { group: 1, limits: {} }));
});

test('a grid keeps groups together, begins a row for each model, and never passes 8192 pixels', () => {
  const many = (count, begins = () => false) => Array.from({ length: count }, (_, i) => ({ name: `${i}`, detail: 'x', begins: begins(i) }));
  const rows = ({ grid }) => grid.map(({ row }) => row);
  assert.deepEqual(
    rows(
      layoutOf(
        many(6, (i) => i % 3 === 0),
        3,
        1,
      ),
    ),
    [0, 0, 0, 1, 1, 1],
  );
  assert.deepEqual(
    rows(
      layoutOf(
        many(7, (i) => i === 4),
        1,
        1,
      ),
    ),
    [0, 0, 0, 1, 2, 2, 2],
  );
  for (const count of [1, 24, 500, 3000]) {
    for (const group of [1, 7, 40]) {
      const { width, height, grid, step, margin, picture } = layoutOf(many(count), group, 0.75);
      assert.ok(width <= 8192 && height <= 8192, `${count} ${group}: ${width}x${height}`);
      assert.equal(new Set(grid.map(({ column, row }) => `${column} ${row}`)).size, count);
      assert.ok(grid.every(({ column }) => margin + column * step.x + picture.width <= width));
    }
  }
});

test('a long name gives way in its middle, a short one stays', () => {
  assert.equal(ellipsized('shirt', 15, 500, 320), 'shirt');
  const name = 'AW26-womens-oversized-organic-jersey-tee-000123-final';
  const cut = ellipsized(name, 15, 500, 320);
  assert.match(cut, /^AW26-.+….+-final$/);
  assert.ok(cut.length > 30, `as much as fits: ${cut}`);
  assert.equal(ellipsized('W'.repeat(40), 15, 500, 320).length < ellipsized('i'.repeat(90), 15, 500, 320).length, true, 'by its width, not its letters');
  assert.equal(ellipsized('<&>"\'', 15, 400, 320), '<&>"\'');
});

test('captions tell apart what differs, and folders where names are the same', () => {
  const result = (model, variant, view) => ({ job: { model, variant, view }, file: 'x.png' });
  const one = [result('a/shirt.glb', 'navy', 'front'), result('a/shirt.glb', 'red', 'front')];
  assert.deepEqual(
    itemsOf(one).map(({ name, detail }) => [name, detail]),
    [
      ['shirt', 'navy'],
      ['shirt', 'red'],
    ],
  );
  const two = [...one, result('b/shirt.glb', 'navy', 'back')];
  assert.deepEqual(
    itemsOf(two).map(({ name, detail, begins }) => [name, detail, begins]),
    [
      ['a / shirt', 'navy  ·  front', true],
      ['a / shirt', 'red  ·  front', false],
      ['b / shirt', 'navy  ·  back', true],
    ],
  );
  assert.deepEqual([groupOf(two, undefined), groupOf(two, 'front,back')], [2, 1]);
  assert.equal(itemsOf([{ ...one[0], error: { code: 'E_JSON' } }])[0].error, 'not drawn (E_JSON)');
});
