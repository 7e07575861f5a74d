import { TelarError } from '../error/index.mjs';

/** The lengths of points of measure, on the model. */

/** A point that lies farther off the surface than this is most likely meant for another model or unit: 2 cm. */
const MOVED = 0.02;

/** Keys that say what is measured, of which one may be given. */
export const PLACES = ['points', 'girth', 'border'];

/** What model.measure() is asked for a point of measure; undefined where the spec gives no place on the model. */
function askOf({ points, along, closed, girth, border, part, join }, anchors) {
  const place = (point) => (typeof point === 'string' ? anchors[point] : point);
  const common = { ...(part && { part }), join };
  if (points) return { ...common, points: points.map(place), along, closed };
  if (girth) return { ...common, girth: { ...girth, point: place(girth.point) } };
  return border ? { ...common, border } : undefined;
}

/** The line that shows what was measured: of a border its longest loop. */
function pathOf(measured, { closed: isAsked }) {
  const { polyline, closed = isAsked } = measured.loops?.[0] ?? measured;
  return { path: polyline, isLoop: closed };
}

/**
 * @param {object} measure of readSpec
 * @param {{model: object, anchors: object, variant: string, pointer: string, call: {signal?: AbortSignal, timeoutMs?: number | null}, warn: (code: string, message: string, pointer: string) => void}} context
 * @returns {Promise<{length?: number, path?: number[][], isLoop?: boolean}>} millimetres, and where it runs, metres; nothing where it is not on the model
 * @throws {TelarError} of Model.measure, with the pointer into the spec
 */
export async function lengthOf(measure, { model, anchors, variant, pointer, call, warn }) {
  const ask = askOf(measure, anchors);
  if (!ask) return {};
  try {
    const measured = await model.measure({ ...ask, variant, ...call });
    measured.points?.forEach(({ moved }, i) => {
      if (moved > MOVED)
        warn(
          'W_SHEET_POINT',
          `spec.measures: a point of ${JSON.stringify(measure.code)} is ${Math.round(1000 * moved)} mm off the garment`,
          `${pointer}/points/${i}`,
        );
    });
    return { length: 1000 * measured.length * measure.times, ...pathOf(measured, measure) };
  } catch (thrown) {
    if (!(thrown instanceof TelarError) || thrown.kind === 'cancelled') throw thrown;
    throw new TelarError(thrown.code, `spec.measures: ${JSON.stringify(measure.code)} cannot be measured: ${thrown.message}`, {
      ...thrown.toJSON(),
      pointer,
      cause: thrown,
    });
  }
}
