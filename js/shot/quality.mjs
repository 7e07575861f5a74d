import { shown, wrongValue } from './complain.mjs';
import { resolveReference } from './reference.mjs';
import { PRESETS, SAMPLES_OF_A_PASS } from './schema.mjs';

/** Samples of several passes are averaged in linear light by default. */
const resolveOf = (samples) => (samples > SAMPLES_OF_A_PASS ? 'linear' : 'encoded');

/**
 * Every setting of a quality. A preset comes with all of its own: where one differs, it is another quality.
 * @param {string | object} quality - As the schema parsed it.
 * @returns {{preset?: string, samples: number, resolve: string, noise: number, environmentSamples: number}}
 */
export function resolveQuality(quality) {
  if (quality === 'reference') return resolveReference({});
  if (quality.preset === 'reference') return resolveReference(quality);
  if (typeof quality === 'string') return { preset: quality, ...PRESETS[quality] };
  const { preset, ...given } = quality;
  if (preset !== undefined) {
    for (const [key, value] of Object.entries(given)) {
      if (value !== undefined && PRESETS[preset][key] !== value) {
        throw wrongValue(['quality', key], `${shown(PRESETS[preset][key])} with preset ${shown(preset)}, or no preset`, value);
      }
    }
    return { preset, ...PRESETS[preset] };
  }
  const { standard } = PRESETS;
  const { samples = standard.samples, resolve = resolveOf(samples), noise = standard.noise, environmentSamples = standard.environmentSamples } = given;
  if (samples > SAMPLES_OF_A_PASS && resolve !== 'linear') {
    throw wrongValue(['quality', 'resolve'], `"linear" with more than ${SAMPLES_OF_A_PASS} samples`, resolve);
  }
  if (noise > 0 && samples <= SAMPLES_OF_A_PASS) throw wrongValue(['quality', 'noise'], `0 with ${SAMPLES_OF_A_PASS} samples or fewer`, noise);
  return { samples, resolve, noise, environmentSamples };
}

/**
 * Whether a caller who asks for this asks for long work: paths of light, or more than one pass over the picture.
 * @param {object} quality - Resolved.
 */
export const isLong = ({ preset, samples }) => preset === 'reference' || samples > SAMPLES_OF_A_PASS;
