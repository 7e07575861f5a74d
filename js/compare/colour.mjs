import { srgbToLinear } from '../shot/colour.mjs';

/** Colour spaces of the metrics: linear Rec.709 in [0, 1], CIE XYZ (Y of white = 1), CIELAB, all under D65. */

/** 8-bit sRGB to linear. */
export const LINEAR = Float64Array.from({ length: 256 }, (_, byte) => srgbToLinear(byte / 255));

// Linear Rec.709 to XYZ with the fractions that FLIP publishes; the rows sum to D65.
const M = [
  [10135552 / 24577794, 8788810 / 24577794, 4435075 / 24577794],
  [2613072 / 12288897, 8788810 / 12288897, 887015 / 12288897],
  [1425312 / 73733382, 8788810 / 73733382, 70074185 / 73733382],
];

const inverse3 = (m) => {
  const cofactor = (r, c) => m[(r + 1) % 3][(c + 1) % 3] * m[(r + 2) % 3][(c + 2) % 3] - m[(r + 1) % 3][(c + 2) % 3] * m[(r + 2) % 3][(c + 1) % 3];
  const determinant = [0, 1, 2].reduce((sum, c) => sum + m[0][c] * cofactor(0, c), 0);
  return [0, 1, 2].map((r) => [0, 1, 2].map((c) => cofactor(c, r) / determinant));
};
const INVERSE = inverse3(M);

/** XYZ of white. */
export const WHITE = M.map((row) => row[0] + row[1] + row[2]);

/** XYZ relative to white, so that white is (1, 1, 1); written to `out`. */
export function relativeXyz(r, g, b, out) {
  for (let i = 0; i < 3; i++) out[i] = (M[i][0] * r + M[i][1] * g + M[i][2] * b) / WHITE[i];
  return out;
}

/** Linear Rec.709, unclamped, of XYZ relative to white; written to `out`. */
export function linearOf(x, y, z, out) {
  const [X, Y, Z] = [x * WHITE[0], y * WHITE[1], z * WHITE[2]];
  for (let i = 0; i < 3; i++) out[i] = INVERSE[i][0] * X + INVERSE[i][1] * Y + INVERSE[i][2] * Z;
  return out;
}

const DELTA = 6 / 29;
const labCurve = (t) => (t > DELTA ** 3 ? Math.cbrt(t) : t / (3 * DELTA * DELTA) + 4 / 29);

/** CIELAB of linear Rec.709; written to `out`. */
export function labOf(r, g, b, out) {
  relativeXyz(r, g, b, out);
  const [fx, fy, fz] = [labCurve(out[0]), labCurve(out[1]), labCurve(out[2])];
  [out[0], out[1], out[2]] = [116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)];
  return out;
}
