import assert from 'node:assert/strict';
import { readFile, readdir } from 'node:fs/promises';
import { monitorEventLoopDelay } from 'node:perf_hooks';
import { after, before, test } from 'node:test';
import { setTimeout as sleep } from 'node:timers/promises';
import { Worker } from 'node:worker_threads';
import { fileURLToPath } from 'node:url';
import { runChild } from './support/child.mjs';
import { SHOT, model, openRenderer } from './support/double.mjs';

const WORKER = new URL('./support/worker.mjs', import.meta.url);

let renderer;
before(async () => { renderer = await openRenderer(); });
after(() => renderer.close());

const threadCount = async () => (await readdir('/proc/self/task')).length;

async function until(condition, ms) {
  const end = performance.now() + ms;
  while (!(await condition())) {
    assert.ok(performance.now() < end, `not so within ${ms} ms`);
    await sleep(5);
  }
}

test('the event loop runs on while each stage works', async () => {
  const delay = monitorEventLoopDelay({ resolution: 1 });
  let ticks = 0;
  const ticker = setInterval(() => { ticks += 1; }, 5);
  delay.enable();
  await renderer.render(model({ loadMs: 150, drawMs: 150, encodeMs: 150 }), SHOT);
  delay.disable();
  clearInterval(ticker);
  assert.ok(ticks > 40, `${ticks} ticks of 5 ms in 450 ms`);
  assert.ok(delay.percentile(99) / 1e6 < 25, `p99 ${delay.percentile(99) / 1e6} ms`);
});

test('libuv keeps its threads: a file is read while four jobs work', async () => {
  const jobs = Array.from({ length: 4 }, () => renderer.render(model({ loadMs: 200, drawMs: 50, encodeMs: 100 }), SHOT));
  await sleep(20);
  const start = performance.now();
  await readFile(fileURLToPath(import.meta.url));
  const ms = performance.now() - start;
  assert.ok(ms < 60, `${ms} ms`);
  await Promise.all(jobs);
});

test('a frame is encoded while the next is drawn', async () => {
  const loaded = await renderer.load(model({ drawMs: 60, encodeMs: 60 }));
  const start = performance.now();
  const views = await renderer.renderAll(loaded, Array.from({ length: 6 }, () => SHOT));
  const ms = performance.now() - start;
  assert.equal(views.length, 6);
  assert.ok(ms < 600, `${ms} ms; one after another they take 720`);
  assert.ok(ms >= 420, `${ms} ms; the drawing alone takes 360, the last encoding 60`);
});

test('two renderers draw at once', async () => {
  const other = await openRenderer();
  const start = performance.now();
  await Promise.all([renderer, other].map((one) => one.render(model({ drawMs: 200 }), SHOT)));
  assert.ok(performance.now() - start < 350);
  await other.close();
});

test('six workers at once', async () => {
  const lengths = await Promise.all(Array.from({ length: 6 }, (_, i) => new Promise((resolve, reject) => {
    const worker = new Worker(WORKER, { workerData: { plan: { loadMs: 10, drawMs: 10 * i, encodeMs: 10 }, close: i % 2 === 0 } });
    worker.on('message', (message) => { if (message !== 'open') resolve(message); });
    worker.on('error', reject);
  })));
  assert.equal(lengths.length, 6);
  assert.ok(lengths.every((length) => length > 32));
});

test('a worker may be terminated at any moment of a job, 40 times', async () => {
  const plan = { loadMs: 15, drawMs: 15, encodeMs: 15 };
  let seed = 1;
  const random = () => (seed = (seed * 48271) % 2147483647) / 2147483647;
  let worst = 0;
  for (let i = 0; i < 40; ++i) {
    const worker = new Worker(WORKER, { workerData: { plan } });
    worker.on('error', (error) => assert.fail(error));
    // Every fourth dies before it has opened its renderer.
    if (i % 4 !== 0) await new Promise((resolve) => worker.once('message', resolve));
    await sleep(random() * 60);
    const start = performance.now();
    await worker.terminate();
    worst = Math.max(worst, performance.now() - start);
  }
  assert.ok(worst < 500, `the slowest took ${worst} ms`);
});

test('threads end with close(), and with their environment', async () => {
  const start = await threadCount();
  const others = await Promise.all([openRenderer(), openRenderer()]);
  assert.equal(await threadCount(), start + 2);
  await Promise.all(others.map((other) => other.close()));
  await until(async () => (await threadCount()) === start, 1000);
  const worker = new Worker(WORKER, { workerData: { plan: { drawMs: 5000 } } });
  await new Promise((resolve) => worker.once('message', resolve));
  assert.ok((await threadCount()) > start);
  await worker.terminate();
  await until(async () => (await threadCount()) === start, 1000);
});

test('a renderer that is collected without close() frees its thread', async () => {
  const { code, stdout, stderr } = await runChild(`
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
    await kept.close();`, { args: ['--expose-gc'] });
  assert.equal(code, 0, stderr);
  assert.equal(stdout, '2 0\n');
});

test('the process ends by itself, renderer open or closed, when nothing is pending', async () => {
  for (const text of ['', 'await renderer.close();', 'await renderer.render(support.model({ drawMs: 20 }), support.SHOT);']) {
    const { code, ms, stderr } = await runChild(`const renderer = await support.openRenderer(); ${text}`);
    assert.equal(code, 0, stderr);
    assert.ok(ms < 3000, `${text}: ${ms} ms`);
  }
});

test('the process stays while a job is pending', async () => {
  const { code, stdout, stderr } = await runChild(`
    const renderer = await support.openRenderer();
    renderer.render(support.model({ loadMs: 80, drawMs: 80, encodeMs: 80 }), support.SHOT).then(() => console.log('drawn'));`);
  assert.equal(code, 0, stderr);
  assert.equal(stdout, 'drawn\n');
});

test('process.exit() during any stage is quick and keeps its code', async () => {
  for (const stage of ['load', 'draw', 'encode']) {
    const { code, signal, stdout, stderr } = await runChild(`
      const renderer = await support.openRenderer();
      for (let i = 0; i < 3; ++i) renderer.render(support.model({ ${stage}Ms: 5000 }), support.SHOT);
      setTimeout(() => { console.log(Date.now()); process.exit(7); }, 50);`);
    assert.deepEqual([code, signal], [7, null], `${stage}: ${stderr}`);
    assert.ok(Date.now() - Number(stdout) < 600, `${stage}: ${Date.now() - Number(stdout)} ms`);
  }
});

test('process.exit() with a stuck driver waits for it, then ends with its code', async () => {
  const { code, signal, stdout, stderr } = await runChild(`
    const renderer = await support.openRenderer();
    renderer.render(support.model({ drawMs: 60000, stubborn: true }), support.SHOT);
    setTimeout(() => { console.log(Date.now()); process.exit(7); }, 100);`);
  assert.deepEqual([code, signal], [7, null], stderr);
  const ms = Date.now() - Number(stdout);
  assert.ok(ms > 4000 && ms < 7000, `${ms} ms`);
});
