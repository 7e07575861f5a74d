import assert from 'node:assert/strict';
import { test } from 'node:test';
import { EarlyGl } from '../../../js/api/opening.mjs';
import { beginRenderer } from '../../../js/api/renderer.mjs';
import { SHOT, model, native } from './support/double.mjs';

/** The addon, which counts the GLs that it opens. */
function counting() {
  const counted = { ...native, opened: 0 };
  counted.createRenderer = (...args) => {
    counted.opened += 1;
    return native.createRenderer(...args);
  };
  return counted;
}

test('a GL that opens early is that of the renderer with the same options, once', async () => {
  const counted = counting();
  const early = new EarlyGl(counted);
  const other = beginRenderer({ limits: { L_LIGHTS: 7 } }, early, counted);
  assert.equal(counted.opened, 2);
  const same = beginRenderer({ timeoutMs: 5000 }, early, counted);
  assert.equal(counted.opened, 2);
  const second = beginRenderer({}, early, counted);
  assert.equal(counted.opened, 3);
  for (const { renderer, opened } of [other, same, second]) {
    assert.equal((await renderer.render(model(), SHOT)).data.length > 0, true);
    await opened;
    assert.equal(typeof renderer.backend, 'string');
    await renderer.close();
  }
  await early.close();
});

test('a GL that nobody takes is closed', async () => {
  let closed = 0;
  const createRenderer = async (...args) => {
    const { renderer, facts } = await native.createRenderer(...args);
    const close = () => {
      closed += 1;
      return renderer.close();
    };
    return { renderer: { close }, facts };
  };
  await new EarlyGl({ ...native, createRenderer }).close();
  assert.equal(closed, 1);
  const taken = new EarlyGl({ ...native, createRenderer });
  const { renderer } = beginRenderer({}, taken, native);
  await taken.close();
  assert.equal(closed, 1);
  await renderer.close();
  assert.equal(closed, 2);
});

test('a picture of what was begun to load is that of its source; what is wrong with it, the picture tells', async () => {
  const { renderer, beginLoad } = beginRenderer({}, undefined, native);
  const drawn = (source, options) => renderer.render(source, SHOT, options);
  const { data } = await drawn(model());
  assert.deepEqual((await drawn(beginLoad(model()))).data, data);
  assert.deepEqual((await drawn(beginLoad(model()), { onProgress: () => {} })).data, data);
  const failing = model({ fail: { stage: 'load', as: 'error' } });
  await assert.rejects(drawn(beginLoad(failing)), { code: 'L_VERTICES' });
  // Nobody draws it: no rejection is left over, and close() does not wait for ever.
  beginLoad(failing);
  const aborted = new AbortController();
  const slow = beginLoad(model({ loadMs: 3_600_000 }), aborted.signal);
  const picture = drawn(slow, { signal: aborted.signal });
  aborted.abort();
  await assert.rejects(picture, { name: 'AbortError' });
  await renderer.close();
});

test('loading and drawing share the time of a picture', async () => {
  const { renderer, beginLoad } = beginRenderer({ timeoutMs: 150 }, undefined, native);
  await renderer.render(model(), SHOT);
  await assert.rejects(renderer.render(beginLoad(model({ loadMs: 100, drawMs: 100 })), SHOT), { code: 'X_TIMEOUT' });
  await renderer.close();
});
