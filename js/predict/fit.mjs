import { classesOf, FEWEST } from './classes.mjs';
import { leastSquares } from './least_squares.mjs';
import { FAMILIES, SETTINGS } from './settings.mjs';

/**
 * Part of the scenes of a class that a bound of its error is to hold for. Few goals are so near to a bound that it decides: with this part 96 of 100 goals hold,
 * of models that are left out of the fit.
 */
export const HELD = 0.92;

/** The same of what a window shows: a larger part holds no more goals, of models that are left out, and fewer are met in twice the least time. */
const SHOWN = 0.9;

/** Part of the pictures that a predicted time is not to be passed by. */
const IN_TIME = 0.9;

/**
 * Upper bound that a further value of the same kind stays below with this probability: the k-th of n values, k = ceil(share (n + 1))
 * (conformal prediction: Vovk, Gammerman & Shafer 2005). Of too few values, the largest and as much again as it stands above the median,
 * by the part that is missing.
 * @param {number[]} values not empty
 * @param {number} share 0..1
 */
export function upperBound(values, share) {
  const sorted = values.toSorted((a, b) => a - b);
  const k = Math.ceil(share * (sorted.length + 1));
  if (k <= sorted.length) return sorted[k - 1];
  const median = sorted[Math.floor((sorted.length - 1) / 2)];
  const missing = (k - sorted.length) / (sorted.length + 1) / (1 - share) / 2;
  return sorted.at(-1) + Math.min(1, missing) * (sorted.at(-1) - median);
}

const groupBy = (rows, namesOf) => {
  const groups = new Map();
  for (const row of rows) for (const name of namesOf(row)) groups.set(name, [...(groups.get(name) ?? []), row]);
  return [...groups];
};

/** By setting and class what it errs at most. Within a family a cheaper one never seems more accurate than one that follows. */
function errorsOf(rows) {
  const errors = {};
  for (const family of Object.values(FAMILIES)) {
    const worst = {};
    for (const setting of Object.keys(family).toReversed()) {
      const own = rows.filter((row) => row.setting === setting);
      const classes = groupBy(own, ({ features }) => classesOf(features)).filter(([, list]) => list.length >= FEWEST);
      errors[setting] = Object.fromEntries(
        classes.map(([name, list]) => {
          const bound = upperBound(
            list.map(({ flip }) => flip),
            HELD,
          );
          worst[name] = Math.min(1, Math.max(bound, worst[name] ?? 0));
          return [name, { flip: round(worst[name]), count: list.length }];
        }),
      );
    }
  }
  return errors;
}

const round = (value) => Number(value.toPrecision(4));

/** CPU milliseconds = base + triangle * triangles + pixel * covered pixels, none negative; `spread`: factor that IN_TIME of the pictures stay below. */
function timeOf(list) {
  const points = list.map(({ cpuMs, features }) => ({ of: [1, features.triangles, features.covered], is: cpuMs }));
  const [base, triangle, pixel] = leastSquares(points);
  const ratios = points.map(({ of, is }) => is / (base * of[0] + triangle * of[1] + pixel * of[2]));
  return { base: round(base), triangle: round(triangle), pixel: round(pixel), spread: round(Math.max(1, upperBound(ratios, IN_TIME))), count: list.length };
}

/** Times the fewest covered pixels of a class that its most must be: scenes of one size do not tell what a pixel takes. */
const SPAN = 3;

const spansSizes = (list) => {
  const covered = list.map(({ features }) => features.covered);
  return Math.max(...covered) >= SPAN * Math.min(...covered);
};

function timesOf(rows) {
  return Object.fromEntries(
    Object.keys(SETTINGS).map((setting) => {
      const own = rows.filter((row) => row.setting === setting);
      const classes = groupBy(own, ({ features }) => classesOf(features)).filter(([, list]) => list.length >= FEWEST && spansSizes(list));
      return [setting, Object.fromEntries(classes.map(([name, list]) => [name, timeOf(list)]))];
    }),
  );
}

/**
 * A look at a window of a measured scene.
 * @typedef {object} Look
 * @property {string} setting
 * @property {number} flip - In the window.
 * @property {number} is - That was measured of the scene.
 */

/** By setting: what its error in a window is multiplied by. @param {Look[]} looks */
export function factorsOf(looks) {
  const bounds = groupBy(looks, ({ setting }) => [setting])
    .filter(([, list]) => list.length >= FEWEST)
    .map(([setting, list]) => {
      const ratios = list.map(({ flip, is }) => is / flip);
      return [setting, round(upperBound(ratios, SHOWN))];
    });
  return Object.fromEntries(bounds);
}

/**
 * What is predicted from measurements.
 * @param {import('../trade/measure.mjs').Row[]} rows
 * @param {{raster: number, tracer: number}} machine calibration of the machine that they were measured on
 * @param {Look[]} [looks]
 * @returns {import('./choose.mjs').TradeTable}
 */
export function fitTable(rows, machine, looks = []) {
  const scenes = new Set(rows.map(({ model, light, size, shading }) => [model, light, size, shading].join()));
  return { scenes: scenes.size, rows: rows.length, machine, errors: errorsOf(rows), times: timesOf(rows), window: factorsOf(looks) };
}
