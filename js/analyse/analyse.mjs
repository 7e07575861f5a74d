import { TelarError, toTelarError } from '../error/index.mjs';
import { cellsOf, stepsOf } from './cells.mjs';
import { curvesOf } from './lobes.mjs';
import { rank } from './ranking.mjs';

/**
 * @typedef {object} Analysis
 * @property {{from: string, to: string}} names - Of the two shadings.
 * @property {import('./swaps.mjs').Swaps} swaps
 * @property {Awaited<ReturnType<typeof cellsOf>>} cells
 * @property {import('./ranking.mjs').Row[]} rows - The term that changes most first.
 * @property {import('./lobes.mjs').Curves[]} curves - One a target.
 * @property {object} shot - Keys that all pictures share.
 */

/** @returns {number} steps that `analyse` counts off */
export const analysisSteps = (plan) => stepsOf(plan) + plan.targets.length;

/**
 * Draws, compares and ranks.
 * @param {object} api with evaluateShading
 * @param {object} renderer of api.createRenderer
 * @param {{names: {from: string, to: string}, targets: import('./targets.mjs').Target[], lights: Array<{name: string, shot:
 *   object}>, swaps: import('./swaps.mjs').Swaps, shot: object}} plan
 * @param {{signal?: AbortSignal, step?: (name: string) => void}} [options]
 * @returns {Promise<Analysis>}
 * @throws {import('../error/index.mjs').TelarError} with the target's name in front; the signal's reason
 */
export async function analyse(api, renderer, plan, { signal, step = () => {} } = {}) {
  const { names, targets, swaps, shot } = plan;
  const [cells, curves] = [[], []];
  for (const target of targets) {
    try {
      const model = await renderer.load(target.source, { signal });
      cells.push(...(await cellsOf(renderer, model, target, plan, { signal, step })));
      await renderer.release(model);
      curves.push(await curvesOf(api, model, target, swaps.shadings, { signal }));
      step(`${target.name}, lobes`);
    } catch (thrown) {
      signal?.throwIfAborted();
      throw named(target, thrown);
    }
  }
  return { names, swaps, cells, rows: rank(cells, swaps.terms), curves, shot };
}

function named(target, thrown) {
  const error = toTelarError(thrown);
  return new TelarError(error.code, `${target.name}: ${error.message}`, error);
}
