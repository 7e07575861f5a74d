import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { setTimeout as sleep } from 'node:timers/promises';
import { createRendererOn } from '../../../js/api/renderer.mjs';
import { ENDLESS_MS, SHOT, model, native, openRenderer } from './support/double.mjs';

let renderer;
before(async () => {
  renderer = await openRenderer();
});
after(() => renderer.close());

// Stages take an hour: a test that ends at all has seen the work stop, however busy this machine is.

/** Aborts a job `ms` into it: it must reject with the very reason. */
async function abortAfter(ms, start) {
  const controller = new AbortController();
  const reason = new Error('enough');
  const job = start(controller.signal);
  setTimeout(() => controller.abort(reason), ms);
  await assert.rejects(job, (error) => error === reason);
}

const drawsAgain = async () => assert.ok((await renderer.render(model(), SHOT)).data.length > 0);

for (const stage of ['load', 'draw', 'encode']) {
  test(`an abort during ${stage} rejects, and frees the thread`, async () => {
    await abortAfter(40, (signal) => renderer.render(model({ [`${stage}Ms`]: ENDLESS_MS }), SHOT, { signal, timeoutMs: null }));
    await drawsAgain();
  });
}

test('an abort of load()', async () => {
  await abortAfter(30, (signal) => renderer.load(model({ loadMs: ENDLESS_MS }), { signal, timeoutMs: null }));
});

test('an abort of a job that waits behind others leaves those alone', async () => {
  const others = Array.from({ length: 8 }, () => renderer.render(model({ drawMs: 30 }), SHOT));
  await abortAfter(20, (signal) => renderer.render(model({ drawMs: ENDLESS_MS }), SHOT, { signal, timeoutMs: null }));
  assert.equal((await Promise.all(others)).length, 8);
});

test("an abort of a job in the renderer's own queue does not wait for the one that draws", async () => {
  const first = new AbortController();
  let isBusy = true;
  const busy = assert
    .rejects(renderer.render(model({ drawMs: ENDLESS_MS }), SHOT, { signal: first.signal, timeoutMs: null }), { name: 'AbortError' })
    .then(() => {
      isBusy = false;
    });
  await abortAfter(30, (signal) => renderer.render(model({ drawMs: ENDLESS_MS }), SHOT, { signal, timeoutMs: null }));
  assert.equal(isBusy, true);
  first.abort();
  await busy;
  await drawsAgain();
});

test('an abort of renderAll() stops all of its frames', async () => {
  const shots = Array.from({ length: 20 }, () => SHOT);
  await abortAfter(60, (signal) => renderer.renderAll(model({ drawMs: ENDLESS_MS }), shots, { signal, timeoutMs: null }));
  await drawsAgain();
});

test('a frame that fails stops the others of renderAll()', async () => {
  const shots = [{ ...SHOT, pose: { animation: 0, time: 0 } }, ...Array.from({ length: 20 }, () => SHOT)];
  const plan = model({ drawMs: ENDLESS_MS, fail: { stage: 'pose', as: 'error' } });
  await assert.rejects(renderer.renderAll(plan, shots, { timeoutMs: null }), { code: 'L_VERTICES' });
  await drawsAgain();
});

test('an abort while the context is made', async () => {
  await abortAfter(30, (signal) => createRendererOn(native, { cacheDirectory: '/tmp/slow', signal }));
  await sleep(250); // the late renderer closes itself
});

test('an aborted signal starts nothing', async () => {
  const reason = new Error('before');
  const signal = AbortSignal.abort(reason);
  const same = (error) => error === reason;
  await assert.rejects(renderer.render(model({ loadMs: 500 }), SHOT, { signal }), same);
  await assert.rejects(renderer.load(model({ loadMs: 500 }), { signal }), same);
  await assert.rejects(renderer.renderAll(model({ loadMs: 500 }), [SHOT], { signal }), same);
  await assert.rejects(createRendererOn(native, { signal }), same);
});

test('reasons of the platform pass through', async () => {
  await assert.rejects(renderer.render(model({ drawMs: 2000 }), SHOT, { signal: AbortSignal.timeout(30) }), { name: 'TimeoutError' });
  const controller = new AbortController();
  setTimeout(() => controller.abort(), 20);
  await assert.rejects(renderer.render(model({ drawMs: 2000 }), SHOT, { signal: controller.signal }), { name: 'AbortError' });
});

test('a signal that never fires keeps no listener, and an abort after the end changes nothing', async () => {
  const controller = new AbortController();
  const { signal } = controller;
  let listeners = 0;
  for (const [method, step] of [
    ['addEventListener', 1],
    ['removeEventListener', -1],
  ]) {
    const original = signal[method].bind(signal);
    signal[method] = (...args) => {
      listeners += step;
      original(...args);
    };
  }
  const { data } = await renderer.render(model(), SHOT, { signal });
  await renderer.renderAll(model(), [SHOT, SHOT], { signal });
  await sleep(0);
  assert.equal(listeners, 0);
  controller.abort();
  assert.ok(data.length > 0);
});

test('random aborts, 100 times, leave a renderer that draws', async () => {
  let seed = 7;
  const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
  const jobs = Array.from({ length: 100 }, (_, i) => {
    const controller = new AbortController();
    if (i % 10 > 0) setTimeout(() => controller.abort(), random() * 400);
    return renderer.render(model({ loadMs: 3, drawMs: 5, encodeMs: 3 }), SHOT, { signal: controller.signal });
  });
  const outcomes = await Promise.allSettled(jobs);
  outcomes.forEach(({ status, reason }, i) => assert.ok(status === 'fulfilled' || (i % 10 > 0 && reason.name === 'AbortError'), reason?.stack));
  assert.ok(outcomes.some(({ status }) => status === 'rejected'));
  await renderer.render(model(), SHOT);
  assert.equal(await renderer.liveObjects(), 0);
});

test('one signal for many jobs: no leak warning, all reject', async () => {
  const warnings = [];
  const onWarning = (warning) => warnings.push(warning.name);
  process.on('warning', onWarning);
  const controller = new AbortController();
  const jobs = Array.from({ length: 30 }, () => renderer.render(model({ drawMs: 50 }), SHOT, { signal: controller.signal }));
  setTimeout(() => controller.abort(), 20);
  const outcomes = await Promise.allSettled(jobs);
  assert.ok(outcomes.every(({ reason }) => reason?.name === 'AbortError'));
  await sleep(5);
  process.off('warning', onWarning);
  assert.deepEqual(warnings, []);
});
