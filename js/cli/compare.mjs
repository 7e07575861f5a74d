import { stat } from 'node:fs/promises';
import path from 'node:path';
import { encodePng, foldersReport, heatMap, htmlReport, junitReport } from '../compare/index.mjs';
import { checkName, checkText, COLUMNS, number, regionRows, textTable } from '../compare/figures.mjs';
import { EXIT_OVER_THE_GATE } from '../error/table.mjs';
import { TelarError } from '../error/index.mjs';
import { differingKeys, openShotOf, shotText } from './drawn_shot.mjs';
import { removeUnfinished, writeFileAtomically } from '../api/atomic_file.mjs';
import { maskFiles, maskReader, readThresholds } from './compare_options.mjs';
import { atOneSize, comparePair, readPicture } from './compare_pair.mjs';
import { maxFileBytes, readLimits } from './limits.mjs';
import { environmentOf, refuseOverwriting } from './overwritten.mjs';
import { releaseHints } from './release_hint.mjs';
import { withPathsFrom } from './shot_options.mjs';

/**
 * telar compare EXPECTED [ACTUAL]
 * Figures of the difference of two images, or of all images in two folders, and whether they are within a gate. Tells the
 * shots that two images hold; without ACTUAL, draws --model with EXPECTED's.
 * @param {string} expected path of a PNG, JPEG or WebP, or of a folder of such
 * @param {string | undefined} actual path
 * @param {object} options as commander parsed them
 * @param {import('./console.mjs').Io & {console: import('./console.mjs').Console, api: object}} context
 * @returns {Promise<number>} 0 within the gate, 1 over it
 */
export async function compare(expected, actual, options, { console, signal, api }) {
  checkUsage(actual, options);
  const context = { limits: readLimits(options.limit), signal, api, console };
  const settings = { gate: options.gate, limits: readThresholds(options.threshold), resize: options.resize };
  const masks = maskReader(options, { limits: context.limits, signal });
  const kinds = [await kindOf(expected), actual === undefined ? 'none' : await kindOf(actual)];
  const isNew = options.update === true && kinds[0] === 'missing';
  try {
    if ((kinds[0] === 'folder' || isNew) && kinds[1] === 'folder') {
      const { compareFolders } = await import('./compare_folders.mjs');
      return await compareFolders({ expected, actual }, options, { ...context, settings, masks, isNew });
    }
    refuseHalves(kinds, [expected, actual ?? options.model], options);
    if (isNew) return await acceptNew({ expected, actual }, options, { ...context, settings });
    return await compareFiles({ expected, actual }, options, { ...context, settings: { ...settings, masksOf: masks() } });
  } finally {
    removeUnfinished();
  }
}

/** "folder", "missing", or "file" for whatever else it is. */
const kindOf = (file) =>
  stat(file).then(
    (found) => (found.isDirectory() ? 'folder' : 'file'),
    ({ code }) => (code === 'ENOENT' ? 'missing' : 'file'),
  );

const usage = (message) => new TelarError('E_USAGE', message);

/** What goes with --model, and what does not, of images and of folders. */
function checkUsage(actual, { model, update, explain, environment }) {
  if ((actual === undefined) === (model === undefined)) throw usage('expected either ACTUAL or --model MODEL');
  if (update && model !== undefined) throw usage('--update accepts ACTUAL; with --model, write the image with telar thumbnail');
  if (explain && model === undefined) throw usage('--explain draws the shot of EXPECTED again: it goes with --model');
  if (environment !== undefined && model === undefined) throw usage('--environment goes with --model');
}

function refuseHalves(kinds, names, { model }) {
  const folder = kinds.indexOf('folder');
  if (folder === 0 && model !== undefined) throw usage(`${names[0]} is a folder: --model draws the shot of one image`);
  if (folder >= 0) throw usage(`${names[folder]} is a folder and ${names[1 - folder]} is not: give two images or two folders`);
}

/** --update where EXPECTED is not there: ACTUAL must be an image, and becomes it. There is nothing to compare, and no heat map. */
async function acceptNew({ expected, actual }, options, context) {
  const { report, junit } = options;
  const { signal, console, settings } = context;
  await refuseOver({ expected, actual }, options, context);
  const { bytes, image, shot } = await readPicture(actual, context);
  await writeFileAtomically(expected, bytes, signal);
  const accepted = { name: path.basename(expected), status: 'updated', files: { actual: 'actual.png' } };
  if (report) {
    await writeFileAtomically(path.join(report, 'actual.png'), await encodePng(image, { signal }), signal);
    await writeFileAtomically(path.join(report, 'index.html'), Buffer.from(foldersReport([accepted], { title: accepted.name, gate: settings.gate })), signal);
  }
  await writeJunit(accepted, { junit }, signal);
  const shots = { expected: null, actual: shot };
  const result = { ok: true, exit: 0, expected, actual, shots, gate: settings.gate, pass: true, checks: [], hints: [], updated: true };
  await console.result(result, [...(await shotLines({ expected, actual }, shots)), acceptedLine({ expected, actual })]);
  return 0;
}

/** Pictures, and what else is read, are not what is written. EXPECTED is both where it is accepted. @throws {TelarError} E_USAGE */
async function refuseOver({ expected, actual }, options, { limits }, shot = {}) {
  const { model, environment, heatmap, report, junit } = options;
  const pages = report ? ['expected.png', 'actual.png', 'heatmap.png', 'index.html'].map((name) => path.join(report, name)) : [];
  // One map of one comparison, wherever it is written.
  const isTwice = heatmap !== undefined && pages.some((page) => path.resolve(page) === path.resolve(heatmap) && path.basename(page) === 'heatmap.png');
  await refuseOverwriting({
    inputs: [
      { file: expected, what: 'EXPECTED' },
      { file: actual, what: 'ACTUAL' },
      ...maskFiles(options),
      ...(model === undefined ? [] : [environment === undefined ? environmentOf(shot) : { file: environment, what: 'the environment' }]),
    ],
    models: model === undefined ? [] : [model],
    outputs: [
      { file: isTwice ? undefined : heatmap, what: '--heatmap' },
      ...pages.map((file) => ({ file, what: '--report' })),
      { file: junit, what: '--junit' },
    ],
    maxBytes: maxFileBytes(limits),
  });
}

const acceptedLine = ({ expected, actual }) => `accepted: ${expected} is now ${actual}`;

async function compareFiles({ expected, actual }, options, context) {
  const first = await readPicture(expected, context);
  await refuseOver({ expected, actual }, options, context, first.shot ? withPathsFrom(path.dirname(expected), first.shot) : {});
  const drawn = actual ? undefined : await openShotOf(expected, first.shot, options, context);
  try {
    return await compareWith({ expected, actual, first, drawn }, options, context);
  } finally {
    await drawn?.close();
  }
}

/** Why the pictures differ, as far as pictures and, where the model is at hand, other releases of three.js tell. */
async function hintsOf({ first, drawn, found }, { explain, resize }) {
  if (found.verdict.pass || !drawn) return found.hints;
  const [expected] = found.images;
  const draw = async (shading) => atOneSize(expected, await drawn.draw(shading), resize)[1];
  return [...found.hints, ...(await releaseHints({ expected, shot: first.shot, draw, explain }))];
}

async function compareWith({ expected, actual, first, drawn }, options, context) {
  const { signal, console, settings } = context;
  const second = drawn ? { shot: null, image: await drawn.draw() } : await readPicture(actual, context);
  signal?.throwIfAborted();
  const shots = { expected: first.shot, actual: second.shot };
  const found = await comparePair({ expected: first.image, actual: second.image }, settings);
  const { images, comparison, verdict } = found;
  const hints = await hintsOf({ first, drawn, found }, options);
  const names = { expected, actual: actual ?? options.model };
  await writeReports({ names, images, comparison, verdict, hints }, options, signal);
  const updated = options.update && !verdict.pass;
  if (updated) await writeFileAtomically(expected, second.bytes, signal);
  await writeJunit({ name: titleOf(names), verdict, hints, ...(updated && { status: 'updated' }) }, options, signal);
  const exit = verdict.pass || updated ? 0 : EXIT_OVER_THE_GATE;
  const { flipMap, ...figures } = comparison;
  await console.result({ ok: exit === 0, exit, ...names, shots, ...verdict, hints, ...(options.update && { updated }), ...figures }, [
    ...(await shotLines(names, shots)),
    ...lines(comparison, verdict, hints),
    ...(updated ? [acceptedLine(names)] : []),
  ]);
  return exit;
}

/** What the pictures say that they show. */
async function shotLines(names, shots) {
  const told = Object.keys(shots)
    .filter((side) => shots[side])
    .map(async (side) => `${names[side]} shows ${await shotText(shots[side])}`);
  const differing = shots.expected && shots.actual ? differingKeys(shots.expected, shots.actual) : [];
  return [...(await Promise.all(told)), ...(differing.length ? [`the shots differ in ${differing.join(', ')}`] : [])];
}

const titleOf = ({ expected, actual }) => `${path.basename(expected)} and ${path.basename(actual)}`;

async function writeReports({ names, images, comparison, verdict, hints }, { heatmap, report }, signal) {
  const map = heatmap || report ? await encodePng(heatMap(comparison), { signal }) : undefined;
  if (heatmap) await writeFileAtomically(heatmap, map, signal);
  if (report) {
    const pictures = await Promise.all(images.map((image) => encodePng(image, { signal })));
    const page = htmlReport(comparison, verdict, { expected: 'expected.png', actual: 'actual.png', heatMap: 'heatmap.png', title: titleOf(names), hints });
    const files = { 'expected.png': pictures[0], 'actual.png': pictures[1], 'heatmap.png': map, 'index.html': Buffer.from(page) };
    for (const [file, data] of Object.entries(files)) await writeFileAtomically(path.join(report, file), data, signal);
  }
}

async function writeJunit(compared, { junit }, signal) {
  if (junit) await writeFileAtomically(junit, Buffer.from(junitReport([compared])), signal);
}

function lines(comparison, verdict, hints) {
  return [
    ...textTable([['', ...COLUMNS], ...regionRows(comparison)], [0]),
    `SSIM ${number(comparison.ssim)}`,
    ...verdict.checks.map((item) => `${item.pass ? 'within' : 'over  '}  ${checkName(item)} ${checkText(item)}`),
    ...hints.map(({ message }) => `hint    ${message}`),
    `${verdict.pass ? 'within' : 'over'} the gate ${verdict.gate}`,
  ];
}
