import { RASTER, SAMPLES_OF_A_PASS } from '../shot/table/quality.mjs';

/** Samples that the raster can be asked for. */
const STEPS = RASTER.shape.samples.values;

/**
 * The settings of a picture that was ended, as those of one that is drawn to its end: of no more samples than it has.
 * @param {object} quality - Resolved.
 * @param {number} [samples] - That a pixel has taken at most; none: all.
 * @returns {object} resolved
 */
export function endedQuality(quality, samples) {
  if (samples === undefined) return quality;
  if (quality.preset === 'reference') return { ...quality, samples };
  const { preset: _, noise, ...settings } = quality;
  const few = STEPS.findLast((step) => step <= samples);
  // Each pass takes its part of the directions.
  const environmentSamples = Math.ceil((quality.environmentSamples * few) / quality.samples);
  // In one pass no pixel takes fewer samples than another.
  return { ...settings, samples: few, noise: few > SAMPLES_OF_A_PASS ? noise : 0, environmentSamples };
}
