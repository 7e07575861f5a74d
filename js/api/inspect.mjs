import { inspectOptions } from './options.mjs';
import { nativeCall } from './native_call.mjs';
import { Work } from './work.mjs';
import { shotJson } from './shot_json.mjs';
import { readShot, readSource } from './source.mjs';
import { loadNative } from './native.mjs';
import { Model, goalModule, loadModel, measuredFor, qualityModule, shownModel, shotModule } from './model.mjs';

/** Documented in js/api/inspect.d.ts. */
export async function inspect(source, options = {}) {
  return inspectOn(loadNative(), source, options);
}

/** @internal */
export async function inspectOn(native, source, options = {}) {
  const { shot, measure, limits, signal, timeoutMs, ...loading } = inspectOptions(options, Object.keys(native.limits));
  const maxBytes = limits.L_FILE_BYTES ?? native.limits.L_FILE_BYTES;
  const input = readSource(native, source, maxBytes);
  const request = readShot(native, shot, maxBytes);
  const work = new Work(native, signal, timeoutMs);
  const loaded = await loadModel(native, input, limits, { ...loading, work });
  const model = await shownModel(native, loaded, request.shot, { work, forget: true });
  const measures = measure.length > 0 && { measures: await measured(native, model, measure, work) };
  const cloths = { materials: await withCloths(native, model, work) };
  if (!model.facts.bounds) return { ...model.facts, ...cloths, ...measures, plan: null };
  const { resolveShot } = await shotModule();
  const resolved = resolveShot(request.shot, await measuredFor(native, model, request.shot, work));
  if (request.map) resolved.environment.map = request.map;
  const goal = (await qualityModule()).isGoal(resolved.quality) && (await aimed(native, { resolved, model, limits }, work));
  const json = shotJson(resolved);
  const plan = await nativeCall(native, work, (token) => native.plan(Model.sceneOf(model), json, limits, token));
  return { ...model.facts, ...cloths, ...measures, plan: JSON.parse(plan), ...(goal && { goal }) };
}

/** Puts settings in the place of a goal. Nothing draws here, so times are those of the machine that was measured. A flat has no error to reach. */
async function aimed(native, { resolved, model, limits }, work) {
  if (resolved.style === 'flat') {
    resolved.quality = (await qualityModule()).resolveQuality('standard');
    return undefined;
  }
  const { settingsFor } = await goalModule();
  const { quality, goal } = await settingsFor(
    native,
    { resolved, scene: Model.sceneOf(model), facts: model.facts, limits, machine: async () => undefined },
    work,
  );
  resolved.quality = quality;
  return goal;
}

/** The materials with the size of their texture coordinates, and the cloth that their names suggest. */
async function withCloths(native, model, work) {
  const { proposedPreset } = await import('./proposed_preset.mjs');
  const scales = JSON.parse(await nativeCall(native, work, (token) => native.uvScales(Model.sceneOf(model), token)));
  return model.facts.materials?.map((material, i) => ({ ...material, metresPerUv: scales[i] ?? null, proposedPreset: proposedPreset(material.name) }));
}

/** Few callers measure, so what it needs comes when it is asked for. */
async function measured(native, model, list, work) {
  const { measureAll } = await import('./measure.mjs');
  return measureAll(native, model, list, work);
}
