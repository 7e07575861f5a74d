import assert from 'node:assert/strict';
import { once } from 'node:events';
import { after, before, test } from 'node:test';
import { setTimeout as sleep } from 'node:timers/promises';
import { ENDLESS, GLB, HOURS, MODELS, SHOT, bytesOf, connect, head, openPool, post, postForm, problemOf, readiness, serve } from './support.mjs';
import { until } from '../../until.mjs';
import { importMutant } from './mutants.mjs';

// What clients may take of the service: time, bytes, connections, places. By real sockets: most of these are no requests that fetch would send.

const THUMBNAILS = '/v1/thumbnails';

let pool, glb;
before(async () => {
  [pool, glb] = await Promise.all([openPool(), MODELS.cloth()]);
});
after(() => pool.close());

/** A service for one test, on the pool of all. */
async function withService(options, use) {
  const service = await serve({ pool, ...options });
  try {
    return await use(service);
  } finally {
    await service.drain();
  }
}

const statusOf = (said) => Number(/^HTTP\/1\.1 (\d+)/.exec(said)?.[1]);
const codeOf = (said) => JSON.parse(said.slice(said.indexOf('\r\n\r\n') + 4)).code;

test('headers that come slowly end in 408, however alive the sender is', () =>
  withService({ headersMs: 300 }, async (service) => {
    const { socket, said } = await connect(service);
    socket.write(`POST ${THUMBNAILS} HTTP/1.1\r\nhost: here\r\n`);
    const dripping = setInterval(() => socket.write('x-drip: 1\r\n'), 50);
    const answer = await said;
    clearInterval(dripping);
    assert.deepEqual([statusOf(answer), codeOf(answer)], [408, 'X_UPLOAD_TIME']);
    assert.match(answer, /content-type: application\/problem\+json/);
  }));

for (const [way, headers, chunk] of [
  ['with its length', { 'content-length': 1_000_000 }, 'x'],
  ['in chunks', { 'transfer-encoding': 'chunked' }, '1\r\nx\r\n'],
]) {
  test(`a body ${way} that comes slowly ends in 408, however alive the sender is`, () =>
    withService({ uploadMs: 300 }, async (service) => {
      const { socket, said } = await connect(service);
      socket.write(head(THUMBNAILS, { 'content-type': GLB, ...headers }));
      const dripping = setInterval(() => socket.write(chunk), 50);
      const answer = await said;
      clearInterval(dripping);
      assert.deepEqual([statusOf(answer), codeOf(answer)], [408, 'X_UPLOAD_TIME']);
    }));
}

test('a form that comes slowly too', () =>
  withService({ uploadMs: 300 }, async (service) => {
    const { socket, said } = await connect(service);
    socket.write(head(THUMBNAILS, { 'content-type': 'multipart/form-data; boundary=b', 'content-length': 1_000_000 }));
    socket.write('--b\r\ncontent-disposition: form-data; name="model"; filename="m"\r\n\r\nglTF');
    const answer = await said;
    assert.deepEqual([statusOf(answer), codeOf(answer)], [408, 'X_UPLOAD_TIME']);
  }));

test('a body that says it is too large is refused before it is sent', () =>
  withService({ requestBytes: 1000 }, async (service) => {
    const { socket, said } = await connect(service);
    socket.write(head(THUMBNAILS, { 'content-type': GLB, 'content-length': 2 ** 40 }));
    const answer = await said;
    assert.deepEqual([statusOf(answer), codeOf(answer)], [413, 'L_FILE_BYTES']);
  }));

test('a body that does not say it is cut at its bound, and its sender reads the answer', () =>
  withService({ requestBytes: 1000 }, async (service) => {
    const { socket, said } = await connect(service);
    socket.write(head(THUMBNAILS, { 'content-type': GLB, 'transfer-encoding': 'chunked' }));
    let sent = 0;
    const flood = setInterval(() => {
      sent += 65_536;
      socket.write(`10000\r\n${'x'.repeat(65_536)}\r\n`);
    }, 5);
    const answer = await said;
    clearInterval(flood);
    assert.deepEqual([statusOf(answer), codeOf(answer)], [413, 'L_FILE_BYTES']);
    assert.ok(sent < 2 ** 28);
  }));

test('a file, a field and the whole of a form are bounded', () =>
  withService({ requestBytes: 3_000_000, pool: { size: 1, cacheDirectory: null, limits: { L_FILE_BYTES: 1000 } } }, async ({ url }) => {
    const ask = async (fields) => {
      const { status, code, limit } = await problemOf(await postForm(url, THUMBNAILS, fields));
      return [status, code, limit?.max];
    };
    assert.deepEqual(await ask({ model: Buffer.alloc(1001) }), [413, 'L_FILE_BYTES', 1000]);
    assert.deepEqual(await ask({ model: Buffer.alloc(10), shot: ' '.repeat(2 ** 20 + 1) }), [413, 'L_REQUEST_BYTES', 2 ** 20]);
    assert.deepEqual(await ask({ model: Buffer.alloc(3_000_000) }), [413, 'L_REQUEST_BYTES', 3_000_000]);
  }));

test('so many bodies at once, and one more is refused at once with retry-after', () =>
  withService({ uploads: 2, uploadMs: HOURS }, async (service) => {
    const slow = await Promise.all([1, 2].map(() => connect(service)));
    for (const { socket } of slow) socket.write(head(THUMBNAILS, { 'content-type': GLB, 'content-length': 100 }));
    const metrics = async () => (await fetch(new URL('/metrics', service.url))).text();
    await until(async () => /^telar_uploads 2$/m.test(await metrics()));
    const refused = await post(service.url, THUMBNAILS, glb, { shot: SHOT });
    assert.match(refused.headers.get('retry-after'), /^\d+$/);
    assert.deepEqual([refused.status, (await problemOf(refused)).code], [429, 'X_BUSY']);
    slow[0].socket.destroy();
    await until(async () => /^telar_uploads 1$/m.test(await metrics()));
    assert.equal((await post(service.url, THUMBNAILS, glb, { shot: SHOT })).status, 200);
    slow[1].socket.destroy();
  }));

for (const [way, headers, body] of [
  ['that say how many they have', { 'content-length': 3000 }, ''],
  ['that do not', { 'transfer-encoding': 'chunked' }, `bb8\r\n${'x'.repeat(3000)}\r\n`],
]) {
  test(`bodies ${way}: so many bytes of all together, and more is refused with retry-after`, () =>
    withService({ uploadBytes: 5000, uploadMs: HOURS }, async (service) => {
      const held = async () => /^telar_held_bytes (\d+)$/m.exec(await (await fetch(new URL('/metrics', service.url))).text())[1];
      const slow = await connect(service);
      slow.socket.write(head(THUMBNAILS, { 'content-type': GLB, ...headers }) + body);
      await until(async () => (await held()) === '3000');
      const { socket, said } = await connect(service);
      socket.write(head(THUMBNAILS, { 'content-type': GLB, ...headers }) + body);
      const refused = await said;
      assert.deepEqual([statusOf(refused), codeOf(refused)], [429, 'X_BUSY']);
      assert.match(refused, /retry-after: \d+\r\n/);
      slow.socket.destroy();
      await until(async () => (await held()) === '0');
      assert.equal((await post(service.url, THUMBNAILS, glb, { shot: SHOT })).status, 200);
    }));
}

test('a side that the model makes of a scale is bounded too, asked for at once and as a job', () =>
  withService({ side: 100 }, async ({ url }) => {
    const shotOf = (ppi) => ({ scale: '1:10', output: { ppi } });
    const { status, code, limit, pointer, message } = await problemOf(await post(url, THUMBNAILS, glb, { shot: shotOf(600) }));
    assert.deepEqual([status, code, limit.max, pointer], [413, 'L_OUTPUT_SIZE', 100, '/size/width'], message);
    assert.ok(limit.actual > 100);
    const small = await post(url, THUMBNAILS, glb, { shot: shotOf(10) });
    const { data, info } = await pool.render(glb, shotOf(10));
    assert.deepEqual([small.status, small.headers.get('etag')], [200, `"${info.key}"`]);
    assert.ok((await bytesOf(small)).equals(data));
    const { links } = await (await post(url, THUMBNAILS, glb, { shot: shotOf(600) }, { prefer: 'respond-async' })).json();
    const over = await until(async () => {
      const told = await (await fetch(new URL(links.self, url))).json();
      return told.state === 'failed' && told;
    });
    assert.equal(over.error.code, 'L_OUTPUT_SIZE');
    assert.equal((await problemOf(await post(url, THUMBNAILS, glb, { shot: { scale: 7 } }))).code, 'E_SHOT');
  }));

const GET_HEALTH = 'GET /healthz HTTP/1.1\r\nhost: here\r\n';

/** By a connection of its own. */
async function healthOf(service) {
  const { socket, said } = await connect(service);
  socket.write(`${GET_HEALTH}connection: close\r\n\r\n`);
  return statusOf(await said);
}

test('so many connections at once', () =>
  withService({ connections: 2 }, async (service) => {
    const held = [await connect(service), await connect(service)];
    const { said } = await connect(service);
    assert.equal(await said, '', 'closed without a word');
    for (const { socket } of held) socket.destroy();
    await until(async () => (await healthOf(service)) === 200);
  }));

const IDLE_CONNECTIONS = { connections: 2 };

/** What two connections that wait for nothing were told, and what a fourth is after a third found no place. */
async function besideIdle(service) {
  const idle = [await connect(service), await connect(service)];
  for (const { socket } of idle) socket.write(`${GET_HEALTH}\r\n`);
  const [kept] = await Promise.all(idle.map(async ({ socket }) => String((await once(socket, 'data'))[0])));
  await healthOf(service);
  return { kept, status: await healthOf(service) };
}

/** Seconds after which load balancers let an idle connection go. */
const BALANCER_S = 60;

test('an idle connection is kept for longer than a load balancer keeps it, but keeps nobody out', () =>
  withService(IDLE_CONNECTIONS, async (service) => {
    const { kept, status } = await besideIdle(service);
    assert.ok(Number(/^keep-alive: timeout=(\d+)\r$/im.exec(kept)[1]) > BALANCER_S, kept);
    assert.equal(status, 200);
  }));

test('planted: idle connections that keep others out', async () => {
  const { listen } = await importMutant([['listen.mjs', 'fastify.server.closeIdleConnections()', '{}']]);
  const service = await listen({ port: 0, pool, ...IDLE_CONNECTIONS });
  assert.notEqual((await besideIdle(service)).status, 200);
  await service.drain();
});

test('as many jobs as workers run, so many wait, one more is refused before its body is read; who goes away makes room', () =>
  withService({ waiting: 1, deadlineMs: HOURS }, async (service) => {
    const clients = [1, 2].map(() => new AbortController());
    const endless = ({ signal }) => fetch(...endlessOf(service, signal)).catch(({ name }) => name);
    const answers = [endless(clients[0])];
    await until(async () => (await readiness(service.url)).running === 1);
    answers.push(endless(clients[1]));
    await until(async () => (await readiness(service.url)).waiting === 1);
    const { socket, said } = await connect(service);
    socket.write(head(THUMBNAILS, { 'content-type': GLB, 'content-length': 1000 }));
    const refused = await said;
    assert.deepEqual([statusOf(refused), codeOf(refused)], [429, 'X_BUSY']);
    assert.match(refused, /retry-after: \d+\r\n/);
    assert.deepEqual(await readiness(service.url).then(({ running, waiting }) => [running, waiting]), [1, 1]);
    clients[1].abort();
    await until(async () => (await readiness(service.url)).waiting === 0);
    const last = post(service.url, THUMBNAILS, glb, { shot: SHOT });
    await until(async () => (await readiness(service.url)).waiting === 1);
    clients[0].abort();
    assert.equal((await last).status, 200, 'the worker draws again');
    assert.deepEqual(await Promise.all(answers), ['AbortError', 'AbortError']);
    const log = await (await fetch(new URL('/metrics', service.url))).text();
    assert.match(log, /^telar_requests_total\{route="\/v1\/thumbnails",status="499",code="X_CANCELLED"\} 2$/m);
  }));

const endlessOf = ({ url }, signal) => [
  new URL(`${THUMBNAILS}?shot=${encodeURIComponent(JSON.stringify(ENDLESS))}`, url),
  { method: 'POST', body: glb, signal, headers: { 'content-type': GLB } },
];

test('an answer that takes longer than its deadline is a 504, running or waiting; prefer: wait shortens it', () =>
  withService({ deadlineMs: 300, jobMs: HOURS }, async (service) => {
    const { url } = service;
    const ask = async (headers) => {
      const { status, code, retryable, message } = await problemOf(await post(url, THUMBNAILS, glb, { shot: ENDLESS }, headers));
      return [status, code, retryable, message];
    };
    const late = (ms) => [504, 'X_TIMEOUT', true, `the answer took longer than the ${ms} ms that it may take, waiting included`];
    assert.deepEqual(await ask(), late(300));
    // The one place is taken by a job, which has no such deadline.
    const { links } = await (await post(url, THUMBNAILS, glb, { shot: ENDLESS }, { prefer: 'respond-async' })).json();
    await until(async () => (await readiness(url)).running === 1);
    assert.deepEqual(await ask(), late(300));
    assert.deepEqual((await readiness(url)).jobs.running, 1);
    await fetch(new URL(links.self, url), { method: 'DELETE' });
    await withService({ deadlineMs: HOURS }, async (patient) => {
      const answer = await post(patient.url, THUMBNAILS, glb, { shot: ENDLESS }, { prefer: 'wait=1' });
      assert.equal((await problemOf(answer)).message, late(1000)[3]);
    });
  }));

test('a job that was cancelled while the queue fetched its bytes is not drawn', async () => {
  let work;
  const queue = { warnings: [], take: (given) => (work = given), counts: () => ({}), abort: () => {}, idle: async () => {}, close: async () => {} };
  await withService({ queue, jobMs: 3000 }, async () => {
    const reason = new Error('cancelled');
    const task = { kind: 'thumbnail', asked: { shot: ENDLESS }, files: { model: glb } };
    await assert.rejects(work(task, { signal: AbortSignal.abort(reason), onStart: assert.fail }), reason);
  });
});

/** The pool, whose first worker ends in the middle of its job. */
function endingOnce() {
  let isFirst = true;
  const render = (model, shot, options) => {
    if (!isFirst) return pool.render(model, shot, options);
    isFirst = false;
    const onProgress = () => process.kill(pool.workers.find(({ state }) => state === 'busy').pid, 'SIGKILL');
    return pool.render(model, ENDLESS, { ...options, onProgress });
  };
  return Object.defineProperty({ render, close: async () => {} }, 'workers', { get: () => pool.workers });
}

test('a worker that ends in the middle costs no answer: another one draws it', () =>
  withService({ pool: endingOnce(), deadlineMs: HOURS }, async ({ url }) => {
    const answer = await post(url, THUMBNAILS, glb, { shot: SHOT });
    assert.equal(answer.status, 200);
    assert.ok((await bytesOf(answer)).equals((await pool.render(glb, SHOT)).data));
    assert.match(await (await fetch(new URL('/metrics', url))).text(), /^telar_retries_total 1$/m);
  }));

test('what is no HTTP gets a 400, and a connection that says nothing costs nothing', () =>
  withService({}, async (service) => {
    const { socket, said } = await connect(service);
    socket.write('\x16\x03\x01 what is this\r\n\r\n');
    const answer = await said;
    assert.deepEqual([statusOf(answer), codeOf(answer)], [400, 'E_REQUEST']);
    const long = await connect(service);
    long.socket.write(`GET /healthz?${'x'.repeat(100_000)} HTTP/1.1\r\n\r\n`);
    assert.deepEqual([statusOf(await long.said), codeOf(await long.said)], [400, 'E_REQUEST']);
    await sleep(0);
  }));
