import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { setTimeout as wait } from 'node:timers/promises';
import { chromium } from 'playwright-core';
import '../api/support/real.mjs';
import { readImage, shrinkImage } from '../../../js/compare/index.mjs';
import { createRenderer } from '../../../js/index.mjs';
import { sheetOf } from './examples.mjs';
import { judgedFolder } from './judged_folder.mjs';

/** A sheet in two readers that share no code: poppler, and PDFium in Chromium. */

const { folder, run } = judgedFolder('readers');
let browser;
before(async () => {
  const renderer = await createRenderer();
  try {
    writeFileSync(path.join(folder, 'skirt.pdf'), (await sheetOf(renderer, 'skirt', 'pdf', { ppi: 100 })).files[0]);
  } finally {
    await renderer.close();
  }
  // The headless shell has no viewer; the browser's own headless mode has one.
  browser = await chromium.launch({
    executablePath: process.env.TELAR_CHROMIUM ?? '/usr/bin/chromium',
    headless: false,
    args: ['--headless=new', '--no-sandbox', '--no-first-run', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  });
});
after(() => browser?.close());

/** The white paper on the viewer's dark ground; undefined where there is none yet. */
function paperOf({ width, height, data }) {
  const isWhite = (x, y) => data[4 * (y * width + x)] > 250;
  const row = Math.round(height / 2);
  const columns = Array.from({ length: width }, (_, x) => x).filter((x) => isWhite(x, row));
  if (columns.length < width / 2) return undefined;
  const [left, right] = [columns[0], columns.findLast((x) => x < width - 20)];
  // Beneath and above it other pages may show.
  let [top, bottom] = [row, row];
  while (top > 0 && isWhite(left + 8, top - 1)) top -= 1;
  while (bottom < height - 1 && isWhite(left + 8, bottom + 1)) bottom += 1;
  return { left, top, width: right - left + 1, height: bottom - top + 1 };
}

/** A page as Chromium shows it, the paper alone; for as long as it is not `isShown` the viewer may still be on its way to it. */
async function inChromium(page, isShown) {
  let last;
  const tab = await browser.newPage({ viewport: { width: 900, height: 640 } });
  try {
    await tab.goto(`file://${folder}/skirt.pdf#toolbar=0&navpanes=0&view=Fit&page=${page}`);
    for (let tries = 0; tries < 60; ++tries) {
      await wait(500);
      const shown = await readImage(await tab.screenshot());
      const paper = paperOf(shown);
      if (!paper) continue;
      const data = new Uint8Array(4 * paper.width * paper.height);
      for (let y = 0; y < paper.height; ++y) {
        const from = 4 * ((y + paper.top) * shown.width + paper.left);
        data.set(shown.data.subarray(from, from + 4 * paper.width), 4 * y * paper.width);
      }
      last = { width: paper.width, height: paper.height, data };
      if (isShown(last)) return last;
    }
    assert.ok(last, 'Chromium shows no page');
    return last;
  } finally {
    await tab.close();
  }
}

async function inPoppler(page) {
  run('pdftoppm', '-r', '150', '-f', String(page), '-l', String(page), '-png', '-singlefile', 'skirt.pdf', 'page');
  return readImage(readFileSync(path.join(folder, 'page.png')));
}

/** Mean difference of two pictures over a grid of cells that letters and lines fill as grey, 0 to 255. */
function difference(a, b) {
  const size = { width: 120, height: 85 };
  const [p, q] = [a, b].map((image) => shrinkImage(image, size).data);
  return p.reduce((sum, value, i) => sum + Math.abs(value - q[i]), 0) / p.length;
}

/** Most that the way in which the readers draw lines and letters makes of a page. */
const READERS_DIFFER = 2.5;

test('poppler and Chromium show the same pages', async () => {
  const pages = [1, 2, 8];
  const [seen, expected] = [[], []];
  for (const page of pages) {
    const wanted = await inPoppler(page);
    expected.push(wanted);
    seen.push(await inChromium(page, (image) => difference(image, wanted) < READERS_DIFFER));
  }
  const off = seen.map((image, i) => difference(image, expected[i]));
  // Another page is many times farther off.
  const planted = difference(seen[0], expected[1]);
  assert.ok(
    off.every((value) => value < READERS_DIFFER),
    `${off}, another page ${planted}`,
  );
  assert.ok(planted > 5, `${planted}`);
});

test('qpdf finds nothing wrong, and text comes in the order of reading', () => {
  assert.doesNotMatch(run('qpdf', '--check', 'skirt.pdf'), /WARNING|ERROR/);
  const text = run('pdftotext', '-raw', '-f', '1', '-l', '3', 'skirt.pdf', '-').replaceAll(/\s+/g, ' ');
  const order = ['Pleated skirt', 'Knee-length skirt', 'Bottle', 'Flats', 'Construction', 'Straight waistband', 'Knife pleats', 'Hem 30 mm'];
  const places = order.map((words) => text.indexOf(words));
  assert.ok(
    places.every((place, i) => place >= 0 && (i === 0 || place > places[i - 1])),
    `${places}`,
  );
  // A damaged file is found.
  const bytes = readFileSync(path.join(folder, 'skirt.pdf'));
  writeFileSync(path.join(folder, 'cut.pdf'), bytes.subarray(0, bytes.length - 900));
  assert.throws(() => run('qpdf', '--check', 'cut.pdf'));
});
