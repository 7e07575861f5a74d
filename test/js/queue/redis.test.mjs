import assert from 'node:assert/strict';
import { test } from 'node:test';
import { deferred, freePort, open, over, startProcess, resultOf, startRedis, taskOf, textOf } from './support.mjs';
import { openQueue } from '../../../js/queue/index.mjs';
import { until } from '../../until.mjs';

// The Redis server itself: its settings, its end and its return.

async function redis(t, settings) {
  const server = await startRedis(settings);
  t.after(() => {
    server.thaw();
    return server.stop();
  });
  return server;
}

test('settings: one that throws jobs away is refused, one that forgets them is told', async (t) => {
  const evicting = await redis(t, ['--maxmemory', '50mb', '--maxmemory-policy', 'allkeys-lru']);
  await assert.rejects(open(t, { redis: evicting.url }), {
    code: 'X_QUEUE',
    retryable: true,
    message: 'maxmemory-policy of the Redis server is allkeys-lru: it may throw jobs away. Set it to noeviction',
  });
  const forgetting = await redis(t, ['--appendonly', 'no']);
  const { warnings } = await open(t, { redis: forgetting.url });
  assert.deepEqual(
    warnings.map(({ code }) => code),
    ['W_QUEUE'],
  );
  assert.match(warnings[0].message, /Set appendonly to yes$/);
  const right = await redis(t);
  assert.deepEqual((await open(t, { redis: right.url })).warnings, []);
});

test('no server, another protocol, a wrong address', async (t) => {
  await assert.rejects(open(t, { redis: `redis://127.0.0.1:${await freePort()}` }), { code: 'X_QUEUE', message: /ECONNREFUSED/ });
  await assert.rejects(open(t, { redis: 'http://127.0.0.1:6379' }), { code: 'E_OPTION', message: /^options\.redis: expected an address that begins with/ });
  await assert.rejects(open(t, { redis: 'redis://a:1', sqlite: 'b' }), { code: 'E_OPTION', message: /^options\.sqlite: expected nothing/ });
});

test('its memory is full: no more jobs, and those that are there are drawn', async (t) => {
  const { url } = await redis(t, ['--maxmemory', '6mb']);
  const queue = await open(t, { redis: url });
  const first = await queue.add(taskOf('first'));
  const large = (name) => ({ ...taskOf(name), files: { model: Buffer.alloc(4_000_000, name) } });
  const added = await Promise.allSettled([queue.add(large('a')), queue.add(large('b'))]);
  const refused = added.filter(({ status }) => status === 'rejected').map(({ reason }) => reason.code);
  assert.deepEqual([...new Set(refused)], ['X_BUSY']);
  await startProcess(t, { redis: url });
  assert.equal((await over(queue, first.id)).state, 'done');
});

test('kill -9 of Redis and its return: what was added is drawn, workers and listeners find it again', async (t) => {
  const server = await redis(t, ['--appendfsync', 'always']);
  const place = { redis: server.url, leaseMs: 2000 };
  const queue = await open(t, place);
  const worker = await startProcess(t, place);
  const running = await queue.add(taskOf('running', { sleep: 1500 }));
  await until(() => worker.lines.includes('runs running'));
  const waiting = await queue.add(taskOf('waiting'));
  const told = [];
  queue.watch(waiting.id, ({ state }) => told.push(state));
  await server.kill();
  const refused = await queue.add(taskOf('meanwhile')).catch((error) => error);
  assert.deepEqual([refused.code, refused.http], ['X_QUEUE', 503], 'at once, and not when it is there again');
  await server.start();
  for (const { id } of [running, waiting]) {
    const state = await until(async () => {
      const now = await queue.get(id).catch(() => undefined);
      return now?.ended && now;
    });
    assert.deepEqual([state.state, await textOf(queue, id)], ['done', `result ${id === running.id ? 'running' : 'waiting'}`]);
  }
  await until(() => told.at(-1) === 'done');
  const counts = await queue.counts();
  assert.deepEqual([counts.waiting, counts.running, counts.kept], [0, 0, 2]);
});

test('Redis keeps its connections and answers nothing: whoever asks is told in time, and the queue ends', { timeout: 60_000 }, async (t) => {
  const server = await redis(t);
  const queue = await openQueue({ redis: server.url });
  const [begun, goOn] = [deferred(), deferred()];
  queue.take(
    async () => {
      begun.settle();
      await goOn.promise;
      return resultOf('a');
    },
    { atOnce: 1 },
  );
  const { id } = await queue.add(taskOf('a'));
  await begun.promise;
  server.freeze();
  await Promise.all([queue.get(id), queue.add(taskOf('b')), queue.counts()].map((asked) => assert.rejects(asked, { code: 'X_QUEUE' })));
  // Its result waits for the server.
  goOn.settle();
  await queue.close();
});
