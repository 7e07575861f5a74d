import path from 'node:path';
import {
  analyse as analyseAll,
  analysisPage,
  analysisSteps,
  dataUrls,
  FABRICS,
  fabricTargets,
  figuresOf,
  lightsOf,
  modelTargets,
  picturesOf,
  rankLines,
  swapsBetween,
  termLines,
} from '../analyse/index.mjs';
import { TelarError } from '../error/index.mjs';
import { ANY_MODEL } from '../shot/facts.mjs';
import { resolveShot } from '../shot/index.mjs';
import { BASES, resolveTerms, shadingName, SLOTS, termsBeside } from '../shot/shading_terms.mjs';
import { TONE_MAPPINGS } from '../shot/table/tone_mappings.mjs';
import { removeUnfinished, writeFileAtomically } from '../api/atomic_file.mjs';
import { readLimits, readTimeout } from './limits.mjs';
import { namesOf } from './name_list.mjs';
import { parseShading, parseSize, parseValue } from './shot_options.mjs';

/** Lights of an analysis unless others are named: one from all around, one lamp. */
const DEFAULT_LIGHTS = ['studio', 'sun'];

/** A shading in words: "three-r115 (sheen: zeltner)", "three@180". */
function nameOf(shading) {
  const terms = termsBeside(shading).map(([slot, term]) => `${slot}: ${term}`);
  return terms.length > 0 ? `${shadingName(shading)} (${terms.join(', ')})` : shadingName(shading);
}

/** Filmic as neutral is, and in every release. */
const IN_EVERY_RELEASE = 'aces';

/** The default tone mapping, or one that both releases have. */
function toneMappingOf(...shadings) {
  const isOlder = shadings.some(({ revision }) => revision < TONE_MAPPINGS.neutral.since);
  return isOlder ? { toneMapping: IN_EVERY_RELEASE } : {};
}

function planOf(models, options) {
  if (models.length > 0 && options.fabrics !== undefined) throw new TelarError('E_USAGE', '--fabrics are of the bundled drape: leave it out, or the models');
  const [from, to] = [parseShading(options.from, '--from'), parseShading(options.to, '--to')];
  const swaps = swapsBetween(from, to);
  const shot = { size: parseSize(options.size), quality: parseValue(options.quality), ...toneMappingOf(from, to) };
  const targets = models.length > 0 ? modelTargets(models) : fabricTargets(namesOf('fabrics', options.fabrics, FABRICS));
  // A wrong shot is told before anything is opened.
  resolveShot({ ...shot, camera: options.view === undefined ? {} : { view: options.view } }, ANY_MODEL);
  if (options.view !== undefined) for (const target of targets) target.shot = { ...target.shot, camera: { view: options.view } };
  return { names: { from: nameOf(from), to: nameOf(to) }, swaps, targets, lights: lightsOf(namesOf('lights', options.lights, DEFAULT_LIGHTS)), shot };
}

/**
 * telar analyse [MODEL...]
 * Swaps one term at a time between two shadings on fabrics and lights, and ranks which change the picture most.
 * @param {string[]} models paths; none = the bundled drape in --fabrics
 * @param {object} options as commander parsed them
 * @param {import('./console.mjs').Io & {console: import('./console.mjs').Console, api: object}} context
 * @returns {Promise<number>} exit code
 */
export async function analyse(models, options, { console, signal, api }) {
  if (options.terms) return tellTerms(console);
  const plan = planOf(models, options);
  const limits = readLimits(options.limit);
  const renderer = await api.createRenderer({ backend: options.backend, limits, timeoutMs: readTimeout(options.timeoutMs), signal });
  const progress = await console.progress(analysisSteps(plan));
  let analysis;
  try {
    analysis = await analyseAll(api, renderer, plan, { signal, step: (name) => progress.step(name) });
  } finally {
    progress.stop();
    await renderer.close();
  }
  for (const { target, warnings } of firstOfEach(analysis.cells)) for (const warning of warnings) console.warning(warning, target);
  const figures = figuresOf(analysis);
  const report = options.report === undefined ? undefined : await writeReport(options.report, analysis, figures, signal);
  await console.result({ ok: true, exit: 0, ...(report && { report }), ...figures }, [...rankLines(analysis), ...(report ? ['', report] : [])]);
  return 0;
}

/** A cell of each target. */
const firstOfEach = (cells) => cells.filter(({ target }, i) => cells.findIndex((cell) => cell.target === target) === i);

/** DIR/index.html, which needs no other file, and DIR/analysis.json. */
async function writeReport(folder, analysis, figures, signal) {
  const sources = [];
  for (const cell of analysis.cells) sources.push(dataUrls(await picturesOf(cell, { signal })));
  const page = path.join(folder, 'index.html');
  try {
    await writeFileAtomically(path.join(folder, 'analysis.json'), Buffer.from(`${JSON.stringify(figures, null, 1)}\n`), signal);
    await writeFileAtomically(page, Buffer.from(analysisPage(analysis, sources)), signal);
  } finally {
    removeUnfinished();
  }
  return page;
}

async function tellTerms(console) {
  const shadings = Object.fromEntries(BASES.map((base) => [base, resolveTerms(base)]));
  await console.result({ ok: true, exit: 0, slots: SLOTS, shadings }, termLines(SLOTS, shadings));
  return 0;
}
