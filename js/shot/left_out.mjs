import { ghostSchema } from './schema.mjs';

/**
 * The ghosts of a shot that leaves a part of the model out, so that the rest can be measured before the shot is resolved: what is left out
 * does not count for cameras, shadows and the ground.
 * @param {import('../index.d.ts').Shot} shot
 * @returns {object[] | undefined} all of the shot's `ghost`, as a later one may show again what an earlier one leaves out; undefined where
 *   nothing is left out; a wrong one is resolveShot's to tell
 */
export function resolveLeftOut(shot) {
  const { success, data } = ghostSchema.safeParse(shot?.ghost);
  return success && data?.some(({ opacity }) => opacity === 0) ? data : undefined;
}
