import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import os from 'node:os';
import path from 'node:path';
import { before, test } from 'node:test';
import { promisify } from 'node:util';
import { RedisMarks } from '../../../js/queue/redis_marks.mjs';
import { Table } from '../../../js/queue/sqlite_table.mjs';
import { TelarError } from '../../../js/queue/index.mjs';
import { buildLibrary } from '../../faults/support.mjs';
import { open, over, taskOf, temporaryFolder } from './support.mjs';

// A queue on a disk that is full: what may pass is tried again, and told as the queue's fault.

let built;
before(() => {
  built = buildLibrary();
});

const RUN = promisify(execFile);

/** Runs a program in a process whose folder of bytes is on a disk without room. */
async function onFullDisk(program) {
  const text = `import { openQueue } from ${JSON.stringify(new URL('../../../js/queue/index.mjs', import.meta.url).href)};
    import { over, resultOf, taskOf } from ${JSON.stringify(new URL('support.mjs', import.meta.url).href)};
    ${program}`;
  const env = { ...process.env, LD_PRELOAD: built.library, TELAR_FAULT_PATH: 'jobs.db-bytes/', TELAR_FAULT_OPEN: String(os.constants.errno.ENOSPC) };
  const { stdout } = await RUN(process.execPath, ['--input-type=module', '-e', text], { env });
  return JSON.parse(stdout);
}

test('a job that cannot be stored: X_QUEUE, which may pass', async (t) => {
  const { folder, remove } = temporaryFolder('full');
  t.after(remove);
  const place = JSON.stringify({ sqlite: path.join(folder, 'jobs.db') });
  const told = await onFullDisk(`
    const queue = await openQueue(${place});
    const error = await queue.add(taskOf('a')).catch((thrown) => thrown);
    console.log(JSON.stringify([error.code, error.retryable, error.message, await queue.counts()]));
    await queue.close();`);
  assert.deepEqual(told, ['X_QUEUE', true, 'a file of the queue cannot be written (ENOSPC)', { waiting: 0, running: 0, kept: 0 }]);
});

test('a result that cannot be stored is tried again, and drawn where there is room', async (t) => {
  const { folder, remove } = temporaryFolder('full');
  t.after(remove);
  const place = { sqlite: path.join(folder, 'jobs.db'), backoffMs: 1, attempts: 9 };
  const queue = await open(t, place);
  const { id } = await queue.add(taskOf('a'));
  const state = await onFullDisk(`
    const queue = await openQueue(${JSON.stringify(place)});
    let runs = 0;
    const twice = new Promise((resolve) => {
      queue.take(async () => { if (++runs === 2) resolve(); return resultOf('a'); }, { atOnce: 1 });
    });
    await Promise.race([twice, over(queue, ${JSON.stringify(id)})]);
    await queue.close();
    console.log(JSON.stringify(runs));`);
  assert.equal(state, 2);
  queue.take(async () => ({ key: 'k', info: {}, files: [{ name: 'a', type: 't', data: Buffer.from('a') }] }), { atOnce: 1 });
  assert.equal((await over(queue, id)).state, 'done');
});

test('a database that is full: X_QUEUE says so, and it goes on when there is room', async (t) => {
  const { folder, remove } = temporaryFolder('full');
  t.after(remove);
  const { DatabaseSync } = await import('node:sqlite').catch(() => import('@photostructure/sqlite'));
  const db = new DatabaseSync(path.join(folder, 'jobs.db'));
  const table = new Table(db);
  t.after(() => table.close());
  const { page_count: pages } = db.prepare('PRAGMA page_count').get();
  const add = (id, task) => table.change('add', { id, kind: 'k', priority: 0, now: 0, bytes: 0, task, meta: '{}', put: null });
  db.exec(`PRAGMA max_page_count = ${pages + 1}`);
  const large = 'x'.repeat(2 ** 20);
  assert.throws(() => table.transaction(() => add('a', large)), { code: 'X_QUEUE', retryable: true, message: /full/ });
  assert.equal(table.row('get', { id: 'a' }), undefined);
  db.exec('PRAGMA max_page_count = 100000');
  table.transaction(() => add('a', large));
  assert.equal(table.row('get', { id: 'a' }).task, large);
});

test('the mark of a job on Redis: whoever is first ends it', async () => {
  const keys = new Map();
  const client = {
    set: async (key, value) => (keys.has(key) ? null : keys.set(key, value) && 'OK'),
    get: async (key) => keys.get(key) ?? null,
    mget: async (all) => all.map((key) => keys.get(key) ?? null),
    unlink: async (key) => keys.delete(key),
  };
  const marks = new RedisMarks(client, (id) => `mark ${id}`);
  const state = { id: 'a', state: 'cancelled', error: new TelarError('X_CANCELLED', 'the job was cancelled') };
  assert.deepEqual([await marks.end('a', 1), await marks.cancel('a', state, 1), await marks.cancelled('a')], [true, false, undefined]);
  assert.equal(await marks.end('a', 1), true, 'a worker that has the job of one that ended');
  assert.deepEqual([await marks.cancel('b', state, 1), await marks.end('b', 1), (await marks.cancelled('b')).error.code], [true, false, 'X_CANCELLED']);
  assert.deepEqual(await marks.cancelledOf(['a', 'b', 'c']), ['b']);
  await marks.clear('b');
  assert.equal(await marks.end('b', 1), true);
});
