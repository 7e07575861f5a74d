import { median } from '../compare/statistics.mjs';
import { classesOf } from '../predict/classes.mjs';
import { PRESET_NAMES } from '../predict/settings.mjs';
import { aboveFront, cheapestWithin, frontOf } from './front.mjs';

/** FLIP of the table of cheapest settings. */
export const BARS = [0.005, 0.01, 0.02, 0.04];

/** How far above the front a preset may lie, as a part of its time. */
export const LEEWAY = 0.1;

/** Rows of one scene at one size. @param {import('./measure.mjs').Row[]} rows */
export function byScene(rows) {
  const groups = new Map();
  for (const row of rows) {
    const name = [row.model, row.light, row.shading, row.size].join(', ');
    groups.set(name, [...(groups.get(name) ?? []), row]);
  }
  return [...groups].map(([name, list]) => ({ name, rows: list, front: frontOf(list) }));
}

/**
 * Each setting over the scenes in which all were drawn: median error and median time.
 * @param {import('./measure.mjs').Row[]} rows
 * @returns {{setting: string, flip: number, worst: number, cpuMs: number, count: number}[]}
 */
export function overall(rows) {
  const names = [...new Set(rows.map(({ setting }) => setting))];
  return names.map((setting) => {
    const own = rows.filter((row) => row.setting === setting);
    return {
      setting,
      flip: median(own.map(({ flip }) => flip)),
      worst: Math.max(...own.map(({ flip }) => flip)),
      cpuMs: median(own.map(({ cpuMs }) => cpuMs)),
      count: own.length,
    };
  });
}

/**
 * The table of cheapest settings, of each scene and of the medians.
 * @returns {{name: string, cells: (import('./measure.mjs').Row | undefined)[]}[]}
 */
export const cheapestTable = (rows) => byScene(rows).map(({ name, rows: own }) => ({ name, cells: BARS.map((bar) => cheapestWithin(own, bar)) }));

/**
 * How far the presets lie above the front, over all scenes.
 * @returns {{preset: string, times: number, worst: number, within: number, scenes: number}[]} times: median of aboveFront; within: scenes where it is
 *   at most 1 + LEEWAY
 */
export function presetsAboveFront(rows) {
  const scenes = byScene(rows);
  return Object.entries(PRESET_NAMES).flatMap(([preset, setting]) => {
    const ratios = scenes.flatMap(({ rows: own }) => {
      const point = own.find((row) => row.setting === setting);
      return point ? [aboveFront(point, own)] : [];
    });
    if (ratios.length === 0) return [];
    return [{ preset, times: median(ratios), worst: Math.max(...ratios), within: ratios.filter((ratio) => ratio <= 1 + LEEWAY).length, scenes: ratios.length }];
  });
}

/**
 * The same by the class of the scenes, and what beats the preset most often where it lies too high.
 * @returns {{preset: string, group: string, times: number, within: number, scenes: number, better?: string}[]}
 */
export function presetsByClass(rows) {
  const scenes = byScene(rows).map((scene) => ({ ...scene, group: classesOf(scene.rows[0].features)[1] }));
  return [...new Set(scenes.map(({ group }) => group))].toSorted().flatMap((group) =>
    Object.entries(PRESET_NAMES).flatMap(([preset, setting]) => {
      const own = scenes.filter((scene) => scene.group === group && scene.rows.some((row) => row.setting === setting));
      if (own.length === 0) return [];
      const found = own.map((scene) => {
        const point = scene.rows.find((row) => row.setting === setting);
        return { ratio: aboveFront(point, scene.rows), better: cheapestWithin(scene.rows, point.flip).setting };
      });
      const high = found.filter(({ ratio }) => ratio > 1 + LEEWAY).map(({ better }) => better);
      const often = (name) => high.filter((each) => each === name).length;
      const better = [...new Set(high)].toSorted((a, b) => often(b) - often(a))[0];
      return [{ preset, group, times: median(found.map(({ ratio }) => ratio)), within: own.length - high.length, scenes: own.length, better }];
    }),
  );
}

const COLUMNS = ['model', 'light', 'shading', 'size', 'setting', 'family', 'flip', 'deltaE', 'cpuMs', 'timed', 'windowMs', 'samples'];
const FEATURES = ['surface', 'environment', 'shadows', 'triangles', 'pixels', 'covered', 'traceable'];

/** RFC 4180. */
const field = (value) => (/[",\n]/.test(String(value)) ? `"${String(value).replaceAll('"', '""')}"` : String(value));
const rounded = (value) => (typeof value === 'number' && !Number.isInteger(value) ? Number(value.toPrecision(5)) : value);

/** @param {import('./measure.mjs').Row[]} rows @returns {string} CSV with a line of names */
export const csvOf = (rows) =>
  [[...COLUMNS, ...FEATURES], ...rows.map((row) => [...COLUMNS.map((key) => row[key]), ...FEATURES.map((key) => row.features[key])])]
    .map((cells) => `${cells.map((value) => field(rounded(value))).join(',')}\n`)
    .join('');
