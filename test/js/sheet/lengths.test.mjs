// What is told of the lengths of a sheet: points off the garment, and girths that do not close or that slide away.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import '../api/support/real.mjs';
import { strip } from '../api/support/strip.mjs';
import { GlbBuilder } from '../../fixtures/glb.mjs';
import { plane } from '../../fixtures/geometry.mjs';
import { createRenderer } from '../../../js/index.mjs';
import { lengthOf } from '../../../js/sheet/lengths.mjs';
import { readSpec } from '../../../js/sheet/read.mjs';

let renderer;
let open;
let shirt;
before(async () => {
  renderer = await createRenderer();
  open = await renderer.load(strip());
  shirt = await renderer.load(fileURLToPath(new URL('../../../js/assets/tshirt.glb', import.meta.url)));
});
after(() => renderer.close());

/** Codes and pointers of what is told of a girth. */
async function told(model, girth) {
  const { measures, anchors } = readSpec({ measures: [{ code: 'A', description: 'a', girth }] });
  const warnings = [];
  await lengthOf(measures[0], { model, anchors, variant: '', pointer: '/measures/0', call: {}, warn: (...warning) => warnings.push(warning) });
  return warnings;
}

test('a girth that does not close is told', async () => {
  assert.deepEqual(await told(open, { point: [0.2, 0.2, 0] }), [
    ['W_SHEET_GIRTH', 'spec.measures: the girth "A" does not close around the part; what is measured is an open line', '/measures/0/girth'],
  ]);
  assert.deepEqual(await told(shirt, { point: [0, 0.42, 0.1] }), []);
});

test('a point of a girth that lies more than 2 cm off the line is told', async () => {
  const off = (z) => told(open, { point: [0.2, 0.2, z] });
  assert.equal((await off(0.019)).length, 1);
  assert.deepEqual((await off(0.021)).slice(1), [
    ['W_SHEET_POINT', 'spec.measures: the point of the girth "A" is 21 mm off the line that is measured', '/measures/0/girth/point'],
  ]);
  const [[code, , pointer]] = await told(shirt, { point: [0, 0.42, 0.2] });
  assert.deepEqual([code, pointer], ['W_SHEET_POINT', '/measures/0/girth/point']);
});

test('the last stretch of a closed line counts', async () => {
  const square = [
    [0, 0, 0],
    [1, 0, 0],
    [1, 0, 1],
    [0, 0, 1],
  ];
  const model = { measure: async () => ({ length: 4, closed: true, polyline: square }) };
  assert.deepEqual(await told(model, { point: [0, 0, 0.5] }), []);
  assert.equal((await told(model, { point: [0.5, 0, 0.5] })).length, 1);
});

test('the point of a tight girth may lie in a hollow that the tape leaves', async () => {
  const lines = {
    true: [
      [0.1, 0, 0],
      [0.1, 0, 1],
      [0.2, 0, 1],
    ],
    false: [
      [0, 0, 0],
      [0, 0, 1],
      [0.2, 0, 1],
    ],
  };
  const model = { measure: async ({ girth }) => ({ length: 3, closed: true, polyline: lines[girth.tight] }) };
  assert.deepEqual(await told(model, { point: [0, 0, 0.5], tight: true }), []);
  const [[, message]] = await told(model, { point: [-0.05, 0, 0.5], tight: true });
  assert.match(message, /is 50 mm off/);
});

test('a tight girth that slides to where the part is narrower is told', async () => {
  const builder = new GlbBuilder();
  const flat = plane(1, 0.5, { cells: 24 });
  // A flared tube: 12 cm wide at the top, 32 cm below.
  const positions = flat.positions.flatMap((x, i) => {
    if (i % 3 !== 0) return [];
    const [turn, y] = [2 * Math.PI * x, flat.positions[i + 1]];
    const radius = 0.11 - 0.2 * y;
    return [radius * Math.cos(turn), y, radius * Math.sin(turn)];
  });
  builder.add({ positions, indices: flat.indices }, null);
  const skirt = await renderer.load(await builder.bytes());
  const point = [0.11, 0, 0];
  assert.deepEqual(await told(skirt, { point }), []);
  const [[code, message, pointer], ...others] = await told(skirt, { point, tight: true });
  assert.deepEqual([code, pointer, others], ['W_SHEET_GIRTH', '/measures/0/girth/tight', []]);
  const [, slid] = /^spec\.measures: drawn tight, the girth "A" slides (\d+) mm out of its plane, to where the part is narrower$/.exec(message);
  assert.ok(Math.abs(slid - 250) < 5, `${slid}: up to its edge`);
});
