import '../api/support/real.mjs';
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { MODELS, SHOT, bytesOf, openPool, post } from '../server/support.mjs';
import { startRedis, temporaryFolder, until } from './support.mjs';

// `telar serve` and `telar worker`, in processes of their own.

const BIN = fileURLToPath(new URL('../../../js/cli/telar.mjs', import.meta.url));
const THUMBNAILS = '/v1/thumbnails';

let glb, drawn;
before(async () => {
  glb = await MODELS.cloth();
  const pool = await openPool();
  drawn = (await pool.render(glb, SHOT)).data;
  await pool.close();
});

const left = [];
after(() => left.forEach((child) => child.kill('SIGKILL')));

/** Runs a command until it says what is looked for, or to its end. */
async function run(argv, says, env = {}) {
  const child = spawn(BIN, argv, { stdio: ['ignore', 'pipe', 'pipe'], env: { ...process.env, REDIS_URL: '', ...env } });
  left.push(child);
  const said = { out: '', err: '' };
  child.stdout.on('data', (text) => {
    said.out += text;
  });
  child.stderr.on('data', (text) => {
    said.err += text;
  });
  const ended = once(child, 'exit').then(([code, signal]) => ({ code, signal }));
  const found = await until(() => says.exec(said.out) ?? (child.exitCode !== null && []));
  return { child, said, ended, found: found[0] };
}

const SERVE = ['serve', '--port', '0', '--workers', '1', '--log-level', 'silent', '--no-draw-jobs'];
const serve = (argv, env) => run([...SERVE, ...argv], /http:\S+\n/, env);
const work = (argv, env) => run(['worker', '--workers', '1', ...argv], /1 worker draws the jobs of the queue\n/, env);

const job = async (url, self) => (await fetch(new URL(self, url))).json();

async function submit(url) {
  const response = await post(url, THUMBNAILS, glb, { shot: SHOT }, { prefer: 'respond-async' });
  return (await response.json()).links;
}

async function checkPlace(argv, env) {
  const [api, worker] = await Promise.all([serve(argv, env), work(argv, env)]);
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
}

test('SQLite: the API adds, the worker draws, and both end well', async (t) => {
  const { folder, remove } = temporaryFolder('commands');
  t.after(remove);
  await checkPlace(['--sqlite', path.join(folder, 'jobs.db')]);
});

test('REDIS_URL: the same', async (t) => {
  const server = await startRedis();
  t.after(() => server.stop());
  await checkPlace([], { REDIS_URL: server.url });
});

test('what is wrong with a queue is told with the exit code of its error', async () => {
  for (const [argv, code, message] of [
    [['worker'], 2, /expected --redis URL, --sqlite FILE or REDIS_URL/],
    [['worker', '--redis', 'http://here'], 2, /options\.redis: expected an address/],
    [['worker', '--sqlite', '/nowhere/at/all.db'], 6, /X_QUEUE/],
    [['serve', '--port', '0', '--redis', 'redis://127.0.0.1:1'], 6, /X_QUEUE/],
  ]) {
    const { ended, said } = await run(argv, /never/);
    assert.deepEqual([(await ended).code, message.test(said.err)], [code, true], said.err);
  }
});
