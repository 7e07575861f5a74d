import assert from 'node:assert/strict';
import { test } from 'node:test';
import { hasTracer } from '../../../js/api/goal.mjs';
import { handOver, isHandedOver, knownDigest } from '../../../js/api/handed_over.mjs';

// What js/api keeps for a process is kept by what it is of.

/** An addon's exports whose looks for the tracer end so, one after the other. */
function nativeWith(...outcomes) {
  const native = { CancelToken: class {}, looks: 0 };
  native.probeReference = () => {
    const works = outcomes[native.looks++];
    return works === undefined ? Promise.reject(new Error('planted')) : Promise.resolve(JSON.stringify({ works }));
  };
  return native;
}

test('the tracer is looked for once for each addon', async () => {
  const [with1, without] = [nativeWith(true), nativeWith(false)];
  assert.deepEqual(await Promise.all([with1, without, with1].map((native) => hasTracer(native))), [true, false, true]);
  assert.deepEqual([with1.looks, without.looks], [1, 1]);
});

test('a look that failed is no answer: the next one looks again', async () => {
  const native = nativeWith(undefined, true);
  await assert.rejects(hasTracer(native), /planted/);
  assert.equal(await hasTracer(native), true);
  assert.equal(native.looks, 2);
});

test('several files of one memory are handed over, each by its place', () => {
  const all = new Uint8Array(8);
  const [first, second] = [all.subarray(0, 3), all.subarray(3)];
  handOver(first, 'a');
  handOver(second, 'b');
  assert.deepEqual([first, second, all.subarray(0, 3), all, all.subarray(1, 3)].map(knownDigest), ['a', 'b', 'a', undefined, undefined]);
  assert.deepEqual([first, second, all].map(isHandedOver), [true, true, false]);
});
