import { complaint } from './complain.mjs';
import { dressingsOf } from './dressings.mjs';
import { materialsSchema } from './schema.mjs';

/**
 * Which parts of a model a shot shows in another cloth.
 * @param {import('../index.d.ts').Shot} shot
 * @param {import('./dressings.mjs').Names} names
 * @returns {import('./dressings.mjs').Dressing[]}
 * @throws {TelarError} E_SHOT, E_CLOTH
 */
export function resolveMaterials(shot, names) {
  const result = materialsSchema.safeParse(shot?.materials);
  if (!result.success) throw complaint(result.error.issues, shot.materials, materialsSchema, { path: ['materials'] });
  return dressingsOf(result.data, names);
}
