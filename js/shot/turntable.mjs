import { VIEWS } from './frame.mjs';

/** Frames of a model that turns. Pure. */

/** Degrees as a name has them: "007", "112.5". */
const degreesText = (angle) => {
  const [whole, part] = String(Number(angle.toFixed(3))).split('.');
  return part === undefined ? whole.padStart(3, '0') : `${whole.padStart(3, '0')}.${part}`;
};

/** Each frame would be metered by itself, and the model grow bright and dark as it turns. */
const unmetered = ({ look, metering }) => (look || metering ? { metering: null } : {});

/**
 * The shots of a turntable, evenly spaced, the first one the shot's own view: all share one scale and one axis
 * (`camera.fitTo: "turntable"`), and one exposure, as nothing is metered.
 * @param {object} shot not resolved; its camera is a view
 * @param {number} frames at least 1
 * @returns {{name: string, angle: number, shot: object}[]} in order; name: "side-000", by degrees from the first
 */
export function turntable(shot, frames) {
  const { view = 'front', azimuth, elevation, ...framing } = shot.camera ?? {};
  const isNamed = azimuth === undefined && elevation === undefined;
  const first = isNamed ? VIEWS[view] : { azimuth: azimuth ?? 0, elevation: elevation ?? 0 };
  return Array.from({ length: frames }, (_, i) => {
    const angle = (360 * i) / frames;
    const turned = (first.azimuth + angle) % 360;
    const camera = { ...framing, azimuth: turned, elevation: first.elevation, fitTo: 'turntable' };
    return { name: `side-${degreesText(angle)}`, angle, shot: { ...shot, ...unmetered(shot), camera } };
  });
}
