import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { setTimeout as sleep } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';
import { overdrawGlb } from '../../fixtures/overdraw.mjs';
import { MODELS } from '../../fixtures/index.mjs';
import { indexUrl } from './support/real.mjs';

// The real addon and files that are small and draw much: they end, and what comes next is as ever. To draw them takes hours, so a test
// that ends at all has seen the work stop.

const { createRenderer, inspect } = await import(indexUrl);
const COST = fileURLToPath(new URL('../../../../shared/hostile/cost', import.meta.url));
const skip = existsSync(COST) ? false : 'no ../shared';

/** Some 25 CPU hours at 512 x 512, and hours at 64 x 64. */
const MUCH = overdrawGlb(250_000);
/** Below L_FRAGMENTS: it begins to be drawn. */
const SMALL = { size: { width: 64, height: 64 } };
const ANY_FRAGMENTS = { L_FRAGMENTS: 1e15 };

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

/** Milliseconds of CPU that a job took of this process, its threads included: no other process on this machine adds to it. */
async function cpuOf(job) {
  const before = process.cpuUsage();
  await job();
  const { user, system } = process.cpuUsage(before);
  return (user + system) / 1000;
}

test('a draw ends with its time, and the next is as before', async () => {
  const timeoutMs = 1000;
  await assert.rejects(renderer.render(MUCH, SMALL, { timeoutMs }), { code: 'X_TIMEOUT', retryable: true });
  await drawsAsBefore();
});

test('an abort frees the thread', async () => {
  const controller = new AbortController();
  const job = renderer.render(MUCH, SMALL, { signal: controller.signal, timeoutMs: null });
  await Promise.all([assert.rejects(job, { name: 'AbortError' }), sleep(500).then(() => controller.abort())]);
  await drawsAsBefore();
});

test('another renderer draws meanwhile, and close() returns', async () => {
  const busy = await createRenderer({ cacheDirectory: null, limits: ANY_FRAGMENTS });
  const controller = new AbortController();
  let isOver = false;
  const job = assert.rejects(busy.render(MUCH, SMALL, { signal: controller.signal, timeoutMs: null }), { name: 'AbortError' }).then(() => {
    isOver = true;
  });
  await sleep(500);
  for (let i = 0; i < 3; ++i) await drawsAsBefore();
  assert.equal(isOver, false, 'beside the other');
  controller.abort();
  await job;
  await busy.close();
});

test('passes of every kind are stopped', async () => {
  const lights = [{ type: 'point', position: [0.5, 0.5, 2], castShadow: true }];
  const shots = { shadows: { ...SMALL, lights }, 'many passes': { ...SMALL, quality: { samples: 16 } }, fabric: { ...SMALL, shading: 'fabric' } };
  for (const [name, shot] of Object.entries(shots)) {
    await assert.rejects(renderer.render(MUCH, shot, { timeoutMs: 1000 }), { code: 'X_TIMEOUT' }, name);
  }
  await drawsAsBefore();
});

test('what is too much is refused before the first draw, and told by inspect', async () => {
  const careful = await createRenderer({ cacheDirectory: null });
  await assert.rejects(careful.render(MUCH), (error) => {
    const { code, limit } = error;
    assert.deepEqual([code, limit.name, limit.max], ['L_FRAGMENTS', 'L_FRAGMENTS', 1e10]);
    return limit.actual > limit.max;
  });
  await drawsAsBefore(careful);
  await careful.close();
  const { plan } = await inspect(MUCH);
  assert.ok(plan.fragments > 1e10, `${plan.fragments}`);
  const {
    plan: { fragments },
  } = await inspect(ball, { shot: SMALL });
  assert.ok(fragments > 64 * 64 * 0.5 && fragments < 64 * 64 * 100, `${fragments}`);
});

test('the files of ../shared/hostile/cost', { skip }, async () => {
  const careful = await createRenderer({ cacheDirectory: null });
  const cpu = await cpuOf(() => assert.rejects(careful.render(`${COST}/overdraw-20M.glb`), { code: 'L_FRAGMENTS' }));
  assert.ok(cpu < 2000, `${cpu} ms of CPU`);
  await drawsAsBefore(careful);
  for (const file of ['overdraw-20M.glb', 'points-5x9.9M.glb']) {
    await renderer.render(`${COST}/${file}`, SMALL, { timeoutMs: 3000 }).catch(({ code }) => assert.match(code, /^(X_TIMEOUT|L_\w+)$/));
    await drawsAsBefore();
  }
  await careful.close();
});
