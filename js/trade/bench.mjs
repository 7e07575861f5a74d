import { TelarError, toTelarError } from '../error/index.mjs';
import { featuresOf } from '../predict/features.mjs';
import { measureScene } from './measure.mjs';

/** Settings times scenes: what `bench` counts off. */
export const benchSteps = ({ scenes, settings }) => scenes.length * Object.keys(settings).length;

/**
 * Draws every scene with every setting.
 * @param {object} api with inspect
 * @param {object} renderer of api.createRenderer
 * @param {{scenes: import('./measure.mjs').Scene[], settings: Record<string, object | string>, window: number, capMs: number, machine?: string,
 *   truth?: object}} plan
 * @param {object} store of measureScene
 * @param {{limits?: object, signal?: AbortSignal, step?: (name: string) => void}} [options] limits: those of the renderer, by name
 * @returns {Promise<import('./measure.mjs').Row[]>}
 * @throws {TelarError} with the scene's name in front; the signal's reason
 */
export async function bench(api, renderer, plan, store, { limits, signal, step } = {}) {
  const rows = [];
  let held;
  const release = async () => {
    if (held) await renderer.release(held.model);
    if (held?.visible) await renderer.release(held.visible);
  };
  for (const scene of plan.scenes) {
    try {
      if (held?.source !== scene.source) {
        await release();
        held = { source: scene.source, model: await renderer.load(scene.source, { signal }) };
      }
      const featuresOfShot = async (shot) => {
        const { plan: drawn, ...facts } = await api.inspect(scene.source, {
          shot: { ...shot, materials: scene.shot.materials ?? {}, quality: 'draft' },
          ...(limits && { limits }),
          signal,
        });
        return featuresOf(shot, drawn, facts);
      };
      const visibleModel = async () => (held.visible ??= await renderer.load(scene.source, { signal, ambientVisibility: true, timeoutMs: null }));
      rows.push(...(await measureScene(renderer, held.model, scene, { ...plan, featuresOf: featuresOfShot, visibleModel }, store, { signal, step })));
    } catch (thrown) {
      signal?.throwIfAborted();
      const error = toTelarError(thrown);
      throw new TelarError(error.code, `${scene.model}, ${scene.light}: ${error.message}`, error);
    }
  }
  return rows;
}
