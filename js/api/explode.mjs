import { checkObject, checkSignal, loading, STRICT, wrongOption } from './options.mjs';
import { Model } from './model.mjs';
import { loadNative } from './native.mjs';
import { nativeCall } from './native_call.mjs';
import { sha256 } from './sha256.mjs';
import { Work } from './work.mjs';

/**
 * Options of Model.explode().
 * @throws {import('../error/index.mjs').TelarError} E_OPTION
 */
export function explodeOptions(distance, options) {
  checkObject('options', options, ['timeoutMs', 'signal']);
  const { timeoutMs } = loading(options, STRICT);
  if (!(Number.isFinite(distance) && distance >= 0)) throw wrongOption('distance', 'metres, 0 or more', distance);
  return { signal: checkSignal(options.signal), timeoutMs };
}

/**
 * Documented in js/api/model.d.ts as Model.explode.
 * @internal
 */
export async function explodeModel(model, distance, options) {
  const { signal, timeoutMs } = explodeOptions(distance, options);
  const native = loadNative();
  const work = new Work(native, signal, timeoutMs);
  const { scene, facts } = await nativeCall(native, work, (token) => native.explode(Model.sceneOf(model), distance, token));
  const read = JSON.parse(facts);
  // Its pictures are others than those of the file.
  return new Model(scene, { ...read, sha256: sha256(`${read.sha256} exploded by ${distance}`, native) });
}
