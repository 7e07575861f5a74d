import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createRendererOn } from '../../../js/api/renderer.mjs';
import { inspectOn } from '../../../js/api/inspect.mjs';
import { ENDLESS_MS, SHOT, model, native, openRenderer } from './support/double.mjs';

// timeoutMs, on stages that only wait.

let renderer;
before(async () => {
  renderer = await openRenderer();
});
after(() => renderer.close());

const TIMEOUT = { code: 'X_TIMEOUT', kind: 'time', retryable: true, exit: 5, http: 504 };

const timesOut = (start) => assert.rejects(start(), TIMEOUT);

for (const stage of ['load', 'pose', 'draw', 'encode']) {
  test(`what takes too long to ${stage} ends, and the renderer draws on`, async () => {
    const plan = model({ [`${stage}Ms`]: ENDLESS_MS });
    const shot = stage === 'pose' ? { ...SHOT, pose: { animation: 0, time: 0 } } : SHOT;
    await timesOut(() => renderer.render(plan, shot, { timeoutMs: 100 }));
    await renderer.render(model(), SHOT);
  });
}

test('the stages of one image share its time', async () => {
  const plan = model({ loadMs: 150, drawMs: 150, encodeMs: 150 });
  await timesOut(() => renderer.render(plan, SHOT, { timeoutMs: 300 }));
  await renderer.render(plan, SHOT, { timeoutMs: 20_000 });
});

test('waiting for others takes none of it', async () => {
  const jobs = Array.from({ length: 12 }, () => renderer.render(model({ drawMs: 500 }), SHOT, { timeoutMs: 5000 }));
  assert.equal((await Promise.all(jobs)).length, 12);
});

test('each image of renderAll() has its own time, and so has the loading', async () => {
  const shots = Array.from({ length: 8 }, () => SHOT);
  const plan = model({ loadMs: 500, drawMs: 500 });
  assert.equal((await renderer.renderAll(plan, shots, { timeoutMs: 3500 })).length, 8);
  await timesOut(() => renderer.renderAll(plan, shots, { timeoutMs: 50 }));
});

test('load() and inspect() end as well', async () => {
  await timesOut(() => renderer.load(model({ loadMs: ENDLESS_MS }), { timeoutMs: 50 }));
  await timesOut(() => inspectOn(native, model({ loadMs: ENDLESS_MS }), { timeoutMs: 50 }));
});

test("a renderer's own time goes for its calls, unless one says otherwise", async () => {
  const hasty = await createRendererOn(native, { cacheDirectory: null, timeoutMs: 50 });
  const slow = model({ drawMs: 300 });
  await timesOut(() => hasty.render(slow, SHOT));
  await hasty.render(slow, SHOT, { timeoutMs: null });
  await hasty.render(slow, SHOT, { timeoutMs: 5000 });
  await hasty.close();
});

test('a time that was given goes for long qualities too; the default does not', async () => {
  // The double reports what its token allows by ending: 20 s are too long to wait for here, so the default is made short.
  const { Work } = await import('../../../js/api/work.mjs');
  const allowed = [];
  class CancelToken {
    constructor(ms) {
      this.ms = ms;
    }
    allowAnyTime() {
      allowed.push(this.ms);
    }
  }
  for (const timeoutMs of [undefined, null, 500]) new Work({ CancelToken }, undefined, timeoutMs).allowLong();
  assert.deepEqual(allowed, [20_000]);
  for (const quality of ['medium', 'high', 'reference', { samples: 16 }]) {
    await timesOut(() => renderer.render(model({ drawMs: ENDLESS_MS }), { ...SHOT, quality }, { timeoutMs: 100 }));
  }
});

/** What is called of the addon, in order: loads, poses and draws, and that any time is allowed. */
async function callsOf(draw, options = {}) {
  const calls = [];
  class CancelToken extends native.CancelToken {
    allowAnyTime() {
      calls.push('any time');
      super.allowAnyTime();
    }
  }
  const noting =
    (name) =>
    (...args) => {
      calls.push(name);
      return native[name](...args);
    };
  const watched = await createRendererOn({ ...native, CancelToken, load: noting('load'), pose: noting('pose') }, { cacheDirectory: null, ...options });
  try {
    await draw(watched);
  } finally {
    await watched.close();
  }
  return calls;
}

test('a shot that asks for long work may take any time from its loading on, whatever is drawn for it', async () => {
  const posed = { ...SHOT, pose: { animation: 0, time: 0 } };
  for (const quality of ['reference', 'high', { samples: 16 }, { maxError: 1e-6 }]) {
    assert.deepEqual(
      (await callsOf((watched) => watched.render(model(), { ...posed, quality }))).slice(0, 3),
      ['any time', 'load', 'pose'],
      JSON.stringify(quality),
    );
  }
  // Of a quantity a goal comes to settings of one pass: what was asked for counts, as it does in a pool.
  const quantity = await callsOf((watched) => watched.renderQuantity(model(), { ...SHOT, quality: { maxError: 0.1 } }, 'n').catch(() => {}));
  assert.deepEqual(quantity, ['any time', 'load']);
  for (const quality of [undefined, 'draft', { samples: 4 }]) {
    assert.deepEqual(await callsOf((watched) => watched.render(model(), { ...posed, quality })), ['load', 'pose']);
  }
  const many = (...shots) => callsOf((watched) => watched.renderAll(model(), shots));
  assert.deepEqual((await many(SHOT, { ...SHOT, quality: 'medium' })).slice(0, 2), ['any time', 'load'], 'the loading is for both');
  assert.deepEqual(await many(SHOT, SHOT), ['load']);
  const bounded = { timeoutMs: 5000 };
  assert.deepEqual(await callsOf((watched) => watched.render(model(), { ...SHOT, quality: 'medium' }), bounded), ['load']);
});

test('which qualities are long', async () => {
  const { isLong, resolveQuality } = await import('../../../js/shot/quality.mjs');
  const long = (quality) => isLong(resolveQuality(quality));
  assert.deepEqual(['draft', 'standard', { samples: 4 }, { environmentSamples: 64 }].map(long), [false, false, false, false]);
  assert.deepEqual(['medium', 'high', 'reference', { samples: 16 }, { preset: 'reference', samples: 1 }].map(long), [true, true, true, true, true]);
});

test('close() waits for a job no longer than its time', async () => {
  const closing = await openRenderer();
  const job = assert.rejects(closing.render(model({ drawMs: ENDLESS_MS }), SHOT, { timeoutMs: 200 }), TIMEOUT);
  await closing.close();
  await job;
});

test('wrong times are told', async () => {
  for (const timeoutMs of [0, -1, 1.5, NaN, Infinity, 2 ** 31, '20', true]) {
    const wrong = { code: 'E_OPTION', message: /^options\.timeoutMs: expected whole milliseconds from 1 to 2147483647, or null for any time, got / };
    await assert.rejects(renderer.render(model(), SHOT, { timeoutMs }), wrong);
    await assert.rejects(createRendererOn(native, { timeoutMs }), wrong);
  }
});
