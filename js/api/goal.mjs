import { nativeCall } from './native_call.mjs';
import { onAbort } from './on_abort.mjs';
import { shotJson } from './shot_json.mjs';

/** Settings for a shot whose quality is a goal: {maxError} or {budgetMs}. They depend on the model, those of a budget on the machine too. */

/** Few shots have a goal, so what it needs comes with the first. */
const predictModule = () => import('../predict/index.mjs');

/** By the addon's exports: whether the path tracer is there. */
const tracers = new WeakMap();

/** Whether the path tracer is there; it is looked for once, and again after a look that failed. @returns {Promise<boolean>} */
export function hasTracer(native) {
  const known = tracers.get(native);
  if (known) return known;
  const looked = nativeCall(native, undefined, () => native.probeReference()).then((json) => JSON.parse(json).works);
  tracers.set(native, looked);
  looked.catch(() => tracers.delete(native));
  return looked;
}

/** As js/predict has it. @type {typeof import('../predict/calibrate.mjs').calibrate} */
export const calibrate = async (...args) => (await predictModule()).calibrate(...args);

/** What others wait for too goes on when one of them leaves. */
function untilAbort(promise, signal) {
  if (!signal) return promise;
  signal.throwIfAborted();
  return new Promise((resolve, reject) => {
    const stopListening = onAbort(signal, reject);
    promise.then(resolve, reject).finally(stopListening);
  });
}

/** What the narrowest class of a scene and its numbers say, in words. */
const basisOf = ({ basis, scenes, looked }, isHere) =>
  `${looked ? `a window of ${looked} pixels, and times of ` : ''}${scenes} measured scenes of the class "${basis}"${isHere ? ', times by the calibration of this machine' : ''}`;

/**
 * @param {object} native the addon's exports
 * @param {object} request
 * @param {object} request.resolved shot whose quality is a goal
 * @param {object} request.scene native
 * @param {{triangles: number}} request.facts of the model
 * @param {object} request.limits
 * @param {() => Promise<import('../predict/choose.mjs').Machine>} request.machine calibration, where it is needed
 * @param {(shot: object) => Promise<Uint8Array>} [request.draw] resolved shot to RGBA: an error is then also looked for in a window of the picture
 * @param {import('./work.mjs').Work} [work]
 * @returns {Promise<{quality: object, goal: object, end?: import('../predict/choose.mjs').End}>} quality: resolved; goal: what info tells of it; end: for endBy
 */
export async function settingsFor(native, { resolved, scene, facts, limits, machine, draw }, work) {
  const { choose, chooseByWindow, featuresOf, TABLE } = await predictModule();
  const { resolveQuality } = await import('../shot/quality.mjs');
  const draft = shotJson({ ...resolved, quality: resolveQuality('draft') });
  const plan = JSON.parse(await nativeCall(native, work, (token) => native.plan(scene, draft, limits, token, true)));
  const isHere = resolved.quality.budgetMs !== undefined;
  const here = { tracer: await hasTracer(native), machine: isHere ? await untilAbort(machine(), work?.signal) : undefined };
  const of = [TABLE, resolved.quality, featuresOf(resolved, plan, facts), here];
  const chosen = draw && !isHere ? await chooseByWindow(...of, resolved, draw) : choose(...of);
  const { setting, quality, flip, cpuMs, mostMs, holds, end, ...from } = chosen;
  const goal = { ...resolved.quality, setting, predicted: { flip, cpuMs, mostMs }, holds, basis: basisOf(from, isHere) };
  return { quality: resolveQuality(quality), goal, end: endFor(end, resolved) };
}

/** An environment behind the model moves from sample to sample as the model does: what of the noise is the model's is not known. */
const endFor = (end, { background }) => (end?.error !== undefined && (background.type ?? background) === 'environment' ? undefined : end);

/** Ends a job when its goal is reached. @param {import('../predict/choose.mjs').End | undefined} end @param {object} token native */
export function endBy(end, token) {
  if (end?.spentMs !== undefined) token.allowCpu(end.spentMs);
  if (end?.error !== undefined) token.allowError(end.error);
}

/**
 * What a picture with a goal of error came to: its settings in a window of it, against the path tracer.
 * @param {object} native
 * @param {object} resolved the shot that was drawn
 * @param {number | undefined} ended samples with which it was
 * @param {(shot: object) => Promise<Uint8Array>} draw resolved shot to RGBA
 * @returns {Promise<{flip: number, pixels: number} | null>} null where the tracer is not there
 */
export async function reachedBy(native, resolved, ended, draw) {
  if (!(await hasTracer(native))) return null;
  const { endedQuality, openWindow } = await predictModule();
  const window = await openWindow(draw, resolved, { exact: true });
  return { flip: await window.flipOf(endedQuality(resolved.quality, ended)), pixels: window.pixels };
}

/** @param {object} goal of settingsFor @returns {{code: string, message: string, pointer: string}[]} */
export function goalWarnings({ maxError, budgetMs, setting, predicted, holds }) {
  if (holds) return [];
  const [key, wanted, reached] =
    maxError === undefined
      ? ['budgetMs', `${budgetMs} ms`, `the fastest, ${setting}, may take ${Math.ceil(predicted.mostMs)} ms`]
      : ['maxError', `FLIP ${maxError}`, `the most accurate, ${setting}, is at ${predicted.flip.toFixed(4)}`];
  return [{ code: 'W_QUALITY', pointer: `/quality/${key}`, message: `shot.quality.${key}: no setting is predicted to hold ${wanted} here; ${reached}` }];
}
