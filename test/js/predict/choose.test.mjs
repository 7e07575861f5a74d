import assert from 'node:assert/strict';
import { test } from 'node:test';
import { calibrate, choose, endedQuality, featuresOf, predictAll, TABLE } from '../../../js/predict/index.mjs';
import { fitTable } from '../../../js/predict/fit.mjs';
import { flipOfError } from '../../../js/predict/noise.mjs';
import { canEnd, familyOf, SETTINGS } from '../../../js/predict/settings.mjs';
import { resolveQuality } from '../../../js/shot/quality.mjs';
import { resolveShot } from '../../../js/shot/index.mjs';
import { featuresWith, MACHINE, plantedRows } from './support.mjs';

const table = fitTable(plantedRows(), MACHINE);
const HERE = { tracer: true };
const features = featuresWith();

test('an error gets the cheapest setting that holds it', () => {
  const all = predictAll(table, features, HERE);
  assert.equal(all.length, Object.keys(SETTINGS).length);
  for (const maxError of [0.3, 0.1, 0.05, 0.02, 0.01]) {
    const chosen = choose(table, { maxError }, features, HERE);
    assert.ok(chosen.holds && chosen.flip <= maxError, JSON.stringify(chosen));
    assert.deepEqual(chosen.quality, SETTINGS[chosen.setting]);
    for (const { setting, flip, cpuMs } of all) assert.ok(flip > maxError || cpuMs >= chosen.cpuMs, `${setting} holds ${maxError} for less`);
  }
});

test('a time gets the most accurate setting that fits: by what it takes at most, or is likely to where it can be ended', () => {
  const wide = structuredClone(table);
  for (const byClass of Object.values(wide.times)) for (const time of Object.values(byClass)) time.spread = 2;
  const all = predictAll(wide, features, HERE);
  let ended = 0;
  for (const budgetMs of [60, 200, 1000, 5000, 100_000]) {
    const chosen = choose(wide, { budgetMs }, features, HERE);
    assert.ok(chosen.holds && chosen.mostMs <= budgetMs, JSON.stringify(chosen));
    assert.deepEqual(chosen.end, { spentMs: budgetMs });
    const fits = ({ setting, cpuMs, mostMs }) => (canEnd(setting) ? cpuMs : mostMs) <= budgetMs;
    for (const each of all) assert.ok(!fits(each) || each.flip >= chosen.flip, `${each.setting} is nearer in ${budgetMs}`);
    ended += all.find(({ setting }) => setting === chosen.setting).mostMs > budgetMs;
  }
  assert.ok(ended > 0, 'one that may have to be ended is among them');
});

test('an error ends a picture where its noise makes no more than its family leaves', () => {
  const all = predictAll(table, features, HERE);
  const biasOf = (family) => all.filter(({ setting }) => familyOf(setting) === family).at(-1).flip;
  const seen = new Set();
  for (let maxError = 0.4; maxError > 0.004; maxError *= 0.8) {
    const { setting, end, holds } = choose(table, { maxError }, features, HERE);
    const family = familyOf(setting);
    if (family === 'prefiltered') assert.equal(end, undefined);
    else if (!holds) assert.ok(!end || flipOfError(end.error) <= maxError);
    else assert.ok(Math.abs(flipOfError(end.error) + (family === 'tracer' ? 0 : biasOf(family)) - maxError) < 1e-9, `${setting} ${JSON.stringify(end)}`);
    seen.add(family);
  }
  assert.ok(seen.has('denoised') || seen.has('tracer'));
  const raster = choose(table, { maxError: 1e-6 }, features, { tracer: false });
  assert.equal(raster.end, undefined, 'the raster alone errs more: nothing ends it before');
});

test('a picture that was ended has settings of no more samples than it has', () => {
  const tracer = resolveQuality(SETTINGS['tracer noise 2']);
  assert.deepEqual(endedQuality(tracer, 32), { ...tracer, samples: 32 });
  assert.equal(endedQuality(tracer, undefined), tracer);
  const raster = resolveQuality(SETTINGS['denoised 64/256']);
  assert.deepEqual(endedQuality(raster, 33), { ...raster, samples: 16, environmentSamples: 64 });
  assert.deepEqual(endedQuality(resolveQuality('medium'), 5).preset, undefined);
  const high = resolveQuality(SETTINGS['high by the raster']);
  for (const samples of [1, 2, 4, 5, 15, 16, 300]) {
    const ended = endedQuality(high, samples);
    assert.deepEqual(resolveQuality(ended), ended, `a quality that can be drawn, of ${samples} samples`);
    assert.equal(ended.noise, samples < 16 ? 0 : high.noise);
  }
});

test('what nothing holds gets the most accurate or the fastest, and says so', () => {
  const all = predictAll(table, features, HERE);
  const exact = choose(table, { maxError: 1e-6 }, features, HERE);
  assert.deepEqual([exact.holds, exact.flip], [false, Math.min(...all.map(({ flip }) => flip))]);
  const fast = choose(table, { budgetMs: 0.001 }, features, HERE);
  assert.deepEqual([fast.holds, fast.setting], [false, 'draft']);
});

test('a smaller error never costs less, a longer time never errs more', () => {
  const errors = Array.from({ length: 40 }, (_, i) => choose(table, { maxError: 0.4 * 0.85 ** i }, features, HERE));
  for (let i = 1; i < errors.length; i++) assert.ok(!errors[i].holds || errors[i].cpuMs >= errors[i - 1].cpuMs);
  const times = Array.from({ length: 40 }, (_, i) => choose(table, { budgetMs: 10 * 1.3 ** i }, features, HERE));
  for (let i = 1; i < times.length; i++) assert.ok(!times[i - 1].holds || times[i].flip <= times[i - 1].flip);
});

test('a machine of half the speed gets less for the same time; an error has the same settings', () => {
  const slow = { tracer: true, machine: { raster: 2 * MACHINE.raster, tracer: 2 * MACHINE.tracer } };
  const chosen = choose(table, { budgetMs: 2000 }, features, slow);
  assert.equal(chosen.setting, choose(table, { budgetMs: 1000 }, features, HERE).setting);
  const slowTracer = { tracer: true, machine: { ...MACHINE, tracer: 100 * MACHINE.tracer } };
  assert.notEqual(familyOf(choose(table, { budgetMs: 100_000 }, features, slowTracer).setting), 'tracer');
});

test('the tracer is left out where it is not there or shows otherwise', () => {
  for (const [of, here] of [
    [features, { tracer: false }],
    [featuresWith({ traceable: false }), HERE],
  ]) {
    assert.ok(predictAll(table, of, here).every(({ setting }) => familyOf(setting) !== 'tracer'));
    assert.notEqual(familyOf(choose(table, { maxError: 1e-6 }, of, here).setting), 'tracer');
  }
});

test('in the smallest pictures the draft stays the cheapest, and families in order', () => {
  const planted = structuredClone(table);
  // As a fit gives it that no small picture is in.
  for (const name of ['denoised 64/64', 'tracer 8']) for (const time of Object.values(planted.times[name])) time.base = 0;
  const tiny = featuresWith({ pixels: 4, covered: 2, triangles: 0 });
  const all = predictAll(planted, tiny, HERE);
  // Also where paths are a hundred times as fast as on the machine that was measured.
  for (const list of [all, predictAll(planted, tiny, { tracer: true, machine: { ...MACHINE, tracer: MACHINE.tracer / 100 } })]) {
    assert.equal(list[0].setting, 'draft');
    for (const { cpuMs } of list) assert.ok(cpuMs >= list[0].cpuMs);
  }
  const of = (family) => all.filter(({ setting }) => familyOf(setting) === family).map(({ cpuMs }) => cpuMs);
  for (const family of ['denoised', 'tracer'])
    assert.deepEqual(
      of(family),
      of(family).toSorted((a, b) => a - b),
    );
});

test('more pixels and triangles take longer', () => {
  const time = (more) => choose(table, { maxError: 0.05 }, featuresWith(more), HERE).cpuMs;
  assert.ok(time({ pixels: 1 << 20, covered: 1e6 }) > 2 * time({}));
  assert.ok(time({ triangles: 100_000 }) > 2 * time({}));
});

test('features are those of the shot, of what is drawn and of the model', () => {
  const shot = resolveShot(
    { size: { width: 64, height: 32 }, shading: 'fabric', environment: 'none', lights: [{ type: 'directional', castShadow: true }] },
    { bounds: { min: [-1, -1, -1], max: [1, 1, 1] } },
  );
  const square = [-0.5, 0.5].flatMap((x) => [-0.5, 0.5].map((y) => [x, y, 0]));
  const of = (drawn, more = {}, { outline, ...plan } = {}) => featuresOf({ ...shot, ...more }, { features: drawn, ...plan }, { triangles: 12, outline });
  assert.deepEqual(of(['normal-map']), {
    shading: 'fabric',
    surface: 'relief',
    environment: 'none',
    shadows: true,
    triangles: 12,
    pixels: 2048,
    covered: 2048,
    traceable: true,
  });
  assert.deepEqual(
    [['normal-map', 'sheen'], ['weave', 'normal-map', 'sheen'], ['alpha-mask', 'normal-map'], ['normal-facets', 'normal-map'], []].map(
      (drawn) => of(drawn).surface,
    ),
    ['napped', 'stretched', 'cut', 'facets', 'smooth'],
  );
  const surfaceOf = (features, passes) => featuresOf(shot, { features, passes }, { triangles: 12 }).surface;
  assert.deepEqual(
    [surfaceOf(['normal-map'], ['opaque', 'blend']), surfaceOf(['normal-map', 'back-faces-first'], ['transmissive'])],
    ['cut', 'relief'],
    'sheer cloth; glass',
  );
  assert.equal(of([], {}, { fragments: 300 }).covered, 300);
  const camera = { projection: 'orthographic', position: [0, 0, 2], target: [0, 0, 0], up: [0, 1, 0], height: 4, near: 1, far: 3 };
  assert.equal(of([], { camera }, { outline: square }).covered, 64, 'a quarter of the height of 32, squared');
  const near = { projection: 'perspective', position: [0, 0, 1], target: [0, 0, 0], up: [0, 1, 0], fovY: 90, near: 0.1, far: 3 };
  assert.equal(of([], { camera: near }, { outline: square }).covered, 256, 'half of the height');
  assert.equal(of([], { camera: { ...near, position: [0, 0, 0.1] } }, { outline: square }).covered, 2048, 'no more than there are');
  assert.equal(of([], { camera: near }, { outline: [...square, [0, 0, 1.5]] }).covered, 2048, 'a point behind the camera');
  assert.equal(of([], {}, { traceable: false }).traceable, false);
  assert.equal(of([], { lens: { aperture: 2, focusDistance: 1 } }).traceable, false, 'the raster shows all of it sharp');
  assert.equal(of([], { lens: { aperture: 2, focusDistance: null } }).traceable, true);
  assert.equal(of([], { layers: ['beauty', 'depth'] }).traceable, false);
  assert.equal(of([], { environment: { map: 'hall.hdr', intensity: 1 } }).environment, 'file');
  assert.equal(of([], { shading: { base: 'three', revision: 180 } }).shading, 'three');
});

test('the calibration is the least of several, without the first', async () => {
  const spent = [];
  const spin = (ms) => {
    const { user, system } = process.cpuUsage();
    while (process.cpuUsage().user + process.cpuUsage().system - user - system < 1000 * ms);
  };
  const draw = async (_, { quality }) => {
    spent.push(quality.preset ?? quality);
    spin(spent.length === 1 ? 1 : 10);
  };
  const { raster, tracer } = await calibrate(draw, { tracer: true });
  assert.ok(raster >= 10 && tracer >= 10, `${raster}, ${tracer}: the first, of 1 ms, does not count`);
  assert.deepEqual([...new Set(spent)], ['standard', 'reference']);
  assert.equal((await calibrate(draw, { tracer: false })).tracer, 0);
});

test('what is shipped answers every kind of scene', () => {
  for (const shading of ['fabric', 'three', 'three-r115', 'disney-2012']) {
    for (const surface of ['relief', 'smooth']) {
      for (const environment of ['none', 'studio', 'file']) {
        const of = featuresWith({ shading, surface, environment, shadows: environment === 'none' });
        const cheap = choose(TABLE, { maxError: 1 }, of, HERE);
        const exact = choose(TABLE, { maxError: 1e-6 }, of, HERE);
        assert.ok(cheap.holds && !exact.holds && exact.cpuMs > cheap.cpuMs && exact.flip < cheap.flip, `${shading}, ${surface}, ${environment}`);
        for (const { flip, cpuMs, mostMs } of predictAll(TABLE, of, HERE)) assert.ok(flip > 0 && flip <= 1 && cpuMs > 0 && mostMs >= cpuMs);
      }
    }
  }
});
