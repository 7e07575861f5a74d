import * as z from '../dist/zod.mjs';
import { wrongValue } from './complain.mjs';
import { choice, number, object } from './fields.mjs';

/** Settings of quality "reference", the path tracer. */

/** Every core of the machine: a resolved shot is the same on each of them. */
const ALL_CORES = 0;

const REFERENCE = Object.freeze({ samples: 256, seed: 1, transport: 'global', bounces: 8, threads: ALL_CORES });

/** What light is followed, from what the raster computes to all there is. */
const TRANSPORTS = ['global', 'occlusion', 'direct'];

export const referenceQuality = object('Settings of the path tracer', {
  preset: z.literal('reference', { error: '"reference"' }).describe('The path tracer'),
  samples: number('Paths a pixel, default 256; the noise falls with the root of it',
    { what: 'a whole number of paths a pixel', min: 1, max: 65536, integer: true }).optional(),
  seed: number('The same seed gives the same bytes, with any number of threads; default 1',
    { what: 'a whole number', min: 0, max: 1e9, integer: true }).optional(),
  transport: choice('"global": all light, over `bounces` reflections; "occlusion": light that arrives directly, less what surfaces hide; '
    + '"direct": the same with nothing hidden but the shadows that the shot asks for, which is what the raster computes; default "global"', TRANSPORTS).optional(),
  bounces: number('Reflections from surface to surface, "global" alone; default 8',
    { what: 'a whole number of bounces', min: 0, max: 64, integer: true }).optional(),
  threads: number('Threads that trace; default 0 = one for each core', { what: 'a whole number of threads', min: 0, max: 256, integer: true }).optional(),
});

/**
 * @param {{samples?: number, seed?: number, transport?: string, bounces?: number, threads?: number}} quality
 * @returns {object} with every default
 */
export function resolveReference(quality) {
  const resolved = { preset: 'reference', ...REFERENCE, ...quality };
  if (resolved.transport === 'global') return resolved;
  if (quality.bounces) throw wrongValue(['quality', 'bounces'], `0 with transport "${resolved.transport}"`, quality.bounces);
  return { ...resolved, bounces: 0 };
}
