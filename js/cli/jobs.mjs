import { TelarError } from '../error/index.mjs';
import { ANY_MODEL } from '../shot/facts.mjs';
import { nearest, shown } from '../shot/complain.mjs';
import { namesIn } from './name_list.mjs';
import { framingOf } from './shot_options.mjs';
import { variantNames } from './variants.mjs';

/**
 * One picture to draw.
 * @typedef {object} Job
 * @property {string} model as given, - for stdin
 * @property {string | Uint8Array} source of the model: path or bytes
 * @property {string} folder of the model beneath the one that was given; empty where none was
 * @property {string} [where] line of the manifest
 * @property {string} [output] name that the manifest gives
 * @property {string} [shotFile] path of the shot that the manifest names
 * @property {object} shot not resolved
 * @property {string} view, variant for names
 */

const usage = (message) => new TelarError('E_USAGE', message);

/** "front,back" or "all" as names of views. */
async function viewsOf({ views, view }) {
  if (views === undefined) return undefined;
  if (view !== undefined) throw usage('--views and --view: give one of them');
  const { VIEWS } = await import('../shot/index.mjs');
  const known = Object.keys(VIEWS);
  if (views === 'all') return known;
  const names = namesIn(views);
  if (names.length === 0) throw usage('--views: expected names with commas between, or all');
  for (const name of names) {
    if (known.includes(name)) continue;
    const near = nearest(name, known);
    throw usage(`--views: there is no view ${shown(name)}; ${near ? `did you mean ${near}?` : `expected ${known.join(', ')} or all`}`);
  }
  return names;
}

/** Which variants of a model: a list, or a function of the model's own. */
function variantsOf({ variants, variant }) {
  if (variants === undefined) return undefined;
  if (variant !== undefined) throw usage('--variants and --variant: give one of them');
  if (variants === 'all') return (own) => own;
  const names = namesIn(variants);
  if (names.length === 0) throw usage('--variants: expected names with commas between, or all');
  return () => names;
}

/** What {view} and {variant} say of a shot. */
const viewName = ({ camera }) => {
  if (camera?.view !== undefined) return String(camera.view);
  const isFramed = ['position', 'gltf', 'azimuth', 'elevation'].every((key) => camera?.[key] === undefined);
  return isFramed ? 'front' : 'camera';
};
const variantName = ({ variant }) => (typeof variant === 'string' && variant !== '' ? variant : 'default');

/** Most frames of a turntable. */
const FRAMES_MAX = 720;

/** "36" of --turntable. */
function framesOf({ turntable, views }) {
  if (turntable === undefined) return undefined;
  if (views !== undefined) throw usage('--turntable and --views: give one of them');
  const frames = Number(turntable);
  if (!(Number.isInteger(frames) && frames >= 1 && frames <= FRAMES_MAX)) {
    throw usage(`--turntable: expected a whole number of frames from 1 to ${FRAMES_MAX}, got ${shown(turntable)}`);
  }
  return frames;
}

/** The frames of a shot's turntable, with the name that {view} stands for. */
async function turned(shot, frames) {
  const { camera } = shot;
  if (camera?.position !== undefined || camera?.gltf !== undefined) throw usage('--turntable: the camera is to be a view, which frames the model');
  const { turntable } = await import('../shot/turntable.mjs');
  return turntable(shot, frames).map(({ name, shot: each }) => ({ shot: each, view: name }));
}

/** The shot with each variant and each view; itself where none is asked for. */
function crossed(shot, variants, views) {
  const coloured = variants.length === 0 ? [shot] : variants.map((variant) => ({ ...shot, variant }));
  if (!views) return coloured;
  return coloured.flatMap((each) => views.map((view) => ({ ...each, camera: { ...framingOf(each.camera), view } })));
}

/**
 * Every picture of a command line, in order: models, variants, views.
 * @param {Array<{model: string, source: string | Uint8Array, folder: string, where?: string, shot: object, output?: string}>} entries
 * @param {{views?: string, view?: string, turntable?: string, variants?: string, variant?: string}} options as commander parsed them
 * @param {number} maxBytes of a model
 * @returns {Promise<{jobs: Job[], crosses: {views: boolean, variants: boolean}}>} crosses: whether a model has many
 * @throws {TelarError} E_USAGE, E_SHOT
 */
export async function makeJobs(entries, options, maxBytes) {
  const views = await viewsOf(options);
  const frames = framesOf(options);
  const chosen = variantsOf(options);
  const jobs = [];
  for (const { shot, ...entry } of entries) {
    const variants = chosen ? chosen(await variantNames(entry.source, maxBytes)) : [];
    for (const each of crossed(shot, variants, views)) {
      const shots = frames === undefined ? [{ shot: each, view: viewName(each) }] : await turned(each, frames);
      for (const one of shots) jobs.push({ ...entry, ...one, variant: variantName(each) });
    }
  }
  // A name that a file gives is the file's fault, and no other picture's.
  const isOwn = options.variants === 'all';
  await checkShots(isOwn ? jobs.map(({ shot: { variant: _, ...shot }, where }) => ({ shot, where })) : jobs);
  return { jobs, crosses: { views: views?.length > 1 || frames > 1, variants: chosen !== undefined } };
}

/** Tells a wrong shot early, and each once. What depends on the model is left to its own turn. */
async function checkShots(jobs) {
  const { resolveShot } = await import('../shot/index.mjs');
  const checked = new Set();
  for (const { shot, where } of jobs) {
    const text = JSON.stringify(shot);
    if (checked.has(text)) continue;
    checked.add(text);
    try {
      resolveShot(shot, ANY_MODEL);
    } catch (error) {
      if (error.code !== 'E_SHOT') continue;
      throw where === undefined ? error : new TelarError(error.code, `${where}: ${error.message}`, error);
    }
  }
}
