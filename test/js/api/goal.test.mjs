import assert from 'node:assert/strict';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { keptCalibrations } from '../../../js/api/calibration.mjs';
import { createRenderer, inspect } from '../../../js/index.mjs';
import { TABLE } from '../../../js/predict/index.mjs';
import { SETTINGS } from '../../../js/predict/settings.mjs';
import { resolveQuality } from '../../../js/shot/quality.mjs';
import { MODELS } from '../../fixtures/index.mjs';
import './support/real.mjs';

// Qualities that are a goal: {maxError} and {budgetMs}.

const SHOT = { size: { width: 24, height: 24 }, shading: 'fabric', output: { format: 'raw' } };
const asked = (quality) => ({ ...SHOT, quality });

let folder, renderer, glb, model;
before(async () => {
  folder = await mkdtemp(path.join(os.tmpdir(), 'telar-goal-'));
  renderer = await createRenderer({ cacheDirectory: folder });
  glb = await MODELS.cloth();
  model = await renderer.load(glb);
});
after(async () => {
  await renderer.close();
  await rm(folder, { recursive: true });
});

test('an error: info has the settings, the prediction and what it is from; the settings draw the same', async () => {
  const { data, info } = await renderer.render(model, asked({ maxError: 0.9 }));
  const { goal, quality, shot, warnings } = info;
  assert.deepEqual(quality, resolveQuality(SETTINGS[goal.setting]));
  assert.deepEqual(shot.quality, quality);
  assert.equal(goal.maxError, 0.9);
  assert.ok(goal.holds && goal.predicted.flip > 0 && goal.predicted.flip <= 0.9, JSON.stringify(goal));
  assert.ok(goal.predicted.cpuMs > 0 && goal.predicted.mostMs >= goal.predicted.cpuMs);
  assert.match(goal.basis, /^\d+ measured scenes of the class "/);
  assert.deepEqual(warnings, []);
  const again = await renderer.render(model, shot);
  assert.deepEqual(again.data, data);
  assert.equal(again.info.goal, undefined);
  const exact = await renderer.render(model, asked({ maxError: 0.05 }));
  assert.notEqual(exact.info.goal.setting, goal.setting);
  assert.notDeepEqual(exact.data, data);
});

test('a small window of the picture is looked at: it shows what the class alone is not sure of', async () => {
  const ball = await MODELS.ball(); // easier than its class
  const shot = { ...asked({ maxError: 0.06 }), size: { width: 400, height: 400 } };
  const { data, info } = await renderer.render(ball, shot);
  const { goal } = await inspect(ball, { shot });
  assert.match(info.goal.basis, /^a window of 576 pixels, and times of \d+ measured scenes of the class "/);
  assert.match(goal.basis, /^\d+ measured scenes/, 'inspect draws nothing');
  assert.ok(info.goal.holds && info.goal.predicted.flip <= 0.06 && info.goal.predicted.cpuMs < goal.predicted.cpuMs, JSON.stringify([info.goal, goal]));
  assert.deepEqual((await renderer.render(ball, info.shot)).data, data);
});

test("what the path tracer leaves out is the raster's: lines, and where a lens would blur", async () => {
  const lines = await MODELS['lines-map']();
  for (const [source, shot] of [
    [lines, asked({ budgetMs: 60_000 })],
    [glb, { ...asked({ budgetMs: 60_000 }), lens: { aperture: 2, focusDistance: 'target' } }],
  ]) {
    assert.doesNotMatch((await inspect(source, { shot })).goal.setting, /tracer/);
  }
  assert.match((await inspect(glb, { shot: asked({ budgetMs: 60_000 }) })).goal.setting, /tracer/, 'it is the most accurate');
  assert.equal((await inspect(lines, { shot: SHOT })).plan.traceable, false);
});

test('the window has the metered exposure: a dark scene has the settings of the same one in more light', async () => {
  const ball = await renderer.load(await MODELS.ball());
  const lit = (intensity) => ({
    ...asked({ maxError: 0.03 }),
    size: { width: 400, height: 400 },
    environment: { map: 'studio', intensity },
    metering: { most: 1000 },
  });
  const [{ info: bright }, { info: dark }] = [await renderer.render(ball, lit(1)), await renderer.render(ball, lit(0.01))];
  assert.ok(Math.abs(dark.meteredExposure / bright.meteredExposure - 100) < 0.1);
  assert.match(dark.goal.basis, /^a window of 576 pixels/);
  assert.deepEqual([dark.goal.setting, dark.shot.exposure], [bright.goal.setting, 1]);
  assert.ok(Math.abs(dark.goal.predicted.flip - bright.goal.predicted.flip) < 1e-3, `${dark.goal.predicted.flip} and ${bright.goal.predicted.flip}`);
});

test('progress is that of the picture, and not of the look before it', async () => {
  const parts = [];
  const shot = { ...asked({ maxError: 0.03 }), size: { width: 300, height: 300 } };
  const { info } = await renderer.render(model, shot, { onProgress: (part) => parts.push(part) });
  assert.equal(info.backend, 'reference');
  assert.ok(parts.length > 1 && parts[0] < 0.9 && parts.at(-1) === 1, String(parts));
});

test('what was looked at is let go where no picture comes of it', async () => {
  const ball = await MODELS.ball();
  // The raster warns of the distance, once its settings are known.
  const lens = { aperture: 8, focusDistance: 1 };
  const looked = { ...asked({ maxError: 0.03 }), size: { width: 400, height: 400 }, lens };
  const metered = { ...asked({ maxError: 1e-6 }), metering: {}, lens };
  for (const shot of [looked, metered]) {
    const left = [];
    for (let i = 0; i < 3; i++) {
      await assert.rejects(renderer.render(ball, shot, { failOn: 'warning' }), { code: 'E_WARNING' });
      left.push(await renderer.liveObjects());
    }
    assert.deepEqual(left, [left[0], left[0], left[0]], 'no more with each model');
  }
});

test('an error that nothing holds: the most accurate settings, and a warning that can be refused', async () => {
  const { info } = await renderer.render(model, asked({ maxError: 1e-6 }), { timeoutMs: null });
  assert.equal(info.goal.holds, false);
  const [{ code, pointer, message }] = info.warnings;
  assert.deepEqual([code, pointer], ['W_QUALITY', '/quality/maxError']);
  assert.equal(
    message,
    `shot.quality.maxError: no setting is predicted to hold FLIP 0.000001 here; the most accurate, ${info.goal.setting}, is at ${info.goal.predicted.flip.toFixed(4)}`,
  );
  await assert.rejects(renderer.render(model, asked({ maxError: 1e-6 }), { failOn: 'warning' }), { code: 'E_WARNING' });
});

test('a time: this machine is measured once, by two renders at once too', async () => {
  assert.deepEqual(await keptCalibrations(folder), {});
  const [first] = await Promise.all([1e6, 2e6].map((budgetMs) => renderer.render(model, asked({ budgetMs }))));
  assert.ok(first.info.goal.holds && first.info.goal.predicted.mostMs <= 1e6);
  assert.match(first.info.goal.basis, /times by the calibration of this machine$/);
  const kept = await keptCalibrations(folder);
  assert.deepEqual(Object.keys(kept), [renderer.gl.renderer]);
  assert.ok(kept[renderer.gl.renderer].raster > 1 && kept[renderer.gl.renderer].tracer > 1, JSON.stringify(kept));
  const text = await readFile(path.join(folder, 'calibration.json'), 'utf8');
  const other = await createRenderer({ cacheDirectory: folder });
  await other.render(glb, asked({ budgetMs: 1e6 }));
  await other.close();
  assert.equal(await readFile(path.join(folder, 'calibration.json'), 'utf8'), text, 'not measured again');
});

test('planted: the file says that this machine is slow, or nothing that can be read', async () => {
  const file = path.join(folder, 'calibration.json');
  const kept = JSON.parse(await readFile(file, 'utf8'));
  const drawnWith = async (text) => {
    await writeFile(file, text);
    const other = await createRenderer({ cacheDirectory: folder });
    try {
      return (await other.render(glb, asked({ budgetMs: 5000 }))).info;
    } finally {
      await other.close();
    }
  };
  const slow = Object.fromEntries(Object.keys(kept).map((name) => [name, { raster: 1e6 * TABLE.machine.raster, tracer: 1e6 * TABLE.machine.tracer }]));
  const { goal, warnings } = await drawnWith(JSON.stringify(slow));
  assert.deepEqual([goal.setting, goal.holds, warnings[0].code], ['draft', false, 'W_QUALITY']);
  assert.match(warnings[0].message, /^shot\.quality\.budgetMs: no setting is predicted to hold 5000 ms here; the fastest, draft, may take \d+ ms$/);
  for (const text of ['{"', '[]', 'null', JSON.stringify(Object.fromEntries(Object.keys(kept).map((name) => [name, { raster: 'x' }])))]) {
    assert.equal((await drawnWith(text)).goal.holds, true, text);
    assert.ok((await keptCalibrations(folder))[renderer.gl.renderer].raster > 1, 'measured again');
  }
});

test('an abort while the machine is measured ends that picture alone', async () => {
  const other = await createRenderer({ cacheDirectory: null });
  try {
    const aborted = new AbortController();
    const ends = other.render(glb, asked({ budgetMs: 5000 }), { signal: aborted.signal });
    const stays = other.render(glb, asked({ budgetMs: 5000 }));
    setTimeout(() => aborted.abort(), 20);
    await assert.rejects(ends, { name: 'AbortError' });
    assert.equal((await stays).info.goal.holds, true);
  } finally {
    await other.close();
  }
});

test('inspect tells the settings and what they compile, without a machine to draw on', async () => {
  const { plan, goal } = await inspect(glb, { shot: asked({ maxError: 0.02 }) });
  const { info } = await renderer.render(model, asked({ maxError: 0.02 }));
  assert.deepEqual(goal, info.goal);
  assert.ok(plan.passes.length > 0);
  const timed = await inspect(glb, { shot: asked({ budgetMs: 1e6 }) });
  assert.ok(timed.goal.holds && timed.goal.budgetMs === 1e6);
  assert.equal((await inspect(glb, { shot: SHOT })).goal, undefined);
});

test('quantities and flats have no error to reach', async () => {
  const { data } = await renderer.renderQuantity(model, asked({ budgetMs: 1 }), 'n');
  assert.equal(data.length, 24 * 24 * 4);
  const { info } = await renderer.render(model, { ...asked({ maxError: 1e-6 }), style: 'flat' });
  assert.deepEqual([info.goal, info.warnings, info.quality.preset], [undefined, [], 'standard']);
  assert.equal((await inspect(glb, { shot: { ...asked({ maxError: 1e-6 }), style: 'flat' } })).goal, undefined);
});
