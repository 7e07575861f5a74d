import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { setTimeout as sleep } from 'node:timers/promises';
import { createRenderer } from '../../../js/index.mjs';
import { MODELS } from '../../fixtures/index.mjs';
import { errorOf, open, SHOT } from './support.mjs';

// The option `resolve` across the pipe: the caller's function runs in the caller's process.

const HEADER = 12;

/** A GLB as a .gltf whose buffer is a file beside it. */
function split(glb) {
  const view = new DataView(glb.buffer, glb.byteOffset, glb.byteLength);
  const jsonEnd = HEADER + 8 + view.getUint32(HEADER, true);
  const json = JSON.parse(new TextDecoder().decode(glb.subarray(HEADER + 8, jsonEnd)));
  json.buffers[0].uri = 'geometry%20data.bin';
  return { gltf: Buffer.from(JSON.stringify(json)), bin: Buffer.from(glb.subarray(jsonEnd + 8, jsonEnd + 8 + view.getUint32(jsonEnd, true))) };
}

let renderer, pool, glb, gltf, bin;
before(async () => {
  [renderer, pool, glb] = await Promise.all([createRenderer({ cacheDirectory: null }), open(), MODELS.cloth()]);
  ({ gltf, bin } = split(glb));
});
after(() => Promise.all([renderer.close(), pool.close()]));

test('parts from a store draw what the GLB draws: of a call, of load(), of the pool', async () => {
  const expected = (await renderer.render(glb, SHOT)).data;
  const asked = [];
  const resolve = async (uri, { signal }) => {
    await sleep(1);
    asked.push([uri, signal.aborted]);
    return bin;
  };
  assert.ok((await pool.render(gltf, SHOT, { resolve })).data.equals(expected));
  assert.deepEqual(asked, [['geometry data.bin', false]]);
  const model = await pool.load(gltf, { resolve });
  assert.ok((await pool.render(model, SHOT)).data.equals(expected));
  assert.equal(asked.length, 2, 'the worker that loaded it has it');
  await pool.release(model);
  assert.ok((await pool.render(model, SHOT)).data.equals(expected));
  assert.equal(asked.length, 3);
  const own = await open({ resolve });
  assert.ok((await own.render(gltf, SHOT)).data.equals(expected));
  await own.close();
});

test('what is absent, no bytes or a failure is the error of a renderer', async () => {
  const cause = new Error('the store is down');
  const RESOLVERS = [() => null, () => 5, () => Promise.reject(cause), () => Buffer.alloc(0), undefined];
  for (const resolve of RESOLVERS) {
    const [own, far] = await Promise.all([renderer, pool].map((to) => errorOf(to.render(gltf, SHOT, { resolve }))));
    assert.deepEqual(far.toJSON(), own.toJSON());
    if (own.code === 'X_RESOLVE') assert.equal(far.cause, cause);
  }
});

test('a call that is aborted while it waits for a part', async () => {
  const mine = new AbortController();
  let inner;
  const resolve = (_, { signal }) => {
    inner = signal;
    mine.abort(new Error('mine'));
    return new Promise(() => {});
  };
  assert.equal((await errorOf(pool.render(gltf, SHOT, { resolve, signal: mine.signal })))?.message, 'mine');
  assert.ok(inner.aborted, 'the resolver is told');
  assert.ok((await pool.render(glb, SHOT)).data.length > 0, 'the worker is free again');
});
