import { PRESETS } from '../shot/table/quality.mjs';

/**
 * Qualities that stand for the whole trade of time for accuracy: what `telar bench trade` measures and what `{maxError}` and
 * `{budgetMs}` choose from. Within a family each one that follows takes more samples, so that it costs no less and errs no more.
 */

const raster = (samples, environmentSamples, noise = 0) => ({ samples, ...(noise > 0 && { noise }), environmentSamples });

/** Light that arrives directly: what the raster computes, too. */
const paths = (samples, noise) => ({ preset: 'reference', transport: 'direct', samples, ...(noise !== undefined && { noise }) });

/** Most paths of a pixel that stops at a standard error. */
const MOST_PATHS = 4096;

/** Families: what draws, and its settings from the cheapest to the most accurate. "raster 16/64": samples and directions of the environment. */
export const FAMILIES = {
  prefiltered: { draft: 'draft', standard: 'standard' },
  raster: {
    'raster 16/16': raster(16, 16),
    'raster 16/64': raster(16, 64),
    'raster 64/128 noise 5': { ...raster(64, 128, 5), mergeQuads: true },
    'raster 64/256': raster(64, 256),
    'raster 256/512 noise 4': raster(256, 512, 4),
    'raster 1024/2048 noise 2': raster(1024, 2048, 2),
    // By its name the tracer may draw it.
    'high by the raster': PRESETS.high,
  },
  denoised: { medium: 'medium' },
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

/** Whether a picture of a setting can be ended with what it has: it is drawn in passes or paths. @param {string} name of SETTINGS */
export const canEnd = (name) => familyOf(name) !== 'prefiltered';

/** Names under which presets are measured. */
export const PRESET_NAMES = Object.freeze({ draft: 'draft', standard: 'standard', medium: 'medium', high: 'high by the raster' });
