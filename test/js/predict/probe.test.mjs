import assert from 'node:assert/strict';
import { test } from 'node:test';
import { choose, predictAll } from '../../../js/predict/choose.mjs';
import { factorsOf, fitTable } from '../../../js/predict/fit.mjs';
import { chooseByWindow, openWindow, SIDE } from '../../../js/predict/probe.mjs';
import { SETTINGS } from '../../../js/predict/settings.mjs';
import { resolveShot } from '../../../js/shot/index.mjs';
import { featuresWith, MACHINE, plantedRows } from './support.mjs';

const FACTS = { bounds: { min: [-1, -1, -1], max: [1, 1, 1] } };
const resolved = resolveShot({ size: { width: 300, height: 200 }, shading: 'fabric', background: 'white', layers: ['beauty', 'depth'] }, FACTS);
const HERE = { tracer: true };
const features = featuresWith();

/** Factors of 1.2 wherever a setting has been measured. */
const factors = Object.fromEntries(Object.keys(SETTINGS).map((name) => [name, 1.2]));
const table = { ...fitTable(plantedRows(), MACHINE), window: factors };

/** Stands in for the renderer: a grey disc, as many levels too light as `off` says; what was asked for goes to `asked`. */
function planted(off) {
  const asked = [];
  const draw = async (shot) => {
    asked.push(shot);
    const { width, height } = shot.size;
    const data = new Uint8Array(width * height * 4);
    const level = 100 + off(shot.quality);
    for (let y = 0; y < height; y++)
      for (let x = 0; x < width; x++) {
        const isInside = width <= SIDE || Math.hypot((2 * x + 1) / width - 1, (2 * y + 1) / height - 1) < 0.7;
        if (isInside) data.set([level, level, level, 255], (y * width + x) * 4);
      }
    return data;
  };
  return { asked, draw };
}

/** The fewer samples, the further off; a truth is right. */
const bySamples = ({ preset, samples, noise, seed }) => (seed === 3 ? 0 : preset === 'reference' && noise > 0 ? 1 : 30 / Math.sqrt(samples));

test('the cheapest setting that the window shows to hold, and no window where the class is sure of something as cheap', async () => {
  const { asked, draw } = planted(bySamples);
  const window = await openWindow(draw, resolved);
  assert.equal(window.pixels, SIDE * SIDE);
  for (const maxError of [0.1, 0.05, 0.03]) {
    const chosen = await chooseByWindow(table, { maxError }, features, HERE, resolved, draw);
    const sure = choose(table, { maxError }, features, HERE);
    assert.ok(chosen.holds && chosen.flip <= maxError && chosen.cpuMs <= sure.cpuMs, JSON.stringify(chosen));
    for (const { setting, cpuMs } of predictAll(table, features, HERE)) {
      if (cpuMs >= chosen.cpuMs || cpuMs > 0.6 * sure.cpuMs) continue;
      assert.ok(1.2 * (await window.flipOf(setting)) > maxError, `${setting} holds ${maxError} for less`);
    }
  }
  const before = asked.length;
  const cheap = await chooseByWindow(table, { maxError: 0.9 }, features, HERE, resolved, draw);
  assert.deepEqual([cheap.setting, cheap.looked, asked.length], ['draft', undefined, before]);
});

test('planted fault: a window that is believed too much chooses what does not hold', async () => {
  const { draw } = planted(bySamples);
  const window = await openWindow(draw, resolved);
  const chosenBy = (each) => chooseByWindow({ ...table, window: each }, { maxError: 0.03 }, features, HERE, resolved, draw);
  const trusting = Object.fromEntries(Object.keys(factors).map((name) => [name, 0.1]));
  const [right, wrong] = [await chosenBy(factors), await chosenBy(trusting)];
  assert.ok((await window.flipOf(wrong.setting)) > 0.03, `${wrong.setting} was chosen`);
  assert.ok(right.cpuMs > wrong.cpuMs && (!right.looked || (await window.flipOf(right.setting)) <= 0.03), `${right.setting} was chosen`);
});

test('a scene that is easy gets less than its class, one that is hard no less', async () => {
  const sure = choose(table, { maxError: 0.05 }, features, HERE);
  const easy = await chooseByWindow(table, { maxError: 0.05 }, features, HERE, resolved, planted(() => 0).draw);
  assert.ok(easy.looked === SIDE * SIDE && easy.cpuMs < sure.cpuMs);
  const hard = await chooseByWindow(table, { maxError: 0.05 }, features, HERE, resolved, planted(({ seed }) => (seed === 3 ? 0 : 90)).draw);
  assert.deepEqual([hard.setting, hard.looked], [sure.setting, undefined]);
});

test('nothing is looked at where no paths can be traced, or the goal is below their noise', async () => {
  const { asked, draw } = planted(bySamples);
  for (const [of, here, maxError] of [
    [featuresWith({ traceable: false }), HERE, 0.05],
    [features, { tracer: false }, 0.05],
    [features, HERE, 0.001],
  ]) {
    const chosen = await chooseByWindow(table, { maxError }, of, here, resolved, draw);
    assert.deepEqual(chosen, choose(table, { maxError }, of, here));
  }
  assert.equal(asked.length, 0);
});

test('windows are small, over nothing, without layers, at the scale of the picture; the paths are traced once', async () => {
  const { asked, draw } = planted(bySamples);
  const window = await openWindow(draw, resolved);
  for (const setting of ['draft', 'standard']) await window.flipOf(setting);
  const [overview, ...windows] = asked;
  assert.deepEqual([overview.size, overview.quality.preset], [{ width: 64, height: 43 }, 'draft']);
  assert.deepEqual(
    windows.map(({ quality }) => quality.preset),
    ['reference', 'draft', 'standard'],
  );
  for (const { background, layers, size, output, camera } of windows) {
    assert.deepEqual([background, layers, size, output.format], ['transparent', ['beauty'], { width: SIDE, height: SIDE }, 'raw']);
    const scale = ({ fovY }) => Math.tan((fovY * Math.PI) / 360);
    const part = scale(camera) / scale(resolved.camera) / (SIDE / 200);
    assert.ok(Math.abs(part - 1) < 0.05, `${part} of the scale`);
  }
  const tiny = await openWindow(draw, resolveShot({ size: { width: 10, height: 4 } }, FACTS));
  assert.equal(tiny.pixels, 40);
  const empty = await openWindow(async ({ size }) => new Uint8Array(size.width * size.height * 4), resolved);
  assert.equal(await empty.flipOf('draft'), 1, 'a window without the model shows nothing to hold');
});

test('factors are the bound of what was measured over what a window showed', () => {
  const looks = Array.from({ length: 19 }, (_, i) => ({ setting: 'draft', flip: 0.1, is: 0.1 * (1 + i / 10) }));
  const few = looks.slice(0, 3).map((look) => ({ ...look, setting: 'standard' }));
  // ceil(0.9 * 20) = the 18th of 19.
  assert.deepEqual(factorsOf([...looks, ...few]), { draft: 2.7 });
  assert.notDeepEqual(factorsOf(looks.slice(0, 17)), { draft: 2.7 });
});
