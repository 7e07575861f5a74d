import assert from 'node:assert/strict';
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { after, before, describe, test } from 'node:test';
import { FolderStore } from '../../../js/queue/folder_store.mjs';
import { TelarError, openQueue } from '../../../js/queue/index.mjs';
import { LEASE_MS, QUEUES, onRedis, open, over, resultOf, startProcess, startRedis, taskOf, temporaryFolder, textOf } from './support.mjs';
import { until } from '../../until.mjs';

// Queues that several processes share: their ends, by kill -9 too.

let server;
before(async () => {
  server = await startRedis();
});
after(() => server.stop());

const KINDS = {
  SQLite: QUEUES.SQLite,
  Redis: { place: () => onRedis(server).place() },
  'Redis and a folder': {
    async place(t) {
      const { folder, remove } = temporaryFolder('bytes');
      t.after(remove);
      return { ...(await onRedis(server).place()), folder };
    },
  },
};

/** Runs of each job so far, from the log of the workers. */
const runsIn = (log) => readFileSync(log, 'utf8').split('\n').filter(Boolean);

function logFile(t) {
  const { folder, remove } = temporaryFolder('log');
  t.after(remove);
  const log = path.join(folder, 'log');
  writeFileSync(log, '');
  return log;
}

for (const [name, kind] of Object.entries(KINDS)) {
  describe(name, { concurrency: true }, () => {
    test('jobs and results survive the process that added them; another one draws them', async (t) => {
      const place = await kind.place(t);
      const first = await openQueue(place);
      const { id } = await first.add(taskOf('a'), { meta: { type: 'x' } });
      await first.close();
      const second = await open(t, place);
      assert.equal((await second.get(id)).state, 'waiting');
      const seen = [];
      second.watch(id, ({ state, progress }) => seen.push(`${state} ${progress}`));
      const worker = await startProcess(t, place);
      assert.equal((await over(second, id)).state, 'done');
      await until(() => seen.at(-1) === 'done 1');
      worker.child.kill('SIGTERM');
      assert.deepEqual(await worker.ended, { code: 0, signal: null });
      const third = await open(t, place);
      assert.equal(await textOf(third, id), 'result a');
      assert.deepEqual((await third.result(id)).meta, { type: 'x' });
    });

    test('kill -9 of a worker: another one does its job, and there is one result', async (t) => {
      const [place, log] = [await kind.place(t), logFile(t)];
      const queue = await open(t, place);
      const { id } = await queue.add(taskOf('a', { sleep: LEASE_MS }));
      const workers = [await startProcess(t, place, { log })];
      await until(() => runsIn(log).length === 1);
      assert.equal((await queue.get(id)).state, 'running');
      workers[0].child.kill('SIGKILL');
      workers.push(await startProcess(t, place, { log }), await startProcess(t, place, { log }));
      const told = await over(queue, id);
      assert.deepEqual([told.state, told.error, runsIn(log)], ['done', undefined, ['a', 'a']]);
      assert.equal(await textOf(queue, id), 'result a');
      assert.deepEqual(await queue.counts(), { waiting: 0, running: 0, kept: 1 });
    });

    test('a job that kills its worker processes fails as poison, and the next one is drawn', async (t) => {
      const [place, log] = [{ ...(await kind.place(t)), poison: 2 }, logFile(t)];
      const queue = await open(t, place);
      const { id } = await queue.add(taskOf('poison', { kills: true }), { priority: 0 });
      const good = await queue.add(taskOf('good'));
      const ends = [];
      for (let i = 0; i < 2; ++i) {
        const worker = await startProcess(t, place, { log });
        ends.push(await worker.ended);
      }
      assert.deepEqual(ends, Array(2).fill({ code: null, signal: 'SIGKILL' }));
      await startProcess(t, place, { log });
      const told = await over(queue, id);
      assert.deepEqual([told.state, told.error.code], ['failed', 'X_QUARANTINE']);
      assert.equal((await over(queue, good.id)).state, 'done');
      assert.deepEqual(runsIn(log).toSorted(), ['good', 'poison', 'poison']);
      assert.equal((await queue.add(taskOf('poison', { kills: true }), { priority: 0 })).state, 'failed');
    });

    test('SIGTERM: what takes too long is given back, and counts for nothing', async (t) => {
      const [place, log] = [await kind.place(t), logFile(t)];
      const queue = await open(t, { ...place, poison: 1, attempts: 1 });
      const { id } = await queue.add(taskOf('a', { sleep: 800 }));
      const slow = await startProcess(t, { ...place, poison: 1, attempts: 1 }, { log });
      await until(() => runsIn(log).length === 1);
      slow.child.kill('SIGTERM');
      assert.deepEqual(await slow.ended, { code: 0, signal: null });
      assert.equal((await queue.get(id)).state, 'waiting');
      await startProcess(t, { ...place, poison: 1, attempts: 1 }, { log });
      const told = await over(queue, id);
      assert.deepEqual([told.state, told.error], ['done', undefined]);
    });

    test('cancel in one process stops the job in another', async (t) => {
      const [place, log] = [await kind.place(t), logFile(t)];
      const queue = await open(t, place);
      const { id } = await queue.add(taskOf('a', { sleep: 3_600_000 }));
      await startProcess(t, place, { log });
      await until(() => runsIn(log).length === 1);
      assert.equal((await queue.cancel(id)).state, 'cancelled');
      const next = await queue.add(taskOf('b'));
      assert.equal((await over(queue, next.id)).state, 'done');
      assert.equal((await queue.get(id)).state, 'cancelled');
    });

    test('a worker whose pool is closed gives its job back and takes no more; another one draws it', async (t) => {
      const place = await kind.place(t);
      const [closed, other] = [await open(t, place), await open(t, place)];
      let runs = 0;
      closed.take(
        async () => {
          runs += 1;
          throw new TelarError('X_CLOSED', 'the pool was closed');
        },
        { atOnce: 1 },
      );
      const ids = [(await other.add(taskOf('a'))).id, (await other.add(taskOf('b'))).id];
      await until(() => runs === 1);
      await until(async () => (await other.counts()).waiting === 2);
      other.take(async ({ asked }) => resultOf(asked.name), { atOnce: 1 });
      for (const id of ids) assert.equal((await over(other, id)).state, 'done');
      assert.equal(runs, 1);
    });

    test('several add and several draw at once: each job once, each result its own', async (t) => {
      const [place, log] = [await kind.place(t), logFile(t)];
      const queues = [await open(t, place), await open(t, place)];
      await Promise.all([startProcess(t, place, { log }), startProcess(t, place, { log })]);
      const names = Array.from({ length: 40 }, (_, i) => `job ${i % 20}`);
      const added = await Promise.all(names.map((one, i) => queues[i % 2].add(taskOf(one))));
      assert.equal(new Set(added.map(({ id }) => id)).size, 20);
      for (const [i, { id }] of added.entries()) {
        assert.equal((await over(queues[0], id)).state, 'done');
        assert.equal(await textOf(queues[1], id), `result ${names[i]}`);
      }
      assert.deepEqual(runsIn(log).toSorted(), [...new Set(names)].sort());
    });
  });
}

test('a folder keeps no bytes of what is over, nor what writes left behind; planted: a cut result is none', async (t) => {
  const place = await QUEUES.SQLite.place(t);
  const queue = await open(t, { ...place, resultMs: 3_600_000 });
  const { id } = await queue.add(taskOf('a'));
  const folder = `${place.sqlite}-bytes`;
  assert.equal(readdirSync(folder).length, 1);
  await startProcess(t, place);
  await over(queue, id);
  await until(() => readdirSync(folder).length === 1);
  const [file] = readdirSync(folder);
  assert.equal(readFileSync(path.join(folder, file), 'utf8'), 'result a');
  writeFileSync(path.join(folder, file), 'result');
  assert.equal(await queue.result(id), undefined);
  const store = await FolderStore.open(folder);
  await store.sweep(1000);
  assert.equal(readdirSync(folder).length, 1);
  await store.sweep(-3_600_001);
  assert.equal(readdirSync(folder).length, 0);
});
