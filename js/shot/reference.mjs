import { wrongValue } from './complain.mjs';
import { REFERENCE } from './table/quality.mjs';
import { inOrder } from './table/resolved.mjs';

/**
 * @param {{samples?: number, seed?: number, transport?: string, bounces?: number, threads?: number}} quality
 * @returns {object} with every default
 */
export function resolveReference(quality) {
  const resolved = inOrder(REFERENCE, { preset: 'reference', ...quality });
  if (resolved.transport === 'global') return resolved;
  if (quality.bounces) throw wrongValue(['quality', 'bounces'], `0 with transport "${resolved.transport}"`, quality.bounces);
  return { ...resolved, bounces: 0 };
}
