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

/** Standard errors, in 1/255, at which the paths of a window's truth end: the coarsest is taken that a goal is not lost in. */
export const NOISES = [8, 4, 2];
const COARSEST = [
  { noise: 8, from: 0.06 },
  { noise: 4, from: 0.03 },
  { noise: 2, from: 0.012 },
];

/** Part of the time of what a class is sure of up to which another setting is worth a look. */
const WORTH = 0.67;

/** Light that arrives directly; another seed than that of the settings. */
const truthOf = (noise) => ({ preset: 'reference', transport: 'direct', samples: 4096, noise, seed: 3 });

/** The standard error for a goal; undefined where noise is more than the goal allows. @param {number} maxError FLIP */
export const noiseFor = (maxError) => COARSEST.find(({ from }) => maxError >= from)?.noise;

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
 * @returns {Promise<{pixels: number, flipOf(setting: string, noise: number): Promise<number>}>} flipOf: mean FLIP of a setting against paths of that noise;
 *   each is drawn once
 */
export async function openWindow(draw, resolved) {
  const shot = await windowShot(draw, resolved);
  const kept = new Map();
  const drawn = async (name, quality) => {
    if (!kept.has(name)) kept.set(name, await draw({ ...shot, quality: resolveQuality(quality) }));
    return { ...shot.size, data: kept.get(name) };
  };
  return {
    pixels: shot.size.width * shot.size.height,
    // A window without the model says nothing.
    flipOf: async (setting, noise) => compareImages(await drawn(noise, truthOf(noise)), await drawn(setting, SETTINGS[setting])).object?.flip.mean ?? 1,
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
  const noise = noiseFor(maxError);
  if (noise === undefined || !here.tracer || !features.traceable) return sure;
  const factors = table.window?.[noise] ?? {};
  const cheaper = predictAll(table, features, here)
    .filter(({ setting, cpuMs }) => factors[setting] !== undefined && (!sure.holds || cpuMs < WORTH * sure.cpuMs))
    .toSorted((a, b) => a.cpuMs - b.cpuMs);
  if (cheaper.length === 0) return sure;
  const window = await openWindow(draw, resolved);
  for (const each of cheaper) {
    const flip = factors[each.setting] * (await window.flipOf(each.setting, noise));
    if (flip <= maxError) return { ...each, flip, quality: SETTINGS[each.setting], holds: true, looked: window.pixels };
  }
  return sure;
}
