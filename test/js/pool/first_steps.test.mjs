import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { chmodSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, readlinkSync, rmSync, writeFileSync } from 'node:fs';
import net from 'node:net';
import { release, tmpdir } from 'node:os';
import path from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { loadNative } from '../../../js/api/native.mjs';
import { workerEnvironment } from '../../../js/pool/environment.mjs';
import { open, SHOT } from './support.mjs';
import { MODELS } from '../../fixtures/index.mjs';

// What a worker gives up before its program runs (addon/first_steps.h): descriptors that a program in between left open, the network, and files of others.

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
const FOLDER = mkdtempSync(path.join(tmpdir(), 'telar-first-'));
after(() => rmSync(FOLDER, { recursive: true }));

/** Steps that this kernel refuses. */
const refused = JSON.parse(await loadNative().probeIsolation(true)).flatMap(({ step, failure }) => (failure ? [`${step}: ${failure}`] : []));
const skipWithout = (step) => refused.find((text) => text.startsWith(step)) ?? false;

/** Standard output of a program, as JSON. */
async function told(command, argv, options) {
  const child = spawn(command, argv, { stdio: ['ignore', 'pipe', 'pipe'], ...options });
  const text = async (stream) => Buffer.concat(await stream.toArray()).toString();
  const [stdout, stderr] = await Promise.all([text(child.stdout), text(child.stderr), once(child, 'close')]);
  return JSON.parse(stdout || assert.fail(stderr));
}

/** What module text tells that runs where a worker's program would, or without what makes it one. */
const inWorker = (text, { env = workerEnvironment(1), ...options } = {}) =>
  told(process.execPath, ['--input-type=module', '-e', `const tell = (value) => console.log(JSON.stringify(value));\n${text}`], {
    env,
    stdio: ['ignore', 'pipe', 'pipe', 'pipe'],
    ...options,
  });

// A descriptor that is left open across exec: bash opens it so, Node does not.
const HOST = `
  const { createPool } = await import('${path.join(ROOT, 'js/pool/index.mjs')}');
  const { readdirSync, readlinkSync } = await import('node:fs');
  const pool = await createPool({ size: 1, cacheDirectory: null });
  const [{ pid }] = pool.workers;
  const filesOf = (who) => readdirSync('/proc/' + who + '/fd').flatMap((fd) => { try { return [readlinkSync('/proc/' + who + '/fd/' + fd)]; } catch { return []; } });
  console.log(JSON.stringify({ own: filesOf('self'), worker: filesOf(pid) }));
  await pool.close();`;

test('a worker has no descriptor of its parent but its pipe', { skip: skipWithout('no inherited descriptors') }, async () => {
  const file = path.join(FOLDER, 'secret');
  const argv = ['-c', `exec 100>"$0"; exec "$@"`, file, process.execPath, '--input-type=module', '-e', HOST];
  const { own, worker } = await told('bash', argv);
  assert.ok(own.includes(file), 'the parent has it');
  assert.ok(!worker.includes(file), worker.join());
});

const NETWORK = `
  import net from 'node:net';
  import { readlinkSync } from 'node:fs';
  const reach = (path) => new Promise((resolve) => net.connect(path).on('connect', () => resolve('reached')).on('error', ({ code }) => resolve(code)));
  tell({ network: readlinkSync('/proc/self/ns/net'), abstract: await reach(NAME), isTold: process.env.TELAR_IS_WORKER });
  process.exit(0);`;

test('a worker is in a network of its own, without the abstract sockets of this one', { skip: skipWithout('own network') }, async (t) => {
  // A name that begins with 0 is no file: whoever is in the network has it.
  const name = `\0telar-first-${process.pid}`;
  const server = net.createServer((socket) => socket.destroy()).listen({ path: name });
  await once(server, 'listening');
  t.after(() => server.close());
  const text = NETWORK.replace('NAME', JSON.stringify(name));
  const here = readlinkSync('/proc/self/ns/net');
  const { TELAR_IS_WORKER, ...env } = workerEnvironment(1);
  assert.deepEqual(await inWorker(text, { env }), { network: here, abstract: 'reached' }, 'planted: who is no worker');
  const { network, ...facts } = await inWorker(text);
  assert.notEqual(network, here);
  assert.deepEqual(facts, { abstract: 'ECONNREFUSED' });
});

const WRITES = `
  import fs from 'node:fs';
  import { Worker } from 'node:worker_threads';
  const attempt = (use) => { try { use(); return 'done'; } catch ({ code }) { return code; } };
  const at = (folder) => ({
    make: attempt(() => fs.writeFileSync(folder + '/new', '')),
    write: attempt(() => fs.writeFileSync(folder + '/there', '1')),
    truncate: attempt(() => fs.truncateSync(folder + '/there')),
    rename: attempt(() => fs.renameSync(folder + '/there', folder + '/moved')),
    folder: attempt(() => fs.mkdirSync(folder + '/folder')),
    link: attempt(() => fs.symlinkSync(folder, folder + '/link')),
    remove: attempt(() => fs.rmSync(folder + '/gone')),
    read: attempt(() => fs.readdirSync(folder)),
  });
  const text = 'const { parentPort } = require("node:worker_threads"); try { require("node:fs").writeFileSync(' + JSON.stringify(ELSEWHERE + '/thread') + ', ""); parentPort.postMessage("done"); } catch ({ code }) { parentPort.postMessage(code); }';
  const thread = await new Promise((resolve) => new Worker(text, { eval: true, execArgv: [] }).once('message', resolve));
  tell({ elsewhere: at(ELSEWHERE), cache: at(CACHE), device: attempt(() => fs.writeFileSync('/dev/null', '')), thread, isTold: process.env.TELAR_WORKER_FOLDERS });
  process.exit(0);`;

/** From Linux 6.2 on a file that is there is not emptied by its path either. */
const [MAJOR, MINOR] = release().split('.').map(Number);
const EMPTIES = MAJOR < 6 || (MAJOR === 6 && MINOR < 2);

test('a worker writes in its cache and nowhere else, in no thread', { skip: skipWithout('no writes elsewhere') }, async () => {
  const text = (elsewhere, cache) => WRITES.replaceAll('ELSEWHERE', JSON.stringify(elsewhere)).replaceAll('CACHE', JSON.stringify(cache));
  /** A folder with files to change. */
  const made = (name) => {
    const folder = path.join(FOLDER, name);
    mkdirSync(folder);
    for (const file of ['there', 'gone']) writeFileSync(path.join(folder, file), file);
    return folder;
  };
  const [elsewhere, cache] = [made('of others'), made('cache: of workers')];
  const all = (outcome) => Object.fromEntries(['make', 'write', 'truncate', 'rename', 'folder', 'link', 'remove', 'read'].map((name) => [name, outcome]));
  const facts = { cache: all('done'), device: 'done' };
  const env = workerEnvironment(1, { cacheDirectory: cache });
  const denied = { ...all('EACCES'), ...(EMPTIES && { truncate: 'done' }), read: 'done' };
  assert.deepEqual(await inWorker(text(elsewhere, cache), { env }), { elsewhere: denied, thread: 'EACCES', ...facts });
  assert.deepEqual(readdirSync(elsewhere), ['gone', 'there']);
  assert.equal(readFileSync(path.join(elsewhere, 'there'), 'utf8'), EMPTIES ? '' : 'there');
  const { TELAR_IS_WORKER, TELAR_WORKER_FOLDERS, ...outside } = env;
  const free = await inWorker(text(made('of others too'), made('another cache')), { env: outside });
  assert.deepEqual(free, { elsewhere: all('done'), thread: 'done', ...facts }, 'planted: who is no worker');
});

const USER = 12_345;
const OF_USER = `
  import { readFileSync, readlinkSync, writeFileSync } from 'node:fs';
  writeFileSync(${JSON.stringify(path.join(FOLDER, 'written'))}, '');
  const status = readFileSync('/proc/self/status', 'latin1');
  tell({ user: process.getuid(), group: process.getgid(), rights: /^CapEff:\\s*(\\w+)/m.exec(status)[1], network: readlinkSync('/proc/self/ns/net') });`;

/** Why a user without rights cannot be tried. */
function skipOfUser() {
  if (process.getuid() !== 0) return 'not root';
  const { status } = spawnSync('unshare', ['--user', '--net', 'true'], { uid: USER, gid: USER, cwd: '/' });
  return status === 0 ? false : 'this kernel gives users no namespaces';
}

test('a worker of a user without rights too: it has its number, its files, and no right', { skip: skipOfUser() }, async () => {
  chmodSync(FOLDER, 0o777);
  const { network, ...facts } = await inWorker(OF_USER, { env: workerEnvironment(1, { cacheDirectory: FOLDER }), uid: USER, gid: USER, cwd: '/' });
  assert.notEqual(network, readlinkSync('/proc/self/ns/net'));
  assert.deepEqual(facts, { user: USER, group: USER, rights: '0'.repeat(16) });
});

test('a pool tells it of its workers, and draws', async (t) => {
  const pool = await open();
  t.after(() => pool.close());
  await pool.render(await MODELS.cloth(), SHOT);
  const [{ pid, isolation }] = pool.workers;
  assert.deepEqual(
    isolation.flatMap(({ step, failure }) => (failure ? [`${step}: ${failure}`] : [])),
    refused,
  );
  if (!skipWithout('own network')) assert.notEqual(readlinkSync(`/proc/${pid}/ns/net`), readlinkSync('/proc/self/ns/net'));
});
