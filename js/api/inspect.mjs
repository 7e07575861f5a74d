import { inspectOptions } from './options.mjs';
import { nativeCall } from './native_call.mjs';
import { Work } from './work.mjs';
import { shotJson } from './shot_json.mjs';
import { readShot, readSource } from './source.mjs';
import { loadNative } from './native.mjs';
import { Model, loadModel, measuredFor, poseModel, shotModule } from './model.mjs';

/**
 * What is in a model, and what a render of it would compile and run. Needs no GL.
 * @param {string | URL | Uint8Array | ArrayBuffer} source - Path, file: URL or bytes.
 * @param {object} [options]
 * @param {object} [options.shot] - Shot to plan for.
 * @param {Record<string, number>} [options.limits] - By the L_* names.
 * @param {'error' | 'warning' | 'none'} [options.failOn='error'] - As createRenderer has it.
 * @param {(uri: string) => unknown} [options.resolve] - As createRenderer has it.
 * @param {number | null} [options.timeoutMs=20000] - Milliseconds that the work may take; null for any time.
 * @param {AbortSignal} [options.signal]
 * @returns {Promise<object>} bounds and size in metres, counts, materials, images, lights, variants, cameras, animations, warnings, and
 *   `plan`: {features, programs, passes, fragments}, null when there is nothing to draw
 */
export async function inspect(source, options = {}) {
  return inspectOn(loadNative(), source, options);
}

/** @internal */
export async function inspectOn(native, source, options = {}) {
  const { shot, limits, signal, timeoutMs, ...loading } = inspectOptions(options, Object.keys(native.limits));
  const maxBytes = limits.L_FILE_BYTES ?? native.limits.L_FILE_BYTES;
  const input = readSource(native, source, maxBytes);
  const request = readShot(native, shot, maxBytes);
  const work = new Work(native, signal, timeoutMs);
  const loaded = await loadModel(native, input, limits, { ...loading, work });
  const model = await poseModel(native, loaded, request.shot, { work, forget: true });
  if (!model.facts.bounds) return { ...model.facts, plan: null };
  const { resolveShot } = await shotModule();
  const resolved = resolveShot(request.shot, await measuredFor(native, model, request.shot, work));
  if (request.map) resolved.environment.map = request.map;
  const json = shotJson(resolved);
  const plan = await nativeCall(native, work, (token) => native.plan(Model.sceneOf(model), json, limits, token));
  return { ...model.facts, plan: JSON.parse(plan) };
}
