import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import * as api from '@opentelemetry/api';
import { listen } from '../../../js/server/index.mjs';
import { NO_SPANS, openSpans } from '../../../js/server/spans.mjs';
import { importMutant } from './mutants.mjs';
import { MODELS, SHOT, at, bytesOf, openPool, post } from './support.mjs';
import { until } from '../../until.mjs';

// Spans of OpenTelemetry: a small SDK takes them.

const THUMBNAILS = '/v1/thumbnails';
const TRACE = '0af7651916cd43dd8448eb211c80319c';
const CALLER = 'b7ad6b7169203331';
const SECRET = 'hunter2';

let spans = [];
/** What an SDK does, as far as it is looked at here. */
api.trace.setGlobalTracerProvider({
  getTracer: (name) => ({
    startSpan(title, { startTime = performance.timeOrigin + performance.now(), attributes = {}, kind }, context) {
      const parent = api.trace.getSpanContext(context);
      const own = { traceId: parent?.traceId ?? 'new', spanId: String(spans.length), traceFlags: 1 };
      const span = { by: name, title, kind, parent: parent?.spanId, traceId: own.traceId, startTime, attributes: { ...attributes }, id: own.spanId };
      spans.push(span);
      const given = {
        spanContext: () => own,
        setAttributes: (more) => Object.assign(span.attributes, more),
        setStatus: (status) => Object.assign(span, { status }),
        end: (endTime = performance.timeOrigin + performance.now()) => Object.assign(span, { endTime }),
      };
      return given;
    },
  }),
});
api.propagation.setGlobalPropagator({
  extract(context, { traceparent }) {
    const [, traceId, spanId] = traceparent?.split('-') ?? [];
    return traceId ? api.trace.setSpanContext(context, { traceId, spanId, traceFlags: 1 }) : context;
  },
  inject() {},
  fields: () => ['traceparent'],
});

let pool, glb, folder;
before(async () => {
  [pool, glb] = await Promise.all([openPool(), MODELS.cloth()]);
  folder = mkdtempSync(path.join(tmpdir(), 'telar-spans-'));
});
after(async () => {
  await pool.close();
  rmSync(folder, { recursive: true });
});

/** Spans of what is asked of a service, all of them ended. */
async function spansOf(serve, options, ask) {
  spans = [];
  const service = await serve({ port: 0, pool, ...options });
  await ask(service.url);
  await service.drain();
  await until(() => spans.every(({ endTime }) => endTime !== undefined));
  return spans.filter(({ title }) => !title.includes('readyz'));
}

/** A tree of titles. */
const tree = (all, parent) => all.filter((span) => span.parent === parent).map(({ title, id }) => [title, ...tree(all, id)]);

const CHECKS = {
  async 'a request: its parts beneath it, all beneath its caller'(serve) {
    const headers = { traceparent: `00-${TRACE}-${CALLER}-01`, authorization: SECRET };
    const all = await spansOf(serve, { store: mkdtempSync(path.join(folder, 's')) }, async (url) =>
      bytesOf(await post(url, THUMBNAILS, glb, { shot: SHOT }, headers)),
    );
    assert.deepEqual(tree(all, CALLER), [['POST /v1/thumbnails', ['telar.receive'], ['telar.store'], ['telar.wait'], ['telar.work']]]);
    const [request] = all;
    assert.deepEqual([request.by, request.kind, request.traceId, request.status], ['telar', api.SpanKind.SERVER, TRACE, undefined]);
    assert.deepEqual(request.attributes, { 'http.request.method': 'POST', 'http.route': THUMBNAILS, 'http.response.status_code': 200 });
    for (const { startTime, endTime } of all) assert.ok(request.startTime <= startTime && startTime <= endTime && endTime <= request.endTime + 1);
    assert.ok(!JSON.stringify(all).includes(SECRET));
  },
  async 'a request that fails has its code, and is a fault where it is ours'(serve) {
    const resolve = () => {
      throw new Error(SECRET);
    };
    const all = await spansOf(serve, { resolve }, async (url) => {
      await bytesOf(await post(url, THUMBNAILS, 'x', { shot: SHOT }));
      await bytesOf(await fetch(at(url, THUMBNAILS, { model: SECRET })));
    });
    const told = all
      .filter(({ parent }) => parent === undefined)
      .map(({ status, attributes }) => [status?.code, attributes['error.type'], attributes['http.response.status_code']]);
    assert.deepEqual(told, [
      [undefined, 'E_JSON', 422],
      [api.SpanStatusCode.ERROR, 'X_RESOLVE', 500],
    ]);
    assert.ok(!JSON.stringify(all).includes(SECRET));
  },
  async 'a job is a span of its own'(serve) {
    const all = await spansOf(serve, {}, async (url) => bytesOf(await post(url, THUMBNAILS, glb, { shot: SHOT }, { prefer: 'respond-async' })));
    assert.deepEqual(tree(all, undefined), [
      ['POST /v1/thumbnails', ['telar.receive']],
      ['telar.job', ['telar.wait'], ['telar.work']],
    ]);
  },
};
const FAULTS = [
  [
    ['spans.mjs', 'propagation.extract(active, headers)', 'active'],
    ['spans.mjs', '.end(clock(to))', '.end(to)'],
  ],
  [
    ['hooks.mjs', 'code, isFault: status >= 500', 'isFault: status >= 500'],
    ['hooks.mjs', 'isFault: status >= 500', 'isFault: status >= 400'],
  ],
  [['spans.mjs', "'telar.job', { attributes }, ROOT_CONTEXT)", "'telar.work', { attributes }, ROOT_CONTEXT)"]],
];
for (const [i, [name, check]] of Object.entries(CHECKS).entries()) {
  test(name, async () => {
    await check(listen);
    for (const edit of FAULTS[i]) await assert.rejects(check((await importMutant([edit])).listen), `planted: ${edit}`);
  });
}

test('where the package is not installed nothing is made', async () => {
  const missing = () => Promise.reject(Object.assign(new Error('no'), { code: 'ERR_MODULE_NOT_FOUND' }));
  assert.equal(await openSpans(missing), NO_SPANS);
  assert.notEqual(await openSpans(), NO_SPANS);
  const span = NO_SPANS.request({}, 'GET /', {});
  span.add('a', 0, 1);
  span.end({ attributes: {} });
});
