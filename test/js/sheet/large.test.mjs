// Squares and details that fill their paper: nothing is cut at its edge, and no text is lost beneath it.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import '../api/support/real.mjs';
import { readImage } from '../../../js/compare/index.mjs';
import { createSheet } from '../../../js/sheet/index.mjs';
import { wordFaults, wordsOf } from './documents.mjs';
import { judgedFolder } from './judged_folder.mjs';
import { CHEAP, openSquare } from './square.mjs';

const { folder, run } = judgedFolder('large');

let renderer;
let model;
before(async () => {
  ({ renderer, model } = await openSquare());
});
after(() => renderer.close());

const PPI = 50;
const perMillimetre = PPI / 25.4;
/** Half of the margin of a page, millimetres. */
const EDGE = 6;

/** From where to where a page is dark, and how wide it is, millimetres. */
async function darkOf(file, page) {
  run('pdftoppm', '-r', String(PPI), '-f', String(page), '-l', String(page), '-png', '-singlefile', file, 'page');
  const { width, height, data } = await readImage(readFileSync(path.join(folder, 'page.png')));
  const columns = Array.from({ length: width }, (_, x) => x).filter((x) =>
    Array.from({ length: height }, (_, y) => y).some((y) => data[4 * (y * width + x)] < 128),
  );
  return { from: columns[0] / perMillimetre, to: (columns.at(-1) + 1) / perMillimetre, width: width / perMillimetre };
}

for (const size of ['A4', 'Letter'])
  test(`two squares of 10 cm at 1:1 are whole on upright ${size}`, async () => {
    const swatches = [{ title: 'black', material: 'black', scale: '1:1' }];
    const { files } = await createSheet(model, { paper: { size, orientation: 'portrait' }, swatches }, { renderer, shot: CHEAP });
    writeFileSync(path.join(folder, 'square.pdf'), files[0]);
    const { from, to, width } = await darkOf('square.pdf', 2);
    assert.ok(from > EDGE && to < width - EDGE, `${from} to ${to} of ${width} mm`);
  });

test('a detail that fills its page in a scale of its own leaves its heading there, and its text goes on', async () => {
  const texts = [`first ${'word '.repeat(110)}last`, `above\n${'line\n'.repeat(10)}below`];
  const details = texts.map((text, i) => ({ title: `d${i}`, point: [0, 0.3, 0], size: 0.155, shape: 'rectangle', scale: '1:1', text }));
  const { files } = await createSheet(model, { details }, { renderer, shot: CHEAP });
  const pages = wordsOf(files[0]);
  assert.deepEqual(wordFaults(pages, ['first', 'last', 'above', 'below']), []);
  const [, page] = pages.map(({ words }) => words.map(({ text }) => text));
  for (const word of ['Details', 'd0', 'first']) assert.ok(page.includes(word), `${word} on the page of the heading`);
});

test('names of colours that wrap go on to a next page, and none is lost', async () => {
  const long = 'Pantone classic blue with a long name of its own '.repeat(2).slice(0, 80).trim();
  const swatches = Array.from({ length: 6 }, (_, i) => ({ part: long, name: `${long} first${i}`, code: `${long} last${i}`, color: 'blue' }));
  const colourways = Array.from({ length: 3 }, (_, i) => ({ name: `C${i}`, swatches }));
  const { files } = await createSheet(model, { colourways }, { renderer, shot: CHEAP });
  const marks = swatches.flatMap((_, i) => [`first${i}`, `last${i}`]);
  assert.deepEqual(wordFaults(wordsOf(files[0]), marks), []);
});
