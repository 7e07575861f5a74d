import type { ResolvedShot, Shot } from '../shot/shot.js';
import type { ModelFacts, Plan } from './facts.js';
import type { Limits, LoadOptions, Source } from './loading.js';
import type { BorderMeasure, GirthMeasure, MeasureAsk, PointsMeasure } from './measure.js';
import type { QualityGoal } from './picture.js';

export interface InspectOptions extends LoadOptions {
  /**
   * The shot to plan for.
   * @default {}
   */
  shot?: Shot | ResolvedShot;
  /**
   * What to measure on the model in the shot's pose, as Model.measure() takes it.
   * @default []
   */
  measure?: ReadonlyArray<MeasureAsk>;
  /**
   * What an input may cost, by the L_* names.
   * @default {}: the limits in js/docs/errors.md
   */
  limits?: Limits;
}

/**
 * Tells what is in a model, and what a render of it would compile and run. Needs no GL.
 * @param options - shot, measure, limits, failOn, resolve, timeoutMs, ambientVisibility, signal.
 * @returns The facts; `plan` is null where there is nothing to draw, `measures` are in the order of options.measure.
 * @throws {TelarError} What Renderer.load() throws, E_SHOT
 * @example
 * const { triangles, materials, plan } = await inspect('shirt.glb', { shot: { quality: 'high' } });
 * console.log(triangles, materials.map(({ name }) => name), plan?.passes);
 */
export function inspect(source: Source, options?: InspectOptions): Promise<Inspection>;

/** What inspect() gives. */
export interface Inspection extends ModelFacts {
  /** In the order that `measure` has. */
  measures?: Array<PointsMeasure | GirthMeasure | BorderMeasure>;
  /** What a render would compile and run; null where there is nothing to draw. */
  plan: Plan | null;
  /** Of a shot whose quality is a goal: the settings that `plan` is of. Times are those of the machine that was measured, as nothing is drawn on this one. */
  goal?: QualityGoal;
}
