import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { mkdtempSync, rmSync } from 'node:fs';
import net from 'node:net';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { openQueue } from '../../../js/queue/index.mjs';
import { until } from '../../until.mjs';

/** A folder of its own, and what removes it. */
export function temporaryFolder(name) {
  const folder = mkdtempSync(path.join(tmpdir(), `telar-${name}-`));
  return { folder, remove: () => rmSync(folder, { recursive: true, force: true }) };
}

export async function freePort() {
  const server = net.createServer().listen(0, '127.0.0.1');
  await once(server, 'listening');
  const { port } = server.address();
  server.close();
  await once(server, 'close');
  return port;
}

/** The program of the server: another one than Redis, which speaks as Redis does, such as valkey-server. */
const SERVER = process.env.TELAR_REDIS_SERVER || 'redis-server';

/**
 * A Redis server on a free port, with a folder of its own.
 * @param {string[]} [settings] as on its command line
 */
export async function startRedis(settings = []) {
  const { folder, remove } = temporaryFolder('redis');
  const port = await freePort();
  const argv = ['--port', String(port), '--bind', '127.0.0.1', '--dir', folder, '--save', '', '--appendonly', 'yes', '--daemonize', 'no', ...settings];
  let child;
  const start = async () => {
    child = spawn(SERVER, argv, { stdio: ['ignore', 'pipe', 'inherit'] });
    let said = '';
    child.stdout.on('data', (text) => {
      said += text;
    });
    const ended = once(child, 'exit').then(() => {
      throw new Error(`${SERVER} does not start:\n${said}`);
    });
    ended.catch(() => {});
    await Promise.race([until(() => said.includes('Ready to accept connections')), ended]);
  };
  const end = async (signal = 'SIGTERM') => {
    if (child.exitCode !== null || child.signalCode !== null) return;
    child.kill(signal);
    await once(child, 'exit');
  };
  await start();
  return {
    url: `redis://127.0.0.1:${port}`,
    start,
    /** It keeps its connections and answers nothing. */
    freeze: () => child.kill('SIGSTOP'),
    thaw: () => child.kill('SIGCONT'),
    kill: () => end('SIGKILL'),
    async stop() {
      await end();
      remove();
    },
  };
}

/** Something to draw, for a work of a test. */
export const taskOf = (name, asked = {}) => ({ kind: 'thumbnail', asked: { name, ...asked }, files: { model: Buffer.from(`model ${name}`) } });

/** What a work of a test gives. */
export const resultOf = (text) => ({
  key: `key of ${text}`,
  info: { text },
  files: [{ name: 'a.txt', type: 'text/plain', data: Buffer.from(`result ${text}`) }],
});

/** The text of a result. */
export const textOf = async (queue, id) => (await queue.result(id))?.result.files[0].data.toString();

export const over = (queue, id) =>
  until(async () => {
    const state = await queue.get(id);
    return ['done', 'failed', 'cancelled'].includes(state?.state) && state;
  });

/** A promise and what settles it. */
export function deferred() {
  let settle;
  const promise = new Promise((resolve) => {
    settle = resolve;
  });
  return { promise, settle };
}

/** The three queues: places(t) gives the options that open the same one again and again. */
export const QUEUES = {
  'in memory': { isShared: false, place: async () => ({}) },
  SQLite: {
    isShared: true,
    async place(t) {
      const { folder, remove } = temporaryFolder('queue');
      t.after(remove);
      return { sqlite: path.join(folder, 'jobs.db') };
    },
  },
};

let count = 0;
/** On one server, each test has a queue of its own. */
export const onRedis = (server) => ({ isShared: true, place: async () => ({ redis: server.url, name: `test-${count++}` }) });

/** How long a worker that says nothing keeps its job: short, for tests that end one. Sanitizers need longer. */
export const LEASE_MS = Number(process.env.TELAR_LEASE_MS ?? 1000);
const BOUNDS = { leaseMs: LEASE_MS, backoffMs: 20 };

/** A queue that is closed after the test. */
export async function open(t, options) {
  const queue = await openQueue({ ...BOUNDS, ...options });
  t.after(() => queue.close());
  return queue;
}

const WORKER = fileURLToPath(new URL('worker_process.mjs', import.meta.url));

/**
 * A process that works for a queue: what it does is told by what is asked (worker_process.mjs).
 * @returns lines: what it said so far
 */
export async function startProcess(t, options, { log } = {}) {
  const child = spawn(process.execPath, [WORKER, JSON.stringify({ ...BOUNDS, ...options }), log ?? ''], {
    stdio: ['ignore', 'pipe', 'inherit'],
  });
  t.after(() => child.kill('SIGKILL'));
  const lines = [];
  child.stdout.on('data', (text) => lines.push(...String(text).trim().split('\n')));
  const ended = once(child, 'exit').then(([code, signal]) => ({ code, signal }));
  await Promise.race([until(() => lines.includes('ready')), ended]);
  return { child, lines, ended };
}
