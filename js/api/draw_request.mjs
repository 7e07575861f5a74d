import { TelarError } from '../error/index.mjs';
import { DEBUG_QUANTITIES } from '../shot/table/debug_quantities.mjs';
import { wrongOption } from './option_check.mjs';

/** What `renderQuantity` draws. */
const QUANTITIES = Object.keys(DEBUG_QUANTITIES);

/** @throws {TelarError} E_OPTION */
export function checkQuantity(quantity) {
  if (!QUANTITIES.includes(quantity)) throw wrongOption('quantity', `one of ${QUANTITIES.join(', ')}`, quantity);
}

/** @throws {TelarError} E_OPTION */
export function checkShots(shots) {
  if (!Array.isArray(shots)) throw wrongOption('shots', 'an array of shots', shots);
}

/** The shot that draws a quantity: its numbers as they are. */
export const quantityShot = (shot) => ({ ...shot, background: 'transparent', output: { format: 'raw', bitDepth: 32 } });

/**
 * The error of one of renderAll's shots, which says which: `index`. What an AbortSignal or onProgress threw is of no shot.
 * Shots may share an error (of their pose), so each gets its own.
 */
export function ofShot(thrown, index) {
  if (!(thrown instanceof TelarError)) return thrown;
  return new TelarError(thrown.code, `shots[${index}]: ${thrown.message}`, { ...thrown.toJSON(), index, cause: thrown });
}
