import { LINEAR, labOf } from './colour.mjs';

/** CIEDE2000 as written down by Sharma, Wu and Dalal (2005), with kL = kC = kH = 1. */

const RADIANS = Math.PI / 180;
const P7 = 25 ** 7;
const chromaTerm = (chroma) => Math.sqrt(chroma ** 7 / (chroma ** 7 + P7));

/** Hue angle in degrees, 0..360; 0 for grey. */
function hueOf(a, b) {
  if (a === 0 && b === 0) return 0;
  const angle = Math.atan2(b, a) / RADIANS;
  return angle < 0 ? angle + 360 : angle;
}

/** Signed difference and mean of two hues in degrees, along the shorter arc. Where either is grey the mean is their sum. */
function hues(h1, h2, grey) {
  if (grey) return [0, h1 + h2];
  const apart = h2 - h1;
  if (Math.abs(apart) <= 180) return [apart, (h1 + h2) / 2];
  return [apart > 180 ? apart - 360 : apart + 360, (h1 + h2 + (h1 + h2 < 360 ? 360 : -360)) / 2];
}

/**
 * @param {ArrayLike<number>} lab1 CIELAB: L*, a*, b*
 * @param {ArrayLike<number>} lab2
 * @returns {number} 0 = equal, about 1 = just noticeable
 */
export function ciede2000([L1, a1, b1], [L2, a2, b2]) {
  const g = 1 + 0.5 * (1 - chromaTerm((Math.hypot(a1, b1) + Math.hypot(a2, b2)) / 2));
  const [A1, A2] = [a1 * g, a2 * g];
  const [C1, C2] = [Math.hypot(A1, b1), Math.hypot(A2, b2)];
  const [dh, h] = hues(hueOf(A1, b1), hueOf(A2, b2), C1 * C2 === 0);
  const [L, C] = [(L1 + L2) / 2, (C1 + C2) / 2];
  const cos = (factor, shift) => Math.cos((factor * h + shift) * RADIANS);
  const t = 1 - 0.17 * cos(1, -30) + 0.24 * cos(2, 0) + 0.32 * cos(3, 6) - 0.2 * cos(4, -63);
  const dL = (L2 - L1) / (1 + (0.015 * (L - 50) ** 2) / Math.sqrt(20 + (L - 50) ** 2));
  const dC = (C2 - C1) / (1 + 0.045 * C);
  const dH = (2 * Math.sqrt(C1 * C2) * Math.sin((dh / 2) * RADIANS)) / (1 + 0.015 * C * t);
  const rotation = -Math.sin(60 * RADIANS * Math.exp(-(((h - 275) / 25) ** 2))) * 2 * chromaTerm(C);
  return Math.sqrt(dL * dL + dC * dC + dH * dH + rotation * dC * dH);
}

/**
 * @param {Uint8Array} expected RGBA8, sRGB-encoded; alpha is not looked at
 * @param {Uint8Array} actual
 * @returns {Float32Array} CIEDE2000 of each pixel
 */
export function ciede2000Map(expected, actual) {
  const map = new Float32Array(expected.length / 4);
  const lab = (pixels, i, out) => labOf(LINEAR[pixels[i]], LINEAR[pixels[i + 1]], LINEAR[pixels[i + 2]], out);
  const [first, second] = [new Float64Array(3), new Float64Array(3)];
  for (let p = 0, i = 0; p < map.length; p++, i += 4) {
    if (expected[i] === actual[i] && expected[i + 1] === actual[i + 1] && expected[i + 2] === actual[i + 2]) continue;
    map[p] = ciede2000(lab(expected, i, first), lab(actual, i, second));
  }
  return map;
}
