import { median } from '../compare/statistics.mjs';
import { PRESETS } from '../shot/table/quality.mjs';
import { byScene } from './figures.mjs';

/**
 * Each number of the shot that trades time for error, alone and the steepest together, from quality `standard`. Of the knobs of other renderers telar
 * has none that takes diffuse light from spherical harmonics, which ring under small lights, and none that makes area lights points, which stock three.js
 * does not do either.
 */

const { standard } = PRESETS;

/** The setting that all others differ from. */
export const FROM = 'standard';

const sampled = (samples, more = {}) => ({ ...standard, samples, ...(samples > 4 && { resolve: 'linear' }), ...more });

/** By knob and value: what of a quality it changes, or of the shadows of lamps. A knob that another needs comes with it, and its value says so. */
export const KNOBS = Object.freeze({
  samples: { 1: { samples: 1 }, 16: { samples: 16 }, 64: { samples: 64 } },
  resolve: { linear: { resolve: 'linear' } },
  environmentSamples: { 4: { environmentSamples: 4 }, 16: { environmentSamples: 16 }, 64: { environmentSamples: 64 }, 256: { environmentSamples: 256 } },
  noise: { '4 of 64 samples': { samples: 64, noise: 4 } },
  mergeQuads: { true: { mergeQuads: true } },
  denoise: { 'of 16 samples, 32 directions': { samples: 16, environmentSamples: 32, denoise: true } },
  textureSize: { 128: { textureSize: 128 }, 256: { textureSize: 256 }, 512: { textureSize: 512 } },
  environmentSize: { 64: { environmentSize: 64 }, 128: { environmentSize: 128 }, 512: { environmentSize: 512 } },
  prefilterSamples: { 32: { prefilterSamples: 32 }, 1024: { prefilterSamples: 1024 } },
  maxLights: { 1: { maxLights: 1 } },
  shadowScale: { 2: { shadowScale: 2 }, 4: { shadowScale: 4 } },
  transmissionScale: { 0.25: { transmissionScale: 0.25 }, 0.5: { transmissionScale: 0.5 } },
  geometryError: { 0.25: { geometryError: 0.25 }, 0.5: { geometryError: 0.5 }, 1: { geometryError: 1 } },
  'shadow.mapSize': { 256: { shadow: { mapSize: 256 } }, 512: { shadow: { mapSize: 512 } }, 2048: { shadow: { mapSize: 2048 } } },
  'shadow.radius': { 0: { shadow: { radius: 0 } }, 1: { shadow: { radius: 1 } } },
});

/** A setting of js/trade/measure.mjs. */
const settingOf = ({ shadow, samples = standard.samples, ...rest }) => {
  const quality = sampled(samples, rest);
  return shadow ? { quality, shadow } : quality;
};

const alone = Object.entries(KNOBS).flatMap(([knob, values]) => Object.entries(values).map(([value, change]) => ({ name: `${knob} ${value}`, knob, change })));

/** What surfaces hide is in no quality of the raster but by ambient visibility of the model, and the truth has it only where it is asked for. */
const OCCLUDED = { quality: FROM, transport: 'occlusion' };
const FROM_OCCLUDED = 'standard, of what is hidden';
const VISIBILITY = 'ambientVisibility';

/** Each knob alone, by name. */
export const KNOB_SETTINGS = Object.freeze({
  [FROM]: FROM,
  ...Object.fromEntries(alone.map(({ name, change }) => [name, settingOf(change)])),
  [FROM_OCCLUDED]: OCCLUDED,
  [VISIBILITY]: { ...OCCLUDED, ambientVisibility: true },
});

/** What a setting is compared with. */
const fromOf = (setting) => (setting === VISIBILITY ? FROM_OCCLUDED : FROM);

/**
 * What each setting changes against `standard` of the same scene, ambient visibility against the same truth.
 * @param {import('./measure.mjs').Row[]} rows
 * @returns {{setting: string, flip: number, cpuMs: number, perSecond: number, scenes: number}[]} flip, cpuMs: medians of the changes; perSecond: FLIP that a
 *   second of CPU takes away, by these; the steepest first
 */
export function sensitivity(rows) {
  const pairs = byScene(rows).flatMap(({ rows: own }) => {
    const rowOf = (name) => own.find(({ setting }) => setting === name);
    return own.flatMap((row) => {
      const from = rowOf(fromOf(row.setting));
      const isFrom = row.setting === FROM || row.setting === FROM_OCCLUDED;
      return from && !isFrom ? [{ ...row, by: { flip: row.flip - from.flip, cpuMs: row.cpuMs - from.cpuMs } }] : [];
    });
  });
  return [...new Set(pairs.map(({ setting }) => setting))]
    .map((setting) => {
      const own = pairs.filter((pair) => pair.setting === setting).map(({ by }) => by);
      const of = (key) => median(own.map((by) => by[key]));
      const [flip, cpuMs] = [of('flip'), of('cpuMs')];
      return { setting, flip, cpuMs, perSecond: flip === 0 ? 0 : (-1000 * flip) / cpuMs, scenes: own.length };
    })
    .toSorted((a, b) => b.perSecond - a.perSecond);
}

/** How many knobs are tried together. */
const STEEPEST = 3;

/**
 * The steepest knobs that take error away, each at its steepest value, together: all pairs, and all.
 * @param {import('./measure.mjs').Row[]} rows of KNOB_SETTINGS
 * @returns {Record<string, object>} settings by name
 */
export function together(rows) {
  const found = [];
  for (const { setting, flip, cpuMs } of sensitivity(rows)) {
    const own = alone.find(({ name }) => name === setting);
    if (own && flip < 0 && cpuMs > 0 && !found.some(({ knob }) => knob === own.knob)) found.push(own);
  }
  const steepest = found.slice(0, STEEPEST);
  const pairs = steepest.flatMap((a, i) => steepest.slice(i + 1).map((b) => [a, b]));
  const sets = steepest.length > 2 ? [...pairs, steepest] : pairs;
  const isAlone = (setting) => Object.values(KNOB_SETTINGS).some((each) => JSON.stringify(each) === JSON.stringify(setting));
  const named = sets.map((set) => [set.map(({ name }) => name).join(', '), settingOf(Object.assign({}, ...set.map(({ change }) => change)))]);
  // More samples average in linear light anyway.
  return Object.fromEntries(named.filter(([, setting]) => !isAlone(setting)));
}

const signed = (value, digits) => `${value > 0 ? '+' : ''}${value.toFixed(digits)}`;

/** Heads and lines of the table. @param {import('./measure.mjs').Row[]} rows */
export const knobsTable = (rows) => ({
  head: ['from `standard`', 'FLIP', 'CPU time, ms', 'FLIP less for a second', 'scenes'],
  lines: sensitivity(rows).map(({ setting, flip, cpuMs, perSecond, scenes }) => [
    setting,
    signed(flip, 4),
    signed(cpuMs, 0),
    // Less error in less time has no slope, nor has more in more.
    flip < 0 === cpuMs > 0 || flip === 0 ? perSecond.toFixed(3) : flip < 0 ? 'less of both' : 'more of both',
    String(scenes),
  ]),
});
