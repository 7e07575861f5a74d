import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { setTimeout as sleep } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';
import { overdrawGlb } from '../../fixtures/overdraw.mjs';
import { MODELS } from '../../fixtures/index.mjs';
import { indexUrl } from './support/real.mjs';

// The real addon and files that are small and draw much: they end, and what comes next is as ever.

const { createRenderer, inspect } = await import(indexUrl);
const COST = fileURLToPath(new URL('../../../../shared/hostile/cost', import.meta.url));
const skip = existsSync(COST) ? false : 'no ../shared';

/** Some 25 CPU hours at 512 x 512, and hours at 64 x 64. */
const MUCH = overdrawGlb(250_000);
/** Below L_FRAGMENTS: it begins to be drawn. */
const SMALL = { size: { width: 64, height: 64 } };
const ANY_FRAGMENTS = { L_FRAGMENTS: 1e15 };
/** What timeoutMs promises, over the time itself. */
const GRACE_MS = 2000;

let renderer;
let ball;
let expected;
before(async () => {
  renderer = await createRenderer({ cacheDirectory: null, limits: ANY_FRAGMENTS });
  ball = await MODELS.ball();
  expected = (await renderer.render(ball, SMALL)).data;
});
after(() => renderer.close());

const drawsAsBefore = async (with_ = renderer) => assert.ok((await with_.render(ball, SMALL)).data.equals(expected), 'the next picture');

async function endsWithin(ms, start, error) {
  const begin = performance.now();
  await assert.rejects(start(), error);
  const took = performance.now() - begin;
  assert.ok(took < ms, `${took} ms`);
}

test('a draw ends with its time, and the next is as before', async () => {
  const timeoutMs = 1000;
  await endsWithin(timeoutMs + GRACE_MS, () => renderer.render(MUCH, SMALL, { timeoutMs }), { code: 'X_TIMEOUT', retryable: true });
  const begin = performance.now();
  await drawsAsBefore();
  assert.ok(performance.now() - begin < GRACE_MS, 'the thread was free');
});

test('an abort frees the thread', async () => {
  const controller = new AbortController();
  const job = renderer.render(MUCH, SMALL, { signal: controller.signal, timeoutMs: null });
  await Promise.all([assert.rejects(job, { name: 'AbortError' }), sleep(500).then(() => controller.abort())]);
  const begin = performance.now();
  await drawsAsBefore();
  assert.ok(performance.now() - begin < GRACE_MS, 'the thread was free');
});

test('another renderer draws meanwhile, and close() returns', async () => {
  const busy = await createRenderer({ cacheDirectory: null, limits: ANY_FRAGMENTS });
  const controller = new AbortController();
  const job = assert.rejects(busy.render(MUCH, SMALL, { signal: controller.signal, timeoutMs: null }), { name: 'AbortError' });
  await sleep(500);
  const begin = performance.now();
  for (let i = 0; i < 3; ++i) await drawsAsBefore();
  assert.ok(performance.now() - begin < 3 * GRACE_MS, 'beside the other');
  controller.abort();
  await job;
  const closing = performance.now();
  await busy.close();
  assert.ok(performance.now() - closing < GRACE_MS, 'close()');
});

test('passes of every kind are stopped', async () => {
  const lights = [{ type: 'point', position: [0.5, 0.5, 2], castShadow: true }];
  const shots = { shadows: { ...SMALL, lights }, 'many passes': { ...SMALL, quality: { samples: 16 } }, fabric: { ...SMALL, shading: 'fabric' } };
  for (const [name, shot] of Object.entries(shots)) {
    await endsWithin(1000 + GRACE_MS, () => renderer.render(MUCH, shot, { timeoutMs: 1000 }), { code: 'X_TIMEOUT' }, name);
  }
  await drawsAsBefore();
});

test('what is too much is refused before the first draw, and told by inspect', async () => {
  const careful = await createRenderer({ cacheDirectory: null });
  await endsWithin(GRACE_MS, () => careful.render(MUCH), (error) => {
    const { code, limit } = error;
    assert.deepEqual([code, limit.name, limit.max], ['L_FRAGMENTS', 'L_FRAGMENTS', 1e10]);
    return limit.actual > limit.max;
  });
  await drawsAsBefore(careful);
  await careful.close();
  const { plan } = await inspect(MUCH);
  assert.ok(plan.fragments > 1e10, `${plan.fragments}`);
  const { plan: { fragments } } = await inspect(ball, { shot: SMALL });
  assert.ok(fragments > 64 * 64 * 0.5 && fragments < 64 * 64 * 100, `${fragments}`);
});

test('the files of ../shared/hostile/cost', { skip }, async () => {
  const careful = await createRenderer({ cacheDirectory: null });
  const cpu = process.cpuUsage();
  await endsWithin(2 * GRACE_MS, () => careful.render(`${COST}/overdraw-20M.glb`), { code: 'L_FRAGMENTS' });
  const { user, system } = process.cpuUsage(cpu);
  assert.ok(user + system < 2e6, `${(user + system) / 1000} ms of CPU`);
  await drawsAsBefore(careful);
  for (const file of ['overdraw-20M.glb', 'points-5x9.9M.glb']) {
    const begin = performance.now();
    await renderer.render(`${COST}/${file}`, SMALL, { timeoutMs: 3000 }).catch(({ code }) => assert.match(code, /^(X_TIMEOUT|L_\w+)$/));
    assert.ok(performance.now() - begin < 3000 + GRACE_MS, file);
    await drawsAsBefore();
  }
  await careful.close();
});
