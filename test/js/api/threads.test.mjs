import assert from 'node:assert/strict';
import { readFile, readdir } from 'node:fs/promises';
import { after, before, test } from 'node:test';
import { setTimeout as sleep } from 'node:timers/promises';
import { Worker } from 'node:worker_threads';
import { fileURLToPath } from 'node:url';
import { runChild } from './support/child.mjs';
import { ENDLESS_MS, SHOT, model, openRenderer } from './support/double.mjs';
import { until } from '../../until.mjs';

const WORKER = new URL('./support/worker.mjs', import.meta.url);

let renderer;
before(async () => {
  renderer = await openRenderer();
});
after(() => renderer.close());

const threadCount = async () => (await readdir('/proc/self/task')).length;

/** Begins endless work, does something meanwhile, and ends the work. */
async function during(plans, act, shots = plans.map(() => SHOT)) {
  const controller = new AbortController();
  let ended = 0;
  const jobs = plans.map((plan, i) =>
    assert.rejects(renderer.render(model(plan), shots[i], { signal: controller.signal, timeoutMs: null }), { name: 'AbortError' }).then(() => {
      ended += 1;
    }),
  );
  await sleep(50);
  await act();
  assert.equal(ended, 0, 'the work went on');
  controller.abort();
  await Promise.all(jobs);
}

for (const stage of ['load', 'pose', 'draw', 'encode']) {
  test(`the event loop runs on while ${stage} works`, async () => {
    await during([{ [`${stage}Ms`]: ENDLESS_MS }], async () => {
      for (let tick = 0; tick < 20; ++tick) await sleep(5);
    }, [stage === 'pose' ? { ...SHOT, pose: { animation: 0, time: 0 } } : SHOT]);
  });
}

test('libuv keeps its threads: files are read while more jobs work than it has', async () => {
  const jobs = Array.from({ length: 8 }, (_, i) => ({ [i % 2 === 0 ? 'loadMs' : 'encodeMs']: ENDLESS_MS }));
  await during(jobs, () => Promise.all(Array.from({ length: 8 }, () => readFile(fileURLToPath(import.meta.url)))));
});

test('a frame is encoded while the next is drawn', async () => {
  await during([{ encodeMs: ENDLESS_MS }], () => renderer.render(model({ drawMs: 20 }), SHOT));
});

test('two renderers draw at once', async () => {
  const other = await openRenderer();
  await during([{ drawMs: ENDLESS_MS }], () => other.render(model({ drawMs: 20 }), SHOT));
  await other.close();
});

test('six workers at once', async () => {
  const lengths = await Promise.all(
    Array.from(
      { length: 6 },
      (_, i) =>
        new Promise((resolve, reject) => {
          const worker = new Worker(WORKER, { workerData: { plan: { loadMs: 10, drawMs: 10 * i, encodeMs: 10 }, close: i % 2 === 0 } });
          worker.on('message', (message) => {
            if (message !== 'open') resolve(message);
          });
          worker.on('error', reject);
        }),
    ),
  );
  assert.equal(lengths.length, 6);
  assert.ok(lengths.every((length) => length > 32));
});

test('a worker may be terminated at any moment of a job, 20 times', async () => {
  const plans = [{ loadMs: 15, drawMs: 15, encodeMs: 15 }, { loadMs: ENDLESS_MS }, { drawMs: ENDLESS_MS }, { encodeMs: ENDLESS_MS }];
  let seed = 1;
  const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
  for (let i = 0; i < 20; ++i) {
    const worker = new Worker(WORKER, { workerData: { plan: plans[i % 3 === 0 ? 0 : 1 + (i % 3)] } });
    worker.on('error', (error) => assert.fail(error));
    // Every fourth dies before it has opened its renderer.
    if (i % 4 !== 0) await new Promise((resolve) => worker.once('message', resolve));
    await sleep(random() * 60);
    await worker.terminate();
  }
});

test('threads end with close(), and with their environment', async () => {
  const start = await threadCount();
  const others = await Promise.all([openRenderer(), openRenderer()]);
  assert.equal(await threadCount(), start + 2);
  await Promise.all(others.map((other) => other.close()));
  await until(async () => (await threadCount()) === start);
  const worker = new Worker(WORKER, { workerData: { plan: { drawMs: ENDLESS_MS } } });
  await new Promise((resolve) => worker.once('message', resolve));
  assert.ok((await threadCount()) > start);
  await worker.terminate();
  await until(async () => (await threadCount()) === start);
});

test('a renderer that is collected without close() frees its thread', async () => {
  const { code, stdout, stderr } = await runChild(
    `
    import { readdirSync } from 'node:fs';
    const count = () => readdirSync('/proc/self/task').length;
    const kept = await support.openRenderer();
    const start = count();
    const opened = await (async () => {
      const held = [await support.openRenderer(), await support.openRenderer()];
      return held.map(() => count()).at(-1);  // both are alive while they are counted
    })();
    for (let i = 0; i < 100 && count() > start; ++i) {
      gc();
      await new Promise((resolve) => setTimeout(resolve, 10));
    }
    console.log(opened - start, count() - start);
    await kept.close();`,
    { args: ['--expose-gc'] },
  );
  assert.equal(code, 0, stderr);
  assert.equal(stdout, '2 0\n');
});

test('the process ends by itself, renderer open or closed, when nothing is pending', async () => {
  for (const text of ['', 'await renderer.close();', 'await renderer.render(support.model({ drawMs: 20 }), support.SHOT);']) {
    const { code, stderr } = await runChild(`const renderer = await support.openRenderer(); ${text}`);
    assert.equal(code, 0, stderr);
  }
});

test('the process stays while a job is pending', async () => {
  const { code, stdout, stderr } = await runChild(`
    const renderer = await support.openRenderer();
    renderer.render(support.model({ loadMs: 80, drawMs: 80, encodeMs: 80 }), support.SHOT).then(() => console.log('drawn'));`);
  assert.equal(code, 0, stderr);
  assert.equal(stdout, 'drawn\n');
});

test('process.exit() during any stage ends it and keeps its code', async () => {
  for (const stage of ['load', 'draw', 'encode']) {
    const { code, signal, stderr } = await runChild(`
      const renderer = await support.openRenderer();
      for (let i = 0; i < 3; ++i) renderer.render(support.model({ ${stage}Ms: support.ENDLESS_MS }), support.SHOT, { timeoutMs: null });
      setTimeout(() => process.exit(7), 50);`);
    assert.deepEqual([code, signal], [7, null], `${stage}: ${stderr}`);
  }
});

test('process.exit() with a driver that ends late waits for it; one that is stuck is left behind', async () => {
  // What stands after the addon in the list of exit handlers runs only where it could join its threads.
  for (const [drawMs, told] of [
    ['2000', 'true\n'],
    ['support.ENDLESS_MS', ''],
  ]) {
    const { code, signal, stdout, stderr } = await runChild(`
      import { readdirSync } from 'node:fs';
      const renderer = await support.openRenderer();
      const before = readdirSync('/proc/self/task').length;
      renderer.render(support.model({ drawMs: ${drawMs}, stubborn: true }), support.SHOT, { timeoutMs: null });
      process.on('exit', () => console.log(readdirSync('/proc/self/task').length < before));
      setTimeout(() => process.exit(7), 100);`);
    assert.deepEqual([code, signal], [7, null], stderr);
    assert.equal(stdout, told, drawMs);
  }
});
