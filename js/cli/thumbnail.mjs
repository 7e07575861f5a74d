import path from 'node:path';
import { TelarError, worstExit } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { SHOWN_FORMATS } from '../shot/table/output.mjs';
import { isGoal } from '../shot/quality.mjs';
import { isAnimation, writeAnimation } from './animation.mjs';
import { removeUnfinished, sweepStale, writeFileAtomically } from '../api/atomic_file.mjs';
import { Drawing } from './draw_jobs.mjs';
import { faultyFile } from './faulty_file.mjs';
import { makeJobs } from './jobs.mjs';
import { maxFileBytes, readLimits, readTimeout, readWorkers } from './limits.mjs';
import { readManifest } from './manifest.mjs';
import { checkLayerFiles, layerFiles } from './layer_files.mjs';
import { findModels, readModel } from './models.mjs';
import { outputNames } from './output_names.mjs';
import { environmentOf, refuseOverwriting } from './overwritten.mjs';
import { readShotOptions } from './shot_options.mjs';
import { KnownPictures } from './unchanged.mjs';

/**
 * telar thumbnail MODEL... -o OUT
 * One image a model, or one for each of its variants and views. What fails does not stop the others; the exit code is the
 * highest of theirs. Everything that the command line says is checked before the first is drawn.
 * @param {string[]} models paths of models and folders, or - for stdin
 * @param {object} options as commander parsed them
 * @param {import('./console.mjs').Io & {api: object, console: import('./console.mjs').Console}} context
 * @returns {Promise<number>} exit code
 */
export async function thumbnail(models, options, context) {
  checkUsage(models, options);
  const limits = readLimits(options.limit);
  const timeoutMs = readTimeout(options.timeoutMs);
  readWorkers('--jobs', options.jobs);
  const unwanted = new AbortController();
  const signal = anyOf(context.signal, unwanted.signal);
  const how = { backend: options.backend, limits, failOn: options.failOn, ...visibilityOf(options), timeoutMs, signal };
  const found = options.manifest === undefined ? await findModels(models, options) : [];
  // The GL of this process opens, and a single model is loaded, beside what is read and checked. What that finds is told first. Other processes are started
  // after it.
  const begun = options.jobs === undefined ? context.api.beginRenderer(how) : undefined;
  begun?.opened.catch(() => unwanted.abort());
  const [{ model: source } = {}] = found;
  const ahead = begun && hasOnePicture(found, options) ? { source, load: begun.beginLoad(source, signal) } : undefined;
  const plan = await planned(found, options, limits, context).catch((error) => {
    unwanted.abort();
    // One that has opened already.
    begun?.renderer.close().catch(() => {});
    throw error;
  });
  const { renderer, opened } = begun ?? (await openPool(how, options, context));
  try {
    if (isAnimation(options)) {
      await opened;
      return await writeAnimation({ jobs: plan.jobs, options, renderer }, context);
    }
    const [gl, drawn] = await Promise.allSettled([opened, drawAll({ ...plan, ahead, options, renderer, limits }, { ...context, signal })]);
    // A GL that does not open fails every picture: it is told once.
    for (const { reason } of [gl, drawn]) if (reason) throw reason;
    const results = drawn.value;
    const sheet = await writeSheet(results, options, { limits, signal: context.signal });
    return await tell(results, { options, entries: plan.entries, sheet }, context.console);
  } finally {
    removeUnfinished();
    await renderer.close();
  }
}

/** What is drawn, and the files that it goes to. Animations have one, and check all else of it themselves. */
async function planned(found, options, limits, context) {
  const shot = await readShotOptions(options, context);
  const entries = await readEntries(found, options, shot, limits, context);
  const { jobs, crosses } = await makeJobs(entries, options, maxFileBytes(limits));
  const read = { inputs: inputsOf(jobs, options), models: jobs.map(({ model }) => model), maxBytes: maxFileBytes(limits) };
  if (isAnimation(options)) {
    await refuseOverwriting({ ...read, outputs: [{ file: options.output, what: '-o' }] });
    return { jobs };
  }
  const outputs = outputNames(options.output, jobs, crosses);
  checkLayerFiles(jobs, outputs);
  checkSheet(options.contactSheet, jobs, outputs);
  await refuseOverwriting({ ...read, outputs: writtenBy(jobs, outputs, options) });
  jobs.forEach((job, i) => {
    if (job.shot.output === undefined || typeof job.shot.output === 'object')
      job.shot = { ...job.shot, output: { ...job.shot.output, format: outputs[i].format } };
  });
  await Promise.all([...new Set(outputs.filter(({ file }) => file !== '-').map(({ file }) => path.dirname(file)))].map(sweepStale));
  return { entries, jobs, outputs };
}

/** What is read beside the models. */
const inputsOf = (jobs, { shot, manifest }) => [
  { file: shot, what: 'the shot' },
  { file: manifest, what: 'the manifest' },
  ...jobs.flatMap((job) => [{ file: job.shotFile, what: 'the shot' }, environmentOf(job.shot)]),
];

/** Every file that is written: pictures, their layers, a contact sheet. */
const writtenBy = (jobs, outputs, { contactSheet }) => [
  ...outputs.map(({ file }, i) => ({ file, what: jobs[i].output === undefined ? '-o' : `${jobs[i].where}: output` })),
  ...jobs.flatMap(({ shot }, i) => Object.entries(layerFiles(outputs[i].file, shot)).map(([layer, file]) => ({ file, what: `the layer ${layer}` }))),
  { file: contactSheet, what: '--contact-sheet' },
];

const anyOf = (...signals) => AbortSignal.any(signals.filter(Boolean));

/** Whether a single file is drawn, once, and whatever is there. */
const hasOnePicture = (found, { views, variants, turntable, explode, skipUnchanged }) =>
  found.length === 1 && found[0].model !== '-' && [views, variants, turntable, explode, skipUnchanged].every((option) => option === undefined);

/** How the models are loaded, and their keys made. */
const visibilityOf = ({ ambientVisibility }) => ambientVisibility && { ambientVisibility };

/** What draws with --jobs: a pool of other processes. */
async function openPool(how, options, { loadPool }) {
  const workers = readWorkers('--jobs', options.jobs);
  const { createPool } = await loadPool();
  return { renderer: await createPool({ ...how, ...(workers !== null && { size: workers }) }), opened: Promise.resolve() };
}

function checkUsage(models, { shot, output, json, manifest, skipUnchanged, explode }) {
  const usage = (message) => new TelarError('E_USAGE', message);
  if (explode !== undefined) {
    if (!(Number(explode) >= 0 && explode.trim() !== '' && Number.isFinite(Number(explode))))
      throw usage(`--explode: expected metres, 0 or more, got ${shown(explode)}`);
    if (skipUnchanged) throw usage('--explode and --skip-unchanged: give one of them');
  }
  if (manifest === undefined && models.length === 0) throw usage("missing required argument 'model': name models, a folder with -r, or a --manifest");
  if (manifest !== undefined && models.length > 0) throw usage('models and --manifest: give one of them');
  if (manifest === undefined && output === undefined) throw usage("required option '-o, --output <out>' not specified");
  const readers = [...models, shot, manifest].filter((file) => file === '-').length;
  if (readers > 1) throw usage('- (stdin) can stand for one file only');
  if (output === '-' && json) throw usage('-o - and --json both want stdout; give a file to -o');
  if (output === '-' && skipUnchanged) throw usage('-o - and --skip-unchanged: what went to stdout is not there to be compared; give a file to -o');
}

/** The models with their shots: of the manifest, or of the command line. */
async function readEntries(found, options, shot, limits, context) {
  if (options.manifest !== undefined) {
    const lines = await readManifest(options.manifest, context);
    return lines.map((line) => ({ ...line, source: line.model, shot: { ...shot, ...line.shot } }));
  }
  return Promise.all(
    found.map(async ({ model, folder }) => {
      const source = await readModel(model, limits, context);
      return { model, folder, source, shot };
    }),
  );
}

function checkSheet(sheet, jobs, outputs) {
  if (sheet === undefined) return;
  const usage = (message) => new TelarError('E_USAGE', `--contact-sheet ${shown(sheet)}: ${message}`);
  if (path.extname(sheet).toLowerCase() !== '.png') throw usage('expected a name that ends in .png');
  const hidden = outputs.find(({ file, format }) => file === '-' || !SHOWN_FORMATS.includes(format));
  if (hidden) throw usage(`it shows pictures in ${SHOWN_FORMATS.join(', ')} files, and one goes to ${hidden.file === '-' ? 'stdout' : shown(hidden.file)}`);
  const taken = [...outputs.map(({ file }) => file), ...jobs.map(({ model }) => model)].find((file) => path.resolve(file) === path.resolve(sheet));
  if (taken) throw usage('a picture or a model has this name');
}

/** Whether the path tracer draws it, or quality "high" or a goal lets it: the model decides. */
function mayBeTraced({ quality }) {
  const preset = quality?.preset ?? quality;
  return preset === 'reference' || preset === 'high' || isGoal(preset ?? {});
}

async function drawAll({ jobs, outputs, ahead, options, renderer, limits }, { api, console, signal }) {
  const gradual = jobs.some(({ shot }) => mayBeTraced(shot));
  const progress = await console.progress(jobs.length, { gradual });
  const known = options.skipUnchanged ? new KnownPictures(options.failOn) : undefined;
  const keyOf = (source, shot) => api.pictureKey(source, shot, { limits, ...visibilityOf(options), signal });
  try {
    const explode = options.explode === undefined ? undefined : Number(options.explode);
    const atOnce = renderer.workers?.length;
    const { reached } = options;
    const how = { explode, atOnce, reached, known, keyOf, progress, signal, toStdout: (bytes) => console.bytes(bytes) };
    return await new Drawing({ jobs, outputs, ahead, renderer, ...how }).run();
  } finally {
    progress.stop();
    await known?.save();
  }
}

async function writeSheet(results, { contactSheet: file, views }, { limits, signal }) {
  if (file === undefined || signal?.aborted) return undefined;
  const { contactSheet } = await import('./contact_sheet.mjs');
  const { itemsOf, groupOf } = await import('./sheet_items.mjs');
  await writeFileAtomically(file, await contactSheet(itemsOf(results), { group: groupOf(results, views), limits, signal }), signal);
  return file;
}

const resultJson = ({ job, file, layers, unchanged, key, bytes, info, error }, crossed) => ({
  model: job.model,
  ok: error === undefined,
  ...(crossed && { variant: job.variant, view: job.view }),
  ...(error ? { error } : { output: file }),
  ...(layers && { layers }),
  ...(unchanged && { unchanged, key }),
  ...(info && { bytes, info }),
});

async function tell(results, { options, entries, sheet }, console) {
  const crossed = options.views !== undefined || options.variants !== undefined || options.manifest !== undefined;
  tellFaults(results, console);
  const [drawn, unchanged] = [results.filter(({ info }) => info), results.filter((result) => result.unchanged)];
  const noun = results.length === entries.length && !crossed ? 'models' : 'pictures';
  if (results.length > 1) console.note(`${drawn.length} of ${results.length} ${noun} drawn${unchanged.length > 0 ? `, ${unchanged.length} unchanged` : ''}`);
  const exit = worstExit(results.map(({ error }) => error?.exit ?? 0));
  if (options.output !== '-') {
    const images = results.map((result) => resultJson(result, crossed));
    const lines = [...results.filter(({ error }) => !error).map(({ file }) => file), ...(sheet ? [sheet] : [])];
    await console.result({ ok: exit === 0, exit, ...(sheet && { contactSheet: sheet }), images }, lines);
  }
  return exit;
}

/** What several pictures of one model have in common is said once. */
function tellFaults(results, console) {
  const said = new Set();
  const once = (text, say) => {
    if (!said.has(text)) say();
    said.add(text);
  };
  for (const {
    job: { model, where, shot },
    error,
    info,
  } of results) {
    const at = (file) => (where === undefined ? file : `${where}: ${file}`);
    const about = at(model);
    const faulty = at(faultyFile(error, model, shot));
    if (error) once(`${faulty} ${error.code} ${error.message}`, () => console.error(error, faulty));
    for (const warning of info?.warnings ?? []) once(`${model} ${JSON.stringify(warning)}`, () => console.warning(warning, about));
  }
}
