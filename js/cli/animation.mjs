import path from 'node:path';
import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { writeFileAtomically } from '../api/atomic_file.mjs';

/** A turntable in one animated file. */

const usage = (message) => new TelarError('E_USAGE', message);

/** Whether the frames of a turntable go into one file: -o names one, and not a pattern. */
export const isAnimation = ({ turntable, output }) =>
  turntable !== undefined && output !== undefined && path.extname(output).toLowerCase() === '.webp' && !/\{[a-z]+\}/i.test(output);

/**
 * @param {{jobs: import('./jobs.mjs').Job[], options: object, renderer: object}} drawing jobs: the frames in order
 * @param {{api: object, console: import('./console.mjs').Console, signal?: AbortSignal}} context
 * @returns {Promise<number>} exit code
 */
export async function writeAnimation({ jobs, options, renderer }, { api, console, signal }) {
  const file = options.output;
  const models = new Set(jobs.map(({ model, variant }) => `${variant} ${model}`));
  if (models.size > 1) throw usage(`-o ${shown(file)}: one animation holds one model in one variant; use a pattern such as out/{name}-{view}.webp`);
  if (options.contactSheet !== undefined || options.skipUnchanged)
    throw usage(`-o ${shown(file)}: an animation has no --contact-sheet and no --skip-unchanged`);
  if (jobs.some(({ shot }) => shot.layers?.some((layer) => layer !== 'beauty'))) throw usage(`-o ${shown(file)}: an animation has no layers`);
  const shots = jobs.map(({ shot }) => ({ ...shot, output: { ...shot.output, format: 'webp' } }));
  const source =
    options.explode === undefined ? jobs[0].source : await (await renderer.load(jobs[0].source, { signal })).explode(Number(options.explode), { signal });
  const frames = await renderer.renderAll(source, shots, { signal });
  const data = api.animateWebp(frames.map(({ data: still }) => still));
  await writeFileAtomically(file, data, signal);
  const { width, height, warnings } = frames[0].info;
  for (const warning of warnings) console.warning(warning, jobs[0].model);
  const image = { model: jobs[0].model, ok: true, output: file, bytes: data.length, frames: frames.length, width, height };
  await console.result({ ok: true, exit: 0, images: [image] }, [file]);
  return 0;
}
