import { shown, wrongValue } from './complain.mjs';
import { resolveReference } from './reference.mjs';
import { PRESETS, RASTER, SAMPLES_OF_A_PASS } from './table/quality.mjs';
import { inOrder } from './table/resolved.mjs';

/** Samples of several passes are averaged in linear light by default. */
const resolveOf = (samples) => (samples > SAMPLES_OF_A_PASS ? 'linear' : 'encoded');

/** Whether a quality says what is to be reached, and not how. */
export const isGoal = ({ maxError, budgetMs }) => maxError !== undefined || budgetMs !== undefined;

/**
 * Every setting of a quality, but of a goal: that stays one until the model and the machine are known. A preset comes with all of its own: where one differs, it is another quality.
 * @param {string | object} quality - As the schema parsed it.
 * @returns {object} Of the rows RASTER or REFERENCE, or {maxError} or {budgetMs}.
 */
export function resolveQuality(quality) {
  if (isGoal(quality)) return { ...quality };
  if (quality === 'reference') return resolveReference({});
  if (quality.preset === 'reference') return resolveReference(quality);
  if (typeof quality === 'string') return inOrder(RASTER, { preset: quality, ...PRESETS[quality] });
  const { preset, ...given } = quality;
  if (preset !== undefined) {
    const own = inOrder(RASTER, { preset, ...PRESETS[preset] });
    for (const [key, value] of Object.entries(given)) {
      if (value !== undefined && own[key] !== value) {
        throw wrongValue(['quality', key], `${shown(own[key])} with preset ${shown(preset)}, or no preset`, value);
      }
    }
    return own;
  }
  const { samples } = inOrder(RASTER, given);
  const settings = inOrder(RASTER, { ...given, resolve: given.resolve ?? resolveOf(samples) });
  const { resolve, noise } = settings;
  if (samples > SAMPLES_OF_A_PASS && resolve !== 'linear') {
    throw wrongValue(['quality', 'resolve'], `"linear" with more than ${SAMPLES_OF_A_PASS} samples`, resolve);
  }
  if (noise > 0 && samples <= SAMPLES_OF_A_PASS) throw wrongValue(['quality', 'noise'], `0 with ${SAMPLES_OF_A_PASS} samples or fewer`, noise);
  return settings;
}

/**
 * Whether a caller who asks for this asks for long work: paths of light, more than one pass over the picture, or a goal, which may need them.
 * @param {object} quality - Resolved.
 */
export const isLong = (quality) => quality.preset === 'reference' || quality.samples > SAMPLES_OF_A_PASS || isGoal(quality);
