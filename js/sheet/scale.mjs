import { dot, subtract, viewBasis, VIEWS } from '../shot/frame.mjs';
import { INCH, metresPerPixelOf, PIXELS_MAX, ratioOf } from '../shot/true_scale.mjs';

export { INCH, ratioOf };

/**
 * Views in true scale: an orthographic camera whose millimetres per pixel are exact, and where it sees a point of the model. Pure.
 *
 * @typedef {[number, number, number]} Vec3
 * @typedef {{right: Vec3, up: Vec3, back: Vec3}} Basis
 * @typedef {object} Extent what a direction sees of a model
 * @property {Basis} basis
 * @property {Vec3} centre - Of what is seen, metres.
 * @property {number} width - Metres along `basis.right`.
 * @property {number} height - Metres along `basis.up`.
 */

/** Usual scales of drawings, millimetres of the garment on one of paper: small ones enlarge. */
const USUAL = [0.1, 0.2, 0.25, 0.5, 1, 1.5, 2, 2.5, 3, 4, 5, 6, 7, 8, 10, 12, 15, 20, 25, 30, 40, 50, 75, 100, 200, 500, 1000, 2000, 5000];

/** 5 = "1:5", 0.5 = "2:1". */
export const scaleText = (ratio) => (ratio >= 1 ? `1:${Number(ratio.toFixed(3))}` : `${Number((1 / ratio).toFixed(3))}:1`);

/** Basis of a view of the spec. @param {{view?: string, azimuth?: number, elevation?: number}} view */
export function basisOf({ view, azimuth, elevation }) {
  const named = azimuth === undefined && elevation === undefined ? VIEWS[view ?? 'front'] : { azimuth: azimuth ?? 0, elevation: elevation ?? 0 };
  return viewBasis(named.azimuth, named.elevation);
}

/**
 * What a direction sees of a model.
 * @param {[number, number][]} ranges from where to where it reaches along `right`, `up` and `back` of the basis, metres
 * @param {Basis} basis
 * @returns {Extent}
 */
export function extentOf([x, y, z], basis) {
  const middle = ([low, high]) => low + (high - low) / 2;
  const centre = [0, 1, 2].map((i) => middle(x) * basis.right[i] + middle(y) * basis.up[i] + middle(z) * basis.back[i]);
  return { basis, centre, width: x[1] - x[0], height: y[1] - y[0] };
}

/**
 * The largest usual scale at which all of some extents fit into a box.
 * @param {{width: number, height: number}[]} extents metres
 * @param {{width: number, height: number}} box millimetres of paper
 * @returns {number} millimetres of the garment on one of paper
 */
export function fittingRatio(extents, box) {
  const needed = Math.max(...extents.map(({ width, height }) => Math.max((1000 * width) / box.width, (1000 * height) / box.height)));
  return USUAL.find((ratio) => ratio >= needed * (1 - 1e-9)) ?? needed;
}

/**
 * An orthographic camera in true scale.
 * @param {Extent} extent metres
 * @param {{ratio: number, ppi: number, margin?: number, depth?: number}} options ratio: millimetres of the garment on one of paper;
 *   margin: white around, millimetres of paper; depth: metres from the centre to the camera
 * @returns {TrueView}
 *
 * @typedef {object} TrueView
 * @property {{width: number, height: number}} size - Pixels.
 * @property {object} camera - Of the shot.
 * @property {number} metresPerPixel
 * @property {{width: number, height: number}} paper - Millimetres that the picture takes.
 * @property {(point: Vec3) => [number, number]} paperOf - Where a point of the model is, millimetres of paper from the top left corner.
 * @property {(place: [number, number]) => Vec3} pointAt - The point there, as deep as the centre.
 * @property {number} ratio
 */
export function trueView({ basis, centre, width, height }, { ratio, ppi: wanted, margin = 0, depth = 10 }) {
  // A picture of more pixels than can be drawn has a lower resolution: cut off, a part of the garment would be missing.
  const inches = ((1000 * Math.max(width, height)) / ratio + 2 * margin) / INCH;
  const ppi = Math.min(wanted, (PIXELS_MAX - 1) / inches);
  const metresPerPixel = metresPerPixelOf(ratio, ppi);
  const side = (length) => Math.max(1, Math.ceil(length / metresPerPixel + (2 * margin * ppi) / INCH));
  const size = { width: side(width), height: side(height) };
  const camera = {
    projection: 'orthographic',
    position: centre.map((x, i) => x + depth * basis.back[i]),
    target: centre,
    up: basis.up,
    height: size.height * metresPerPixel,
  };
  const paper = { width: (size.width * INCH) / ppi, height: (size.height * INCH) / ppi };
  const paperOf = (point) => {
    const from = subtract(point, centre);
    return [paper.width / 2 + (1000 * dot(from, basis.right)) / ratio, paper.height / 2 - (1000 * dot(from, basis.up)) / ratio];
  };
  const pointAt = ([x, y]) => {
    const [across, upwards] = [((x - paper.width / 2) * ratio) / 1000, ((paper.height / 2 - y) * ratio) / 1000];
    return centre.map((c, i) => c + across * basis.right[i] + upwards * basis.up[i]);
  };
  return { size, camera, metresPerPixel, paper, paperOf, pointAt, ratio };
}
