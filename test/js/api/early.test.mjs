import assert from 'node:assert/strict';
import { test } from 'node:test';
import { EarlyRenderer } from '../../../js/api/early.mjs';
import { beginRenderer } from '../../../js/api/renderer.mjs';
import { ENDLESS_MS, SHOT, model, native } from './support/double.mjs';

/** The addon, which counts what it opens, loads and closes. */
function counting() {
  const counted = { ...native, opened: 0, loaded: 0, closed: 0 };
  counted.load = (...args) => {
    counted.loaded += 1;
    return native.load(...args);
  };
  counted.createRenderer = async (...args) => {
    counted.opened += 1;
    const { renderer, facts } = await native.createRenderer(...args);
    const close = () => {
      counted.closed += 1;
      return renderer.close();
    };
    return { renderer: { render: (...how) => renderer.render(...how), release: (...how) => renderer.release(...how), close }, facts };
  };
  return counted;
}

/** What should end and does not would be waited for for ever. */
const ENDS = { timeout: 60_000 };

/** Paths of the double: their names are the plan. */
const file = '{}.glb';
const slow = `${JSON.stringify({ loadMs: ENDLESS_MS })}.glb`;

test('a renderer that begins early is for the default options, once', ENDS, async () => {
  const counted = counting();
  const early = new EarlyRenderer(file, counted);
  for (const options of [{ limits: { L_LIGHTS: 7 } }, { timeoutMs: 5000 }, { failOn: 'warning' }, { ambientVisibility: true }, { backend: 'osmesa' }])
    assert.equal(early.take(options), undefined, JSON.stringify(options));
  const { renderer, opened, beginLoad } = early.take({ backend: 'auto', limits: {}, signal: new AbortController().signal });
  assert.equal(early.take({}), undefined);
  await opened;
  assert.equal(typeof renderer.backend, 'string');
  const { data } = await renderer.render(beginLoad(file), SHOT);
  assert.equal(counted.loaded, 1);
  // The load is for one picture.
  assert.deepEqual((await renderer.render(beginLoad(file), SHOT)).data, data);
  assert.deepEqual([counted.opened, counted.loaded], [1, 2]);
  await early.close();
  assert.equal(counted.closed, 0);
  await renderer.close();
  assert.equal(counted.closed, 1);
});

test('what nobody takes is ended: the load, and the GL', ENDS, async () => {
  const counted = counting();
  await new EarlyRenderer(slow, counted).close();
  assert.deepEqual([counted.loaded, counted.closed], [1, 1]);
  // Another model than the command line seemed to name.
  const early = new EarlyRenderer(slow, counted);
  const { renderer, beginLoad } = early.take({});
  await renderer.render(beginLoad(file), SHOT);
  await early.close();
  await renderer.close();
  assert.equal(counted.closed, 2);
});

test('an abort ends the early load that was taken', ENDS, async () => {
  const aborted = new AbortController();
  const { renderer, beginLoad } = new EarlyRenderer(slow, native).take({});
  const picture = renderer.render(beginLoad(slow, aborted.signal), SHOT, { signal: aborted.signal });
  aborted.abort();
  await assert.rejects(picture, { name: 'AbortError' });
  await renderer.close();
});

test('a picture of what was begun to load is that of its source; what is wrong with it, the picture tells', async () => {
  const { renderer, beginLoad } = beginRenderer({}, native);
  const drawn = (source, options) => renderer.render(source, SHOT, options);
  const { data } = await drawn(model());
  assert.deepEqual((await drawn(beginLoad(model()))).data, data);
  assert.deepEqual((await drawn(beginLoad(model()), { onProgress: () => {} })).data, data);
  const failing = model({ fail: { stage: 'load', as: 'error' } });
  await assert.rejects(drawn(beginLoad(failing)), { code: 'L_VERTICES' });
  // Nobody draws it: no rejection is left over, and close() does not wait for ever.
  beginLoad(failing);
  const aborted = new AbortController();
  const begun = beginLoad(model({ loadMs: ENDLESS_MS }), aborted.signal);
  const picture = drawn(begun, { signal: aborted.signal });
  aborted.abort();
  await assert.rejects(picture, { name: 'AbortError' });
  await renderer.close();
});

test('loading and drawing share the time of a picture', async () => {
  const { renderer, beginLoad } = beginRenderer({ timeoutMs: 150 }, native);
  await renderer.render(model(), SHOT);
  await assert.rejects(renderer.render(beginLoad(model({ loadMs: 100, drawMs: 100 })), SHOT), { code: 'X_TIMEOUT' });
  await renderer.close();
});
