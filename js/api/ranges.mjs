import { resolveLeftOut } from '../shot/index.mjs';
import { Model } from './model.mjs';
import { loadNative } from './native.mjs';
import { nativeCall } from './native_call.mjs';
import { checkSignal, loading, STRICT } from './options.mjs';
import { Work } from './work.mjs';

/**
 * From where to where a model shows something along each of three axes, of all its drawn vertices. A box or an outline of facts is exact along
 * its own directions alone, so a picture of that size cuts the model off.
 * @internal
 * @param {Model} model
 * @param {[number, number, number][]} axes three of unit length
 * @param {{variant?: string, ghost?: object[], timeoutMs?: number | null, signal?: AbortSignal}} [options] variant and ghost: of a shot
 * @returns {Promise<[number, number][] | null>} metres; null where nothing is drawn
 * @throws {TelarError} E_FRAME (the model draws no such ghost), X_TIMEOUT
 */
export async function rangesOf(model, axes, { variant = '', ghost = [], signal, timeoutMs } = {}) {
  const native = loadNative();
  const work = new Work(native, checkSignal(signal), loading({ timeoutMs }, STRICT).timeoutMs);
  const shown = { variant, ghost: JSON.stringify(resolveLeftOut({ ghost }) ?? []) };
  return JSON.parse(await nativeCall(native, work, (token) => native.rangesAlong(Model.sceneOf(model), axes.flat(), shown, token)));
}
