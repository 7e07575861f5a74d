import { compareImages } from '../compare/compare.mjs';
import { resolveQuality } from '../shot/quality.mjs';
import { choose, predictAll } from './choose.mjs';
import { SETTINGS } from './settings.mjs';
import { windowCamera, windowOf } from './window.mjs';

/**
 * A look at a small window of a picture before it is drawn: how far settings are there from traced paths tells more of a scene than its class does. A window
 * takes some tens of milliseconds, a setting that is dearer than the picture needs takes seconds.
 */

/** Side of the window, pixels. */
export const SIDE = 24;

/** Larger side of the small picture in which the window is looked for, pixels. */
const OVERVIEW = 64;

/** Standard error, in 1/255, at which the paths of a window's truth end. */
const NOISE = 8;

/** The same where what was reached is measured. */
const EXACT_NOISE = 2;

/** FLIP below which a goal is lost in that noise. */
const LEAST = 0.025;

/** CPU milliseconds of what a class is sure of from which on a look is worth its own, and the part of them up to which another setting is. */
const WORTH_MS = 300;
const WORTH = 0.67;

/** Light that arrives directly; another seed than that of the settings. */
const TRUTH = { preset: 'reference', transport: 'direct', samples: 4096, noise: NOISE, seed: 3 };

const within = (value, least, most) => Math.min(Math.max(value, least), most);

/** The shot of a window on the model, at the scale of the whole, over nothing: the model's own pixels count. */
async function windowShot(draw, resolved) {
  const { size, camera } = resolved;
  const seen = { ...resolved, background: 'transparent', layers: ['beauty'], output: { ...resolved.output, format: 'raw', bitDepth: 8 } };
  const part = Math.min(1, OVERVIEW / Math.max(size.width, size.height));
  const small = { width: Math.ceil(size.width * part), height: Math.ceil(size.height * part) };
  const overview = await draw({ ...seen, size: small, quality: resolveQuality('draft') });
  const found = windowOf(overview, small, Math.max(2, Math.round(SIDE * part)));
  const [width, height] = [Math.min(SIDE, size.width), Math.min(SIDE, size.height)];
  const x = within(Math.round((found.x + found.width / 2) / part - width / 2), 0, size.width - width);
  const y = within(Math.round((found.y + found.height / 2) / part - height / 2), 0, size.height - height);
  return { ...seen, size: { width, height }, camera: windowCamera(camera, size, { x, y, width, height }) };
}

/**
 * @param {(shot: object) => Promise<Uint8Array>} draw resolved shot to RGBA, 8 bits a channel
 * @param {object} resolved shot; its quality is not looked at
 * @param {{exact?: boolean}} [how] exact: with less noise in the traced paths, which take longer
 * @returns {Promise<{pixels: number, flipOf(quality: string | object): Promise<number>}>} flipOf: mean FLIP of settings against traced paths; these are drawn once
 */
export async function openWindow(draw, resolved, { exact = false } = {}) {
  const shot = await windowShot(draw, resolved);
  const drawn = async (quality) => ({ ...shot.size, data: await draw({ ...shot, quality: resolveQuality(quality) }) });
  const paths = exact ? { ...TRUTH, noise: EXACT_NOISE } : TRUTH;
  let truth;
  return {
    pixels: shot.size.width * shot.size.height,
    async flipOf(quality) {
      truth ??= await drawn(paths);
      // A window without the model says nothing.
      return compareImages(truth, await drawn(quality)).object?.flip.mean ?? 1;
    },
  };
}

/**
 * The cheapest setting that is predicted to hold an error: by the scene's class, or for less by a window of the picture.
 * @param {import('./choose.mjs').TradeTable} table
 * @param {{maxError: number}} goal
 * @param {import('./features.mjs').Features} features
 * @param {{tracer: boolean}} here
 * @param {object} resolved
 * @param {(shot: object) => Promise<Uint8Array>} draw of openWindow
 * @returns {Promise<ReturnType<typeof choose> & {looked?: number}>} looked: pixels of the window that it is from
 */
export async function chooseByWindow(table, { maxError }, features, here, resolved, draw) {
  const sure = choose(table, { maxError }, features, here);
  const factors = table.window ?? {};
  if (maxError < LEAST || !here.tracer || !features.traceable || (sure.holds && sure.cpuMs < WORTH_MS)) return sure;
  const cheaper = predictAll(table, features, here)
    .filter(({ setting, cpuMs }) => factors[setting] !== undefined && (!sure.holds || cpuMs < WORTH * sure.cpuMs))
    .toSorted((a, b) => a.cpuMs - b.cpuMs);
  if (cheaper.length === 0) return sure;
  const window = await openWindow(draw, resolved);
  for (const each of cheaper) {
    const flip = factors[each.setting] * (await window.flipOf(SETTINGS[each.setting]));
    // What it errs without noise in this scene is not known: it is drawn to its end.
    if (flip <= maxError) return { ...each, flip, quality: SETTINGS[each.setting], holds: true, looked: window.pixels };
  }
  return sure;
}
