import assert from 'node:assert/strict';
import { readdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import '../api/support/real.mjs';
import * as right from '../../../js/queue/index.mjs';
import { importMutant, outcomeOf } from '../server/mutants.mjs';
import { over, temporaryFolder, textOf } from './support.mjs';

// What startWorker() does beside drawing: results of a store are read and written.

const task = (name, files = {}) => ({ kind: 'thumbnail', asked: { shot: { exposure: 2 } }, files: { model: Buffer.from(name), ...files } });

/** A pool that says what it drew. */
function fakePool() {
  const drawn = [];
  const render = async (model) => {
    drawn.push(Buffer.from(model).toString());
    return { data: Buffer.from(`picture of ${model}`), info: { key: 'what a worker says', format: 'png', width: 300, height: 200, shot: {} } };
  };
  return { drawn, render, workers: [{}] };
}

/** Draws the tasks with a worker of its own, one after the other. @returns {Promise<{texts: string[], drawn: string[]}>} */
async function draw({ openQueue, startWorker }, tasks, options) {
  const [queue, pool] = [await openQueue(), fakePool()];
  const worker = startWorker(queue, { pool, ...options });
  await worker.ready;
  const texts = [];
  for (const one of tasks) {
    const { id } = await queue.add(one);
    await over(queue, id);
    texts.push(await textOf(queue, id));
  }
  await worker.drain(10_000);
  await queue.close();
  return { texts, drawn: pool.drawn };
}

async function checkStore(queues, store) {
  const first = await draw(queues, [task('a'), task('b')], { store });
  assert.deepEqual(first, { texts: ['picture of a', 'picture of b'], drawn: ['a', 'b'] });
  assert.deepEqual(
    readdirSync(store).map((name) => /^[0-9a-f]{64}\.result$/.test(name)),
    [true, true],
  );
  const withPart = task('a', { 'part a.bin': Buffer.from('p') });
  const again = await draw(queues, [task('b'), task('a'), withPart, task('c')], { store });
  assert.deepEqual(
    again,
    { texts: ['picture of b', 'picture of a', 'picture of a', 'picture of c'], drawn: ['a', 'c'] },
    'what has parts has no key beforehand',
  );
  assert.deepEqual((await draw(queues, [task('a')])).drawn, ['a'], 'without a store');
  // The service that took the job draws no larger ones.
  const bounded = (side) => ({ ...task('a'), asked: { ...task('a').asked, side } });
  const { texts } = await draw(queues, [bounded(299), bounded(300)], { store });
  assert.deepEqual(texts, [undefined, 'picture of a']);
}

test('what a store has is not drawn, and what is drawn goes there', async (t) => {
  const { folder, remove } = temporaryFolder('worker');
  t.after(remove);
  await checkStore(right, folder);
});

for (const [fault, wrong] of [
  ['if (kept) return kept;', ''],
  ['if (kept) checkStored(task, kept);', ''],
  ['if (key) store.put({ ...result, key });', ''],
  ['if (key) store.put({ ...result, key });', 'if (key) store.put(result);'],
]) {
  test(`planted: ${wrong || `no ${fault}`}`, async (t) => {
    const { folder, remove } = temporaryFolder('worker');
    t.after(remove);
    const mutant = await importMutant([['worker.mjs', fault, wrong]], '../queue/index.mjs');
    assert.equal(await outcomeOf(() => checkStore(mutant, folder), { hangMs: 60_000 }), 'fails');
  });
}

test('a store that cannot be: no job is taken, and it is told', async (t) => {
  const { folder, remove } = temporaryFolder('worker');
  t.after(remove);
  const queue = await right.openQueue();
  t.after(() => queue.close());
  const { id } = await queue.add(task('a'));
  const file = path.join(folder, 'file');
  writeFileSync(file, '');
  const worker = right.startWorker(queue, { pool: fakePool(), store: path.join(file, 'store') });
  await assert.rejects(worker.ready, { code: 'E_OPTION', message: /^options\.store: the folder cannot be made/ });
  assert.equal((await queue.get(id)).state, 'waiting');
  for (const options of [{ store: '' }, { store: {} }, { storeBytes: 0 }, { storeBytes: '1' }]) {
    assert.throws(() => right.startWorker(queue, { pool: fakePool(), ...options }), { code: 'E_OPTION' });
  }
});
