import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import os from 'node:os';
import { before, test } from 'node:test';
import { MODELS } from '../../fixtures/index.mjs';
import { fixturesUrl } from '../api/support/real.mjs';
import { busy, ENDLESS, errorOf, isAlive, open, SHOT } from './support.mjs';
import { niceOfSession } from '../../../js/pool/session_priority.mjs';
import { until } from '../../until.mjs';

// The workers of a pool: how many jobs wait, when workers are replaced, how they end.

const poolUrl = new URL('../../../js/pool/index.mjs', import.meta.url).href;

let glb;
before(async () => {
  glb = await MODELS.cloth();
});

test('one job a worker; more than maxWaiting are refused', async () => {
  const pool = await open({ maxWaiting: 1 });
  const [{ pid }] = pool.workers;
  process.kill(pid, 'SIGSTOP');
  const jobs = [pool.render(glb, SHOT, { timeoutMs: null }), pool.render(glb, SHOT)];
  const error = await errorOf(pool.render(glb, SHOT));
  assert.deepEqual([error?.code, error?.message], ['X_BUSY', '1 jobs wait for this pool, its maxWaiting; try again later']);
  process.kill(pid, 'SIGCONT');
  const [first, second] = await Promise.all(jobs);
  assert.ok(first.data.equals(second.data));
  await pool.close();
});

test('jobs are served in the order in which they came', async () => {
  const pool = await open();
  const done = [];
  const draw = async (i) => {
    await pool.render(glb, SHOT);
    done.push(i);
  };
  await Promise.all([0, 1, 2, 3, 4].map(draw));
  assert.deepEqual(done, [0, 1, 2, 3, 4]);
  await pool.close();
});

for (const options of [{ recycleJobs: 1 }, { recycleBytes: 1 }]) {
  test(`workers are replaced: ${JSON.stringify(options)}`, async () => {
    const pool = await open(options);
    const pids = new Set();
    const model = await pool.load(glb);
    for (let i = 0; i < 3; ++i) {
      const drawn = pool.render(model, SHOT);
      for (const pid of await busy(pool)) pids.add(pid);
      await drawn;
    }
    assert.equal(pids.size, 3);
    await pool.close();
  });
}

test('models over modelBytes are let go and loaded again', async () => {
  const pool = await open({ modelBytes: 0 });
  const models = [await pool.load(glb), await pool.load(await MODELS.ball())];
  const pictures = async () => Promise.all(models.map(async (model) => (await pool.render(model, SHOT)).data));
  assert.deepEqual(await pictures(), await pictures());
  await pool.close();
});

test('close() finishes what was asked for, ends the workers, and refuses more', async () => {
  const pool = await open({ size: 2 });
  await until(() => pool.workers.every(({ state }) => state === 'idle'));
  const pids = pool.workers.map(({ pid }) => pid);
  const model = await pool.load(glb);
  const jobs = [1, 2, 3, 4, 5].map(() => pool.render(glb, SHOT));
  const closed = pool.close();
  assert.equal((await errorOf(pool.render(glb, SHOT)))?.code, 'X_CLOSED');
  assert.equal(
    (
      await errorOf(
        model.measure({
          points: [
            [0, 0, 0],
            [1, 0, 0],
          ],
        }),
      )
    )?.code,
    'X_CLOSED',
  );
  for (const { data } of await Promise.all(jobs)) assert.ok(data.length > 0);
  await closed;
  assert.deepEqual(pids.map(isAlive), [false, false]);
  await pool.close();
});

test('createPool: aborted, or without a GL', async () => {
  const mine = new AbortController();
  const opening = errorOf(open({ signal: mine.signal }));
  const reason = new Error('mine');
  mine.abort(reason);
  assert.equal(await opening, reason);
  assert.equal(await errorOf(open({ signal: mine.signal })), reason);
  const env = { ...process.env, __EGL_VENDOR_LIBRARY_FILENAMES: '/none' };
  const text = `import { createPool } from '${poolUrl}';
    console.log(JSON.stringify(await createPool({ size: 1, backend: 'egl-device' }).catch((error) => error)));`;
  const child = spawn(process.execPath, ['--input-type=module', '-e', text], { env, stdio: ['ignore', 'pipe', 'ignore'] });
  const [[said], [code]] = await Promise.all([once(child.stdout, 'data'), once(child, 'exit')]);
  assert.deepEqual([code, JSON.parse(said).code], [0, 'X_GL']);
});

test('createPool: a worker that ends before it is ready', async () => {
  const children = () => readFileSync(`/proc/self/task/${process.pid}/children`, 'utf8').trim();
  assert.equal(children(), '');
  const opening = errorOf(open());
  process.kill(Number(children()), 'SIGKILL');
  const error = await opening;
  assert.deepEqual([error?.code, error?.message], ['X_WORKERS', 'a worker of the pool ended before it was ready, by SIGKILL']);
});

/** A program with a pool of two that says its workers' process ids, and goes on as told. */
function program(rest) {
  const text = `import { createPool } from '${poolUrl}';
    import { MODELS } from '${fixturesUrl}';
    const pool = await createPool({ size: 2, cacheDirectory: null });
    const glb = await MODELS.cloth();
    await pool.render(glb, { size: { width: 16, height: 16 } });
    while (pool.workers.some(({ state }) => state === 'starting')) await new Promise((resolve) => setTimeout(resolve, 5));
    console.log(JSON.stringify(pool.workers.map(({ pid }) => pid)));
    ${rest}`;
  return spawn(process.execPath, ['--input-type=module', '-e', text], { stdio: ['ignore', 'pipe', 'inherit'] });
}

test('a parent that is killed leaves no worker: idle, drawing or stopped', async () => {
  const parent = program(`await pool.render(glb, ${JSON.stringify(ENDLESS)});`);
  const pids = JSON.parse((await once(parent.stdout, 'data'))[0]);
  assert.ok(pids.length === 2 && pids.every(isAlive));
  process.kill(pids[0], 'SIGSTOP');
  parent.kill('SIGKILL');
  await until(() => !pids.some(isAlive));
});

test('a program that closes nothing ends by itself, and so do its workers', async () => {
  const parent = program('');
  const pids = JSON.parse((await once(parent.stdout, 'data'))[0]);
  const [code] = await once(parent, 'exit');
  assert.equal(code, 0);
  await until(() => !pids.some(isAlive));
});

test('the parent goes before its workers, and before each of their threads', async () => {
  const pool = await open();
  await pool.render(glb, SHOT);
  const [{ pid }] = pool.workers;
  const niceOf = (thread) => Number(readFileSync(`/proc/${pid}/task/${thread}/stat`, 'utf8').split(') ')[1].split(' ')[16]);
  const namedAs = (name) => (thread) => readFileSync(`/proc/${pid}/task/${thread}/comm`, 'utf8').startsWith(name);
  const threads = readdirSync(`/proc/${pid}/task`);
  const drawing = threads.filter(namedAs('llvmpipe'));
  assert.deepEqual([...new Set([String(pid), ...drawing].map(niceOf))], [Math.min(19, os.getPriority() + 5)]);
  // Between sessions, which a worker is one of, the kernel may count these alone.
  const ofSession = (id) => niceOfSession(readFileSync(`/proc/${id}/autogroup`, 'latin1'));
  if (existsSync('/proc/self/autogroup')) await until(() => ofSession(pid) === Math.min(19, ofSession(process.pid) + 5));
  await pool.close();
});

test('a process in no session has the priority of an ordinary one', () => {
  assert.equal(niceOfSession(''), 0);
  assert.equal(niceOfSession('/autogroup-8163 nice -3\n'), -3);
});

test('signals that end a service are for the parent: a worker finishes its job', async () => {
  const pool = await open();
  const [{ pid }] = pool.workers;
  process.kill(pid, 'SIGSTOP');
  const drawn = pool.render(glb, SHOT);
  for (const signal of ['SIGTERM', 'SIGINT', 'SIGHUP']) process.kill(pid, signal);
  process.kill(pid, 'SIGCONT');
  assert.ok((await drawn).data.length > 0);
  await pool.close();
});

test('workers give their rights up, this process does not', async () => {
  const pool = await open();
  await pool.render(glb, SHOT);
  const [{ pid, isolation }] = pool.workers;
  const statusOf = (id) =>
    Object.fromEntries(
      readFileSync(`/proc/${id}/status`, 'utf8')
        .split('\n')
        .map((line) => line.split(':\t')),
    );
  if (!isolation.some(({ failure }) => failure)) {
    assert.deepEqual([statusOf(pid).NoNewPrivs, statusOf(pid).Seccomp], ['1', '2']);
    assert.match(readFileSync(`/proc/${pid}/limits`, 'utf8'), /Max core file size +0 +0/);
  }
  assert.equal(isolation.length, 11);
  assert.notEqual(statusOf(process.pid).Seccomp, '2');
  await pool.close();
});
