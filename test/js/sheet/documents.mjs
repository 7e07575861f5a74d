// What is wrong with a whole document: boxes as they were laid out, and words as a PDF reader finds them.
// node test/js/sheet/documents.mjs 500 [FIRST]      lays out so many random documents and says what is wrong with each
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import '../api/support/real.mjs';
import { createSheet } from '../../../js/sheet/index.mjs';
import { layOut } from '../../../js/sheet/sheet.mjs';
import { crosses, grown, isWithin, overlaps, passes, segmentsOf } from '../../../js/sheet/place/geometry.mjs';
import { randomSpec } from './random_specs.mjs';
import { CHEAP, openSquare } from './square.mjs';

/** Hebrew and Arabic; Chinese, Japanese and Korean (js/machine/debian_packages.txt). */
const FONTS = ['/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf', '/usr/share/fonts/truetype/droid/DroidSansFallbackFull.ttf'];
export const fonts = () => FONTS.map((file) => readFileSync(file));

/** Faults of a figure. */
export function figureFaults({ width, height, pictures, labels, codes, captions, lines, sites }) {
  const paper = { x: 0, y: 0, width, height };
  const faults = [];
  const leaders = lines.filter(({ kind }) => kind === 'leader');
  for (const picture of pictures) if (!isWithin(picture, grown(paper, 0.01))) faults.push('a picture leaves its page');
  const boxes = [...labels.map((label) => ({ ...label, name: `call-out ${label.number}` })), ...codes.map((code) => ({ ...code, name: `code ${code.code}` }))];
  boxes.forEach((box, i) => {
    if (!isWithin(box, paper)) faults.push(`${box.name} leaves its page`);
    for (const other of boxes.slice(i + 1)) if (overlaps(box, other)) faults.push(`${box.name} lies on ${other.name}`);
    if (i < labels.length && pictures.some((picture) => overlaps(box, picture))) faults.push(`${box.name} lies on a picture`);
  });
  leaders.forEach(({ points }, i) => {
    const segments = segmentsOf(points);
    for (const other of leaders.slice(i + 1))
      if (segments.some((a) => segmentsOf(other.points).some((b) => crosses(a, b)))) faults.push(`leader ${i} crosses another`);
    if (labels.some((label) => segments.some((segment) => passes(segment, label)))) faults.push(`leader ${i} strikes a text`);
  });
  for (const { points } of lines)
    for (const [x, y] of points) if (x < -0.01 || y < -0.01 || x > width + 0.01 || y > height + 0.01) faults.push('a line leaves its page');
  for (const [x, y] of sites) if (!pictures.some((picture) => isWithin({ x, y, width: 0, height: 0 }, picture))) faults.push('a site lies off its picture');
  for (const caption of captions) if (caption.y > height) faults.push('a caption leaves its page');
  return faults;
}

/** Faults of the sections as the template gets them. */
export function layoutFaults({ sections, layout }) {
  const figures = sections.flatMap(({ figure }) => (figure ? [figure] : []));
  const faults = figures.flatMap(figureFaults);
  const numbers = figures.flatMap(({ labels }) => labels.map(({ number }) => Number(number))).sort((a, b) => a - b);
  if (numbers.join() !== layout.spec.callouts.map((_, i) => i + 1).join()) faults.push(`call-outs are lost: ${numbers}`);
  const codes = figures.flatMap((figure) => figure.codes.map(({ code }) => code));
  const told = layout.warnings.filter(({ code }) => code === 'W_SHEET_FIT').map(({ pointer }) => layout.spec.measures[Number(pointer.split('/')[2])].code);
  const wanted = layout.spec.measures.filter(({ points }) => points).map(({ code }) => code);
  if ([...codes, ...told].sort().join('\n') !== wanted.sort().join('\n')) faults.push('points of measure are lost');
  return faults;
}

/** Words of a PDF with their boxes, by page: poppler. @returns {{width: number, height: number, words: {x: number, y: number, width: number, height: number, text: string}[]}[]} points */
export function wordsOf(pdf) {
  const folder = mkdtempSync(path.join(tmpdir(), 'telar-words-'));
  try {
    writeFileSync(path.join(folder, 'a.pdf'), pdf);
    const text = execFileSync('pdftotext', ['-bbox', 'a.pdf', '-'], { cwd: folder, encoding: 'utf8', maxBuffer: 2 ** 28 });
    return [...text.matchAll(/<page width="([\d.]+)" height="([\d.]+)">([\s\S]*?)<\/page>/g)].map(([, width, height, inner]) => ({
      width: Number(width),
      height: Number(height),
      words: [...inner.matchAll(/<word xMin="([-\d.]+)" yMin="([-\d.]+)" xMax="([-\d.]+)" yMax="([-\d.]+)">([\s\S]*?)<\/word>/g)].map(([, ...values]) => {
        const [x, y, right, bottom] = values.slice(0, 4).map(Number);
        return { x, y, width: right - x, height: bottom - y, text: values[4] };
      }),
    }));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** Poppler's boxes are as high as a font's ascent and descent, which lines of one paragraph share: letters fill their middle. */
const inked = ({ x, y, width, height }) => ({ x: x + 0.3, y: y + 0.3 * height, width: Math.max(0, width - 0.6), height: 0.4 * height });

/** Least distance from words to the edge of the paper: half of the margin, points. */
const EDGE = 17;

/** Faults of the words of a document. @param {string[]} told words that it must show */
export function wordFaults(pages, told) {
  const faults = [];
  for (const [i, { width, height, words }] of pages.entries()) {
    const paper = { x: EDGE, y: EDGE, width: width - 2 * EDGE, height: height - 2 * EDGE };
    const boxes = words.filter(({ text }) => text.replaceAll('\u200b', '') !== '').map((word) => ({ ...inked(word), text: word.text }));
    for (const box of boxes) if (!isWithin(box, paper)) faults.push(`page ${i + 1}: ${JSON.stringify(box.text)} leaves the page`);
    const rows = [...boxes].sort((a, b) => a.y - b.y);
    rows.forEach((box, k) => {
      for (let m = k + 1; m < rows.length && rows[m].y < box.y + box.height; ++m)
        if (overlaps(box, rows[m])) faults.push(`page ${i + 1}: ${JSON.stringify(box.text)} lies on ${JSON.stringify(rows[m].text)}`);
    });
  }
  const all = pages
    .flatMap(({ words }) => words.map(({ text }) => text))
    .join('')
    .replaceAll(/[\s\u200b-\u200f\u202a-\u202e\u2066-\u2069\u00ad-]/g, '');
  for (const mark of told) if (!all.includes(mark)) faults.push(`${mark} is lost`);
  return faults;
}

/** All faults of a document. */
export async function faultsOf(renderer, model, { spec, told }) {
  const settings = { renderer, shot: CHEAP, fonts: fonts() };
  const laid = await layOut(model, spec, { format: 'pdf', templates: {}, ...settings });
  laid.engine.close();
  const { files } = await createSheet(model, spec, settings);
  return [...layoutFaults(laid), ...wordFaults(wordsOf(files[0]), told)];
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [count, first] = [Number(process.argv[2] ?? 500), Number(process.argv[3] ?? 1)];
  const { renderer, model } = await openSquare();
  try {
    let wrong = 0;
    for (let seed = first; seed < first + count; ++seed) {
      const faults = await faultsOf(renderer, model, randomSpec(seed)).catch((error) => [error.stack]);
      if (faults.length === 0) continue;
      wrong += 1;
      console.log(`seed ${seed}: ${faults.length} faults\n  ${faults.slice(0, 6).join('\n  ')}`);
    }
    console.log(`${wrong} of ${count} documents are wrong`);
    process.exitCode = wrong > 0 ? 1 : 0;
  } finally {
    await renderer.close();
  }
}
