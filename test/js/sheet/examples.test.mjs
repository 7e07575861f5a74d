import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import '../api/support/real.mjs';
import { compareImages, judge, readImage } from '../../../js/compare/index.mjs';
import { createRenderer } from '../../../js/index.mjs';
import { EXAMPLES, goldenFile, smallPages } from './examples.mjs';

let renderer;
before(async () => {
  renderer = await createRenderer();
});
after(() => renderer.close());

/**
 * Pictures come of a GL, whose releases differ by some steps of 1/255 in places; lines and letters do not, and one that moves by a pixel of
 * a golden page is 10 or more off there.
 */
const LIMITS = { 'frame.deltaE.max': 8, 'frame.deltaE.mean': 0.1 };

/** Pages that are the same to the byte, as those of one GL are, need no figures. */
const isAsGolden = (golden, page) =>
  (golden.width === page.width && golden.height === page.height && Buffer.compare(golden.data, page.data) === 0) ||
  judge(compareImages(golden, page), 'draft', LIMITS).pass;

/** Pages that are not as their golden ones. */
async function faultsOf(name, pages) {
  const faults = [];
  for (const [i, page] of pages.entries()) {
    const file = goldenFile(name, i);
    if (!existsSync(file)) faults.push(`${name}: page ${i + 1} is new`);
    else if (!isAsGolden(await readImage(readFileSync(file)), page)) faults.push(`${name}: page ${i + 1} is another`);
  }
  if (existsSync(goldenFile(name, pages.length))) faults.push(`${name}: page ${pages.length + 1} is missing`);
  return faults;
}

for (const name of Object.keys(EXAMPLES))
  test(`the pages of the example ${name} are the golden ones: node test/js/sheet/examples.mjs --golden writes them anew`, async () => {
    const { pages, info } = await smallPages(renderer, name);
    assert.deepEqual(await faultsOf(name, pages), []);
    // The example fits its model: nothing is told of it.
    assert.deepEqual(info.warnings, []);
    assert.ok(info.measures.length >= 5);
  });

test('planted: another word, another page', async () => {
  const { pages } = await smallPages(renderer, 'skirt', { notes: 'Send two pleating trials.', revisions: [] });
  const faults = await faultsOf('skirt', pages);
  assert.ok(faults.length >= 1, 'seen');
});
