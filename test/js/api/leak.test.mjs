import assert from 'node:assert/strict';
import { test } from 'node:test';
import { runChild } from './support/child.mjs';
import { fixturesUrl, indexUrl } from './support/real.mjs';

// 500 renders in one process. The first 100 fill caches and the allocator's arenas; after them nothing may grow.

const SCRIPT = `
  import { readdirSync, readFileSync } from 'node:fs';
  import { createRenderer } from '${indexUrl}';
  import { MODELS } from '${fixturesUrl}';
  const models = await Promise.all(['cloth', 'variants', 'alpha-blend', 'model-lights', 'ball'].map((name) => MODELS[name]()));
  const renderer = await createRenderer({ cacheDirectory: null });
  // Models that nobody holds go when their finalizers have run, which a busy machine does late.
  const settledObjects = async () => {
    let fewest = Infinity;
    for (let look = 0; look < 20; ++look) {
      globalThis.gc();
      await new Promise((resolve) => setTimeout(resolve, 50));
      fewest = Math.min(fewest, await renderer.liveObjects());
    }
    return fewest;
  };
  const measure = async () => {
    const objects = await settledObjects();
    return {
      kibibytes: Number(/VmRSS:\\s+(\\d+)/.exec(readFileSync('/proc/self/status', 'utf8'))[1]),
      files: readdirSync('/proc/self/fd').length,
      threads: readdirSync('/proc/self/task').length,
      objects,
    };
  };
  const frame = async (i) => {
    const shot = { size: { width: 64 + 16 * (i % 3), height: 64 }, camera: { azimuth: i % 360 } };
    const model = models[i % models.length];
    const source = i % 7 === 0 ? await renderer.load(model) : model;
    await renderer.render(source, shot);
    if (i % 7 === 0 && i % 2 === 0) await renderer.release(source);
    if (i % 11 === 0) await renderer.render(model.subarray(0, 100), shot).catch(() => {});
    if (i % 13 === 0) await renderer.render(model, shot, { signal: AbortSignal.timeout(i % 5) }).catch(() => {});
  };
  const samples = [];
  for (let i = 1; i <= 500; ++i) {
    await frame(i);
    if (i % 100 === 0) samples.push(await measure());
  }
  await renderer.close();
  console.log(JSON.stringify(samples));`;

test('500 renders in one process: memory, file descriptors, threads and GL names stay flat', async () => {
  // V8 takes and gives back up to 16 MiB for young objects as it likes: here it has 3 MiB.
  const args = ['--expose-gc', '--max-semi-space-size=1'];
  const { code, stdout, stderr } = await runChild(SCRIPT, { args, support: false });
  assert.equal(code, 0, stderr);
  const samples = JSON.parse(stdout);
  const [first, last] = [samples[1], samples.at(-1)];
  assert.equal(last.files, first.files, JSON.stringify(samples));
  // A load that was aborted may still have its thread at the first look.
  assert.ok(last.threads <= first.threads, JSON.stringify(samples));
  assert.ok(Math.abs(last.objects - first.objects) <= 20, JSON.stringify(samples));
  // What one picture holds comes and goes; what leaks is in the least of two looks too.
  const least = (looks) => Math.min(...looks.map(({ kibibytes }) => kibibytes));
  assert.ok(least(samples.slice(3)) - least(samples.slice(1, 3)) < 8 * 1024, JSON.stringify(samples));
});

test('45 renderers one after another: memory, threads and file descriptors stay flat', async () => {
  const { code, stdout, stderr } = await runChild(
    `
    import { readdirSync, readFileSync } from 'node:fs';
    import { createRenderer } from '${indexUrl}';
    import { MODELS } from '${fixturesUrl}';
    const ball = await MODELS.ball();
    const samples = [];
    for (let i = 1; i <= 45; ++i) {
      const renderer = await createRenderer({ cacheDirectory: null });
      await renderer.render(ball, { size: { width: 32, height: 32 } });
      await renderer.close();
      if (i % 15 !== 0) continue;
      await new Promise((resolve) => setTimeout(resolve, 50));
      const kibibytes = Number(/VmRSS:\\s+(\\d+)/.exec(readFileSync('/proc/self/status', 'utf8'))[1]);
      samples.push({ kibibytes, files: readdirSync('/proc/self/fd').length, threads: readdirSync('/proc/self/task').length });
    }
    console.log(JSON.stringify(samples));`,
    { support: false },
  );
  assert.equal(code, 0, stderr);
  const [first, second, last] = JSON.parse(stdout);
  assert.deepEqual([last.files, last.threads], [first.files, first.threads]);
  // The allocator may take one more arena at some time; a leak grows all the time.
  assert.ok(Math.min(second.kibibytes - first.kibibytes, last.kibibytes - second.kibibytes) < 10 * 1024, stdout);
});
