import { narrowest } from './classes.mjs';
import { errorOfFlip } from './noise.mjs';
import { canEnd, drawnBy, FAMILIES, familyOf, SETTINGS } from './settings.mjs';

/**
 * What was measured, by setting and class.
 * @typedef {object} TradeTable
 * @property {number} scenes
 * @property {number} rows
 * @property {Machine} machine - That it was measured on.
 * @property {Record<string, Record<string, {flip: number, count: number}>>} errors
 * @property {Record<string, Record<string, {base: number, triangle: number, pixel: number, spread: number, count: number}>>} times
 * @property {Record<string, number>} [window] - By setting, what the error in a window is multiplied by: js/predict/probe.mjs.
 *
 * CPU milliseconds of two small pictures: js/predict/calibrate.mjs.
 * @typedef {{raster: number, tracer: number}} Machine
 *
 * @typedef {object} Prediction
 * @property {string} setting
 * @property {number} flip - Not passed by HELD of the scenes of this class.
 * @property {number} cpuMs - Most likely.
 * @property {number} mostMs - Not passed by 9 of 10 pictures.
 * @property {string} basis - Class that it is from.
 * @property {number} scenes - That were measured of it.
 */

/** Speed of another machine: how many times longer it takes. */
const slowness = (setting, table, machine) => {
  const kind = drawnBy(setting);
  return machine ? machine[kind] / table.machine[kind] : 1;
};

/**
 * What every setting that can draw a scene is predicted to take and to err.
 * @param {TradeTable} table
 * @param {import('./features.mjs').Features} features
 * @param {{tracer: boolean, machine?: Machine}} here tracer: whether it is there; machine: none = that of the table
 * @returns {Prediction[]}
 */
export function predictAll(table, features, { tracer, machine }) {
  const times = timesOf(table, features);
  const [[cheapest, first]] = times;
  const leastMs = first.ms * slowness(cheapest, table, machine);
  const drawable = (setting) => familyOf(setting) !== 'tracer' || (tracer && features.traceable);
  return [...times]
    .filter(([setting]) => drawable(setting))
    .flatMap(([setting, { ms, spread }]) => {
      const error = narrowest(table.errors[setting] ?? {}, features);
      if (!error) return [];
      // So the smallest pictures, which a fit knows little of, keep the cheapest of all, whichever machine draws them.
      const likely = Math.max(ms * slowness(setting, table, machine), leastMs);
      return [{ setting, flip: error.flip, cpuMs: likely, mostMs: likely * spread, basis: error.name, scenes: error.count }];
    });
}

/** Likely times on the machine of the table. None is less than one before it in its family: so small pictures stay in order. */
function timesOf(table, features) {
  const times = new Map();
  for (const family of Object.values(FAMILIES)) {
    let before = 0;
    for (const setting of Object.keys(family)) {
      const time = narrowest(table.times[setting] ?? {}, features);
      if (!time) continue;
      before = Math.max(before, time.base + time.triangle * features.triangles + time.pixel * features.covered);
      times.set(setting, { ms: before, spread: time.spread });
    }
  }
  return times;
}

const least = (list, of) => list.reduce((best, each) => (best === undefined || of(each) < of(best) ? each : best), undefined);

/** What ends the picture before its last sample. @typedef {{spentMs?: number, error?: number}} End CPU milliseconds; standard error in 1/255 */

/**
 * The standard error at which a picture of a setting holds an error: what its family errs without noise is taken off. None where the noise is not all that is left.
 * @param {Prediction[]} all of a scene
 */
function errorEnd(all, setting, maxError) {
  if (!canEnd(setting)) return undefined;
  const family = familyOf(setting);
  const bias = family === 'tracer' ? 0 : all.filter((each) => familyOf(each.setting) === family).at(-1).flip;
  return bias < maxError ? { error: errorOfFlip(maxError - bias) } : undefined;
}

/**
 * The cheapest setting that is predicted to hold an error, or the most accurate one that is predicted to fit into a time. Where none is, the most
 * accurate or the cheapest: `holds` tells. One that can be ended needs to fit by its likely time alone: it is ended where it would not.
 * @param {TradeTable} table
 * @param {{maxError: number} | {budgetMs: number}} wanted
 * @param {import('./features.mjs').Features} features
 * @param {{tracer: boolean, machine?: Machine}} here
 * @returns {Prediction & {quality: string | object, holds: boolean, end?: End}}
 */
export function choose(table, { maxError, budgetMs }, features, here) {
  const all = predictAll(table, features, here);
  const fits = ({ setting, cpuMs, mostMs }) => (canEnd(setting) ? cpuMs : mostMs) <= budgetMs;
  const held = all.filter((each) => (maxError === undefined ? fits(each) : each.flip <= maxError));
  const time = ({ cpuMs }) => cpuMs;
  const error = ({ flip }) => flip;
  const found = maxError === undefined ? (least(held, error) ?? least(all, time)) : (least(held, time) ?? least(all, error));
  const answer = { ...found, quality: SETTINGS[found.setting], holds: held.length > 0 };
  if (maxError !== undefined) return { ...answer, end: errorEnd(all, found.setting, maxError) };
  const mostMs = canEnd(found.setting) ? Math.min(found.mostMs, Math.max(budgetMs, found.cpuMs)) : found.mostMs;
  return { ...answer, mostMs, end: { spentMs: budgetMs } };
}
