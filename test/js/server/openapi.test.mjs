import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import Ajv from 'ajv/dist/2020.js';
import { ERRORS } from '../../../js/error/index.mjs';
import { REQUESTS } from '../../../js/server/requests.mjs';
import { ROUTES, UNDESCRIBED } from '../../../js/server/routes.mjs';
import { MODELS, SHOT, openPool, post, postForm, serve } from './support.mjs';

// openapi.json: that it describes what the service does.

const DOCUMENT = JSON.parse(readFileSync(new URL('../../../js/server/openapi.json', import.meta.url), 'utf8'));

let pool, service, url;
before(async () => {
  pool = await openPool();
  service = await serve({ pool, metrics: false });
  ({ url } = service);
});
after(async () => {
  await service.drain();
  await pool.close();
});

const ajv = new Ajv({ strict: false, formats: { uint8array: true, 'date-time': true } });
ajv.addSchema({ $id: 'telar', ...DOCUMENT });
const validator = (pointer) => ajv.getSchema(`telar#${pointer}`) ?? ajv.compile({ $ref: `telar#${pointer}` });
const escaped = (key) => key.replaceAll('~', '~0').replaceAll('/', '~1').replaceAll('{', '%7B').replaceAll('}', '%7D');

/** Every object of the document, with its path. */
function* nodes(node, at = []) {
  if (typeof node !== 'object' || node === null) return;
  yield [at, node];
  for (const [key, value] of Object.entries(node)) yield* nodes(value, [...at, key]);
}

test('references lead somewhere, ids are their own, every response has what OpenAPI wants of it', () => {
  assert.match(DOCUMENT.openapi, /^3\.1\.\d+$/);
  const ids = [];
  for (const [at, node] of nodes(DOCUMENT)) {
    if (typeof node.$ref === 'string') {
      const target = node.$ref
        .slice(2)
        .split('/')
        .reduce((value, key) => value?.[key], DOCUMENT);
      assert.ok(target, `${at.join('/')}: ${node.$ref}`);
    }
    if (node.operationId) {
      ids.push(node.operationId);
      for (const [status, response] of Object.entries(node.responses)) assert.ok(response.$ref || response.description, `${at.join('/')} ${status}`);
    }
    if (node.in === 'path') assert.equal(node.required, true);
    if (node.in === 'query') assert.equal((node.schema === undefined) !== (node.content === undefined), true, at.join('/'));
  }
  assert.equal(new Set(ids).size, ids.length);
  assert.ok(ids.length > 8);
});

test('each route of the table is described, and each is there', async () => {
  const described = Object.entries(ROUTES).filter(([name]) => !UNDESCRIBED.includes(name));
  assert.deepEqual(
    Object.keys(DOCUMENT.paths),
    described.map(([, route]) => route.url.replaceAll(/:(\w+)/g, '{$1}')),
  );
  for (const { url: route, methods } of Object.values(ROUTES).filter(({ url: one }) => one !== '/metrics' && !one.includes(':id'))) {
    for (const method of ['GET', 'POST']) {
      const { status } = await fetch(new URL(route.replace(':code', 'E_FILE'), url), { method });
      assert.equal(status === 405, !methods.includes(method), `${method} ${route}: ${status}`);
      assert.notEqual(status, 404, route);
    }
  }
});

test('its schemas are schemas, and hold for what the service takes and gives', async () => {
  for (const name of Object.keys(DOCUMENT.components.schemas)) assert.equal(typeof validator(`/components/schemas/${name}`), 'function');
  const asked = validator(`/paths/${escaped('/v1/thumbnails')}/post/requestBody/content/${escaped('application/json')}/schema`);
  assert.ok(asked({ model: 'shirt', shot: { ...SHOT, camera: { view: 'front' } }, failOn: 'none' }), JSON.stringify(asked.errors));
  for (const wrong of [{}, { model: 1 }, { model: 'a', shto: {} }, { model: 'a', shot: { exposure: -1 } }, { model: 'a', failOn: 'never' }]) {
    assert.equal(asked(wrong), false, JSON.stringify(wrong));
  }
  const compared = validator(`/paths/${escaped('/v1/compare')}/post/requestBody/content/${escaped('multipart/form-data')}/schema`);
  assert.ok(compared({ gate: 'draft', thresholds: { 'object.flip.mean': 0.02 } }), JSON.stringify(compared.errors));
  assert.equal(compared({ gate: 'none' }), false);
  const holds = async (pointer, response) => {
    const check = validator(pointer);
    assert.ok(check(await response.json()), JSON.stringify(check.errors));
  };
  const readiness = await fetch(new URL('/readyz', url));
  await holds('/components/schemas/Readiness', readiness);
  await holds('/components/schemas/Problem', await post(url, '/v1/thumbnails', '', {}));
  await holds('/components/schemas/Problem', await postForm(url, '/v1/thumbnails', { model: Buffer.alloc(20), shot: { exposure: -1 } }));
  const result = `/paths/${escaped('/v1/thumbnails')}/post/responses/200/content/${escaped('application/json')}/schema`;
  await holds(result, await post(url, '/v1/thumbnails', await MODELS.cloth(), { shot: SHOT }, { accept: 'application/json' }));
});

test('it has every key and file of the table, and every code', () => {
  for (const { url: route, kind } of Object.values(ROUTES).filter((one) => one.kind)) {
    const { properties } = DOCUMENT.paths[route].post.requestBody.content['multipart/form-data'].schema;
    const { keys, files } = REQUESTS[kind];
    assert.deepEqual(Object.keys(properties).sort(), [...new Set([...Object.keys(keys), ...Object.keys(files)])].sort(), kind);
  }
  const told = Object.values(DOCUMENT.components.responses).flatMap(({ description }) => description.split(', '));
  const errors = Object.keys(ERRORS).filter((code) => !code.startsWith('W_'));
  assert.deepEqual(told.sort(), errors.sort());
});

test('the service gives it with where its routes begin, and without those that are off', async () => {
  const { servers, paths } = await (await fetch(new URL('/openapi.json', url))).json();
  assert.deepEqual(servers, [{ url: '/' }]);
  const { '/metrics': _, ...others } = DOCUMENT.paths;
  assert.deepEqual(paths, others);
});
