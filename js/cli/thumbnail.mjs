import path from 'node:path';
import { TelarError, toTelarError, worstExit } from '../error/index.mjs';
import { ANY_MODEL } from '../shot/facts.mjs';
import { removeUnfinished, sweepStale, writeFileAtomically } from './atomic_file.mjs';
import { outputNames } from './output_names.mjs';
import { readShotOptions } from './shot_options.mjs';
import { maxFileBytes, readLimits } from './limits.mjs';
import { readAll } from './streams.mjs';

/** Models on their way at once; the renderer draws one at a time, loading and encoding run beside it. */
const IN_FLIGHT = 4;

/**
 * telar thumbnail MODEL... -o OUT
 * One image a model. A model that fails does not stop the others; the exit code is the highest of theirs.
 * @param {string[]} models paths, or - for stdin
 * @param {object} options as commander parsed them
 * @param {import('./console.mjs').Io & {api: object, console: import('./console.mjs').Console}} context
 * @returns {Promise<number>} exit code
 */
export async function thumbnail(models, options, context) {
  refuseSharedStdin(models, options);
  const shot = await readShotOptions(options, context);
  const { format, files } = outputNames(options.output, models, shot.output?.format);
  const limits = readLimits(options.limit);
  await checkShot(shot);
  if (shot.output === undefined || typeof shot.output === 'object') shot.output = { ...shot.output, format };
  await Promise.all([...new Set(files.filter((file) => file !== '-').map((file) => path.dirname(file)))].map(sweepStale));

  const renderer = await context.api.createRenderer({ backend: options.backend, limits, signal: context.signal });
  try {
    return await drawAll(models, files, { ...context, options, renderer, shot, limits });
  } finally {
    await renderer.close();
  }
}

function refuseSharedStdin(models, { shot, output, json }) {
  const readers = models.filter((model) => model === '-').length + (shot === '-' ? 1 : 0);
  if (readers > 1) throw new TelarError('E_USAGE', '- (stdin) can stand for one file only');
  if (output === '-' && json) throw new TelarError('E_USAGE', '-o - and --json both want stdout; give a file to -o');
}

/** Tells a wrong shot once and early, not once for each model. What depends on the model is left to its own turn. */
async function checkShot(shot) {
  const { resolveShot } = await import('../shot/index.mjs');
  try {
    resolveShot(shot, ANY_MODEL);
  } catch (error) {
    if (error.code === 'E_SHOT' || error.code === 'E_SHOT_UNAVAILABLE') throw error;
  }
}

async function drawAll(models, files, context) {
  const { console, signal, options, shot } = context;
  const gradual = (shot.quality?.preset ?? shot.quality) === 'reference';
  const progress = await console.progress(models.length, { gradual });
  const images = new Array(models.length);
  const next = models.entries();
  const work = async () => {
    for (const [index, model] of next) {
      const onProgress = progress.reach && ((part) => progress.reach(index, part));
      images[index] = await drawOne(model, files[index], { ...context, onProgress });
      progress.step(model, index);
      if (signal?.aborted) return;
    }
  };
  try {
    await Promise.all(Array.from({ length: Math.min(IN_FLIGHT, models.length) }, work));
  } finally {
    progress.stop();
    removeUnfinished();
  }
  return tell(images.filter(Boolean), options, console);
}

async function drawOne(model, file, { console, signal, stdin, renderer, shot, limits, onProgress }) {
  try {
    const source = model === '-' ? await readAll(stdin, maxFileBytes(limits), signal) : model;
    const { data, info } = await renderer.render(source, shot, { signal, onProgress });
    if (file === '-') await console.bytes(data);
    else await writeFileAtomically(file, data, signal);
    return { model, ok: true, output: file, bytes: data.length, info };
  } catch (thrown) {
    return { model, ok: false, error: toTelarError(thrown) };
  }
}

async function tell(images, { output }, console) {
  for (const { model, error, info } of images) {
    if (error) console.error(error, model);
    for (const warning of info?.warnings ?? []) console.warning(warning, model);
  }
  const drawn = images.filter(({ ok }) => ok);
  if (images.length > 1) console.note(`${drawn.length} of ${images.length} models drawn`);
  const exit = worstExit(images.map(({ error }) => error?.exit ?? 0));
  if (output !== '-') await console.result({ ok: exit === 0, exit, images }, drawn.map((image) => image.output));
  return exit;
}
