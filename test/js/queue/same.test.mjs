import assert from 'node:assert/strict';
import { after, before, describe, test } from 'node:test';
import '../api/support/real.mjs';
import { readImage } from '../../../js/compare/index.mjs';
import { TelarError, openQueue } from '../../../js/queue/index.mjs';
import { importMutant, outcomeOf } from '../server/mutants.mjs';
import { LEASE_MS, QUEUES, deferred, onRedis, open, over, resultOf, startRedis, taskOf } from './support.mjs';
import { startHost } from '../../http_host.mjs';
import { until } from '../../until.mjs';

// What holds for each of the three queues.

let server;
before(async () => {
  server = await startRedis();
});
after(() => server.stop());

const fails = (code, message = code) => Promise.reject(new TelarError(code, message));
const codeOf = (promise) =>
  Promise.resolve(promise).then(
    () => undefined,
    ({ code }) => code,
  );

/** A job shows two pictures, and one of floats; another queue of the same place watches. */
async function checkPreviews(t, openOne, place) {
  const worker = await openOne({ leaseMs: LEASE_MS, ...place });
  const watcher = place.sqlite || place.redis ? await openOne(place) : worker;
  t.after(() => Promise.all([worker.close(), watcher.close()]));
  const shown = [];
  const showing = deferred();
  worker.take(
    async (_, { signal, onPreview, onStart }) => {
      onStart();
      await showing.promise;
      for (const [samples, bitDepth] of [
        [1, 32],
        [2, 8],
        [4, 8],
      ]) {
        const show = () => onPreview({ width: 400, height: 200, bitDepth, samples, data: Buffer.alloc(50 * 200 * bitDepth * 4, 255) });
        show();
        // What comes while the one before is still on its way is left out.
        const isShown = () => signal.aborted || shown.at(-1)?.preview.samples === samples;
        if (bitDepth === 8)
          await until(() => {
            if (isShown()) return true;
            show();
            return false;
          });
      }
      return resultOf('a');
    },
    { atOnce: 1 },
  );
  const { id } = await watcher.add(taskOf('a'));
  watcher.watch(id, (state, preview) => preview && shown.push({ state, preview }));
  showing.settle();
  await over(watcher, id);
  for (const { state, preview } of shown) {
    const { png, ...rest } = preview;
    const { width, height } = await readImage(png);
    assert.deepEqual([state.id, state.state, rest.width, rest.height, width, height], [id, 'running', 400, 200, 134, 67]);
  }
  assert.deepEqual(
    shown.map(({ preview }) => preview.samples),
    [2, 4],
  );
}

/** What is wrong in js/queue, by the queue whose check must find it. */
const LOST_PREVIEWS = {
  'in memory': ['memory_queue.mjs', 'if (!isOver(job)) tell(job, preview);', ''],
  SQLite: ['sqlite_runs.mjs', "if (table.change('show', { id, token, ...shown })) changed(id);", ''],
  Redis: ['redis_queue.mjs', "previewOf: (id) => this.#key('preview', id)", "previewOf: (id) => this.#key('previous', id)"],
};

test('in memory: where nobody draws, what waits is not waited for', async (t) => {
  const queue = await open(t, {});
  const { id } = await queue.add(taskOf('a'));
  await queue.idle();
  assert.equal((await queue.get(id)).state, 'waiting');
});

test('in memory: a job whose pool is closed fails, as no other process has it', async (t) => {
  const queue = await open(t, {});
  queue.take(() => fails('X_CLOSED'), { atOnce: 1 });
  const told = await over(queue, (await queue.add(taskOf('a'))).id);
  assert.deepEqual([told.state, told.error.code], ['failed', 'X_CLOSED']);
});

for (const [name, kind] of Object.entries({ ...QUEUES, Redis: { place: () => onRedis(server).place() } })) {
  describe(name, () => {
    /** A queue, and what was asked of its work so far. */
    async function working(t, work, { atOnce = 1, ...options } = {}) {
      const queue = await open(t, { ...(await kind.place(t)), ...options });
      const runs = [];
      queue.take(
        async (task, how) => {
          runs.push(task.asked.name);
          return work(task, how, runs.length);
        },
        { atOnce },
      );
      return { queue, runs };
    }

    test('a job waits, runs and is done; bytes come and go whole, wherever they lie in a task', async (t) => {
      let seen;
      const gate = deferred();
      const { queue } = await working(t, async (task) => {
        seen = task;
        await gate.promise;
        return resultOf(task.asked.name);
      });
      const map = Uint8Array.from([7, 8, 9]);
      const task = {
        ...taskOf('a', { shot: { environment: { map, rotation: 1 } } }),
        files: { model: Buffer.from('glb'), 'part __proto__': Buffer.from('p') },
      };
      const meta = { type: 'image/png' };
      const added = await queue.add(task, { meta });
      assert.match(added.id, /^[0-9a-f]{64}$/);
      assert.deepEqual([added.kind, added.progress, added.state === 'waiting' || added.state === 'running'], ['thumbnail', 0, true]);
      await until(() => seen);
      assert.equal((await queue.get(added.id)).state, name === 'in memory' ? 'waiting' : 'running', 'in this process it runs from onStart() on');
      assert.equal(await queue.result(added.id), undefined);
      gate.settle();
      const told = await over(queue, added.id);
      assert.deepEqual([told.state, told.progress, told.tries, told.error], ['done', 1, 1, undefined]);
      assert.ok(told.created <= told.ended);
      assert.deepEqual([Buffer.from(seen.files.model).toString(), Buffer.from(seen.files['part __proto__']).toString()], ['glb', 'p']);
      assert.deepEqual([[...seen.asked.shot.environment.map], seen.asked.shot.environment.rotation], [[7, 8, 9], 1]);
      const kept = await queue.result(added.id);
      assert.deepEqual(kept.meta, meta);
      assert.deepEqual({ ...kept.result, files: undefined }, { ...resultOf('a'), files: undefined });
      assert.deepEqual(
        kept.result.files.map(({ data, ...file }) => ({ ...file, data: data.toString() })),
        [{ name: 'a.txt', type: 'text/plain', data: 'result a' }],
      );
    });

    test('what is asked for again is the same job; other bytes, shots, tenants and answers are others', async (t) => {
      const { queue, runs } = await working(t, async ({ asked }) => resultOf(asked.name), { atOnce: 2 });
      const ids = new Set();
      for (const [task, how] of [
        [taskOf('a')],
        [{ ...taskOf('a'), files: { model: Buffer.from('other') } }],
        [taskOf('a', { shot: { exposure: 2 } })],
        [taskOf('a'), { tenant: 'one' }],
        [taskOf('a'), { meta: { type: 'json' } }],
      ]) {
        const [first, again] = await Promise.all([queue.add(task, how), queue.add(task, how)]);
        assert.equal(again.id, first.id);
        assert.equal((await over(queue, first.id)).state, 'done');
        assert.equal((await queue.add(task, { ...how, priority: 0 })).state, 'done', 'a result that is there is not made again');
        ids.add(first.id);
      }
      assert.deepEqual([ids.size, runs.length], [5, 5]);
    });

    test('files that come in another order are the same job; fonts, of which the first that has a character shows it, are not', async (t) => {
      const queue = await open(t, await kind.place(t));
      const idOf = async (...names) => (await queue.add({ ...taskOf('a'), files: Object.fromEntries(names.map((name) => [name, Buffer.from(name)])) })).id;
      assert.equal(await idOf('actual', 'expected', 'part b', 'part a'), await idOf('part a', 'expected', 'part b', 'actual'));
      assert.equal(await idOf('font a', 'model', 'font b'), await idOf('model', 'font a', 'font b'));
      assert.notEqual(await idOf('font a', 'font b'), await idOf('font b', 'font a'));
    });

    test('the urgent one first, then in order', async (t) => {
      const gate = deferred();
      const { queue, runs } = await working(t, async ({ asked }) => {
        if (asked.name === 'first') await gate.promise;
        return resultOf(asked.name);
      });
      await queue.add(taskOf('first'));
      await until(() => runs.length === 1);
      const added = [];
      for (const [task, priority] of [
        ['later', 7],
        ['a', undefined],
        ['b', 3],
        ['now', 0],
      ])
        added.push(await queue.add(taskOf(task), { priority }));
      gate.settle();
      for (const { id } of added) await over(queue, id);
      assert.deepEqual(runs, ['first', 'now', 'a', 'b', 'later']);
    });

    test('what one process adds at the same moment passes no bound, and the same job counts once', async (t) => {
      const bounds = { jobs: 4, tenantJobs: 3, tenantMs: 3_600_000 };
      const queue = await open(t, { ...(await kind.place(t)), ...bounds });
      const addAll = async (tenant, names) =>
        (await Promise.all(names.map((name) => codeOf(queue.add(taskOf(name), { tenant }))))).filter((code) => !code).length;
      assert.equal(await addAll('one', ['a', 'a', 'a', 'a', 'b', 'c', 'd', 'e', 'f']), 6, 'a four times, b and c');
      assert.equal(await addAll('two', ['a', 'b', 'c', 'd']), 1);
      assert.equal((await queue.counts()).waiting, bounds.jobs);
    });

    test('so many wait, so large, so often by a tenant; one more is refused, and the same one again is not', async (t) => {
      const queue = await open(t, { ...(await kind.place(t)), jobs: 3, taskBytes: 20, tenantJobs: 2, tenantMs: 3_600_000 });
      assert.equal(await codeOf(queue.add(taskOf('a name that is too long'))), 'L_REQUEST_BYTES');
      const { id } = await queue.add(taskOf('a'), { tenant: 'one' });
      await queue.add(taskOf('b'), { tenant: 'one' });
      assert.equal(await codeOf(queue.add(taskOf('c'), { tenant: 'one' })), 'X_BUSY');
      await assert.rejects(async () => queue.check('one'), { code: 'X_BUSY', message: /^2 jobs were added within 3600000 ms/ });
      await queue.add(taskOf('c'), { tenant: 'two' });
      await assert.rejects(async () => queue.check('three'), { code: 'X_BUSY', message: /^3 jobs wait/ });
      assert.equal(await codeOf(queue.add(taskOf('d'), { tenant: 'three' })), 'X_BUSY');
      assert.equal((await queue.add(taskOf('a'), { tenant: 'one' })).id, id);
      assert.deepEqual(await queue.counts(), { waiting: 3, running: 0, kept: 0 });
    });

    test('an error that may pass is tried again, later each time; another one ends the job at once', async (t) => {
      const { queue, runs } = await working(t, ({ asked }, _, run) => {
        if (asked.name === 'wrong') return fails('E_JSON', 'the glTF JSON is cut');
        if (asked.name === 'slow') return fails('X_TIMEOUT');
        return asked.name === 'lost' || run < 3 ? fails('X_GL_LOST') : resultOf(asked.name);
      });
      const passing = await over(queue, (await queue.add(taskOf('passing'))).id);
      assert.deepEqual([passing.state, passing.tries, runs.length], ['done', 3, 3]);
      const slow = await over(queue, (await queue.add(taskOf('slow'))).id);
      assert.deepEqual([slow.state, slow.error.code, slow.tries, runs.length], ['failed', 'X_TIMEOUT', 2, 5], 'a clock is given one more chance');
      const lost = await over(queue, (await queue.add(taskOf('lost'))).id);
      assert.deepEqual([lost.state, lost.error.code, lost.tries, runs.length], ['failed', 'X_GL_LOST', 3, 8]);
      const wrong = await over(queue, (await queue.add(taskOf('wrong'))).id);
      assert.deepEqual([wrong.state, wrong.error.code, wrong.error.message, runs.length], ['failed', 'E_JSON', 'the glTF JSON is cut', 9]);
      assert.ok(wrong.error instanceof TelarError);
      assert.equal(await queue.result(wrong.id), undefined);
      await over(queue, (await queue.add(taskOf('wrong'))).id);
      await until(() => runs.length === 10);
    });

    test('a job that ends its workers is put aside, and is not run again', async (t) => {
      const input = 'ab'.repeat(32);
      const crash = () => Promise.reject(new TelarError('X_CRASH', 'SIGSEGV', { input }));
      const { queue, runs } = await working(t, crash, { poison: 2, attempts: 9 });
      const told = await over(queue, (await queue.add(taskOf('a'))).id);
      assert.deepEqual([told.state, told.error.code, told.error.retryable, told.error.input], ['failed', 'X_QUARANTINE', false, input]);
      assert.equal(told.error.message, 'the job ended 2 workers, and is not run again; report it');
      assert.equal((await queue.add(taskOf('a'))).error.code, 'X_QUARANTINE');
      assert.equal(runs.length, 2);
    });

    test('cancel: waiting or running; what is over stays, and asked for again it runs', async (t) => {
      const { queue, runs } = await working(t, ({ asked }, { signal }) => {
        if (asked.name !== 'endless') return resultOf(asked.name);
        return new Promise((_, reject) => signal.addEventListener('abort', () => reject(signal.reason), { once: true }));
      });
      const running = await queue.add(taskOf('endless'));
      await until(() => runs.length === 1);
      const waiting = await queue.add(taskOf('b'));
      for (const { id } of [waiting, running]) {
        assert.equal((await queue.cancel(id)).state, 'cancelled');
        const told = await queue.get(id);
        assert.deepEqual([told.state, told.error.code], ['cancelled', 'X_CANCELLED']);
        assert.equal(await queue.result(id), undefined);
      }
      const after = await over(queue, (await queue.add(taskOf('c'))).id);
      assert.deepEqual([after.state, runs], ['done', ['endless', 'c']], 'the worker is free again, and what waited never ran');
      assert.equal((await queue.cancel(after.id)).state, 'done');
      assert.equal((await over(queue, (await queue.add(taskOf('b'))).id)).state, 'done');
      assert.equal(await queue.cancel('0'.repeat(64)), undefined);
    });

    test('cancelled while its worker has the result in its hands: there is one end, and it is the one that was told', async (t) => {
      const added = deferred();
      let said;
      const { queue } = await working(t, async () => {
        said = await queue.cancel(await added.promise);
        return resultOf('a');
      });
      const { id } = await queue.add(taskOf('a'));
      const told = [];
      queue.watch(id, ({ state }) => told.push(state));
      added.settle(id);
      await until(async () => said && (await queue.counts()).running === 0);
      assert.deepEqual([said.state, (await queue.get(id)).state, await queue.result(id)], ['cancelled', 'cancelled', undefined]);
      await until(() => told.includes('cancelled'));
      assert.ok(!told.includes('done'), String(told));
    });

    test('listeners are told of each state and of progress until the end', async (t) => {
      const gate = deferred();
      const { queue } = await working(t, async (_, { onProgress, onStart }) => {
        onStart();
        await gate.promise;
        onProgress(0.5);
        await until(() => told.some(({ progress }) => progress === 0.5));
        return resultOf('a');
      });
      const told = [];
      const { id } = await queue.add(taskOf('a'));
      queue.watch(id, (state) => told.push(state));
      const mute = queue.watch(id, () => assert.fail('it was called off'));
      mute();
      gate.settle();
      await until(() => told.at(-1)?.state === 'done');
      const states = told.map(({ state, progress }) => `${state} ${progress}`);
      assert.ok(states.includes('running 0.5'), String(states));
      assert.equal(new Set(states).size, states.length);
    });

    test('pictures so far are shown small to whoever watches, by whichever process', async (t) => {
      await checkPreviews(t, openQueue, await kind.place(t));
    });

    test(`planted: pictures so far of ${name} that nobody is shown`, async (t) => {
      const { openQueue: mutant } = await importMutant([LOST_PREVIEWS[name]], '../queue/index.mjs');
      const place = await kind.place(t);
      assert.equal(await outcomeOf(() => checkPreviews(t, mutant, place), { hangMs: 1500 }), 'hangs');
    });

    test('results are kept as long as is said', async (t) => {
      const { queue } = await working(t, async ({ asked }) => resultOf(asked.name), { resultMs: 300 });
      const { id } = await over(queue, (await queue.add(taskOf('a'))).id);
      await until(async () => (await queue.get(id)) === undefined);
      assert.equal(await queue.result(id), undefined);
      assert.equal((await over(queue, (await queue.add(taskOf('a'))).id)).state, 'done');
    });

    test('results go to signed addresses, on allowed hosts alone', async (t) => {
      const got = [];
      let refuses = true;
      const { host, stop } = await startHost(async (request, response) => {
        const chunks = await request.toArray();
        got.push([request.method, request.url, request.headers['content-type'], Buffer.concat(chunks).toString()]);
        response.writeHead(refuses ? 503 : 200).end();
        refuses = false;
      });
      t.after(stop);
      const { queue } = await working(t, async ({ asked }) => resultOf(asked.name));
      const { id } = await over(queue, (await queue.add(taskOf('a'), { put: [`http://${host}/a.txt?signature=1`] })).id);
      const sent = ['PUT', '/a.txt?signature=1', 'text/plain', 'result a'];
      assert.deepEqual(got, [sent, sent], 'once more, as the store refused it');
      assert.deepEqual((await queue.result(id)).result.files, [{ name: 'a.txt', type: 'text/plain', bytes: 8, url: `http://${host}/a.txt` }]);
      assert.equal((await queue.add(taskOf('a'), { put: [`http://${host}/a.txt?signature=2`] })).id, id);
      const bounded = await open(t, { ...(await kind.place(t)) });
      bounded.take(async ({ asked }) => resultOf(asked.name), { atOnce: 1, hosts: [host] });
      const denied = await over(bounded, (await bounded.add(taskOf('b'), { put: [`http://localhost:${host.split(':')[1]}/b.txt`] })).id);
      assert.deepEqual([denied.state, denied.error.code, got.length], ['failed', 'E_URI_DENIED', 2], 'nothing was sent');
      assert.equal((await over(bounded, (await bounded.add(taskOf('c'), { put: [`http://${host}/c.txt`] })).id)).state, 'done');
    });

    test('what is wrong is told', async (t) => {
      const queue = await open(t, await kind.place(t));
      for (const [how, message] of [
        [{ priority: 8 }, /^options\.priority: expected a whole number in \[0, 7\], got 8$/],
        [{ tenant: 5 }, /^options\.tenant: expected a text of at most 256 characters, got 5$/],
        [{ put: ['file:///etc/passwd'] }, /^options\.put: expected a list of addresses, got/],
        [{ urgent: true }, /^options\.urgent: expected meta, tenant, priority or put, got true$/],
      ]) {
        await assert.rejects(queue.add(taskOf('a'), how), { code: 'E_OPTION', message });
      }
    });
  });
}
