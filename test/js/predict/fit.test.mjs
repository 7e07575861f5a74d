import assert from 'node:assert/strict';
import { test } from 'node:test';
import { choose, predictAll } from '../../../js/predict/choose.mjs';
import { FEWEST } from '../../../js/predict/classes.mjs';
import { fitTable, upperBound } from '../../../js/predict/fit.mjs';
import { leastSquares } from '../../../js/predict/least_squares.mjs';
import { FAMILIES, familyOf, SETTINGS } from '../../../js/predict/settings.mjs';
import { featuresWith, MACHINE, plantedRows } from './support.mjs';

const near = (actual, expected, part = 1e-6) => assert.ok(Math.abs(actual - expected) <= part * Math.abs(expected), `${actual}, expected ${expected}`);

test('the upper bound is the k-th of n, and more than the largest where n is small', () => {
  const counted = (n) => Array.from({ length: n }, (_, i) => i + 1);
  // ceil(0.95 * 20) = 19 of 19, ceil(0.95 * 101) = 96 of 100.
  assert.equal(upperBound(counted(19), 0.95), 19);
  assert.equal(upperBound(counted(100), 0.95), 96);
  assert.ok(upperBound(counted(18), 0.95) > 18 && upperBound(counted(5), 0.95) > 5);
  assert.ok(upperBound(counted(5), 0.95) <= 5 + (5 - 3), 'no further above the largest than that is above the median');
  assert.equal(upperBound([0.3], 0.95), 0.3);
});

test('a further value stays below the bound as often as it says', () => {
  let seed = 1;
  const random = () => {
    seed = (Math.imul(seed, 1103515245) + 12345) & 0x7fffffff;
    return seed / 2 ** 31;
  };
  const skewed = () => (-Math.log(1 - random())) ** 3;
  const TRIALS = 4000;
  const heldBy = (bound) => {
    let held = 0;
    for (let i = 0; i < TRIALS; i++) {
      const known = Array.from({ length: 39 }, skewed);
      if (skewed() <= bound(known)) held += 1;
    }
    return held / TRIALS;
  };
  // 38 of 39 values: 0.95. Its standard error over the trials is 0.0035; four of them.
  const own = heldBy((known) => upperBound(known, 0.95));
  assert.ok(Math.abs(own - 0.95) < 0.014, String(own));
  const faulty = heldBy((known) => known.toSorted((a, b) => a - b)[34]);
  assert.ok(faulty < 0.95 - 0.014, `planted fault: the bound of 0.875 holds ${faulty}`);
});

test('least squares finds coefficients, and none below 0', () => {
  const points = (of) =>
    Array.from({ length: 40 }, (_, i) => ({ of: [1, (i * 37) % 20000, (i * i * 911) % 400_000], is: 0 })).map((point) => ({ ...point, is: of(point.of) }));
  const found = leastSquares(points(([, t, p]) => 12 + 0.002 * t + 0.0003 * p));
  near(found[0], 12, 1e-4);
  near(found[1], 0.002, 1e-4);
  near(found[2], 0.0003, 1e-4);
  assert.ok(leastSquares(points(([, t, p]) => Math.max(1, 90 - 0.001 * t + 0.0003 * p))).every((value) => value >= 0));
});

test('planted errors and times come back, by class', () => {
  const table = fitTable(plantedRows(), MACHINE);
  for (const [family, settings] of Object.entries(FAMILIES)) {
    const flips = Object.keys(settings).map((name) => table.errors[name]['fabric, relief, studio'].flip);
    assert.deepEqual(
      flips,
      flips.toSorted((a, b) => b - a),
      `${family} errs less and less`,
    );
  }
  const { base, triangle, pixel, spread, count } = table.times.standard.all;
  assert.equal(count, plantedRows().filter(({ setting }) => setting === 'standard').length);
  assert.ok(base > 0 && triangle > 0 && pixel > 0 && spread >= 1 && spread < 1.2, JSON.stringify(table.times.standard.all));
  assert.ok(table.errors.standard['fabric, smooth, studio'].flip < table.errors.standard['fabric, relief, studio'].flip);
});

test('a cheaper setting that was lucky does not seem more accurate than what follows', () => {
  const rows = plantedRows().map((row) => (row.setting === 'denoised 64/64' ? { ...row, flip: 0.0001 } : row));
  const { errors } = fitTable(rows, MACHINE);
  const following = Object.keys(FAMILIES.denoised).slice(2);
  const worst = Math.max(...following.map((name) => errors[name]['fabric, relief'].flip));
  assert.equal(errors['denoised 64/64']['fabric, relief'].flip, worst);
});

test('a class of few scenes has no say: the wider one has', () => {
  const rows = plantedRows();
  const odd = rows.filter(({ features, setting }) => features.surface === 'smooth' && setting === 'standard').slice(0, FEWEST - 1);
  const few = [...rows.filter(({ features }) => features.surface === 'relief'), ...odd];
  const table = fitTable(few, MACHINE);
  assert.equal(table.errors.standard['fabric, smooth'], undefined);
  const { basis } = choose(table, { maxError: 0.5 }, featuresWith({ surface: 'smooth' }), { tracer: true });
  assert.equal(basis, 'fabric, plain');
});

test('a class of scenes of one size does not tell what a pixel takes: the wider one does', () => {
  const rows = plantedRows().map((row) => (row.features.surface === 'smooth' ? { ...row, features: { ...row.features, covered: 30_000 } } : row));
  const { times } = fitTable(rows, MACHINE);
  assert.deepEqual([times.standard['fabric, smooth'], times.standard['fabric, relief'] !== undefined], [undefined, true]);
  const large = featuresWith({ surface: 'smooth', covered: 600_000 });
  assert.ok(
    predictAll(fitTable(rows, MACHINE), large, { tracer: true })[0].cpuMs >
      5 * predictAll(fitTable(rows, MACHINE), { ...large, covered: 30_000 }, { tracer: true })[0].cpuMs,
  );
});

test('every setting has a family, by one name', () => {
  for (const name of Object.keys(SETTINGS)) assert.ok(familyOf(name) in FAMILIES);
  assert.equal(
    Object.values(FAMILIES).reduce((sum, family) => sum + Object.keys(family).length, 0),
    Object.keys(SETTINGS).length,
  );
});
