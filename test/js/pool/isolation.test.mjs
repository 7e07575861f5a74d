import assert from 'node:assert/strict';
import { test } from 'node:test';
import { isolationSteps, loadNative } from '../../../js/api/native.mjs';
import { runChild } from '../api/support/child.mjs';
import './support.mjs';

// What a process can do before and after it gave up what a worker gives up. Before, each is possible: so each check can fail.

/** Steps that libtelar_worker.so takes before the program of a worker runs. */
const FIRST = ['no inherited descriptors', 'own network', 'no writes elsewhere'];

const nativeUrl = new URL('../../../js/api/native.mjs', import.meta.url).href;

const TRIES = `
  import { spawn } from 'node:child_process';
  import { createServer, connect } from 'node:net';
  import { createSocket } from 'node:dgram';
  import { closeSync, openSync, readFileSync } from 'node:fs';
  const told = (emitter, good) => new Promise((resolve) => emitter.on(good, () => resolve('done')).on('error', ({ code }) => resolve(code)));
  const manyFiles = () => {
    const open = [];
    try { for (let i = 0; i < 300; ++i) open.push(openSync('/dev/null')); } finally { for (const file of open) closeSync(file); }
  };
  const attempt = (use) => { try { use(); return 'done'; } catch ({ code }) { return code; } };
  const tries = async () => {
    const server = createServer();
    const datagrams = createSocket('udp4');
    const outcomes = {
      program: await told(spawn('/bin/true'), 'exit'),
      listen: await told(server.listen(0, '127.0.0.1'), 'listening'),
      connect: await told(connect(1, '127.0.0.1'), 'connect'),
      datagram: await told(datagrams.bind(0), 'listening'),
      signal: attempt(() => process.kill(process.ppid, 0)),
      'own signal': attempt(() => process.kill(process.pid, 0)),
      read: attempt(() => readFileSync('/proc/version')),
      files: attempt(manyFiles),
    };
    server.close();
    attempt(() => datagrams.close());
    return outcomes;
  };`;

test('after it: no program, no network, no other process, few files; reading goes on', async (t) => {
  const text = `${TRIES}
    import { loadNative } from '${nativeUrl}';
    const before = await tries();
    const isolation = JSON.parse(loadNative().isolate(2 ** 30)).filter(({ failure }) => failure !== undefined);
    console.log(JSON.stringify({ before, isolation, after: await tries() }));
    process.exit(0);`;
  const { stdout, stderr } = await runChild(text, { support: false });
  const { before, isolation, after } = JSON.parse(stdout || assert.fail(stderr));
  const possible = { program: 'done', listen: 'done', datagram: 'done', signal: 'done', 'own signal': 'done', read: 'done', files: 'done' };
  assert.deepEqual(before, { ...possible, connect: 'ECONNREFUSED' });
  const refused = isolation.filter(({ failure }) => failure);
  assert.ok(!refused.some(({ failure }) => failure === 'EPROTO'), 'a filter that is there denies what it is for');
  if (refused.length > 0) return t.skip(JSON.stringify(refused));
  assert.deepEqual(after, {
    program: 'EACCES',
    listen: 'EACCES',
    connect: 'EACCES',
    datagram: 'EACCES',
    signal: 'EACCES',
    'own signal': 'done',
    read: 'done',
    files: 'EMFILE',
  });
});

test('memory over the bound is refused', async (t) => {
  const { failure } = JSON.parse(await loadNative().probeIsolation(false)).find(({ step }) => step === 'bounded memory');
  if (failure) return t.skip(`bounded memory: ${failure}`);
  const reserve = (isolate) =>
    runChild(
      `import { loadNative } from '${nativeUrl}';
       ${isolate}
       try { console.log(new ArrayBuffer(1.5 * 2 ** 30).byteLength); } catch ({ name }) { console.log(name); }
       process.exit(0);`,
      { support: false },
    );
  assert.equal((await reserve('')).stdout, `${1.5 * 2 ** 30}\n`);
  assert.equal((await reserve('loadNative().isolate(2 ** 30);')).stdout, 'RangeError\n');
});

test('threads that run already are bound too', async () => {
  const text = `
    import { Worker } from 'node:worker_threads';
    import { loadNative } from '${nativeUrl}';
    const worker = new Worker(\`
      const { parentPort } = require('node:worker_threads');
      const { connect } = require('node:net');
      const go = () => connect(1, '127.0.0.1').on('error', ({ code }) => parentPort.postMessage(code));
      parentPort.on('message', go);
      go();\`, { eval: true, execArgv: [] });
    const next = () => new Promise((resolve) => worker.once('message', resolve));
    const before = await next();
    loadNative().isolate(0);
    worker.postMessage('again');
    console.log(JSON.stringify([before, await next()]));
    process.exit(0);`;
  const { stdout, stderr } = await runChild(text, { support: false });
  assert.deepEqual(JSON.parse(stdout || assert.fail(stderr)), ['ECONNREFUSED', 'EACCES']);
});

test('doctor asks a process that ends: this one keeps its rights', async () => {
  const report = JSON.parse(await loadNative().probeIsolation(true));
  assert.deepEqual(
    report.map(({ step }) => step),
    [...FIRST, 'end with the parent', 'no new privileges', 'no core dump', 'few open files', 'bounded memory', 'not traceable', 'filtered system calls'],
  );
  for (const { failure } of report) assert.ok(failure === null || (/^E[A-Z]+$/.test(failure) && failure !== 'EPROTO'), failure);
  assert.deepEqual(JSON.parse(await loadNative().probeIsolation(true)), report);
  const { stdout } = await runChild(
    `import { loadNative } from '${nativeUrl}';
     await loadNative().probeIsolation(true);
     const { spawnSync } = await import('node:child_process');
     console.log(spawnSync('/bin/true').status);`,
    { support: false },
  );
  assert.equal(stdout, '0\n');
});

test('without libtelar_worker.so its steps are told as not taken, with the reason', async () => {
  const report = isolationSteps(await loadNative().probeIsolation(false), 'planted');
  assert.deepEqual(
    report.filter(({ failure }) => failure === 'planted').map(({ step }) => step),
    [...FIRST, 'failed allocations noticed'],
  );
  assert.deepEqual(isolationSteps('[{"step":"a"},{"step":"b","failure":null},{"step":"c","failure":"EPERM"}]', null).slice(0, 3), [
    { step: 'a', failure: 'not taken' },
    { step: 'b', failure: null },
    { step: 'c', failure: 'EPERM' },
  ]);
});
