import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { ENDLESS, HOURS, MODELS, SHOT, bytesOf, openPool, post, postForm, problemOf, readiness, serve, until } from './support.mjs';

// Jobs: asked for now, fetched later.

const THUMBNAILS = '/v1/thumbnails';
const ASYNC = { prefer: 'respond-async' };

let pool, service, url, glb, drawn;
before(async () => {
  [pool, glb] = await Promise.all([openPool(), MODELS.cloth()]);
  service = await serve({ pool, jobs: 2, waiting: 2, deadlineMs: HOURS, jobMs: HOURS });
  ({ url } = service);
  drawn = (await pool.render(glb, SHOT)).data;
});
after(async () => {
  await service.drain();
  await pool.close();
});

const get = (path, options) => fetch(new URL(path, url), options);
const job = async (path) => (await get(path)).json();

/** Asks for a job; where it is. */
async function submit(shot = SHOT, headers = {}, to = url) {
  const response = await post(to, THUMBNAILS, glb, { shot }, { ...ASYNC, ...headers });
  const text = await response.text();
  assert.equal(response.status, 202, text);
  assert.equal(response.headers.get('preference-applied'), 'respond-async');
  const told = JSON.parse(text);
  assert.equal(response.headers.get('location'), told.links.self);
  assert.ok(['waiting', 'running'].includes(told.state));
  return told.links;
}

const over = (self) =>
  until(async () => {
    const told = await job(self);
    return ['done', 'failed', 'cancelled'].includes(told.state) && told;
  });

/** Events of a job until the stream ends: [name, data]. */
async function eventsOf(links, onEvent = () => {}) {
  const response = await get(links.events);
  assert.equal(response.headers.get('content-type'), 'text/event-stream; charset=utf-8');
  const events = [];
  let text = '';
  for await (const chunk of response.body.pipeThrough(new TextDecoderStream())) {
    const parts = (text + chunk).split('\n\n');
    text = parts.pop();
    for (const part of parts) {
      const [, name, data] = /^event: (.+)\ndata: (.+)$/.exec(part) ?? [];
      if (!name) continue;
      events.push([name, JSON.parse(data)]);
      onEvent(events.at(-1));
    }
  }
  return events;
}

test('the result is what the request would have got at once: bytes, type, tag', async () => {
  const links = await submit();
  const told = await over(links.self);
  assert.deepEqual([told.state, told.progress, told.kind, told.links.result], ['done', 1, 'thumbnail', `${links.self}/result`]);
  assert.ok(Date.parse(told.created) <= Date.parse(told.started) && Date.parse(told.started) <= Date.parse(told.ended));
  const response = await get(told.links.result);
  const atOnce = await post(url, THUMBNAILS, glb, { shot: SHOT });
  for (const name of ['content-type', 'etag', 'content-disposition']) assert.equal(response.headers.get(name), atOnce.headers.get(name), name);
  assert.ok((await bytesOf(response)).equals(drawn));
  const asJson = await over((await submit(SHOT, { accept: 'application/json' })).self);
  assert.ok(Buffer.from((await job(asJson.links.result)).files[0].data, 'base64').equals(drawn), 'fetched again and again, as its request accepts it');
  const sheet = await (await postForm(url, '/v1/compare', { expected: drawn, actual: drawn, gate: 'exact' }, ASYNC)).json();
  assert.equal((await job((await over(sheet.links.self)).links.result)).verdict.pass, true);
});

test('events: from what is now to the end, with progress on the way; a job that is over tells its end at once', async () => {
  const shot = { size: { width: 64, height: 64 }, quality: { preset: 'reference', samples: 64 } };
  const blocking = await submit(ENDLESS);
  await until(async () => (await job(blocking.self)).state === 'running');
  const links = await submit(shot);
  let isFree = false;
  const events = await eventsOf(links, ([name]) => {
    if (name === 'waiting' && !isFree) get(blocking.self, { method: 'DELETE' });
    isFree = true;
  });
  const names = events.map(([name]) => name);
  assert.deepEqual([...new Set(names)], ['waiting', 'running', 'done']);
  const parts = events.map(([, { progress }]) => progress);
  assert.ok(
    parts.some((part) => part > 0 && part < 1),
    String(parts),
  );
  assert.deepEqual(
    parts,
    [...parts].sort((a, b) => a - b),
  );
  const again = await eventsOf(links);
  assert.deepEqual(
    again.map(([name, { state, links: at }]) => [name, state, at.result]),
    [['done', 'done', `${links.self}/result`]],
  );
});

test('cancel: running or waiting, its worker is free again, and there is no result', async () => {
  const [running, waiting] = [await submit(ENDLESS), await submit(ENDLESS)];
  await until(async () => (await job(running.self)).state === 'running');
  const early = await problemOf(await get(`${running.self}/result`));
  assert.deepEqual([early.status, early.code, early.message], [404, 'E_NOT_FOUND', 'the job has no result yet; it is running']);
  for (const { self } of [waiting, running]) assert.equal((await (await get(self, { method: 'DELETE' })).json()).state, 'cancelled');
  for (const { self } of [waiting, running]) {
    const told = await job(self);
    assert.deepEqual([told.state, told.error.code], ['cancelled', 'X_CANCELLED']);
    const none = await problemOf(await get(`${self}/result`));
    assert.deepEqual([none.status, none.code], [499, 'X_CANCELLED']);
  }
  assert.equal((await over((await submit()).self)).state, 'done', 'the worker draws again');
  const done = await over((await submit()).self);
  assert.equal((await (await get(done.links.self, { method: 'DELETE' })).json()).state, 'done', 'what is over stays as it is');
});

test('a job that fails tells why, as its request would have been told', async () => {
  const { links } = await (await post(url, THUMBNAILS, 'PK\x03\x04', { shot: SHOT }, ASYNC)).json();
  const told = await over(links.self);
  assert.deepEqual([told.state, told.error.code, told.error.status], ['failed', 'E_NOT_GLTF', 422]);
  const result = await problemOf(await get(`${links.self}/result`));
  assert.deepEqual([result.status, result.code, result.message], [422, 'E_NOT_GLTF', told.error.message]);
});

test('what is wrong in the request itself is told at once, and makes no job', async () => {
  const before = (await readiness(url)).jobs;
  assert.equal((await problemOf(await post(url, THUMBNAILS, glb, { shto: SHOT }, ASYNC))).status, 400);
  assert.equal((await problemOf(await post(url, THUMBNAILS, glb, { shot: SHOT }, { ...ASYNC, accept: 'text/html' }))).status, 406);
  assert.deepEqual((await readiness(url)).jobs, before);
});

test('so many jobs wait, one more is refused; who waits at a connection comes first', async () => {
  const first = await submit(ENDLESS);
  await until(async () => (await job(first.self)).state === 'running');
  const waiting = [await submit(), await submit()];
  const refused = await post(url, THUMBNAILS, glb, { shot: SHOT }, ASYNC);
  assert.match(refused.headers.get('retry-after'), /^\d+$/);
  assert.deepEqual([refused.status, (await problemOf(refused)).code], [429, 'X_BUSY']);
  const order = [];
  const atOnce = post(url, THUMBNAILS, glb, { shot: { ...SHOT, exposure: 2 } }).then(({ status }) => order.push(status));
  await until(async () => (await readiness(url)).waiting === 1);
  const ends = waiting.map(({ self }) => over(self).then(({ state }) => order.push(state)));
  await get(first.self, { method: 'DELETE' });
  await Promise.all([atOnce, ...ends]);
  assert.deepEqual(order, [200, 'done', 'done']);
});

test('a job may take as long as its clock says, and its result is kept as long as its own', async () => {
  const other = await serve({ pool, jobMs: 300, resultMs: 400 });
  const at = (path) => new URL(path, other.url);
  const { self } = await submit(ENDLESS, {}, other.url);
  const told = await until(async () => {
    const { state, error } = await (await fetch(at(self))).json();
    return state === 'failed' && error;
  });
  assert.deepEqual([told.code, told.message], ['X_TIMEOUT', 'the job took longer than 300 ms']);
  await until(async () => (await fetch(at(self))).status === 404);
  await other.drain();
});

test('more results than may be kept: the oldest go first', async () => {
  const other = await serve({ pool, resultBytes: 2 * drawn.length });
  const statusOf = async ({ self }) => (await fetch(new URL(self, other.url))).status;
  const links = [];
  for (let i = 0; i < 3; ++i) {
    links.push(await submit(SHOT, {}, other.url));
    await until(async () => (await readiness(other.url)).jobs.running === 0);
  }
  assert.deepEqual(await Promise.all(links.map(statusOf)), [404, 200, 200]);
  await other.drain();
});

test('draining ends the jobs that run and wait, and tells those that listen', async () => {
  const other = await serve({ pool, drainMs: 300, jobMs: HOURS });
  const { events } = await submit(ENDLESS, {}, other.url);
  const listening = fetch(new URL(events, other.url)).then((response) => response.text());
  await until(async () => (await readiness(other.url)).jobs.running === 1);
  await other.drain();
  assert.match(await listening, /event: failed\ndata: .*"code":"X_SHUTDOWN"/);
});

test('a job that is none', async () => {
  for (const path of ['/v1/jobs/1', '/v1/jobs/1/result', '/v1/jobs/1/events', '/v1/jobs/__proto__']) {
    assert.deepEqual((({ status, code }) => [status, code])(await problemOf(await get(path))), [404, 'E_NOT_FOUND']);
  }
});
