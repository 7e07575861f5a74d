import path from 'node:path';
import { compareImages, encodePng, heatMap, htmlReport, judge, junitReport, readEmbeddedShot, readImage } from '../compare/index.mjs';
import { readFileBytes } from '../compare/files.mjs';
import { checkName, checkText, COLUMNS, number, regionRows, textTable } from '../compare/figures.mjs';
import { EXIT_OVER_THE_GATE } from '../error/table.mjs';
import { TelarError, toTelarError } from '../error/index.mjs';
import { differingKeys, drawShotOf, shotText } from './drawn_shot.mjs';
import { removeUnfinished, writeFileAtomically } from './atomic_file.mjs';
import { readLimits } from './limits.mjs';

/**
 * telar compare EXPECTED [ACTUAL]
 * Figures of the difference of two images, and whether they are within a gate. Tells the shots that they hold; without
 * ACTUAL, draws --model with EXPECTED's.
 * @param {string} expected path of a PNG, JPEG or WebP
 * @param {string | undefined} actual path
 * @param {object} options as commander parsed them
 * @param {import('./console.mjs').Io & {console: import('./console.mjs').Console, api: object}} context
 * @returns {Promise<number>} 0 within the gate, 1 over it
 */
export async function compare(expected, actual, options, { console, signal, api }) {
  if ((actual === undefined) === (options.model === undefined)) throw new TelarError('E_USAGE', 'expected either ACTUAL or --model MODEL');
  const context = { limits: readLimits(options.limit), signal, api };
  const first = await readNamed(expected, context);
  const second = actual ? await readNamed(actual, context) : { shot: null, image: await drawShotOf(expected, first.shot, options, context) };
  signal?.throwIfAborted();
  const images = [first.image, second.image];
  const shots = { expected: first.shot, actual: second.shot };
  const comparison = compareImages(...images);
  const verdict = judge(comparison, options.gate);
  const names = { expected, actual: actual ?? options.model };
  try {
    await writeReports({ names, images, comparison, verdict }, options, signal);
  } finally {
    removeUnfinished();
  }
  const exit = verdict.pass ? 0 : EXIT_OVER_THE_GATE;
  const { flipMap, ...figures } = comparison;
  await console.result({ ok: verdict.pass, exit, ...names, shots, ...verdict, ...figures }, [...(await shotLines(names, shots)), ...lines(comparison, verdict)]);
  return exit;
}

/** What the pictures say that they show. */
async function shotLines(names, shots) {
  const told = Object.keys(shots).filter((side) => shots[side]).map(async (side) => `${names[side]} shows ${await shotText(shots[side])}`);
  const differing = shots.expected && shots.actual ? differingKeys(shots.expected, shots.actual) : [];
  return [...(await Promise.all(told)), ...(differing.length ? [`the shots differ in ${differing.join(', ')}`] : [])];
}

/** The error with the file's name in front. */
function named(file, thrown) {
  const error = toTelarError(thrown);
  return new TelarError(error.code, error.code === 'E_FILE' ? error.message : `${file}: ${error.message}`, error);
}

/** A picture and the shot inside it, null where it holds none. */
async function readNamed(file, { limits, signal }) {
  try {
    const bytes = await readFileBytes(file, { limits, signal });
    return { image: await readImage(bytes, { limits, signal }), shot: readEmbeddedShot(bytes) };
  } catch (thrown) {
    throw named(file, thrown);
  }
}

async function writeReports({ names, images, comparison, verdict }, { heatmap, report, junit }, signal) {
  const map = heatmap || report ? await encodePng(heatMap(comparison), { signal }) : undefined;
  const name = `${path.basename(names.expected)} and ${path.basename(names.actual)}`;
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
  return [
    ...textTable([['', ...COLUMNS], ...regionRows(comparison)], [0]),
    `SSIM ${number(comparison.ssim)}`,
    ...verdict.checks.map((item) => `${item.pass ? 'within' : 'over  '}  ${checkName(item)} ${checkText(item)}`),
    `${verdict.pass ? 'within' : 'over'} the gate ${verdict.gate}`,
  ];
}
