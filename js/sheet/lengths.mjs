import { TelarError } from '../error/index.mjs';
import { dot, subtract } from '../shot/frame.mjs';

/** The lengths of points of measure, on the model. */

/** A point that lies farther off the surface than this is most likely meant for another model or unit: 2 cm. */
const MOVED = 0.02;
/** A loop that is drawn tight and leaves its plane by more has slid to where the part is narrower: 3 cm. */
const SLID = 0.03;

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

/** Metres from a point to a line. */
function distanceTo(point, { polyline, closed }) {
  const ends = closed ? [...polyline.slice(1), polyline[0]] : polyline.slice(1);
  const distanceOf = (end, i) => {
    const [along, to] = [subtract(end, polyline[i]), subtract(point, polyline[i])];
    const part = Math.min(1, Math.max(0, dot(to, along) / dot(along, along) || 0));
    return Math.hypot(
      ...subtract(
        to,
        along.map((x) => part * x),
      ),
    );
  };
  return ends.reduce((least, end, i) => Math.min(least, distanceOf(end, i)), Infinity);
}

/** Tells of points that lie off what was measured, and of a girth that does not close or stays where it is asked for. */
async function warnOf(measured, ask, { code, pointer, warn, section }) {
  const name = JSON.stringify(code);
  const millimetres = (metres) => Math.round(1000 * metres);
  measured.points?.forEach(({ moved }, i) => {
    if (moved > MOVED) warn('W_SHEET_POINT', `spec.measures: a point of ${name} is ${millimetres(moved)} mm off the garment`, `${pointer}/points/${i}`);
  });
  if (!ask.girth) return;
  if (!measured.closed)
    warn('W_SHEET_GIRTH', `spec.measures: the girth ${name} does not close around the part; what is measured is an open line`, `${pointer}/girth`);
  const { point, tight, normal = [0, 1, 0] } = ask.girth;
  const offPlane = (at) => Math.abs(dot(subtract(at, point), normal)) / Math.hypot(...normal);
  const slid = tight ? measured.polyline.reduce((most, at) => Math.max(most, offPlane(at)), 0) : 0;
  if (slid > SLID)
    warn(
      'W_SHEET_GIRTH',
      `spec.measures: drawn tight, the girth ${name} slides ${millimetres(slid)} mm out of its plane, to where the part is narrower`,
      `${pointer}/girth/tight`,
    );
  if (distanceTo(point, measured) <= MOVED) return;
  // A tape that is drawn tight leaves hollows: what counts is the cloth in the plane.
  const distance = distanceTo(point, tight ? await section() : measured);
  if (distance > MOVED)
    warn(
      'W_SHEET_POINT',
      `spec.measures: the point of the girth ${name} is ${millimetres(distance)} mm off the line that is measured`,
      `${pointer}/girth/point`,
    );
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
    const section = () => model.measure({ ...ask, girth: { ...ask.girth, tight: false }, variant, ...call });
    await warnOf(measured, ask, { code: measure.code, pointer, warn, section });
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
