import { RASTER } from '../shot/table/quality.mjs';

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
  const { preset: _, ...settings } = quality;
  const few = STEPS.findLast((step) => step <= samples);
  // Each pass takes its part of the directions.
  return { ...settings, samples: few, environmentSamples: Math.ceil((quality.environmentSamples * few) / quality.samples) };
}
