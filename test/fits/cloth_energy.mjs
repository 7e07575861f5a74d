// node test/fits/cloth_energy.mjs: fits the curves of shaders/brdf/cloth_energy.glsl to the exact albedo and prints their
// numbers, with how far they are off. A fit that keeps more light than there is would shine: errors to that side weigh more.
import { pathToFileURL } from 'node:url';
import { exactTable } from './exact_albedo.mjs';
import { leastSquares } from './least_squares.mjs';

const polynomial = (c, x) => c.reduceRight((sum, a) => sum * x + a, 0);
const parts = (p, sizes) => {
  let at = 0;
  return sizes.map((n) => p.slice(at, (at += n)));
};

/** Each curve: how many numbers its polynomials of the roughness have, where they start, and the curve itself. */
const CURVES = {
  missing: {
    sizes: [3, 3, 3, 3, 3],
    start: [0.3, 0, 0, 0.3, 0, 0, 0.7, 0, 0, 0.7, 0, 0, 0.7, 0, 0],
    excess: (error) => -error,
    tolerated: [0.0026, 0.008],
    value(p, r, c) {
      const [m0, m1, k0, k1, k2] = parts(p, this.sizes).map((part) => polynomial(part, r) ** 2);
      return (c * r * r * (m0 + (m1 - m0) * c)) / (r ** 3 * k0 + c * (r * k1 + c * (k2 + c)));
    },
  },
  grazing: {
    sizes: [3, 4, 4, 3],
    start: [0.3, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0.5, 0, 0],
    excess: (error) => error,
    tolerated: [0.0026, 0.008],
    value(p, r, c) {
      const [n1, q0, q1, q2] = parts(p, this.sizes).map((part) => polynomial(part, r) ** 2);
      return (((1 - c) * (1 + n1 * c)) / (1 + r * q0 + c * (q1 + c * q2))) ** 2;
    },
  },
};

/** Wider towards smooth and grazing, where the curves have a dip that no such fraction follows. */
function tolerance(curve, name, { roughness: r, cosine: c }) {
  const dip = name === 'missing' ? 0.06 * Math.exp(-c / 0.03 - r / 0.15) + (r < 0.12 ? 0.01 : 0) : 0.08 * Math.exp(-c / 0.06 - r / 0.2) + (r < 0.12 ? 0.03 : 0);
  return curve.tolerated[1] + dip;
}

/** The error of each place of the table in units of what is tolerated there; above 0 it keeps too little. */
function misfit(name, table, p) {
  const curve = CURVES[name];
  return table.map((place) => {
    const kept = curve.excess(curve.value(p, place.roughness, place.cosine) - place[name]);
    return kept < 0 ? kept / curve.tolerated[0] : kept / tolerance(curve, name, place);
  });
}

const worst = (values) => values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);

/** Least squares first, then ever higher powers: what remains is spread evenly. */
export function fit(name, table) {
  let p = leastSquares((q) => table.map((place) => CURVES[name].value(q, place.roughness, place.cosine) - place[name]), CURVES[name].start, 300);
  let best = p;
  for (const power of [1, 2, 3, 4]) {
    p = leastSquares((q) => misfit(name, table, q).map((e) => Math.sign(e) * Math.abs(e) ** power), p, 300);
    if (worst(misfit(name, table, p)) < worst(misfit(name, table, best))) best = p;
  }
  return best;
}

/** Nodes and weights by which both curves are averaged over the cosine-weighted hemisphere. */
function fitNodes(curves) {
  const fine = Array.from({ length: 4000 }, (_, i) => ((i + 0.5) / 4000) ** 3);
  const weights = fine.map((c, i) => (2 * c * 3 * ((i + 0.5) / 4000) ** 2) / 4000);
  const roughnesses = Array.from({ length: 96 }, (_, i) => 0.045 + (0.955 * i) / 95);
  const exact = Object.entries(curves).flatMap(([name, p]) =>
    roughnesses.map((r) => {
      const value = (c) => CURVES[name].value(p, r, c);
      const mean = fine.reduce((sum, c, i) => sum + weights[i] * value(c), 0);
      return { value, mean, scale: name === 'missing' ? Math.max(...fine.map(value)) / mean : 2 };
    }),
  );
  const residuals = (q) =>
    exact.map(({ value, mean, scale }) => ((q[4] * value(q[0]) + q[5] * value(q[1]) + q[6] * value(q[2]) + q[7] * value(q[3]) - mean) * scale) / 0.002);
  let q = [0.03, 0.13, 0.39, 0.81, 0.003, 0.042, 0.278, 0.676];
  for (const power of [1, 3, 5]) q = leastSquares((x) => residuals(x).map((e) => Math.sign(e) * Math.abs(e) ** power), q, 300);
  return { q, worst: worst(residuals(q)) * 0.002 };
}

export function errorsOf(name, table, p) {
  const errors = table.map((place) => CURVES[name].excess(CURVES[name].value(p, place.roughness, place.cosine) - place[name]));
  return { light: -Math.min(...errors), loss: Math.max(...errors), rms: Math.sqrt(errors.reduce((s, e) => s + e * e, 0) / errors.length) };
}

function main() {
  const table = exactTable();
  const curves = {};
  for (const name of Object.keys(CURVES)) {
    curves[name] = fit(name, table);
    const { light, loss, rms } = errorsOf(name, table, curves[name]);
    console.log(`${name}: at most ${light.toFixed(4)} light from nowhere, ${loss.toFixed(4)} lost, rms ${rms.toFixed(4)}`);
    for (const part of parts(curves[name], CURVES[name].sizes)) console.log(`  ${part.map((x) => x.toPrecision(7)).join(', ')}`);
  }
  const nodes = fitNodes(curves);
  console.log(`average: ${nodes.worst.toExponential(1)} off\n  ${nodes.q.map((x) => x.toPrecision(7)).join(', ')}`);
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) main();
