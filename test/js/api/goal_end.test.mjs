import assert from 'node:assert/strict';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { compareImages } from '../../../js/compare/index.mjs';
import { createRenderer, pictureKey } from '../../../js/index.mjs';
import { createPool } from '../../../js/pool/index.mjs';
import { TABLE } from '../../../js/predict/index.mjs';
import { errorOfFlip } from '../../../js/predict/noise.mjs';
import { FABRIC_MODELS, MODELS } from '../../fixtures/index.mjs';
import './support/real.mjs';

// Goals that end a picture before its last sample, and what was reached.

const SIZE = { width: 24, height: 24 };
const SHOT = { size: SIZE, shading: 'fabric', output: { format: 'raw' } };
const asked = (quality, more = {}) => ({ ...SHOT, ...more, quality });

let folder, renderer, glb, model;
before(async () => {
  folder = await mkdtemp(path.join(os.tmpdir(), 'telar-end-'));
  renderer = await createRenderer({ cacheDirectory: folder });
  glb = await FABRIC_MODELS['fabric-sequin-thread']();
  model = await renderer.load(glb);
});
after(async () => {
  await renderer.close();
  await rm(folder, { recursive: true });
});

/** Below what the class is sure of, so that settings of many samples are taken: of sequins only the tracer's hold it. */
const EXACT = { maxError: 0.06 };

test('an error ends the picture where its noise is small enough: the same sample each time, nearer than the goal', async () => {
  const { data, info } = await renderer.render(model, asked(EXACT));
  const { goal, ended, samples, standardError, quality } = info;
  assert.ok(ended >= 16 && ended === samples && ended < quality.samples && Number.isInteger(Math.log2(ended)), `${ended} of ${quality.samples}`);
  assert.ok(standardError > 0 && standardError <= errorOfFlip(EXACT.maxError), String(standardError));
  const again = await renderer.render(model, asked(EXACT));
  assert.deepEqual([again.info.ended, again.info.key, again.data.equals(data)], [ended, info.key, true]);
  const truth = await renderer.render(model, asked({ preset: 'reference', transport: 'direct', samples: 4096, noise: 0.5, seed: 9 }));
  const { mean } = compareImages({ ...SIZE, data: truth.data }, { ...SIZE, data }).object.flip;
  assert.ok(mean <= EXACT.maxError, `FLIP ${mean}`);
  const finished = await renderer.render(model, info.shot);
  assert.equal(finished.info.ended, undefined);
  assert.ok(finished.info.samples > ended && !finished.data.equals(data), 'its settings alone take more');
  assert.notEqual(finished.info.key, info.key);
  assert.equal(info.key, await pictureKey(glb, asked(EXACT)), 'the goal says when it ends');
  assert.equal(goal.reached, undefined, 'nobody asked');
});

test('an environment behind the model hides its noise: nothing ends that picture', async () => {
  const { info } = await renderer.render(model, asked(EXACT, { background: 'environment' }));
  assert.equal(info.ended, undefined);
});

test('a time ends the picture with what it has, and tells what was spent', async () => {
  const { info: free } = await renderer.render(model, asked({ budgetMs: 1e6 }));
  assert.ok(free.goal.reached.cpuMs > 0 && free.goal.reached.cpuMs < 1e6 && free.ended === undefined, JSON.stringify(free.goal));
  assert.equal(free.key, await pictureKey(glb, asked({ budgetMs: 1e6 })));
  // Planted: the file says that this machine is fifty times as fast as it is, so that what is likely to fit does not.
  const kept = JSON.parse(await readFile(path.join(folder, 'calibration.json'), 'utf8'));
  const fast = Object.fromEntries(Object.keys(kept).map((name) => [name, { raster: TABLE.machine.raster / 50, tracer: TABLE.machine.tracer / 50 }]));
  await writeFile(path.join(folder, 'calibration.json'), JSON.stringify(fast));
  const other = await createRenderer({ cacheDirectory: folder });
  try {
    const shot = { ...asked({ budgetMs: 200 }), size: { width: 96, height: 96 } };
    const { data, info } = await other.render(glb, shot);
    const { goal, ended, samples, quality, key } = info;
    assert.equal(goal.holds, true);
    assert.ok(ended > 0 && ended === samples && ended < quality.samples, `${ended} of ${quality.samples} by ${goal.setting}`);
    assert.ok(goal.reached.cpuMs >= 200, 'no sooner than that');
    assert.ok(data.some((byte) => byte !== 0) && data.length === 96 * 96 * 4);
    assert.notEqual(key, await pictureKey(glb, shot));
    const { info: short } = await other.render(glb, asked({ budgetMs: 0.001 }));
    assert.deepEqual([short.goal.setting, short.goal.holds, short.ended], ['draft', false, undefined], 'one pass cannot be ended');
    assert.ok(short.goal.reached.cpuMs > 0);
  } finally {
    await other.close();
  }
});

test('what was reached is measured where it is asked for, by a pool too', async () => {
  const { info, data } = await renderer.render(model, asked(EXACT), { reached: true });
  const { flip, pixels } = info.goal.reached;
  assert.ok(flip > 0 && flip <= EXACT.maxError && pixels === 576, JSON.stringify(info.goal.reached));
  assert.ok(data.equals((await renderer.render(model, asked(EXACT))).data));
  const coarse = await renderer.render(model, asked({ maxError: 0.9 }), { reached: true });
  assert.ok(coarse.info.goal.reached.flip > 2 * flip, 'planted: settings that are far off');
  assert.equal((await renderer.render(model, SHOT, { reached: true })).info.goal, undefined);
  await assert.rejects(renderer.render(model, SHOT, { reached: 1 }), { code: 'E_OPTION', message: 'options.reached: expected true or false, got 1' });
  const pool = await createPool({ size: 1, cacheDirectory: null });
  try {
    const far = await pool.render(glb, asked(EXACT), { reached: true });
    assert.deepEqual([far.info.goal, far.info.ended, far.data.equals(data)], [info.goal, info.ended, true]);
  } finally {
    await pool.close();
  }
});

test('what was reached by a caller who has enough at once: settings of one pass, which have no noise to end at', async () => {
  const points = await MODELS['points-map'](); // the raster alone draws them
  const { info } = await renderer.render(points, asked({ maxError: 1e-6 }), { reached: true, enough: AbortSignal.abort() });
  assert.ok(info.quality.noise > 0 && info.ended <= 4, `${info.ended} samples`);
  assert.ok(info.goal.reached.flip > 0 && info.goal.reached.pixels === 576, JSON.stringify(info.goal));
});

test('a caller who leaves while it is measured keeps nothing of the model', async () => {
  await renderer.render(glb, asked(EXACT), { reached: true });
  const before = await renderer.liveObjects();
  const leaves = new AbortController();
  const onProgress = (part) => part === 1 && leaves.abort();
  await assert.rejects(renderer.render(glb, asked(EXACT), { reached: true, onProgress, signal: leaves.signal }), { name: 'AbortError' });
  assert.equal(await renderer.liveObjects(), before);
});
