import { partOption } from './measure_options.mjs';
import { Model } from './model.mjs';
import { loadNative } from './native.mjs';
import { nativeCall } from './native_call.mjs';
import { checkObject, checkSignal, loading, STRICT, wrongOption } from './options.mjs';
import { Work } from './work.mjs';

const KEYS = ['part', 'variant', 'size', 'draped', 'signal', 'timeoutMs'];

/** Metres. */
const SIZES = { min: 1e-3, max: 10 };

/**
 * Options of Model.swatch() with every default written out.
 * @throws {import('../error/index.mjs').TelarError} E_OPTION
 */
export function swatchOptions(options) {
  checkObject('options', options, KEYS);
  const { part, variant = '', size = 0.1, draped = false, signal, timeoutMs } = options;
  if (part === undefined || part === null) throw wrongOption('options.part', '{node} or {material}, by name or index', part);
  if (typeof variant !== 'string') throw wrongOption('options.variant', "a variant's name", variant);
  if (!(size >= SIZES.min && size <= SIZES.max)) throw wrongOption('options.size', `metres from ${SIZES.min} to ${SIZES.max}`, size);
  if (typeof draped !== 'boolean') throw wrongOption('options.draped', 'true or false', draped);
  const request = { part: partOption('options.part', part), variant, size, draped };
  return { request, signal: checkSignal(signal), timeoutMs: loading({ timeoutMs }, STRICT).timeoutMs };
}

/**
 * Documented in js/api/model.d.ts as Model.swatch.
 * @internal
 */
export async function swatchOf(model, options) {
  const { request, signal, timeoutMs } = swatchOptions(options);
  const native = loadNative();
  const work = new Work(native, signal, timeoutMs);
  const made = await nativeCall(native, work, (token) => native.swatch(Model.sceneOf(model), JSON.stringify(request), token));
  return new Model(made.scene, { ...JSON.parse(made.facts), meanBaseColor: made.meanBaseColor });
}
