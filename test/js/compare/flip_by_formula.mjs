/**
 * FLIP straight from the formulas of the paper (Andersson et al. 2020, sections 4.1 to 4.3): full two-dimensional kernels
 * in double precision, pixel by pixel. It shares no code with js/compare and is far too slow for real pictures.
 */

// Linear Rec.709 to XYZ from the chromaticities of the primaries and of D65, as IEC 61966-2-1 gives them.
const PRIMARIES = [
  [0.64, 0.33],
  [0.3, 0.6],
  [0.15, 0.06],
];
const D65 = [0.3127, 0.329];
const xyzOf = ([x, y]) => [x / y, 1, (1 - x - y) / y];

/** Solves a 3 x 3 system by Cramer's rule; columns are vectors. */
function solve(columns, right) {
  const det = ([a, b, c]) => a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) + c[0] * (a[1] * b[2] - a[2] * b[1]);
  return columns.map((_, i) => det(columns.map((column, j) => (i === j ? right : column))) / det(columns));
}

const COLUMNS = PRIMARIES.map(xyzOf);
const SCALES = solve(COLUMNS, xyzOf(D65));
const RGB = COLUMNS.map((column, i) => column.map((value) => value * SCALES[i]));
const WHITE = xyzOf(D65);

const toXyz = (rgb) => [0, 1, 2].map((i) => RGB.reduce((sum, column, c) => sum + column[i] * rgb[c], 0));
const toRgb = (xyz) => solve(RGB, xyz);
const decode = (byte) => (byte / 255 <= 0.04045 ? byte / 255 / 12.92 : ((byte / 255 + 0.055) / 1.055) ** 2.4);

function toOpponent(rgb) {
  const [x, y, z] = toXyz(rgb).map((value, i) => value / WHITE[i]);
  return [116 * y - 16, 500 * (x - y), 200 * (y - z)];
}
function fromOpponent([Y, cx, cz]) {
  const y = (Y + 16) / 116;
  return toRgb([y + cx / 500, y, y - cz / 200].map((value, i) => value * WHITE[i]));
}
function hunt(rgb) {
  const f = (t) => (t > (6 / 29) ** 3 ? t ** (1 / 3) : (t * (29 / 6) ** 2) / 3 + 4 / 29);
  const [x, y, z] = toXyz(rgb).map((value, i) => f(value / WHITE[i]));
  const L = 116 * y - 16;
  return [L, 0.01 * L * 500 * (x - y), 0.01 * L * 200 * (y - z)];
}
const hyab = (p, q) => Math.abs(p[0] - q[0]) + Math.sqrt((p[1] - q[1]) ** 2 + (p[2] - q[2]) ** 2);

/** Weights [{dx, dy, weight}] of a square of this radius. */
function kernel(radius, f) {
  const weights = [];
  for (let dy = -radius; dy <= radius; dy++) for (let dx = -radius; dx <= radius; dx++) weights.push({ dx, dy, weight: f(dx, dy) });
  return weights;
}
const sumOf = (weights) => weights.reduce((sum, { weight }) => sum + weight, 0);
const scaled = (weights, scale) => weights.map((item) => ({ ...item, weight: item.weight * scale(item.weight) }));
function unit(weights) {
  const sum = sumOf(weights);
  return scaled(weights, () => 1 / sum);
}
function halves(weights) {
  const [plus, minus] = [sumOf(weights.filter(({ weight }) => weight > 0)), -sumOf(weights.filter(({ weight }) => weight < 0))];
  return scaled(weights, (weight) => 1 / (weight > 0 ? plus : minus));
}

/** @param {{width: number, height: number, data: Uint8Array}} expected opaque @returns {Float64Array} */
export function flipByFormula(expected, actual, ppd) {
  const { width, height } = expected;
  const clampTo = (value, most) => Math.min(most - 1, Math.max(0, value));
  const at = (values, x, y) => values[clampTo(y, height) * width + clampTo(x, width)];
  const filter = (values, weights, x, y) => weights.reduce((sum, { dx, dy, weight }) => sum + weight * at(values, x + dx, y + dy), 0);

  const csf = [
    [
      [1, 0.0047],
      [0, 1e-5],
    ],
    [
      [1, 0.0053],
      [0, 1e-5],
    ],
    [
      [34.1, 0.04],
      [13.5, 0.025],
    ],
  ];
  const csfRadius = Math.ceil(3 * Math.sqrt(0.04 / (2 * Math.PI * Math.PI)) * ppd);
  const csfKernels = csf.map((terms) =>
    unit(
      kernel(csfRadius, (dx, dy) =>
        terms.reduce((sum, [a, b]) => sum + a * Math.sqrt(Math.PI / b) * Math.exp((-Math.PI * Math.PI * ((dx / ppd) ** 2 + (dy / ppd) ** 2)) / b), 0),
      ),
    ),
  );

  const sd = (0.082 / 2) * ppd;
  const gaussian = (dx, dy) => Math.exp(-(dx * dx + dy * dy) / (2 * sd * sd));
  const radius = Math.ceil(3 * sd);
  const edgeX = halves(kernel(radius, (dx, dy) => -dx * gaussian(dx, dy)));
  const edgeY = halves(kernel(radius, (dx, dy) => -dy * gaussian(dx, dy)));
  const pointX = halves(kernel(radius, (dx, dy) => ((dx / sd) ** 2 - 1) * gaussian(dx, dy)));
  const pointY = halves(kernel(radius, (dx, dy) => ((dy / sd) ** 2 - 1) * gaussian(dx, dy)));

  const planes = [expected, actual].map(({ data }) => {
    const opponent = Array.from({ length: width * height }, (_, p) => toOpponent([0, 1, 2].map((c) => decode(data[p * 4 + c]))));
    return [0, 1, 2].map((c) => opponent.map((value) => value[c]));
  });
  const luminances = planes.map(([Y]) => Y.map((value) => (value + 16) / 116));
  const seen = (image, x, y) =>
    hunt(fromOpponent(csfKernels.map((weights, c) => filter(planes[image][c], weights, x, y))).map((value) => Math.min(1, Math.max(0, value))));
  const feature = (image, [alongX, alongY], x, y) => Math.sqrt(filter(luminances[image], alongX, x, y) ** 2 + filter(luminances[image], alongY, x, y) ** 2);

  const most = hyab(hunt([0, 1, 0]), hunt([0, 0, 1])) ** 0.7;
  return Float64Array.from({ length: width * height }, (_, p) => {
    const [x, y] = [p % width, Math.floor(p / width)];
    const error = hyab(seen(0, x, y), seen(1, x, y)) ** 0.7;
    const colour = error < 0.4 * most ? (error * 0.95) / (0.4 * most) : 0.95 + (0.05 * (error - 0.4 * most)) / (0.6 * most);
    const [edge, point] = [
      [edgeX, edgeY],
      [pointX, pointY],
    ].map((pair) => Math.abs(feature(0, pair, x, y) - feature(1, pair, x, y)));
    return colour ** (1 - Math.sqrt(Math.max(edge, point) / Math.SQRT2));
  });
}
