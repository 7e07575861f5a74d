import { PRESETS } from '../shot/table/quality.mjs';

/**
 * Qualities that stand for the whole trade of time for accuracy: what `telar bench trade` measures and what `{maxError}` and
 * `{budgetMs}` choose from. Within a family each one that follows takes more samples, so that it costs no less and errs no more.
 */

const denoised = (samples, environmentSamples) => ({ samples, environmentSamples, mergeQuads: true, denoise: true, shadowScale: 4 });

/** Light that arrives directly: what the raster computes, too. */
const paths = (samples, noise) => ({ preset: 'reference', transport: 'direct', samples, ...(noise !== undefined && { noise }) });

/** Most paths of a pixel that stops at a standard error. */
const MOST_PATHS = 4096;

/** Families: what draws, and its settings from the cheapest to the most accurate. "denoised 64/256": samples and directions of the environment. */
export const FAMILIES = {
  prefiltered: { draft: 'draft', standard: 'standard' },
  denoised: {
    medium: 'medium',
    'denoised 64/64': denoised(64, 64),
    'denoised 64/256': denoised(64, 256),
    // By its name the tracer may draw it.
    'high by the raster': PRESETS.high,
  },
  tracer: {
    'tracer 4': paths(4),
    'tracer 8': paths(8),
    ...Object.fromEntries([8, 5.6, 4, 2.8, 2, 1.4, 1].map((noise) => [`tracer noise ${noise}`, paths(MOST_PATHS, noise)])),
  },
};

/** All by name. */
export const SETTINGS = Object.freeze(Object.assign({}, ...Object.values(FAMILIES)));

/** The family of a setting. @param {string} name of SETTINGS */
export const familyOf = (name) => Object.keys(FAMILIES).find((family) => Object.hasOwn(FAMILIES[family], name));

/** What draws a setting: each has a speed of its own. @param {string} name of SETTINGS @returns {'raster' | 'tracer'} */
export const drawnBy = (name) => (familyOf(name) === 'tracer' ? 'tracer' : 'raster');

/** Whether a picture of a setting can be ended with what it has: it is drawn in passes or paths. @param {string} name of SETTINGS */
export const canEnd = (name) => familyOf(name) !== 'prefiltered';

/** Names under which presets are measured. */
export const PRESET_NAMES = Object.freeze({ draft: 'draft', standard: 'standard', medium: 'medium', high: 'high by the raster' });
