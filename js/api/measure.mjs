import { ASK_KEYS, measureOptions } from './measure_options.mjs';
import { Model, shownModel } from './model.mjs';
import { loadNative } from './native.mjs';
import { nativeCall } from './native_call.mjs';
import { Work } from './work.mjs';

/**
 * Documented in js/api/model.d.ts as Model.measure.
 * @internal
 */
export async function measureModel(model, options) {
  const { request, pose, signal, timeoutMs } = measureOptions(options);
  const native = loadNative();
  const work = new Work(native, signal, timeoutMs);
  return measureOn(native, await shownModel(native, model, { pose }, { work }), request, work);
}

/** @internal */
export async function measureOn(native, model, request, work) {
  return JSON.parse(await nativeCall(native, work, (token) => native.measure(Model.sceneOf(model), JSON.stringify(request), token)));
}

/**
 * What inspect() measures of a model that it has posed.
 * @internal
 * @param {object[]} list of what Model.measure() takes
 * @returns {Promise<object[]>}
 */
export async function measureAll(native, model, list, work) {
  const requests = list.map((options, i) => measureOptions(options, `options.measure[${i}]`, ASK_KEYS).request);
  const measures = [];
  for (const request of requests) measures.push(await measureOn(native, model, request, work));
  return measures;
}
