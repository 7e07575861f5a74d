import assert from 'node:assert/strict';
import { readImage } from '../../../js/compare/index.mjs';
import { ENDLESS, HOURS, SHOT, bytesOf, post, postForm, problemOf, readiness } from './support.mjs';
import { until } from '../../until.mjs';

// What jobs promise: asked for now, fetched later. jobs.test.mjs checks it of the service, job_faults.test.mjs of services with planted faults.

const THUMBNAILS = '/v1/thumbnails';
const ASYNC = { prefer: 'respond-async' };
const OVER = ['done', 'failed', 'cancelled'];

/** Of the service that all checks but those with a `serve` of their own use. */
export const JOB_OPTIONS = Object.freeze({ jobs: 2, waiting: 2, deadlineMs: HOURS, jobMs: HOURS });

/** A pool that says in which order it was asked, by the exposure of the shots, and whose pictures can be ended. */
export function recording(pool, ending = new AbortController().signal) {
  const order = [];
  const render = (model, shot, { signal, ...options }) => {
    order.push(shot.exposure ?? 1);
    return pool.render(model, shot, { ...options, signal: AbortSignal.any([signal, ending]) });
  };
  const own = { render, order, compare: (...args) => pool.compare(...args), inspect: (...args) => pool.inspect(...args), close: async () => {} };
  return Object.defineProperty(own, 'workers', { get: () => pool.workers });
}

/** A shot like no other: the same bytes and shot are the same job. */
let exposure = 10;
const another = (shot = SHOT) => {
  exposure += 0.01;
  return { ...shot, exposure };
};

/** A client of the service at an address. */
function clientOf(url, glb) {
  const get = (path, options) => fetch(new URL(path, url), options);
  const job = async (path) => (await get(path)).json();
  return {
    get,
    job,
    cancel: async (path) => (await get(path, { method: 'DELETE' })).json(),
    post: (body, asked, headers, signal) => post(url, THUMBNAILS, body, asked, headers, signal),

    /** Asks for a job; where it is. */
    async submit(shot = SHOT, headers = {}) {
      const response = await post(url, THUMBNAILS, glb, { shot }, { ...ASYNC, ...headers });
      const text = await response.text();
      assert.equal(response.status, 202, text);
      assert.equal(response.headers.get('preference-applied'), 'respond-async');
      const told = JSON.parse(text);
      assert.equal(response.headers.get('location'), told.links.self);
      assert.ok(['waiting', 'running'].includes(told.state));
      return told.links;
    },

    /** What is told of a job that is over, or not there. */
    over: (self) =>
      until(async () => {
        const told = await job(self);
        return (told.code || OVER.includes(told.state)) && told;
      }),

    runs: (self) => until(async () => (await job(self)).state === 'running'),

    /** Events of a job until the stream ends: [name, data]. */
    async eventsOf(links, onEvent = () => {}) {
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
    },
  };
}

/**
 * Checks by what they say.
 * @typedef {object} About
 * @property {string} url of a service with JOB_OPTIONS
 * @property {object} pool of recording()
 * @property {(options: object) => Promise<object>} serve another one
 * @property {Buffer} glb a model
 * @property {Buffer} drawn its picture by SHOT
 * @type {Record<string, (about: About) => Promise<void>>}
 */
export const JOB_CHECKS = {
  async 'the result is what the request would have got at once: bytes, type, tag'({ url, glb, drawn }) {
    const { submit, over, get, job, post: ask } = clientOf(url, glb);
    const links = await submit();
    const told = await over(links.self);
    assert.deepEqual([told.state, told.progress, told.kind, told.links.result], ['done', 1, 'thumbnail', `${links.self}/result`]);
    assert.ok(Date.parse(told.created) <= Date.parse(told.started) && Date.parse(told.started) <= Date.parse(told.ended));
    const response = await get(told.links.result);
    const atOnce = await ask(glb, { shot: SHOT });
    for (const name of ['content-type', 'etag', 'content-disposition']) assert.equal(response.headers.get(name), atOnce.headers.get(name), name);
    assert.ok((await bytesOf(response)).equals(drawn));
    const tag = response.headers.get('etag');
    const had = await fetch(response.url, { headers: { 'if-none-match': `"other", ${tag}` } });
    assert.deepEqual([had.status, had.headers.get('etag'), (await bytesOf(had)).length], [304, tag, 0]);
    assert.equal((await fetch(response.url, { headers: { 'if-none-match': '"other"' } })).status, 200);
    const asJson = await over((await submit(SHOT, { accept: 'application/json' })).self);
    assert.ok(Buffer.from((await job(asJson.links.result)).files[0].data, 'base64').equals(drawn), 'fetched again and again, as its request accepts it');
    const compared = await (await postForm(url, '/v1/compare', { expected: drawn, actual: drawn, gate: 'exact' }, ASYNC)).json();
    assert.equal((await job((await over(compared.links.self)).links.result)).verdict.pass, true);
  },

  async 'events: from what is now to the end, with progress on the way; a job that is over tells its end at once'({ url, glb }) {
    const { submit, runs, cancel, eventsOf } = clientOf(url, glb);
    const blocking = await submit(another(ENDLESS));
    await runs(blocking.self);
    const links = await submit({ size: { width: 64, height: 64 }, quality: { preset: 'reference', samples: 32, threads: 1 } });
    let isFree = false;
    const events = await eventsOf(links, () => {
      if (!isFree) cancel(blocking.self);
      isFree = true;
    });
    const changes = events.filter(([name]) => name !== 'preview');
    assert.deepEqual([...new Set(changes.map(([name]) => name))], ['waiting', 'running', 'done']);
    const parts = changes.map(([, { progress }]) => progress);
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
  },

  async 'events: pictures so far, until the job is over'({ url, glb }) {
    const { submit, cancel, eventsOf } = clientOf(url, glb);
    const links = await submit(ENDLESS);
    const events = await eventsOf(links, ([name, { samples }]) => {
      if (name === 'preview' && samples >= 4) cancel(links.self);
    });
    assert.equal(events.at(-1)[0], 'cancelled');
    const previews = events.filter(([name]) => name === 'preview').map(([, preview]) => preview);
    for (const { id, width, height, data } of previews) {
      assert.deepEqual([id, width, height], [links.self.split('/').at(-1), ENDLESS.size.width, ENDLESS.size.height]);
      const picture = await readImage(Buffer.from(data, 'base64'));
      assert.deepEqual([picture.width, picture.height], [128, 128]);
      assert.ok(picture.data.some((value, i) => i % 4 === 3 && value === 255) && picture.data.some((value, i) => i % 4 === 3 && value === 0), 'a garment');
    }
    const samples = previews.map(({ samples: count }) => count);
    assert.deepEqual(
      samples,
      [...new Set(samples)].sort((a, b) => a - b),
    );
  },

  async 'cancel: running or waiting, its worker is free again, and there is no result'({ url, glb }) {
    const { submit, runs, get, job, cancel, over } = clientOf(url, glb);
    const [running, waiting] = [await submit(another(ENDLESS)), await submit(another(ENDLESS))];
    await runs(running.self);
    const early = await problemOf(await get(`${running.self}/result`));
    assert.deepEqual([early.status, early.code, early.message], [404, 'E_NOT_FOUND', 'the job has no result yet; it is running']);
    for (const { self } of [waiting, running]) assert.equal((await cancel(self)).state, 'cancelled');
    for (const { self } of [waiting, running]) {
      const told = await job(self);
      assert.deepEqual([told.state, told.error.code], ['cancelled', 'X_CANCELLED']);
      const none = await problemOf(await get(`${self}/result`));
      assert.deepEqual([none.status, none.code], [499, 'X_CANCELLED']);
    }
    const done = await over((await submit(another())).self);
    assert.equal(done.state, 'done', 'the worker draws again');
    assert.equal((await cancel(done.links.self)).state, 'done', 'what is over stays as it is');
  },

  async 'a job that fails tells why, as its request would have been told'({ url, glb }) {
    const { post: ask, over, get } = clientOf(url, glb);
    const { links } = await (await ask('PK\x03\x04', { shot: SHOT }, ASYNC)).json();
    const told = await over(links.self);
    assert.deepEqual([told.state, told.error.code, told.error.status], ['failed', 'E_NOT_GLTF', 422]);
    const result = await problemOf(await get(`${links.self}/result`));
    assert.deepEqual([result.status, result.code, result.message], [422, 'E_NOT_GLTF', told.error.message]);
  },

  async 'what is wrong in the request itself is told at once, and makes no job'({ url, glb }) {
    const { post: ask } = clientOf(url, glb);
    const before = (await readiness(url)).jobs;
    assert.equal((await problemOf(await ask(glb, { shto: SHOT }, ASYNC))).status, 400);
    assert.equal((await problemOf(await ask(glb, { shot: SHOT }, { ...ASYNC, accept: 'text/html' }))).status, 406);
    assert.deepEqual((await readiness(url)).jobs, before);
  },

  async 'so many jobs wait, one more is refused; who waits at a connection comes first'({ url, glb, pool }) {
    const { submit, over, post: ask } = clientOf(url, glb);
    const leaving = new AbortController();
    const holding = ask(glb, { shot: ENDLESS }, {}, leaving.signal).catch(({ name }) => name);
    await until(async () => (await readiness(url)).running === 1);
    const jobs = [];
    for (const exposure of [3, 4, 5]) jobs.push(await submit({ ...SHOT, exposure }));
    const refused = await ask(glb, { shot: another() }, ASYNC);
    assert.match(refused.headers.get('retry-after') ?? '', /^\d+$/);
    assert.deepEqual([refused.status, (await problemOf(refused)).code], [429, 'X_BUSY']);
    const atOnce = ask(glb, { shot: { ...SHOT, exposure: 2 } });
    await until(async () => (await readiness(url)).waiting === 1);
    leaving.abort();
    assert.deepEqual([await holding, (await atOnce).status], ['AbortError', 200]);
    for (const { self } of jobs) assert.equal((await over(self)).state, 'done');
    assert.deepEqual(pool.order.slice(-4), [2, 3, 4, 5]);
  },

  async 'a job may take as long as its clock says, and its result is kept as long as its own'({ serve, glb }) {
    const own = await serve({ jobMs: 300, resultMs: 1500 });
    const { submit, over, get } = clientOf(own.url, glb);
    const { self } = await submit(ENDLESS);
    const { state, error } = await over(self);
    assert.deepEqual([state, error?.code, error?.message], ['failed', 'X_TIMEOUT', 'the job took longer than 300 ms']);
    await until(async () => (await get(self)).status === 404);
  },

  async 'more results than may be kept: the oldest go first'({ serve, glb, drawn }) {
    const own = await serve({ resultBytes: Math.round(2.5 * drawn.length) });
    const { submit, get } = clientOf(own.url, glb);
    const links = [];
    for (let i = 0; i < 3; ++i) {
      links.push(await submit({ ...SHOT, exposure: 1 + 0.001 * i }));
      await until(async () => (await readiness(own.url)).jobs.running === 0);
    }
    const statuses = await Promise.all(links.map(async ({ self }) => (await get(self)).status));
    assert.deepEqual(statuses, [404, 200, 200]);
  },

  async 'draining ends the jobs that run and wait, and tells those that listen'({ serve, glb }) {
    const own = await serve({ drainMs: 300, jobMs: HOURS });
    const { submit, get } = clientOf(own.url, glb);
    const [running, waiting] = [await submit(another(ENDLESS)), await submit(another(ENDLESS))];
    const listening = await Promise.all([running, waiting].map(({ events }) => get(events)));
    await until(async () => (await readiness(own.url)).jobs.running === 1);
    await own.drain();
    for (const response of listening) assert.match(await response.text(), /event: failed\ndata: .*"code":"X_SHUTDOWN"/);
  },

  async 'asked for again it is the same job, drawn once; for another tenant, or as another type, it is another'({ serve, glb, pool }) {
    const own = await serve({ tenantHeader: 'x-tenant' });
    const { submit, over, post: ask } = clientOf(own.url, glb);
    const shot = another();
    const { self } = await submit(shot);
    assert.equal((await over(self)).state, 'done');
    const drawn = pool.order.length;
    const again = await ask(glb, { shot }, { ...ASYNC, priority: 'u=0' });
    const told = await again.json();
    assert.deepEqual([again.status, told.state, told.links.self, told.links.result], [202, 'done', self, `${self}/result`]);
    assert.equal(pool.order.length, drawn);
    const others = [await submit(shot, { 'x-tenant': 'one' }), await submit(shot, { accept: 'image/webp' })];
    assert.equal(new Set([self, ...others.map((links) => links.self)]).size, 3);
  },

  async 'a job that is none'({ url, glb }) {
    const { get } = clientOf(url, glb);
    for (const path of ['/v1/jobs/1', '/v1/jobs/1/result', '/v1/jobs/1/events', '/v1/jobs/__proto__']) {
      assert.deepEqual((({ status, code }) => [status, code])(await problemOf(await get(path))), [404, 'E_NOT_FOUND']);
    }
  },
};
