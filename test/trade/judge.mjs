import { choose } from '../../js/predict/choose.mjs';
import { canEnd, familyOf } from '../../js/predict/settings.mjs';
import { cheapestWithin } from '../../js/trade/front.mjs';

/** Goals that the predictions are judged by: FLIP, and CPU milliseconds. */
export const MAX_ERRORS = [0.01, 0.015, 0.02, 0.03, 0.04, 0.06, 0.1, 0.2];
export const BUDGETS = [30, 60, 120, 250, 500, 1000, 2000, 4000, 8000, 16000];

/** How many times the time of the cheapest setting that holds a chosen one may take. */
const DEAR = 2;

const drawableOf = (rows) => rows.filter(({ setting, features }) => familyOf(setting) !== 'tracer' || features.traceable);

/** Part of the time of `standard` that a look takes which knows every error of a scene, and which no renderer has. */
export const EXACT_LOOK = 0.5;

/**
 * Answers after such a look, for judge(): how near to the least time a choice can come.
 * @param {import('../../js/trade/measure.mjs').Row[][]} scenes rows of each
 */
export const knowingAnswers = (scenes) =>
  scenes.map((rows) => {
    const lookMs = EXACT_LOOK * rows.find(({ setting }) => setting === 'standard').cpuMs;
    const answer = (best) => ({ setting: best?.setting ?? 'standard', holds: best !== undefined, lookMs });
    return Object.fromEntries(MAX_ERRORS.map((maxError) => [maxError, answer(cheapestWithin(drawableOf(rows), maxError))]));
  });

const share = (list, isTrue) => (list.length === 0 ? undefined : list.filter(isTrue).length / list.length);

/**
 * Goals put to measured scenes, as a renderer would answer them.
 * @param {import('../../js/predict/choose.mjs').TradeTable} table that knows nothing of them
 * @param {import('../../js/trade/measure.mjs').Row[][]} scenes rows of each
 * @param {{raster: number, tracer: number}} machine that they were measured on
 * @param {Record<number, {setting: string, holds: boolean, lookMs: number}>[]} [answers] of each scene, by error: what a renderer chose that looked at a
 *   window, and what that took (looks.mjs); none: by the class alone
 */
export function judge(table, scenes, machine, answers) {
  const here = { tracer: true, machine };
  const asked = (goal, rows, answer) => {
    const drawable = drawableOf(rows);
    const chosen = answer ?? choose(table, goal, rows[0].features, here);
    return { chosen, drawn: rows.find(({ setting }) => setting === chosen.setting), drawable };
  };
  const errors = scenes.flatMap((rows, scene) =>
    MAX_ERRORS.map((maxError) => {
      const { chosen, drawn, drawable } = asked({ maxError }, rows, answers?.[scene][maxError]);
      const best = cheapestWithin(drawable, maxError);
      const isHeld = drawn.flip <= maxError;
      const { holds, setting, lookMs = 0 } = chosen;
      return { maxError, promised: holds, held: isHeld, setting, best: best?.setting, times: best && (drawn.cpuMs + lookMs) / best.cpuMs };
    }),
  );
  const budgets = scenes.flatMap((rows) =>
    BUDGETS.map((budgetMs) => {
      const { chosen, drawn } = asked({ budgetMs }, rows);
      // One that can be ended takes no longer.
      return { budgetMs, promised: chosen.holds, held: canEnd(chosen.setting) || drawn.cpuMs <= budgetMs, setting: chosen.setting };
    }),
  );
  const promised = (list) => list.filter((each) => each.promised);
  const [ownErrors, ownBudgets] = [promised(errors), promised(budgets)];
  const comparable = ownErrors.filter(({ held, times }) => held && times !== undefined);
  return {
    scenes: scenes.length,
    maxError: {
      asked: errors.length,
      promised: ownErrors.length,
      held: share(ownErrors, ({ held }) => held),
      near: share(comparable, ({ times }) => times <= DEAR),
      possible: share(
        errors.filter(({ best }) => best !== undefined),
        (each) => each.promised,
      ),
    },
    budgetMs: { asked: budgets.length, promised: ownBudgets.length, held: share(ownBudgets, ({ held }) => held) },
    byError: MAX_ERRORS.map((maxError) => {
      const own = ownErrors.filter((each) => each.maxError === maxError);
      const times = own.flatMap((each) => (each.held && each.times !== undefined ? [each.times] : [])).sort((a, b) => a - b);
      return {
        maxError,
        promised: own.length,
        held: share(own, ({ held }) => held),
        near: share(times, (each) => each <= DEAR),
        median: times[Math.floor(times.length / 2)],
      };
    }),
    byBudget: BUDGETS.map((budgetMs) => {
      const own = ownBudgets.filter((each) => each.budgetMs === budgetMs);
      return { budgetMs, promised: own.length, held: share(own, ({ held }) => held) };
    }),
  };
}
