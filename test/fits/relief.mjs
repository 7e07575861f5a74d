// node test/fits/relief.mjs: fits the terms of shaders/brdf/relief.glsl to means over the normals of knits, weaves, pile and grain. Every
// normal is lit by a white sky as the shading "fabric" lights a texel in full detail: turned to where it just faces the viewer, the light
// times the terminator of bump.glsl. It starts at the numbers that stand there, tells how far they are off, and prints what it would set.
import { fibres, jersey, pebbles, plainWeave, terry, twill } from '../fixtures/cloth_relief.mjs';
import { leastSquares } from './least_squares.mjs';

const RELIEFS = { jersey: [jersey, 8], twill: [twill, 8], felt: [fibres(16, 1.2), 16], towel: [terry(8), 8], pile: [fibres(16, 0.8), 16] };
Object.assign(RELIEFS, { plain: [plainWeave, 8], grain: [pebbles(10), 10] });
const ROUGHNESSES = [0.2, 0.35, 0.5, 0.65, 0.8, 1];
const COSINES = [0.2, 0.4, 0.6, 0.8, 0.97];
const NORMALS = 400;
const AROUND = 8;
const LIGHTS = 8;

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const scaled = (a, k) => a.map((x) => x * k);
const plus = (a, b) => a.map((x, i) => x + b[i]);
const unit = (a) => scaled(a, 1 / Math.hypot(...a));
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const at = (cosine, phi) => [Math.sqrt(1 - cosine * cosine) * Math.cos(phi), Math.sqrt(1 - cosine * cosine) * Math.sin(phi), cosine];
const golden = (i) => (i * 0.6180339887498949) % 1;

/** Normals at even places of one repeat. */
function normalsOf([field, threads]) {
  const step = threads / 256;
  return Array.from({ length: NORMALS }, (_, i) => {
    const [x, y] = [threads * ((i + 0.5) / NORMALS), threads * golden(i)];
    const height = (dx, dy) => field(x + dx, y + dy).height;
    const slope = [height(step, 0) - height(-step, 0), height(0, step) - height(0, -step)].map((d) => d / (2 * step));
    return unit([...slope.map((s) => -Math.max(-8, Math.min(8, s))), 1]);
  });
}

const facing = (n, v) => (dot(n, v) < 1e-3 ? unit(plus(n, scaled(v, 1e-3 - dot(n, v)))) : n);
function terminator(n, cosine) {
  const cosine2 = Math.max(n[2], 1e-3) ** 2;
  const alpha2 = Math.min((0.125 * (1 - cosine2)) / cosine2, 1);
  return cosine <= 0 ? 0 : (2 * cosine) / (cosine + Math.sqrt(cosine ** 2 + alpha2 * (1 - cosine ** 2)));
}

/** Mean over normals, azimuths of the viewer and lights that `draw` gives: [direction in the frame of the normal, weight]. */
function meanOver(normals, NoV, draw) {
  let sum = 0;
  for (let k = 0; k < AROUND; k += 1) {
    const v = at(NoV, (2 * Math.PI * (k + 0.37)) / AROUND);
    normals.forEach((texel, i) => {
      const n = facing(texel, v);
      const x = unit(Math.abs(n[0]) < 0.7 ? cross(n, [1, 0, 0]) : cross(n, [0, 1, 0]));
      const y = cross(n, x);
      const seen = [dot(v, x), dot(v, y), Math.max(dot(v, n), 1e-3)];
      for (let j = 0; j < LIGHTS; j += 1) {
        const index = (i * AROUND + k) * LIGHTS + j;
        const [l, weight] = draw(seen, [(index * 0.7548776662) % 1, (index * 0.569840291) % 1]);
        if (weight <= 0 || l[2] <= 0) continue;
        sum += weight * terminator(n, x[2] * l[0] + y[2] * l[1] + n[2] * l[2]);
      }
    });
  }
  return sum / (normals.length * AROUND * LIGHTS);
}

/** Share that diffuse light of one direction keeps, by the texels and by the text; mean over all azimuths, and so without lines. */
function keptTowards(normals, NoL, relief) {
  let sum = 0;
  for (let k = 0; k < AROUND; k += 1) {
    const l = at(NoL, (2 * Math.PI * (k + 0.37)) / AROUND);
    for (const n of normals) sum += Math.max(dot(n, l), 0) * terminator(n, NoL);
  }
  const leaning = 0.8 * Math.min(20 * relief, 1) * Math.exp(-NoL / (0.03 + 0.6 * relief));
  return [sum / (normals.length * AROUND * NoL), (1 - relief) * (1 + leaning)];
}

const cosineLobe = (_, [a, b]) => [at(Math.sqrt(1 - a), 2 * Math.PI * b), 1];

/** GGX by its visible normals. @param {number} f0 - With f90 1. */
const ggxLobe =
  (alpha, f0) =>
  (v, [a, b]) => {
    const wide = unit([alpha * v[0], alpha * v[1], v[2]]);
    const cap = plus(at((1 - b) * (1 + wide[2]) - wide[2], 2 * Math.PI * a), wide);
    const h = unit([alpha * cap[0], alpha * cap[1], Math.max(cap[2], 1e-9)]);
    const l = plus(scaled(h, 2 * dot(v, h)), scaled(v, -1));
    const lambda = (z) => (Math.sqrt(1 + alpha ** 2 * (1 / z ** 2 - 1)) - 1) / 2;
    const schlick = f0 + (1 - f0) * (1 - dot(v, h)) ** 5;
    return [l, l[2] > 0 ? (schlick * (1 + lambda(v[2]))) / (1 + lambda(v[2]) + lambda(l[2])) : 0];
  };

const basis = (r, c) => [1, c, c * c].flatMap((y) => [y, y * r, y * r * r]);
const START = [-0.696, -0.14, 1.915, 13.6, -22.311, 5.675, -11.779, 25.081, -10.92];
const START_F90 = [1.8, 1.62];
const lost = (p, { r, c }) =>
  Math.min(
    Math.max(
      basis(r, c).reduce((sum, b, i) => sum + b * p[i], 0),
      0,
    ),
    2,
  );
const keptOf = (p, row) => Math.exp(-1.25 * row.relief * lost(p, row));
const worst = (values) => Math.max(...values.map(Math.abs)).toFixed(3);
const rms = (values) => Math.sqrt(values.reduce((sum, x) => sum + x * x, 0) / values.length).toFixed(3);

const flat = Array.from({ length: NORMALS }, () => [0, 0, 1]);
const diffuse = [];
const gloss = [];
for (const [name, made] of Object.entries(RELIEFS)) {
  const normals = normalsOf(made);
  const mean = normals.reduce(plus, [0, 0, 0]);
  const relief = 1 - Math.hypot(...mean) / NORMALS;
  const keeps = meanOver(normals, 0.7, cosineLobe);
  diffuse.push({ keeps, relief });
  process.stdout.write(
    `${name.padEnd(7)} relief ${relief.toFixed(3)} diffuse keeps ${keeps.toFixed(3)}, by the text ${Math.max(1 - 0.87 * relief, 0.7 - 0.43 * relief).toFixed(3)}\n`,
  );
  const towards = COSINES.map((NoL) => `${NoL}: ${keptTowards(normals, NoL, relief).map((x) => x.toFixed(3))}`);
  process.stdout.write(`        of one direction, by the texels and by the text: ${towards.join('; ')}\n`);
  for (const r of ROUGHNESSES) {
    for (const c of COSINES) {
      const [one, grazing] = [1, 0].map((f0) => meanOver(normals, c, ggxLobe(r * r, f0)));
      const [oneFlat, grazingFlat] = [1, 0].map((f0) => meanOver(flat, c, ggxLobe(r * r, f0)));
      gloss.push({ r, c, relief, f0: (one - grazing) / (oneFlat - grazingFlat), lostOfF90: grazingFlat - grazing, grazingFlat });
    }
  }
}
const slope = diffuse.reduce((sum, d) => sum + (1 - d.keeps) * d.relief, 0) / diffuse.reduce((sum, d) => sum + d.relief ** 2, 0);
process.stdout.write(`diffuse: ${slope.toFixed(3)} of the relief is lost\n`);
const residuals = (p) => gloss.map((row) => keptOf(p, row) - row.f0);
process.stdout.write(`f0 as it stands: rms ${rms(residuals(START))}, worst ${worst(residuals(START))}\n`);
const fitted = leastSquares(residuals, START, 40);
process.stdout.write(`f0 fitted: rms ${rms(residuals(fitted))}, worst ${worst(residuals(fitted))}: ${fitted.map((x) => x.toFixed(3)).join(' ')}\n`);
const ofF90 = ([a, b]) =>
  gloss.map((row) => {
    const seen = Math.max(1 - Math.max(row.c - 0.35, 0) / (0.07 + 3.2 * row.relief), 0);
    return (row.lostOfF90 / row.grazingFlat - Math.sqrt(row.relief) * Math.max(a - b * row.r, 0) * seen) * Math.sqrt(row.grazingFlat);
  });
process.stdout.write(`f90 as it stands: rms ${rms(ofF90(START_F90))}, worst ${worst(ofF90(START_F90))}; `);
const pair = leastSquares(ofF90, START_F90, 40);
process.stdout.write(`fitted: rms ${rms(ofF90(pair))}, worst ${worst(ofF90(pair))}: ${pair.map((x) => x.toFixed(3)).join(' ')}\n`);
