import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { before, test } from 'node:test';
import { ENVIRONMENTS, MODELS } from '../../fixtures/index.mjs';
import { busy, ENDLESS, errorOf, isAlive, open, SHOT } from './support.mjs';
import { until } from '../../until.mjs';

// A worker that ends, hangs or takes too much costs its own job, and nothing else.

const digestOf = (bytes) => createHash('sha256').update(bytes).digest('hex');
const MIB = 2 ** 20;

let glb, ball, expected;
before(async () => {
  [glb, ball] = await Promise.all([MODELS.cloth(), MODELS.ball()]);
  const pool = await open();
  expected = (await pool.render(glb, SHOT)).data;
  await pool.close();
});

/** Runs with a pool of its own, which still draws afterwards, with as many workers as before. */
async function withPool(options, use) {
  const pool = await open(options);
  try {
    await use(pool);
    assert.ok((await pool.render(glb, SHOT)).data.equals(expected), 'the next job is served');
    await until(() => pool.workers.length === (options.size ?? 1));
  } finally {
    await pool.close();
  }
}

for (const signal of ['SIGKILL', 'SIGSEGV', 'SIGABRT']) {
  test(`a worker that ends by ${signal} in the middle of a job`, () =>
    withPool({ size: 2 }, async (pool) => {
      let pid;
      let others;
      const onProgress = () => {
        if (pid) return;
        [pid] = pool.workers.filter(({ state }) => state === 'busy').map((worker) => worker.pid);
        others = Promise.all([1, 2, 3].map(() => pool.render(glb, SHOT)));
        process.kill(pid, signal);
      };
      const error = await errorOf(pool.render(ball, ENDLESS, { onProgress }));
      assert.deepEqual(error.toJSON(), {
        code: 'X_CRASH',
        kind: 'crash',
        message: `the worker that drew this ended by ${signal}; no other job is affected`,
        retryable: true,
        signal,
        input: digestOf(ball),
      });
      for (const { data } of await others) assert.ok(data.equals(expected));
      assert.ok(!pool.workers.some((worker) => worker.pid === pid));
    }));
}

test('a worker that ends while it waits is replaced, and nobody is told', () =>
  withPool({}, async (pool) => {
    const [{ pid }] = pool.workers;
    process.kill(pid, 'SIGKILL');
    await until(() => !isAlive(pid));
  }));

test('a worker that hangs is ended 2 s after its time', () =>
  withPool({}, async (pool) => {
    const [{ pid }] = pool.workers;
    process.kill(pid, 'SIGSTOP');
    const error = await errorOf(pool.render(glb, SHOT, { timeoutMs: 100 }));
    assert.deepEqual([error?.code, error?.retryable], ['X_TIMEOUT', true]);
    assert.match(error.message, /^the work took longer than the 100 ms that timeoutMs allows and did not stop by itself/);
    assert.ok(!isAlive(pid));
  }));

test('a worker that hangs in renderAll is ended after the time of one picture', () =>
  withPool({}, async (pool) => {
    let stopped;
    const onProgress = (part) => {
      if (part < 0.5 || stopped) return;
      stopped = pool.workers[0].pid;
      process.kill(stopped, 'SIGSTOP');
    };
    assert.equal((await errorOf(pool.renderAll(glb, [SHOT, ENDLESS], { timeoutMs: 1500, onProgress })))?.code, 'X_TIMEOUT');
    assert.ok(stopped);
    // On a busy machine it may have answered before it was stopped, and goes on.
    if (isAlive(stopped)) process.kill(stopped, 'SIGCONT');
  }));

test('work that the worker stops by itself keeps its worker', () =>
  withPool({}, async (pool) => {
    const [{ pid }] = pool.workers;
    assert.equal((await errorOf(pool.render(glb, ENDLESS, { timeoutMs: 50 })))?.code, 'X_TIMEOUT');
    assert.equal(pool.workers[0].pid, pid);
  }));

const BOUNDS = {
  memoryBytes: [{ memoryBytes: 64 * MIB }, 'X_MEMORY', 64 * MIB],
  cpuMs: [{ cpuMs: 200 }, 'X_TIMEOUT', 200],
};
for (const [name, [options, code, max]] of Object.entries(BOUNDS)) {
  test(`a job over ${name}`, async () => {
    const pool = await open(options);
    const [{ pid }] = pool.workers;
    const error = await errorOf(pool.render(glb, ENDLESS));
    assert.deepEqual([error?.code, error?.limit?.name, error?.limit?.max], [code, name, max]);
    assert.ok(error.limit.actual > max);
    await until(() => !isAlive(pid));
    await pool.close();
  });
}

test('pictures over outputBytes are refused, and the worker stays', () =>
  withPool({ outputBytes: 20_000 }, async (pool) => {
    const [{ pid }] = pool.workers;
    const big = { size: { width: 100, height: 100 }, output: { format: 'raw' } };
    const error = await errorOf(pool.render(glb, big));
    assert.deepEqual([error?.code, error?.limit], ['L_OUTPUT_BYTES', { name: 'outputBytes', max: 20_000, actual: 40_000 }]);
    assert.equal(pool.workers[0].pid, pid);
  }));

test('abort: at once, with the reason; the worker is free again', () =>
  withPool({}, async (pool) => {
    const [{ pid }] = pool.workers;
    const mine = new AbortController();
    const drawn = errorOf(pool.render(glb, ENDLESS, { signal: mine.signal }));
    const waiting = errorOf(pool.render(glb, SHOT, { signal: mine.signal }));
    await busy(pool);
    const reason = new Error('mine');
    mine.abort(reason);
    assert.deepEqual([await drawn, await waiting], [reason, reason]);
    assert.equal(await errorOf(pool.render(glb, SHOT, { signal: mine.signal })), reason, 'before it begins');
    assert.ok((await pool.render(glb, SHOT)).data.equals(expected));
    assert.equal(pool.workers[0].pid, pid);
  }));

test('abort of a worker that hangs: it is replaced', () =>
  withPool({}, async (pool) => {
    const [{ pid }] = pool.workers;
    process.kill(pid, 'SIGSTOP');
    const reason = new Error('mine');
    const signal = AbortSignal.timeout(1);
    assert.equal((await errorOf(pool.render(glb, SHOT, { signal })))?.name, 'TimeoutError');
    assert.ok(isAlive(pid), String(reason));
  }));

test('a worker that is ended just before it gets its job: another one does it, and the file is not blamed', () =>
  withPool({}, async (pool) => {
    for (let i = 0; i < 3; ++i) {
      const { pid } = await until(() => pool.workers.find(({ state }) => state === 'idle'));
      process.kill(pid, 'SIGKILL');
      // Its end is an event that this process has not seen yet.
      assert.ok((await pool.render(ball, SHOT)).data.length > 0);
    }
  }));

test('a file that hangs its workers is refused too where its callers abort before its time', () =>
  withPool({}, async (pool) => {
    for (let i = 0; i < 2; ++i) {
      const { pid } = await until(() => pool.workers.find(({ state }) => state === 'idle'));
      const mine = new AbortController();
      const onProgress = () => process.kill(pid, 'SIGSTOP') && mine.abort(new Error('mine'));
      assert.equal((await errorOf(pool.render(ball, ENDLESS, { signal: mine.signal, onProgress })))?.message, 'mine');
      await until(() => !isAlive(pid));
    }
    await until(() => pool.workers.some(({ state }) => state === 'idle'));
    assert.equal((await errorOf(pool.render(ball, SHOT)))?.code, 'X_QUARANTINE');
  }));

test('of a job that had an environment of its own both together are refused: which of the two it was is not known', () =>
  withPool({}, async (pool) => {
    const shot = { ...ENDLESS, environment: { map: ENVIRONMENTS['soft-studio']() } };
    for (let i = 0; i < 2; ++i) {
      const onProgress = () => process.kill(pool.workers.find(({ state }) => state === 'busy').pid, 'SIGKILL');
      assert.equal((await errorOf(pool.render(ball, shot, { onProgress })))?.code, 'X_CRASH');
    }
    assert.equal((await errorOf(pool.render(ball, { ...SHOT, environment: shot.environment })))?.code, 'X_QUARANTINE');
    assert.ok((await pool.render(ball, SHOT)).data.length > 0);
    assert.ok((await pool.render(glb, { ...SHOT, environment: shot.environment })).data.length > 0);
  }));

test('a file that ended two workers in a row is refused, others are not', () =>
  withPool({}, async (pool) => {
    const crash = async (source) => {
      const onProgress = () => process.kill(pool.workers.find(({ state }) => state === 'busy').pid, 'SIGKILL');
      assert.equal((await errorOf(pool.render(source, ENDLESS, { onProgress })))?.code, 'X_CRASH');
    };
    const model = await pool.load(ball);
    for (let i = 0; i < 3; ++i) {
      await crash(ball);
      assert.ok((await pool.render(ball, SHOT)).data.length > 0, 'after one it is drawn, and has none in a row');
    }
    await crash(ball);
    await crash(model);
    for (const use of [() => pool.render(ball, SHOT), () => pool.render(model, SHOT), () => pool.load(Buffer.from(ball))]) {
      const error = await errorOf(use());
      assert.deepEqual([error?.code, error?.retryable, error?.input], ['X_QUARANTINE', false, digestOf(ball)]);
    }
    const sameSize = Buffer.from(ball);
    sameSize[sameSize.length - 1] ^= 1;
    assert.ok((await pool.render(sameSize, SHOT)).data.length > 0, 'it goes by the bytes, not by their number');
  }));
