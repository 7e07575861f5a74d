import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { ENDLESS_MS, SHOT, model, openRenderer } from './support/double.mjs';

let renderer;
before(async () => {
  renderer = await openRenderer();
});
after(() => renderer.close());

const TRACED = { ...SHOT, quality: 'reference' };

/** Parts that a drawing tells. */
async function partsOf(draw) {
  const parts = [];
  await draw({ onProgress: (part) => parts.push(part) });
  return parts;
}

test('a traced frame tells how far it is, and 1 when its file is there', async () => {
  assert.deepEqual(await partsOf((options) => renderer.render(model({ drawMs: 350, encodeMs: 250 }), TRACED, options)), [0.5, 1 - Number.EPSILON, 1]);
});

test('a frame of the raster tells that it is done', async () => {
  assert.deepEqual(await partsOf((options) => renderer.render(model({ drawMs: 250 }), SHOT, options)), [1]);
});

test('several frames tell their mean', async () => {
  const parts = await partsOf((options) => renderer.renderAll(model({ drawMs: 250 }), [SHOT, TRACED, TRACED, SHOT], options));
  assert.equal(parts.at(-1), 1);
  assert.ok(parts.length >= 4 && parts.includes(0.25), String(parts));
  assert.ok(
    parts.every((part, i) => i === 0 || part > parts[i - 1]),
    String(parts),
  );
  assert.deepEqual(await partsOf((options) => renderer.renderAll(model(), [], options)), []);
});

test('what onProgress throws ends the work', async () => {
  const failure = new Error('enough');
  await assert.rejects(
    renderer.render(model({ drawMs: ENDLESS_MS }), TRACED, {
      onProgress() {
        throw failure;
      },
    }),
    (error) => error === failure,
  );
  await renderer.render(model(), SHOT);
});

test('the signal ends it, and no more is told', async () => {
  const parts = [];
  const signal = AbortSignal.timeout(150);
  await assert.rejects(renderer.render(model({ drawMs: ENDLESS_MS }), TRACED, { signal, onProgress: (part) => parts.push(part) }), { name: 'TimeoutError' });
  const told = parts.length;
  await new Promise((resolve) => setTimeout(resolve, 250));
  assert.equal(parts.length, told);
});

test('onProgress is a function', async () => {
  await assert.rejects(renderer.render(model(), SHOT, { onProgress: 5 }), { code: 'E_OPTION', message: 'options.onProgress: expected a function, got 5' });
});
