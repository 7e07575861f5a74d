import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createRenderer } from '../../../js/index.mjs';
import { resolveShot } from '../../../js/shot/index.mjs';
import { meteredExposure, meteredSize, meteringShot } from '../../../js/shot/metering.mjs';
import { MODELS } from '../../fixtures/index.mjs';

const BOUNDS = { min: [-1, -1, -1], max: [1, 1, 1] };
const shotOf = (metering, rest) => resolveShot({ metering: { least: 1e-3, most: 1e3, ...metering }, ...rest }, BOUNDS);
const grey = (value, alpha = 1) => [value * alpha, value * alpha, value * alpha, alpha];
/** 100 pixels, of 0.01 to 1. */
const ramp = Array.from({ length: 100 }, (_, i) => grey((i + 1) / 100)).flat();
const isNear = (actual, expected) => assert.ok(Math.abs(actual / expected - 1) < 1e-6, `${actual}, expected ${expected}`);

test('a band below the percentile of the luminance comes to the level', () => {
  const meanOf = (values) => 2 ** (values.reduce((sum, value) => sum + Math.log2(value), 0) / values.length);
  isNear(meteredExposure(shotOf({ percentile: 0.9, level: 0.45 }), ramp), 0.45 / meanOf([0.86, 0.87, 0.88, 0.89, 0.9]));
  isNear(meteredExposure(shotOf({ percentile: 0.5, level: 0.45 }), ramp), 0.45 / meanOf([0.46, 0.47, 0.48, 0.49, 0.5]));
  isNear(meteredExposure(shotOf({ percentile: 0, level: 0.45 }), ramp), 45);
  isNear(meteredExposure(shotOf({ percentile: 0.9, level: 0.45 }), [0.5, 0.1, 0.3, 1]), 0.45 / (0.2126 * 0.5 + 0.7152 * 0.1 + 0.0722 * 0.3));
});

test('what the model covers less than half, and what is no number, is left out', () => {
  const expected = meteredExposure(shotOf({ percentile: 0.9 }), ramp);
  assert.equal(meteredExposure(shotOf({ percentile: 0.9 }), [...ramp, ...grey(90, 0.4), NaN, 1, 1, 1, 0, 0, 0, 0]), expected);
  const translucent = ramp.map((value) => value * 0.75);
  assert.ok(Math.abs(meteredExposure(shotOf({ percentile: 0.9 }), translucent) - expected) < 1e-6);
});

test('the factor keeps to its bounds, and is 1 where there is nothing to see', () => {
  assert.equal(meteredExposure(shotOf({ most: 2 }), grey(1e-9)), 2);
  assert.equal(meteredExposure(shotOf({ least: 0.25 }), grey(1e30)), 0.25);
  for (const nothing of [[], grey(1, 0), [NaN, NaN, NaN, 1]]) assert.equal(meteredExposure(shotOf({}), nothing), 1);
});

test('the picture that is read has the exposure of the lens', () => {
  const lens = { aperture: 8, shutter: 1 / 60, iso: 200 };
  const { exposure, lens: drawn } = meteringShot(shotOf({}, { lens, exposure: 7 }));
  isNear(exposure, ((1 / 60) * 200) / (120 * 64));
  assert.equal(drawn, null);
  for (const other of [null, { aperture: 8 }]) assert.equal(meteringShot(shotOf({}, { lens: other, exposure: 7 })).exposure, 1);
  isNear(meteredExposure(shotOf({ level: 0.5 }, { lens }), grey(1)), 0.5);
});

test('a picture is as much brighter as its factor', () => {
  const small = 2 ** -12;
  const factors = [0.3, 0.3 * (1 + small)].map((value) => meteredExposure(shotOf({}), grey(value)));
  assert.ok(Math.abs(factors[0] / factors[1] - 1 - small) < small / 4, 'what differs by rounding moves the factor by rounding');
});

test('the picture that is read has the shape of the shot', () => {
  const sizeOf = (width, height) => Object.values(meteredSize({ size: { width, height } }));
  assert.deepEqual(
    [sizeOf(512, 512), sizeOf(1024, 256), sizeOf(40, 60), sizeOf(8192, 1)],
    [
      [128, 128],
      [128, 32],
      [40, 60],
      [128, 1],
    ],
  );
});

test('a metered picture is that of its factor, and tells it', async (t) => {
  const renderer = await createRenderer();
  t.after(() => renderer.close());
  const model = await MODELS.stage();
  const shot = {
    size: { width: 64, height: 64 },
    ground: {},
    background: '#3070c0',
    exposure: 0.8,
    metering: { least: 0.1, most: 10 },
    output: { format: 'raw' },
  };
  const { data, info } = await renderer.render(model, shot);
  assert.ok(info.meteredExposure > 0.1 && info.meteredExposure < 10 && info.meteredExposure !== 1, String(info.meteredExposure));
  assert.equal(info.shot.exposure, 0.8, 'the shot stays the one that any renderer meters by itself');
  const told = await renderer.render(model, { ...shot, metering: null, exposure: 0.8 * info.meteredExposure });
  assert.deepEqual(told.data, data);
  const other = await renderer.render(model, { ...shot, background: 'white', lights: [], ground: 'none' });
  const dimmed = await renderer.render(model, { ...shot, background: 'white', lights: [], ground: 'none', environment: { intensity: 0.25 } });
  assert.ok(Math.abs(dimmed.info.meteredExposure / other.info.meteredExposure - 4) < 0.02, 'a quarter of the light, four times the factor');
  assert.deepEqual(dimmed.data.length, other.data.length);
});

test('light that a half float does not hold is metered by the lens that dims it', async (t) => {
  const renderer = await createRenderer();
  t.after(() => renderer.close());
  const model = await MODELS.stage();
  const lens = { aperture: 16, shutter: 1 / 400, iso: 100 };
  const exposure = 100 / 400 / (120 * 256);
  const factorOf = async (intensity, rest) => {
    const lights = [{ type: 'ambient', intensity }];
    const shot = { size: { width: 64, height: 64 }, environment: 'none', lights, metering: { least: 0.01, most: 100 }, ...rest };
    return (await renderer.render(model, shot)).info.meteredExposure;
  };
  for (const sun of [3e5, 1e6]) {
    const [bright, dim] = [await factorOf(sun, { lens }), await factorOf(sun * exposure, {})];
    assert.ok(Math.abs(bright / dim - 1) < 2e-3, `${sun}: ${bright}, ${dim}`);
  }
});

test('a flat has no light to meter', async (t) => {
  const renderer = await createRenderer();
  t.after(() => renderer.close());
  const { info } = await renderer.render(await MODELS.stage(), { style: 'flat', metering: {}, size: { width: 64, height: 64 } });
  assert.equal(info.meteredExposure, undefined);
});
