import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import Fastify from 'fastify';
import { createPool } from '../../../js/pool/index.mjs';
import { telarServer } from '../../../js/server/index.mjs';
import { openQueue } from '../../../js/queue/index.mjs';
import { startRedis } from '../queue/support.mjs';
import { until } from '../../until.mjs';
import { ENDLESS, MODELS, SHOT, bytesOf, post, problemOf } from './support.mjs';

// The plugin in a server that does other things too.

let fastify, url, glb;
before(async () => {
  glb = await MODELS.cloth();
  fastify = Fastify({ forceCloseConnections: true });
  fastify.post('/own', async ({ body }) => ({ got: body }));
  fastify.get('/broken', async () => {
    throw new Error('own');
  });
  await fastify.register(telarServer, { prefix: '/pictures', metrics: false, side: 64, pool: { size: 1, cacheDirectory: null } });
  url = await fastify.listen({ port: 0 });
});
after(() => fastify.close());

test('beneath its prefix it draws, and leads there', async () => {
  const response = await post(url, '/pictures/v1/thumbnails', glb, { shot: SHOT });
  assert.equal(response.status, 200);
  assert.equal((await bytesOf(response)).subarray(1, 4).toString(), 'PNG');
  const { code, type } = await problemOf(await post(url, '/pictures/v1/thumbnails', '', { shot: SHOT }));
  assert.deepEqual([code, type], ['E_EMPTY', '/pictures/v1/errors/E_EMPTY']);
  assert.equal((await fetch(new URL(type, url))).status, 200);
  assert.equal((await fetch(new URL('/pictures/metrics', url))).status, 404);
});

test('what the server itself has stays as it was: bodies, errors, routes that are not there', async () => {
  const headers = { 'content-type': 'application/json' };
  assert.deepEqual(await (await fetch(new URL('/own', url), { method: 'POST', body: '{"a":1}', headers })).json(), { got: { a: 1 } });
  const broken = await fetch(new URL('/broken', url));
  assert.deepEqual([broken.status, (await broken.json()).message, broken.headers.get('x-request-id')], [500, 'own', null]);
  assert.equal((await (await fetch(new URL('/none', url))).json()).message, 'Route GET:/none not found');
});

test("what a hook of the owner's server refuses is answered as that server does, before the service's own hook and after it", async (t) => {
  const pool = await createPool({ size: 1, cacheDirectory: null });
  const other = Fastify();
  t.after(async () => {
    await other.close();
    await pool.close();
  });
  const refuseAt = (hook, status) =>
    other.addHook(hook, async ({ headers }) => {
      if (headers.refuse === hook) throw Object.assign(new Error(`refused ${hook}`), { statusCode: status });
    });
  refuseAt('onRequest', 401);
  refuseAt('preHandler', 429);
  await other.register(telarServer, { pool });
  const address = await other.listen({ port: 0 });
  for (const [refuse, status] of [
    ['onRequest', 401],
    ['preHandler', 429],
  ]) {
    const answer = await fetch(new URL('/openapi.json', address), { headers: { refuse } });
    assert.deepEqual([answer.status, (await answer.json()).message], [status, `refused ${refuse}`]);
  }
  assert.equal((await fetch(new URL('/openapi.json', address))).status, 200);
});

test("a hook of the owner's server answers preflights of browsers before the service refuses the method", async (t) => {
  const pool = await createPool({ size: 1, cacheDirectory: null });
  const other = Fastify();
  t.after(async () => {
    await other.close();
    await pool.close();
  });
  other.addHook('onRequest', async ({ method, headers }, reply) => {
    if (method === 'OPTIONS' && headers['access-control-request-method']) return reply.code(204).header('access-control-allow-origin', '*').send();
    return undefined;
  });
  await other.register(telarServer, { pool });
  const address = new URL('/v1/sheets', await other.listen({ port: 0 }));
  const preflight = await fetch(address, { method: 'OPTIONS', headers: { 'access-control-request-method': 'POST' } });
  assert.deepEqual([preflight.status, preflight.headers.get('access-control-allow-origin')], [204, '*']);
  assert.equal((await fetch(address, { method: 'OPTIONS' })).status, 405);
});

test('jobs that waited in a queue before the service was there are drawn', async (t) => {
  const pool = await createPool({ size: 1, cacheDirectory: null });
  const queue = await openQueue({});
  const other = Fastify();
  t.after(async () => {
    await other.close();
    await queue.close();
    await pool.close();
  });
  const { id } = await queue.add({ kind: 'thumbnail', asked: { shot: SHOT }, files: { model: glb } });
  await other.register(telarServer, { pool, queue });
  await other.ready();
  await until(async () => ['done', 'failed'].includes((await queue.get(id)).state));
  const { state, error } = await queue.get(id);
  assert.deepEqual([state, error], ['done', undefined]);
});

test('a pool of the owner stays open when the server closes; one of the plugin ends with it', async () => {
  const pool = await createPool({ size: 1, cacheDirectory: null });
  const other = Fastify();
  await other.register(telarServer, { pool });
  await other.listen({ port: 0 });
  await other.close();
  assert.ok((await pool.render(glb, SHOT)).data.length > 100);
  await pool.close();
});

test("a pool of the plugin ends before the owner's queue: what it has not drawn waits for another process", async (t) => {
  const redis = await startRedis();
  const queue = await openQueue({ redis: redis.url });
  t.after(async () => {
    await queue.close();
    await redis.stop();
  });
  const other = Fastify();
  await other.register(telarServer, { queue, pool: { size: 1, cacheDirectory: null } });
  const address = await other.listen({ port: 0 });
  const ids = [];
  for (const exposure of [1, 2, 3]) {
    const job = await post(address, '/v1/thumbnails', glb, { shot: { ...ENDLESS, exposure } }, { prefer: 'respond-async' });
    ids.push((await job.json()).id);
  }
  await until(async () => (await queue.counts()).running === 1);
  await other.close();
  const states = await Promise.all(ids.map((id) => queue.get(id)));
  assert.deepEqual(
    states.map(({ state, error }) => [state, error?.code]),
    ids.map(() => ['waiting', undefined]),
  );
});

for (const [options, message] of [
  [{ sides: 1 }, /^options\.sides: unknown key, did you mean side\?/],
  [{ port: 1 }, /^options\.port: unknown key/],
  [{ pool: 1 }, /^options\.pool: expected a pool, or options of createPool, got 1/],
  [{ resolve: 'x' }, /^options\.resolve: expected a function, got "x"/],
  [{ environments: { sky: 'sky.hdr' } }, /^options\.environments\.sky: expected bytes of a \.hdr or \.exr file, got "sky\.hdr"/],
  [{ drawJobs: false }, /^options\.drawJobs: expected true, or a queue on Redis or in SQLite: no other process draws the jobs of this one, got false/],
  [{ deadlineMs: 0 }, /^options\.deadlineMs: expected a whole number in \[1, /],
]) {
  test(`refused: ${JSON.stringify(options)}`, async () => {
    const one = Fastify();
    one.register(telarServer, options);
    await assert.rejects(async () => one.ready(), { code: 'E_OPTION', message });
  });
}
