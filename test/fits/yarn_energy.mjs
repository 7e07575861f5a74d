// node test/fits/yarn_energy.mjs: fits the curves of shaders/brdf/yarn_energy.glsl to the exact albedo of lobes of two widths. It starts at
// the numbers that stand there, tells how far they are off, and prints what it would set in their place. A fit that keeps more light than
// there is would shine: errors to that side weigh more.
import { pathToFileURL } from 'node:url';
import { exactAlbedo } from './exact_albedo.mjs';
import { leastSquares } from './least_squares.mjs';

/** Numbers of the text: four a polynomial, of 1, wide, even and wide². */
const START = {
  // middle; missing.x y z w
  missing: [
    0.61474, -0.41494, 0.02372, 0.31942, -0.20882, 0.06917, 0.76819, 0.03752, 0.10506, -0.0986, -1.04387, 0.03171, 0.1608, 0.22012, -0.82159, -0.35515,
    -0.62388, 0.54975, 0.80672, -0.08909,
  ],
  // width.x y z w; lift, ten times; grazing.x y z w; then those of grazingRatio: n1, q0, q1, q2
  grazing: [
    -0.66714, -0.7103, 1.68641, 0.49069, 1.75086, -1.26667, -7.45126, -0.4081, -1.16979, 2.08477, 6.01511, 0.7239, 0.39109, 0.61989, 0.2796, -0.56408, -0.00997,
    -0.00888, 3.84242, 0.01351, -0.00303, 0.02787, -0.08604, -0.02801, -0.0107, 1.12468, 0.22977, -1.71078, 0.02501, -1.03159, -0.14278, 2.04711, 0.08854,
    -0.94784, -0.15574, 0.3377, 2.04592, -1.62868, -2.38684, 0.5332, 3.69795, -4.00977, 1.62822, 2.17487, -2.75808, -5.6708, 10.7144, 4.01583, -1.57675,
    -4.76371,
  ],
};

const polynomial = (c, x) => c.reduceRight((sum, a) => sum * x + a, 0);
const clamp = (x, low, high) => Math.min(Math.max(x, low), high);
const worst = (values) => values.reduce((most, value) => Math.max(most, value), -Infinity);

/** The missing share of an even lobe, as in cloth_energy.glsl. */
function glossMissing(r, c) {
  const m0 = polynomial([0.1722752, 0.1449183, 0.9587954], r) ** 2;
  const m1 = polynomial([0.02384477, -0.0343379, 2.601833], r) ** 2;
  const k0 = polynomial([0.007781421, -1.468594, 0.8729609], r) ** 2;
  const k1 = polynomial([-0.1979422, 1.122898, 1.332237], r) ** 2;
  const k2 = polynomial([0.8220883, -3.029146, 4.002057], r) ** 2;
  return (c * r * r * (m0 + (m1 - m0) * c)) / (r ** 3 * k0 + c * (r * k1 + c * (k2 + c)));
}

/** grazingRatio() */
function grazingRatio(p, r, c) {
  const [n1, q0, q1, q2] = [p.slice(0, 3), p.slice(3, 7), p.slice(7, 11), p.slice(11, 14)].map((part) => polynomial(part, r) ** 2);
  return (((1 - c) * (1 + n1 * c)) / (1 + r * q0 + c * (q1 + c * q2))) ** 2;
}

/** What does not change while numbers are fitted. */
function placeOf(narrow, wide, cosine, azimuth) {
  const { missing, grazing } = exactAlbedo(narrow, cosine, 56, wide, azimuth);
  const even = narrow / wide;
  const width2 = (narrow * Math.cos(azimuth)) ** 2 + (wide * Math.sin(azimuth)) ** 2;
  const spread2 = width2 * (1 - cosine * cosine);
  const share = spread2 / wide ** 2;
  return { narrow, wide, cosine, azimuth, missing, grazing, even, width2, spread2, share, root: Math.sqrt(share), basis: [1, wide, even, wide * wide] };
}

const at = (p, row, basis) => basis.reduce((sum, b, i) => sum + b * p[4 * row + i], 0);

/** stretchedAlbedo().x */
function missingOf(p, { narrow, wide, cosine: c, even, spread2, share, basis }) {
  const middle2 = narrow ** 2 + (wide ** 2 - narrow ** 2) * clamp(at(p, 0, basis), 0.05, 1);
  const level = c / Math.sqrt(c * c + spread2 / middle2);
  const [x, y, z, w] = [1, 2, 3, 4].map((row) => at(p, row, basis));
  return glossMissing(middle2 ** 0.25, level) * (1 + (1 - even) * (x + y * share + level * (z + w * share)));
}

/** stretchedAlbedo().y */
function grazingOf(p, missing, { wide, cosine: c, even, width2, share, root, basis }) {
  const [x, y, z, w, lift, gx, gy, gz, gw] = Array.from({ length: 9 }, (_, row) => (1 - even) * at(p, row, basis));
  const width = clamp(width2 * Math.max(1 + x + y * root + z * share + w * c, 0.02) + wide * wide * c * 0.1 * Math.max(lift, 0), 1e-9, 1);
  return (1 - missing) * Math.max(1 - gx - gy * root - gz * share - gw * c, 0) * grazingRatio(p.slice(36), width ** 0.25, c);
}

/** Places everywhere, more of them towards grazing and along the axes, where the curves bend. */
function places(count) {
  const list = [];
  const quasi = (i, base) => {
    // src: Halton 1960
    let [value, digit] = [0, 1 / base];
    for (let rest = i; rest > 0; rest = Math.floor(rest / base), digit /= base) value += digit * (rest % base);
    return value;
  };
  for (let i = 1; i <= count; i += 1) {
    const [r, s, c, a] = [2, 3, 5, 7].map((base) => quasi(i, base));
    const narrow = Math.max(r, 0.045) ** 2;
    const strength = s < 0.1 ? 1 : s < 0.15 ? 0.001 : (s - 0.15) / 0.85;
    const cosine = c < 0.5 ? Math.max(2 * c, 1e-3) : 10 ** (-6.6 * (c - 0.5));
    const azimuth = (Math.PI / 2) * (a < 0.1 ? 0 : a < 0.15 ? 1 : a < 0.4 ? 10 ** (-12 * (a - 0.15)) : (a - 0.4) / 0.6);
    list.push(placeOf(narrow, narrow + (1 - narrow) * strength ** 2, cosine, azimuth));
  }
  return list;
}

/** Errors above 0 would be light from nowhere. */
function report(name, errors) {
  const rms = Math.sqrt(errors.reduce((sum, e) => sum + e * e, 0) / errors.length);
  console.log(`${name}: at most ${worst(errors).toFixed(4)} light from nowhere, ${(-worst(errors.map((e) => -e))).toFixed(4)} lost, rms ${rms.toFixed(4)}`);
}

/** Wider where few pixels are: at cosines below 0.01. */
const oneSided = (errors, list) =>
  errors.map((e, i) => {
    const ease = clamp(0.01 / list[i].cosine, 1, 4);
    return (e + 0.001) / ((e > -0.001 ? 0.002 : 0.025) * ease);
  });

function fitted(name, start, list, errorsOf) {
  report(`${name}, as it stands`, errorsOf(start));
  const p = leastSquares((q) => oneSided(errorsOf(q), list), start, 20);
  report(`${name}, fitted`, errorsOf(p));
  for (let i = 0; i < p.length; i += 4)
    console.log(
      `  ${p
        .slice(i, i + 4)
        .map((x) => x.toFixed(5))
        .join(', ')}`,
    );
}

function main() {
  const list = places(4000);
  fitted('missing', START.missing, list, (p) => list.map((place) => missingOf(p, place) - place.missing));
  const missing = list.map((place) => missingOf(START.missing, place));
  fitted('grazing', START.grazing, list, (p) => list.map((place, i) => place.grazing - grazingOf(p, missing[i], place)));
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) main();
