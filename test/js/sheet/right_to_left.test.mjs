// A sheet in a language that is written from right to left: its numbers are not.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import '../api/support/real.mjs';
import { plane } from '../../fixtures/geometry.mjs';
import { GlbBuilder } from '../../fixtures/glb.mjs';
import { createRenderer } from '../../../js/index.mjs';
import { createSheet } from '../../../js/sheet/index.mjs';
import { fonts, wordsOf } from './documents.mjs';
import { CHEAP } from './square.mjs';

let renderer;
before(async () => {
  renderer = await createRenderer();
});
after(() => renderer.close());

const HEADINGS = { code: 'קוד', difference: 'הפרש', measured: 'נמדד', swatches: 'בדים' };

test('signs stand before their numbers, and L, a and b in this order beside their name', async () => {
  const builder = new GlbBuilder();
  builder.add(plane(0.3, 0.3), builder.material({ name: 'blue', baseColor: [0.01, 0.1, 0.5, 1] }), { name: 'square' });
  const ends = [
    [-0.15, 0, 0],
    [0.15, 0, 0],
  ];
  const spec = {
    language: 'he',
    words: HEADINGS,
    units: 'inch',
    header: { sizes: ['38'], baseSize: '38' },
    measures: [12.5, 11].map((length, i) => ({ code: `M${i}`, description: 'רוחב', points: ends, tolerance: 0.25, values: { 38: length } })),
    swatches: [{ title: 'כחול', material: 'blue' }],
  };
  const { files, info } = await createSheet(await builder.bytes(), spec, { renderer, shot: CHEAP, fonts: fonts() });
  const words = wordsOf(files[0]).flatMap((page) => page.words);
  const find = (text) => words.find((word) => word.text === text);
  // 300 mm are 11 13/16 inches.
  for (const text of ['−11/16', '+13/16']) assert.ok(find(text), `${text} in ${words.map((word) => word.text).join(' ')}`);
  const [L, a, b] = info.swatches[0].labD50.map((value) => value.toFixed(1).replace('-', '\u2212'));
  const row = words.filter(({ y }) => Math.abs(y - find(b).y) < 2).sort((one, other) => one.x - other.x);
  assert.deepEqual(
    row.map(({ text }) => text),
    [L, a, b, 'CIE', 'Lab', 'D50'],
  );
  assert.ok(row[3].x - (row[2].x + row[2].width) < 15, 'close to it');
});
