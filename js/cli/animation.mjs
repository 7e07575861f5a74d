import path from 'node:path';
import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { writeFileAtomically } from '../api/atomic_file.mjs';

/** A turntable in one animated file. */

const usage = (message) => new TelarError('E_USAGE', message);

/** Whether the frames of a turntable go into one file: -o names one, and not a pattern. */
export const isAnimation = ({ turntable, output }) =>
  turntable !== undefined && output !== undefined && path.extname(output).toLowerCase() === '.webp' && !/\{[a-z]+\}/i.test(output);

/** The name of a frame, as files of single frames have it. */
const nameOf = ({ model, view }) => `${model}, ${view}`;

/** The error of one frame, by its name. */
function ofFrame(error, jobs) {
  if (!Object.hasOwn(jobs, error?.index)) return error;
  return new TelarError(error.code, `${nameOf(jobs[error.index])}: ${error.message.replace(/^shots\[\d+\]: /, '')}`, error);
}

/** What the model's file and every picture warn of is said once, of the frame that shows it first: numbers in a message differ from frame to frame. */
function tellWarnings(frames, jobs, console) {
  const said = new Set();
  for (const [i, { info }] of frames.entries()) {
    const kinds = info.warnings.map(({ code, pointer }) => `${code} ${pointer ?? ''}`);
    // Several of one code in the first frame are of several things.
    info.warnings.forEach((warning, k) => {
      if (!said.has(kinds[k])) console.warning(warning, nameOf(jobs[i]));
    });
    for (const kind of kinds) said.add(kind);
  }
}

/**
 * @param {{jobs: import('./jobs.mjs').Job[], options: object, renderer: object}} drawing jobs: the frames in order
 * @param {{api: object, console: import('./console.mjs').Console, signal?: AbortSignal}} context
 * @returns {Promise<number>} exit code
 */
export async function writeAnimation({ jobs, options, renderer }, { api, console, signal }) {
  const file = options.output;
  const models = new Set(jobs.map(({ model, variant }) => `${variant} ${model}`));
  if (models.size > 1) throw usage(`-o ${shown(file)}: one animation holds one model in one variant; use a pattern such as out/{name}-{view}.webp`);
  if (options.contactSheet !== undefined || options.skipUnchanged || options.reached)
    throw usage(`-o ${shown(file)}: an animation has no --contact-sheet, no --skip-unchanged and no --reached`);
  const own = jobs.find(({ output }) => output !== undefined);
  if (own) throw usage(`${own.where}: output: the animation goes to ${shown(file)}; drop one of them`);
  const other = jobs.map(({ shot }) => shot.output?.format).find((format) => format !== undefined && format !== 'webp');
  if (other !== undefined) throw usage(`-o ${shown(file)} means an animated webp, but the shot's output.format is ${other}; drop one of them`);
  if (jobs.some(({ shot }) => shot.layers?.some((layer) => layer !== 'beauty'))) throw usage(`-o ${shown(file)}: an animation has no layers`);
  const shots = jobs.map(({ shot }) => ({ ...shot, output: { ...shot.output, format: 'webp' } }));
  const source =
    options.explode === undefined ? jobs[0].source : await (await renderer.load(jobs[0].source, { signal })).explode(Number(options.explode), { signal });
  const frames = await renderer.renderAll(source, shots, { signal }).catch((error) => {
    throw ofFrame(error, jobs);
  });
  const data = api.animateWebp(frames.map(({ data: still }) => still));
  await writeFileAtomically(file, data, signal);
  const { width, height } = frames[0].info;
  tellWarnings(frames, jobs, console);
  const image = { model: jobs[0].model, ok: true, output: file, bytes: data.length, frames: frames.length, width, height };
  await console.result({ ok: true, exit: 0, images: [image] }, [file]);
  return 0;
}
