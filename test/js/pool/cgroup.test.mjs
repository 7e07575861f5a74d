import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmdirSync, writeFileSync } from 'node:fs';
import { rmdir } from 'node:fs/promises';
import path from 'node:path';
import { before, test } from 'node:test';
import { awake } from '../../../js/pool/awake.mjs';
import { Cgroup } from '../../../js/pool/cgroup.mjs';
import { createPool } from '../../../js/pool/index.mjs';
import { poolOptions } from '../../../js/pool/options.mjs';
import { WorkerProcess } from '../../../js/pool/worker_process.mjs';
import { until } from '../../until.mjs';
import { MODELS } from '../../fixtures/index.mjs';
import { errorOf, open, SHOT } from './support.mjs';

// Needs a kernel with the memory controller, of v2 or v1, and a user who may make groups: root is one.

const MIB = 2 ** 20;

let glb;
before(async () => {
  glb = await MODELS.cloth();
});

/** Folders in which this process may be allowed to make a group: root of v2, and its own of v1's memory controller. */
function candidates() {
  const mounts = readFileSync('/proc/self/mountinfo', 'latin1')
    .split('\n')
    .map((line) => line.split(' '));
  const own = /^\d+:memory:(.*)$/m.exec(readFileSync('/proc/self/cgroup', 'latin1'))?.[1];
  const of = (type, option) =>
    mounts.filter((fields) => fields[fields.indexOf('-') + 1] === type && (!option || fields.at(-1).split(',').includes(option))).map((fields) => fields[4]);
  return [...(own === undefined ? [] : of('cgroup', 'memory').map((mount) => path.join(mount, own))), ...of('cgroup2')];
}

/** A new group that is delegated to this process; undefined where none can be made. */
function delegated() {
  for (const folder of candidates()) {
    try {
      const made = mkdtempSync(path.join(folder, 'test-of-telar-'));
      const controllers = path.join(made, 'cgroup.controllers');
      if (!existsSync(controllers) || /\bmemory\b/.test(readFileSync(controllers, 'latin1'))) return made;
      rmdirSync(made);
    } catch {
      // The next one.
    }
  }
}

const groupsIn = (folder) =>
  readdirSync(folder, { withFileTypes: true })
    .filter((entry) => entry.isDirectory())
    .map(({ name }) => name);

/** Runs a test with a group, and takes it away. */
const withGroup = (work) => async (t) => {
  const folder = delegated();
  if (folder === undefined) return t.skip('no cgroup with the memory controller in which others can be made');
  try {
    await work(folder);
    assert.deepEqual(groupsIn(folder), [], 'no group is left');
  } finally {
    // What failed is told, not that a worker still lives.
    for (const group of [...groupsIn(folder).map((name) => path.join(folder, name)), folder]) await rmdir(group).catch(() => {});
  }
};

/** The first of these files that a group has: of v2, of v1. */
const fileOf = (group, ...names) => names.map((name) => path.join(group, name)).find(existsSync);

/** A process that takes so much memory when it is told to, and ends. */
function hungry(bytes) {
  const text = `process.stdin.once('data', () => { Buffer.alloc(${bytes}, 1); process.exit(0); }); console.log('here');`;
  return spawn(process.execPath, ['-e', text], { stdio: ['pipe', 'pipe', 'ignore'] });
}

for (const [bytes, ends] of [
  [512 * MIB, 'is ended, and its bytes are told'],
  [32 * MIB, 'ends by itself'],
])
  test(`a process of ${bytes / MIB} MiB in a group of 256 MiB ${ends}`, (t) =>
    withGroup(async (folder) => {
      const group = new Cgroup(folder).make(256 * MIB);
      const child = hungry(bytes);
      await once(child.stdout, 'data');
      await group.enter(child.pid);
      child.stdin.write('go');
      const [, signal] = await once(child, 'close');
      const told = group.end();
      if (bytes > 256 * MIB) {
        assert.equal(signal, 'SIGKILL');
        assert.ok(told > 200 * MIB && told <= 256 * MIB, `${told} bytes`);
      } else assert.deepEqual([signal, told], [null, undefined]);
    })(t));

test('each worker has a group of its own, which goes with it', (t) =>
  withGroup(async (folder) => {
    const pool = await open({ size: 2, cgroup: folder });
    const pids = await until(() => {
      const all = pool.workers;
      return all.every(({ state }) => state === 'idle') && all.map(({ pid }) => pid);
    });
    const processesOf = (name) => readFileSync(path.join(folder, name, 'cgroup.procs'), 'latin1').trim();
    const byNumber = (a, b) => a - b;
    assert.deepEqual(groupsIn(folder).map(processesOf).map(Number).sort(byNumber), pids.sort(byNumber));
    await pool.close();
  })(t));

test('a worker that the kernel ends for its memory: X_MEMORY with its bytes, and the next draws', (t) =>
  withGroup(async (folder) => {
    const pool = await open({ cgroup: folder });
    await pool.render(glb, SHOT);
    // memoryBytes of the pool, at which resident memory is looked, is far.
    const group = path.join(folder, groupsIn(folder)[0]);
    const now = Number(readFileSync(fileOf(group, 'memory.current', 'memory.usage_in_bytes'), 'latin1'));
    writeFileSync(fileOf(group, 'memory.max', 'memory.limit_in_bytes'), String(now + 16 * MIB));
    const error = await errorOf(pool.render(glb, { size: { width: 2048, height: 2048 } }));
    assert.deepEqual([error?.code, error?.limit?.name, error?.limit?.max], ['X_MEMORY', 'memoryBytes', 2048 * MIB]);
    assert.match(error.message, /^the kernel ended the worker at \d+ MiB of memory/);
    assert.ok(error.limit.actual > now / 2 && error.limit.actual <= now + 16 * MIB, `${error.limit.actual} bytes, ${now} before`);
    assert.ok((await pool.render(glb, SHOT)).data.length > 0);
    await pool.close();
  })(t));

test('a bound below what a worker starts with: no pool, and it is said why', (t) =>
  withGroup(async (folder) => {
    const error = await errorOf(open({ cgroup: folder, memoryBytes: 16 * MIB }));
    assert.equal(error?.code, 'X_WORKERS');
    assert.match(error.message, /ended before it was ready, by SIGKILL of the kernel at 16 MiB, the bound of its cgroup$/);
  })(t));

const NO_GROUP = {
  'none can be made': [
    {
      make: () => {
        throw Object.assign(new Error(), { code: 'EAGAIN' });
      },
    },
    /cannot be made \(EAGAIN\)$/,
  ],
  'it cannot enter': [{ make: () => ({ enter: () => Promise.reject(Object.assign(new Error(), { code: 'EPERM' })), end() {} }) }, /\(EPERM in its cgroup\)$/],
};
for (const [name, [cgroup, said]] of Object.entries(NO_GROUP))
  test(`a worker does not start without its group: ${name}`, async () => {
    const worker = new WorkerProcess({ ...poolOptions({ cacheDirectory: null, size: 1 }, []), cgroup });
    const error = await errorOf(worker.ready);
    assert.equal(error?.code, 'X_WORKERS');
    assert.match(error.message, said);
    await awake(worker.ended);
  });

test('groups of processes that ended are removed, of one of the same number too; those of others stay', (t) =>
  withGroup(async (folder) => {
    const child = spawn(process.execPath, ['-e', '']);
    await once(child, 'exit');
    const mine = new Cgroup(folder).make(64 * MIB);
    const left = [`telar-${child.pid}-1-a`, `telar-${process.pid}-1-b`];
    for (const name of [...left, `telar-${process.ppid}-1-c`, 'telar-d']) mkdirSync(path.join(folder, name));
    new Cgroup(folder);
    assert.deepEqual(groupsIn(folder).sort(), [path.basename(mine.path), `telar-${process.ppid}-1-c`, 'telar-d'].sort());
    for (const name of groupsIn(folder)) rmdirSync(path.join(folder, name));
  })(t));

test('a bound of a group above is not that of the worker', (t) =>
  withGroup(async (folder) => {
    const above = new Cgroup(folder).make(128 * MIB);
    const group = new Cgroup(above.path).make(512 * MIB);
    const child = hungry(300 * MIB);
    await once(child.stdout, 'data');
    await group.enter(child.pid);
    child.stdin.write('go');
    assert.equal((await once(child, 'close'))[1], 'SIGKILL');
    assert.equal(group.end(), undefined);
    above.end();
  })(t));

for (const [given, said] of [
  ['/proc/self/telar', /^options\.cgroup: expected a cgroup .*, got "\/proc\/self\/telar" \(ENOENT\)$/],
  ['/tmp', /^options\.cgroup: expected a cgroup .*, got "\/tmp" \(ENOENT\)$/],
  ['telar', /^options\.cgroup: expected the path of a cgroup, from \/, or null, got "telar"$/],
  [7, /^options\.cgroup: expected the path of a cgroup, from \/, or null, got 7$/],
])
  test(`no cgroup: ${given}`, async () => {
    const error = await errorOf(createPool({ cgroup: given }));
    assert.equal(error?.code, 'E_OPTION');
    assert.match(error.message, said);
  });
