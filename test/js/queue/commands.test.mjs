import '../api/support/real.mjs';
import assert from 'node:assert/strict';
import { readdirSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { before, test } from 'node:test';
import { ENDLESS, MODELS, SHOT, bytesOf, openPool, post } from '../server/support.mjs';
import { startRedis, temporaryFolder } from './support.mjs';
import { startTelar } from '../../telar_process.mjs';
import { until } from '../../until.mjs';

// `telar serve` and `telar worker`, in processes of their own.

const THUMBNAILS = '/v1/thumbnails';

let glb, drawn;
before(async () => {
  glb = await MODELS.cloth();
  const pool = await openPool();
  drawn = (await pool.render(glb, SHOT)).data;
  await pool.close();
});

const SERVE = ['serve', '--port', '0', '--workers', '1', '--log-level', 'silent', '--no-draw-jobs'];
/** Of no queue but the one that is tested. */
const start = (argv, says, env) => startTelar(argv, { says, env: { REDIS_URL: '', ...env } });
const serve = (argv, env) => start([...SERVE, ...argv], /http:\S+\n/, env);
const work = (argv, env) => start(['worker', '--workers', '1', ...argv], /1 worker draws the jobs of the queue\n/, env);

const job = async (url, self) => (await fetch(new URL(self, url))).json();

async function submit(url) {
  const response = await post(url, THUMBNAILS, glb, { shot: SHOT }, { prefer: 'respond-async' });
  return (await response.json()).links;
}

async function checkPlace(t, argv, env) {
  const { folder: store, remove } = temporaryFolder('store');
  t.after(remove);
  const [api, worker] = await Promise.all([serve(argv, env), work([...argv, '--store', store], env)]);
  const url = api.found?.trim();
  assert.ok(url && worker.found, api.said.err + worker.said.err);
  const { self } = await submit(url);
  const done = await until(async () => {
    const told = await job(url, self);
    return told.links.result && told;
  });
  assert.ok((await bytesOf(await fetch(new URL(done.links.result, url)))).equals(drawn));
  api.child.kill('SIGTERM');
  assert.deepEqual(await api.ended, { code: 0, signal: null }, api.said.err);
  const next = await serve(argv, env);
  const nextUrl = next.found.trim();
  assert.equal((await job(nextUrl, self)).state, 'done', 'the next one has the job');
  assert.match(await (await fetch(new URL('/metrics', nextUrl))).text(), /^telar_queue\{state="kept"\} 1$/m);
  for (const { child } of [worker, next]) child.kill('SIGTERM');
  for (const { ended, said } of [worker, next]) assert.deepEqual(await ended, { code: 0, signal: null }, said.err);
  assert.equal(readdirSync(store).length, 1, 'what it drew is in the store');
}

test('SQLite: the API adds, the worker draws, and both end well', async (t) => {
  const { folder, remove } = temporaryFolder('commands');
  t.after(remove);
  await checkPlace(t, ['--sqlite', path.join(folder, 'jobs.db')]);
});

test('a worker ends a picture that takes longer than its --timeout-ms', async (t) => {
  const { folder, remove } = temporaryFolder('commands');
  t.after(remove);
  const argv = ['--sqlite', path.join(folder, 'jobs.db')];
  const [api, worker] = await Promise.all([serve(argv), work([...argv, '--timeout-ms', '700', '--job-ms', '15000'])]);
  const url = api.found.trim();
  const response = await post(url, THUMBNAILS, glb, { shot: ENDLESS }, { prefer: 'respond-async' });
  const { self } = (await response.json()).links;
  const { error } = await until(async () => {
    const told = await job(url, self);
    return told.state === 'failed' && told;
  });
  assert.equal(error.code, 'X_TIMEOUT');
  assert.match(error.message, /\b700 ms/);
  for (const { child, ended } of [worker, api]) {
    child.kill('SIGTERM');
    await ended;
  }
});

test('REDIS_URL: the same', async (t) => {
  const server = await startRedis();
  t.after(() => server.stop());
  await checkPlace(t, [], { REDIS_URL: server.url });
});

test('what is wrong with a queue is told with the exit code of its error', async () => {
  for (const [argv, code, message] of [
    [['worker'], 2, /expected --redis URL, --sqlite FILE or REDIS_URL/],
    [['worker', '--sqlite', path.join(tmpdir(), 'telar-none.db'), '--cgroup', '/dev/null'], 2, /options\.cgroup: expected a cgroup/],
    [['worker', '--redis', 'http://here'], 2, /options\.redis: expected an address/],
    [['worker', '--sqlite', '/nowhere/at/all.db'], 6, /X_QUEUE/],
    [['worker', '--sqlite', path.join(tmpdir(), 'telar-none.db'), '--store', '/dev/null/store'], 2, /options\.store: the folder cannot be made/],
    [['serve', '--port', '0', '--redis', 'redis://127.0.0.1:1'], 6, /X_QUEUE/],
  ]) {
    const { ended, said } = await start(argv);
    assert.deepEqual([(await ended).code, message.test(said.err)], [code, true], said.err);
  }
});
