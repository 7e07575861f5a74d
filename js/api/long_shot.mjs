/**
 * Whether a shot asks for long work, which has no bound on its time unless the caller gave one. It is asked before anything is loaded, and before the shot is checked.
 * @param {object} shot not resolved
 * @returns {Promise<boolean>}
 */
export async function isLongShot(shot) {
  if (shot.quality === undefined && shot.look === undefined) return false;
  const [{ withLook }, { isLong, resolveQuality }] = await Promise.all([import('../shot/looks.mjs'), import('../shot/quality.mjs')]);
  try {
    return isLong(resolveQuality(withLook(shot).quality ?? 'standard'));
  } catch {
    return false; // a wrong shot is not drawn
  }
}

/** Whether one of several does. @param {object[]} shots not resolved @returns {Promise<boolean>} */
export const hasLongShot = async (shots) => (await Promise.all(shots.map(isLongShot))).includes(true);
