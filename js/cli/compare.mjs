import path from 'node:path';
import { compareImages, encodePng, heatMap, htmlReport, judge, junitReport, readImage } from '../compare/index.mjs';
import { checkName, checkText, COLUMNS, number, regionRows } from '../compare/figures.mjs';
import { EXIT_OVER_THE_GATE } from '../error/table.mjs';
import { TelarError, toTelarError } from '../error/index.mjs';
import { removeUnfinished, writeFileAtomically } from './atomic_file.mjs';
import { readLimits } from './limits.mjs';

/**
 * telar compare EXPECTED ACTUAL
 * Figures of the difference of two images, and whether they are within a gate.
 * @param {string} expected path of a PNG, JPEG or WebP
 * @param {string} actual path
 * @param {object} options as commander parsed them
 * @param {import('./console.mjs').Io & {console: import('./console.mjs').Console}} context
 * @returns {Promise<number>} 0 within the gate, 1 over it
 */
export async function compare(expected, actual, options, { console, signal }) {
  const limits = readLimits(options.limit);
  const images = [await readNamed(expected, { limits, signal }), await readNamed(actual, { limits, signal })];
  signal?.throwIfAborted();
  const comparison = compareImages(...images);
  const verdict = judge(comparison, options.gate);
  try {
    await writeReports({ expected, actual, images, comparison, verdict }, options, signal);
  } finally {
    removeUnfinished();
  }
  const exit = verdict.pass ? 0 : EXIT_OVER_THE_GATE;
  const { flipMap, ...figures } = comparison;
  await console.result({ ok: verdict.pass, exit, expected, actual, ...verdict, ...figures }, lines(comparison, verdict));
  return exit;
}

/** @throws {TelarError} with the file's name in front */
async function readNamed(file, options) {
  try {
    return await readImage(file, options);
  } catch (thrown) {
    const error = toTelarError(thrown);
    throw new TelarError(error.code, error.code === 'E_FILE' ? error.message : `${file}: ${error.message}`, error);
  }
}

async function writeReports({ expected, actual, images, comparison, verdict }, { heatmap, report, junit }, signal) {
  const map = heatmap || report ? await encodePng(heatMap(comparison), { signal }) : undefined;
  const name = `${path.basename(expected)} and ${path.basename(actual)}`;
  if (heatmap) await writeFileAtomically(heatmap, map, signal);
  if (report) {
    const pictures = await Promise.all(images.map((image) => encodePng(image, { signal })));
    const page = htmlReport(comparison, verdict, { expected: 'expected.png', actual: 'actual.png', heatMap: 'heatmap.png', title: name });
    const files = { 'expected.png': pictures[0], 'actual.png': pictures[1], 'heatmap.png': map, 'index.html': Buffer.from(page) };
    for (const [file, data] of Object.entries(files)) await writeFileAtomically(path.join(report, file), data, signal);
  }
  if (junit) await writeFileAtomically(junit, Buffer.from(junitReport([{ name, verdict }])), signal);
}

function lines(comparison, verdict) {
  const table = [['', ...COLUMNS], ...regionRows(comparison)];
  const widths = table[0].map((_, column) => Math.max(...table.map((row) => row[column].length)));
  return [
    ...table.map((row) => row.map((cell, i) => (i === 0 ? cell.padEnd(widths[i]) : cell.padStart(widths[i]))).join('  ')),
    `SSIM ${number(comparison.ssim)}`,
    ...verdict.checks.map((item) => `${item.pass ? 'within' : 'over  '}  ${checkName(item)} ${checkText(item)}`),
    `${verdict.pass ? 'within' : 'over'} the gate ${verdict.gate}`,
  ];
}
