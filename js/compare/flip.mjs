import { cut, differingBox, grown, sizeOf } from './box.mjs';
import { LINEAR, labOf, linearOf, relativeXyz } from './colour.mjs';
import { convolve, kernel, total } from './convolve.mjs';

/**
 * FLIP for LDR pictures (Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild 2020): how much a person sees
 * who flips between the two at a given distance. 0 = no difference, 1 = the largest.
 */

/** A 0.7 m wide monitor of 3840 pixels seen from 0.7 m: the setting of the paper. */
export const PIXELS_PER_DEGREE = 67;

/** Contrast sensitivity of each opponent channel: a sum of Gaussians [a, b] over degrees. */
const SENSITIVITY = {
  achromatic: [[1, 0.0047]],
  redGreen: [[1, 0.0053]],
  blueYellow: [
    [34.1, 0.04],
    [13.5, 0.025],
  ],
};
const WIDEST = 0.04;
/** Width of a feature in degrees. */
const FEATURE_DEGREES = 0.082;
const COLOUR_EXPONENT = 0.7;
const FEATURE_EXPONENT = 0.5;
/** The share PC of the largest colour error is mapped to PT. */
const [PC, PT] = [0.4, 0.95];

/** Three standard deviations of the widest sensitivity, in pixels. */
const filterRadius = (pixelsPerDegree) => Math.ceil(3 * Math.sqrt(WIDEST / (2 * Math.PI ** 2)) * pixelsPerDegree);

/** Standard deviation of the Gaussian that finds features, in pixels. */
const featureDeviation = (pixelsPerDegree) => 0.5 * FEATURE_DEGREES * pixelsPerDegree;
const featureRadius = (pixelsPerDegree) => Math.ceil(3 * featureDeviation(pixelsPerDegree));

/** [{across, down}] whose convolutions add up to the filter, which sums to 1. */
function sensitivityFilter(gaussians, pixelsPerDegree) {
  const radius = filterRadius(pixelsPerDegree);
  const parts = gaussians.map(([a, b]) => ({
    weight: a * Math.sqrt(Math.PI / b),
    shape: kernel(radius, (x) => Math.exp((-(Math.PI ** 2) * (x / pixelsPerDegree) ** 2) / b)),
  }));
  const sum = parts.reduce((all, { weight, shape }) => all + weight * total(shape) ** 2, 0);
  return parts.map(({ weight, shape }) => ({ across: shape.map((value) => (value * weight) / sum), down: shape }));
}

/** Smoothing, and first and second derivative, of a Gaussian; positive and negative weights each sum to 1. */
function featureKernels(pixelsPerDegree) {
  const sd = featureDeviation(pixelsPerDegree);
  const radius = featureRadius(pixelsPerDegree);
  const gaussian = (x) => Math.exp(-(x * x) / (2 * sd * sd));
  const halves = (weights) => {
    const [plus, minus] = [total(weights.filter((w) => w > 0)), -total(weights.filter((w) => w < 0))];
    return weights.map((w) => w / (w > 0 ? plus : minus));
  };
  const smooth = kernel(radius, gaussian);
  return {
    smooth: smooth.map((w) => w / total(smooth)),
    edge: halves(kernel(radius, (x) => -x * gaussian(x))),
    point: halves(kernel(radius, (x) => ((x * x) / (sd * sd) - 1) * gaussian(x))),
  };
}

/** Opponent planes [Y, Cx, Cz] (Hunter Lab without its roots). */
function opponentPlanes(pixels) {
  const planes = [0, 1, 2].map(() => new Float32Array(pixels.length / 4));
  const xyz = new Float64Array(3);
  for (let p = 0, i = 0; i < pixels.length; p++, i += 4) {
    relativeXyz(LINEAR[pixels[i]], LINEAR[pixels[i + 1]], LINEAR[pixels[i + 2]], xyz);
    planes[0][p] = 116 * xyz[1] - 16;
    planes[1][p] = 500 * (xyz[0] - xyz[1]);
    planes[2][p] = 200 * (xyz[1] - xyz[2]);
  }
  return planes;
}

function filtered(plane, width, height, filter) {
  const [first, ...rest] = filter.map(({ across, down }) => convolve(plane, width, height, across, down));
  for (const part of rest) for (let i = 0; i < first.length; i++) first[i] += part[i];
  return first;
}

/** CIELAB of linear colour with chroma scaled by lightness (Hunt effect); written to `out`. */
function huntLab(r, g, b, out) {
  labOf(r, g, b, out);
  out[1] *= 0.01 * out[0];
  out[2] *= 0.01 * out[0];
  return out;
}

const hyab = (a, b) => Math.abs(a[0] - b[0]) + Math.hypot(a[1] - b[1], a[2] - b[2]);
const LARGEST = hyab(huntLab(0, 1, 0, []), huntLab(0, 0, 1, [])) ** COLOUR_EXPONENT;

/** Colour error, 0..1, of a HyAB distance. */
function redistributed(distance) {
  const error = distance ** COLOUR_EXPONENT;
  const knee = PC * LARGEST;
  return error < knee ? (PT / knee) * error : PT + ((error - knee) / (LARGEST - knee)) * (1 - PT);
}

/** Perceived colour of a pixel of filtered opponent planes; written to `out`. */
function perceived([Y, Cx, Cz], p, out) {
  const y = (Y[p] + 16) / 116;
  linearOf(y + Cx[p] / 500, y, y - Cz[p] / 200, out);
  const clamp = (x) => Math.min(1, Math.max(0, x));
  return huntLab(clamp(out[0]), clamp(out[1]), clamp(out[2]), out);
}

/** Strength of a feature: length of its response along x and y. */
function strength(luminance, width, height, detector, smooth) {
  const along = convolve(luminance, width, height, detector, smooth);
  const down = convolve(luminance, width, height, smooth, detector);
  return along.map((value, i) => Math.hypot(value, down[i]));
}

function look(pixels, width, height, pixelsPerDegree) {
  const planes = opponentPlanes(pixels);
  const { smooth, edge, point } = featureKernels(pixelsPerDegree);
  const luminance = planes[0].map((Y) => (Y + 16) / 116);
  return {
    colour: Object.values(SENSITIVITY).map((gaussians, c) => filtered(planes[c], width, height, sensitivityFilter(gaussians, pixelsPerDegree))),
    edges: strength(luminance, width, height, edge, smooth),
    points: strength(luminance, width, height, point, smooth),
  };
}

/** How far a pixel's error reaches: the widest filter's radius, in pixels. */
const reachOf = (pixelsPerDegree) => Math.max(filterRadius(pixelsPerDegree), featureRadius(pixelsPerDegree));

/**
 * @param {Uint8Array} expected RGBA8, sRGB-encoded; alpha is not looked at
 * @param {Uint8Array} actual
 * @param {number} width
 * @param {number} height
 * @param {number} [pixelsPerDegree] of the visual field
 * @returns {Float32Array} error of each pixel, 0..1
 */
export function flipMap(expected, actual, width, height, pixelsPerDegree = PIXELS_PER_DEGREE) {
  const map = new Float32Array(width * height);
  const differing = differingBox(expected, actual, width, height);
  if (!differing) return map;
  // Errors lie within the reach of a difference, and pixels within the reach of those errors decide them.
  const reach = reachOf(pixelsPerDegree);
  const errors = grown(differing, reach, width, height);
  const box = grown(errors, reach, width, height);
  const size = sizeOf(box);
  const part = boxMap(cut(expected, width, box), cut(actual, width, box), size.width, size.height, pixelsPerDegree);
  for (let y = errors.top; y < errors.bottom; y++) {
    const from = (y - box.top) * size.width + errors.left - box.left;
    map.set(part.subarray(from, from + errors.right - errors.left), y * width + errors.left);
  }
  return map;
}

function boxMap(expected, actual, width, height, pixelsPerDegree) {
  const [a, b] = [expected, actual].map((pixels) => look(pixels, width, height, pixelsPerDegree));
  const [labA, labB] = [new Float64Array(3), new Float64Array(3)];
  return a.edges.map((edge, p) => {
    const colour = redistributed(hyab(perceived(a.colour, p, labA), perceived(b.colour, p, labB)));
    const feature = Math.max(Math.abs(edge - b.edges[p]), Math.abs(a.points[p] - b.points[p]));
    return colour ** (1 - Math.min(1, feature / Math.SQRT2) ** FEATURE_EXPONENT);
  });
}
