import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { TABLE } from '../../../js/error/table.mjs';
import { judgeHostile } from '../../load/hostile.mjs';
import { makeCases } from '../../robust/make_cases.mjs';
import { openPool, post, problemOf, serve } from './support.mjs';

// Damaged and hostile files over HTTP: what the pool says of each, with the status of its code; no worker is lost, and the next request is answered.

const SHARED = fileURLToPath(new URL('../../../../shared/hostile', import.meta.url));
const SHOT = { size: { width: 8, height: 8 }, environment: 'none' };
/** Kinds of errors that blame the file: no worker was lost, and no time was up. */
const OF_FILES = ['input', 'denied', 'unsupported', 'limit'];
/** Files that are posted at once. */
const AT_ONCE = 3;

let pool, service;
before(async () => {
  pool = await openPool();
  service = await serve({ pool });
});
after(async () => {
  await service.drain();
  await pool.close();
});

const codeOfPool = (bytes) =>
  pool.render(bytes, SHOT).then(
    () => ({ status: 200 }),
    ({ code, message, pointer, http }) => ({ status: http, code, message, pointer }),
  );

async function codeOfService(bytes) {
  const response = await post(service.url, '/v1/thumbnails', bytes, { shot: SHOT });
  if (response.status === 200) return { status: response.status, size: (await response.arrayBuffer()).byteLength };
  const { status, code, message, pointer } = await problemOf(response);
  return { status, code, message, pointer };
}

/** Posts all; what the service said of each. */
async function postAll(cases) {
  const queue = [...cases];
  const worker = async () => {
    for (let one = queue.shift(); one; one = queue.shift()) {
      const [{ size, ...told }, own] = [await codeOfService(one.bytes), await codeOfPool(one.bytes)];
      assert.deepEqual(told, own, one.name);
      assert.ok(told.status !== 200 ? OF_FILES.includes(TABLE[told.code].kind) : size > 60, `${one.name}: ${told.code}`);
      one.check?.(told);
    }
  };
  await Promise.all(Array.from({ length: AT_ONCE }, worker));
}

test('each own case', async () => {
  const cases = makeCases();
  assert.ok(cases.length > 100);
  const check =
    ({ name, code, byPath }) =>
    (told) => {
      if (code && !byPath) assert.deepEqual([told.code, told.status], [code, TABLE[code].http], name);
    };
  await postAll(cases.map((one) => ({ name: one.name, bytes: one.bytes, check: check(one) })));
});

test('each shared case ends within what it accepts', { skip: !existsSync(SHARED) && 'no ../shared/hostile' }, async () => {
  const { cases } = JSON.parse(readFileSync(path.join(SHARED, 'manifest.json'), 'utf8'));
  const byBytes = cases.filter(({ mode }) => mode === 'bytes');
  assert.ok(byBytes.length > 200);
  const outcome = ({ status, code }) => (status === 200 ? 'render' : code.startsWith('L_') ? 'limit' : 'reject');
  await postAll(
    byBytes.map(({ file, accept }) => ({
      name: file,
      bytes: readFileSync(path.join(SHARED, 'cases', file)),
      check: (told) => assert.ok(accept.includes(outcome(told)), `${file}: ${outcome(told)} ${told.code}, accepted ${accept}`),
    })),
  );
});

const answered = (code, expected = {}, ms = 1) => ({ file: { name: 'one.glb', ...expected }, code, ms });
const PLANTED = [
  [{}, []],
  [{ answers: [answered('E_JSON', { code: 'E_GRAPH' })] }, ['one.glb: E_JSON, expected E_GRAPH']],
  [{ answers: [answered('', { code: 'E_GRAPH' })] }, ['one.glb: a picture, expected E_GRAPH']],
  [{ answers: [answered('', { accept: ['reject', 'limit'] })] }, ['one.glb: a picture, accepted reject, limit']],
  [{ answers: [answered('L_NODES', { accept: ['reject'] })] }, ['one.glb: L_NODES, accepted reject']],
  [{ answers: [answered('X_CRASH', { accept: ['reject'] })] }, ['one.glb: X_CRASH blames something else']],
  [{ answers: [answered('ECONNRESET', { accept: ['reject'] })] }, ['one.glb: ECONNRESET blames something else']],
  [{ answers: [answered('E_JSON', {}, 23_000)] }, ['one.glb: 23000 ms']],
  [{ answers: [] }, ['1 of 1 have no answer']],
  [{ lost: 2 }, ['2 workers were lost']],
];
test('planted: what `npm run bench -- hostile` must not find', () => {
  for (const [change, faults] of PLANTED)
    assert.deepEqual(judgeHostile({ asked: 1, answers: [answered('E_JSON')], mostMs: 22_000, lost: 0, ...change }), faults);
});
