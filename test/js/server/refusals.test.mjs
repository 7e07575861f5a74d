import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { request as httpRequest } from 'node:http';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { gzipSync } from 'node:zlib';
import { ERRORS } from '../../../js/error/index.mjs';
import { GLB, MODELS, SHOT, at, logLines, openPool, post, postForm, problemOf, serve } from './support.mjs';

// What the service refuses, how it says so, and what neither its answers nor its log tell.

const THUMBNAILS = '/v1/thumbnails';
const SECRET = 'hunter2';

let pool, service, url, glb, folder;
const log = logLines();
before(async () => {
  [pool, glb] = await Promise.all([openPool(), MODELS.cloth()]);
  folder = mkdtempSync(path.join(tmpdir(), 'telar-server-'));
  writeFileSync(path.join(folder, 'light.hdr'), '#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\nabcdefgh');
  const resolve = () => {
    throw new Error(`cannot open ${folder} with ${SECRET}`);
  };
  service = await serve({ pool, side: 256, logLevel: 'debug', resolve }, { log });
  ({ url } = service);
});
after(async () => {
  await service.drain();
  await pool.close();
  rmSync(folder, { recursive: true });
});

const json = (body) => fetch(at(url, THUMBNAILS), { method: 'POST', body, headers: { 'content-type': 'application/json' } });

/** A form with one part, whose head is as it is written here. */
const rawForm = (head) =>
  fetch(at(url, THUMBNAILS), {
    method: 'POST',
    body: `--b\r\n${head}\r\n\r\nx\r\n--b--\r\n`,
    headers: { 'content-type': 'multipart/form-data; boundary=b' },
  });

const REFUSED = {
  'no model': [() => postForm(url, THUMBNAILS, { shot: SHOT }), 400, 'E_REQUEST', 'request.model: expected a file of the request or a reference, got none'],
  'a model twice': [
    () => postForm(url, THUMBNAILS, { model: [['a'], ['b']].map(([text]) => [Buffer.from(text)]) }),
    400,
    'E_REQUEST',
    'request.model: it is given twice',
  ],
  'a model as file and reference': [
    () => fetch(at(url, THUMBNAILS, { model: 'x' }), { method: 'POST', body: glb, headers: { 'content-type': GLB } }),
    400,
    'E_REQUEST',
    'request.model: the body is the model already',
  ],
  'an unknown key': [() => post(url, THUMBNAILS, glb, { shto: SHOT }), 400, 'E_REQUEST', 'request.shto: unknown key, did you mean shot?'],
  'an unknown file': [
    () => postForm(url, THUMBNAILS, { model: glb, texture: Buffer.from('x') }),
    400,
    'E_REQUEST',
    'request.texture: unknown file, expected one of model, environment, part',
  ],
  'a shot that is no JSON': [() => post(url, THUMBNAILS, glb, { shot: '{"size":' }), 400, 'E_REQUEST', /^request\.shot: it is not JSON \(/],
  'a shot that is no object': [() => post(url, THUMBNAILS, glb, { shot: '[1]' }), 400, 'E_REQUEST', 'request.shot: expected an object, got [1]'],
  'a spec that is nested too deep': [
    () => postForm(url, '/v1/sheets', { model: glb, spec: `{"header":${'{"a":'.repeat(50_000)}0${'}'.repeat(50_000)}}` }),
    400,
    'E_SPEC',
    'spec: expected plain data as in JSON (Maximum call stack size exceeded)',
  ],
  'a key of a shot that sheets do not take': [
    () => post(url, '/v1/sheets', glb, { shot: { ghost: [] } }),
    400,
    'E_OPTION',
    /^request\.shot\.ghost: a sheet does not take it; /,
  ],
  'a key of the prototype': [() => json('{"__proto__":{"shot":{}}}'), 400, 'E_REQUEST', /^request\.__proto__: unknown key/],
  'a threshold by the name of the prototype': [
    () => postForm(url, '/v1/compare', { expected: Buffer.from('x'), actual: Buffer.from('y'), thresholds: '{"__proto__":0}' }),
    400,
    'E_REQUEST',
    'request.thresholds.__proto__: expected another name, got 0',
  ],
  'a cloth by the name of the prototype': [
    () => post(url, THUMBNAILS, glb, { shot: '{"size":{"width":9,"height":9},"materials":{"__proto__":{"preset":"denim"}}}' }),
    400,
    'E_SHOT',
    'shot.materials.__proto__: expected another name, got {"preset"}',
  ],
  'a wrong choice': [
    () => post(url, THUMBNAILS, glb, { failOn: 'never' }),
    400,
    'E_REQUEST',
    'request.failOn: expected "error", "warning" or "none", got "never"',
  ],
  'a body that is no JSON': [() => json('{'), 400, 'E_REQUEST', /^the body is not JSON: /],
  'a value of the shot': [
    () => post(url, THUMBNAILS, glb, { shot: { ...SHOT, exposure: -1 } }),
    400,
    'E_SHOT',
    'shot.exposure: expected a number in [0, 1e30], got -1',
  ],
  'too many pixels': [
    () => post(url, THUMBNAILS, glb, { shot: { size: { width: 257, height: 1 } } }),
    413,
    'L_OUTPUT_SIZE',
    'shot.size.width: this service draws at most 256 pixels a side, got 257',
  ],
  'too many pixels where the shot names none': [
    () => post(url, THUMBNAILS, glb, { shot: {} }),
    413,
    'L_OUTPUT_SIZE',
    'shot.size.width: this service draws at most 256 pixels a side, got 512',
  ],
  'a height that is left out': [() => post(url, THUMBNAILS, glb, { shot: { size: { width: 9 } } }), 413, 'L_OUTPUT_SIZE', /^shot\.size\.height: /],
  'a size that is none': [() => post(url, THUMBNAILS, glb, { shot: { size: '9' } }), 400, 'E_SHOT', /^shot\.size: expected /],
  ...Object.fromEntries(
    ['"1e5"', '1e400', '9007199254740992', '8193', '300.5'].map((width) => [
      `a width of ${width}`,
      [
        () => post(url, THUMBNAILS, glb, { shot: `{"size":{"width":${width},"height":1}}` }),
        400,
        'E_SHOT',
        /^shot\.size\.width: expected a whole number of pixels in \[1, 8192\], got /,
      ],
    ]),
  ),
  'a form that is none': [
    () => fetch(at(url, THUMBNAILS), { method: 'POST', body: 'x', headers: { 'content-type': 'multipart/form-data' } }),
    400,
    'E_REQUEST',
    /^the form is malformed: /,
  ],
  'a form that is cut': [
    () =>
      fetch(at(url, THUMBNAILS), {
        method: 'POST',
        body: '--b\r\ncontent-disposition: form-data; name="model"; filename="m"\r\n\r\nglTF',
        headers: { 'content-type': 'multipart/form-data; boundary=b' },
      }),
    400,
    'E_REQUEST',
    /^the form is malformed: /,
  ],
  'a text of a form without a name': [() => rawForm('content-disposition: form-data'), 400, 'E_REQUEST', 'the form is malformed: a part of it has no name'],
  'a file of a form without a name': [
    () => rawForm('content-disposition: form-data; filename="m.glb"'),
    400,
    'E_REQUEST',
    'the form is malformed: a part of it has no name',
  ],
  'another type': [
    () => post(url, THUMBNAILS, 'x', {}, { 'content-type': 'text/html' }),
    415,
    'E_MEDIA_TYPE',
    'the body is "text/html"; this route takes multipart/form-data, application/json, model/gltf-binary, model/gltf+json, application/octet-stream',
  ],
  'no type': [() => fetch(at(url, THUMBNAILS), { method: 'POST', body: new Uint8Array(3) }), 415, 'E_MEDIA_TYPE', /^the body is ""; this route takes/],
  'an empty model': [() => post(url, THUMBNAILS, '', { shot: SHOT }), 422, 'E_EMPTY', undefined],
  'an archive': [() => post(url, THUMBNAILS, 'PK\x03\x04', { shot: SHOT }), 422, 'E_NOT_GLTF', undefined],
  'another route': [() => fetch(at(url, '/v1/thumbnail')), 404, 'E_NOT_FOUND', undefined],
  'an address that is none': [() => fetch(at(url, '/v1/jobs/%zz')), 400, 'E_REQUEST', /^the address is malformed: a % in it/],
  'a name that is longer than any': [
    () => fetch(at(url, `/v1/jobs/${'a'.repeat(200)}`)),
    404,
    'E_NOT_FOUND',
    'nothing has a name as long as one in the address',
  ],
  'another method': [() => fetch(at(url, '/v1/sheets')), 405, 'E_METHOD', 'this route takes POST'],
  'a question for the methods of a route': [() => fetch(at(url, THUMBNAILS), { method: 'OPTIONS' }), 405, 'E_METHOD', 'this route takes GET and POST'],
  'a body that is packed': [
    () => post(url, THUMBNAILS, gzipSync(glb), { shot: SHOT }, { 'content-encoding': 'gzip' }),
    415,
    'E_MEDIA_TYPE',
    'the body has the content-encoding "gzip"; this route takes bodies without one',
  ],
  'a form that is packed': [
    () => postForm(url, '/v1/compare', { gate: 'exact' }, { 'content-encoding': 'br, identity' }),
    415,
    'E_MEDIA_TYPE',
    /^the body has the content-encoding "br, identity"/,
  ],
  'a key in the address and in the body': [
    () => fetch(at(url, THUMBNAILS, { failOn: 'none' }), { method: 'POST', body: '{"failOn":"error"}', headers: { 'content-type': 'application/json' } }),
    400,
    'E_REQUEST',
    'request.failOn: it is given twice',
  ],
  'a picture to compare with': [
    () => postForm(url, '/v1/compare', { expected: Buffer.from('x') }),
    400,
    'E_REQUEST',
    'request.actual: expected a file of the request, got none',
  ],
  'pictures that are none': [() => postForm(url, '/v1/compare', { expected: Buffer.from('x'), actual: Buffer.from('y') }), 422, 'E_IMAGE_FORMAT', undefined],
};
for (const [name, [ask, status, code, message]] of Object.entries(REFUSED)) {
  test(`refused: ${name}`, async () => {
    const response = await ask();
    const problem = await problemOf(response);
    assert.deepEqual([problem.status, problem.code, problem.type], [status, code, `/v1/errors/${code}`], problem.message);
    assert.equal(response.headers.get('content-type'), 'application/problem+json; charset=utf-8');
    assert.equal(response.headers.get('cache-control'), 'no-store');
    if (message instanceof RegExp) assert.match(problem.detail, message);
    else if (message) assert.equal(problem.detail, message);
    assert.equal(problem.title, ERRORS[code].meaning);
    assert.equal(problem.kind, ERRORS[code].kind);
    assert.equal(response.headers.get('x-request-id'), problem.instance);
  });
}

test('a method that a route does not take is told with those that it takes', async () => {
  for (const [route, allowed] of [
    [THUMBNAILS, 'GET, POST'],
    ['/v1/jobs/1', 'GET, DELETE'],
    ['/healthz', 'GET'],
  ]) {
    for (const method of ['OPTIONS', 'TRACE', 'PUT']) {
      // fetch() sends no TRACE.
      const answer = await new Promise((resolve, reject) => httpRequest(at(url, route), { method }, resolve).on('error', reject).end());
      answer.resume();
      assert.deepEqual([answer.statusCode, answer.headers.allow], [405, allowed], `${method} ${route}`);
    }
  }
});

test('a body whose coding is none is taken', async () => {
  assert.equal((await post(url, THUMBNAILS, glb, { shot: SHOT }, { 'content-encoding': 'identity' })).status, 200);
});

test('each type of problem has a page of its own', async () => {
  const [, { type }] = [0, await (await fetch(at(url, '/nowhere'))).json()];
  assert.deepEqual(await (await fetch(at(url, type))).json(), { code: 'E_NOT_FOUND', ...ERRORS.E_NOT_FOUND });
  assert.equal((await fetch(at(url, '/v1/errors/constructor'))).status, 404);
});

test('no file of the server is opened: by no environment, by no reference, by no file that a model names', async () => {
  const file = path.join(folder, 'light.hdr');
  for (const environment of [file, { map: file }, `../../${file}`, `file://${file}`]) {
    for (const route of [THUMBNAILS, '/v1/inspect', '/v1/sheets']) {
      const problem = await problemOf(await post(url, route, glb, { shot: { environment } }));
      assert.deepEqual([problem.status, problem.code], [400, 'E_SHOT'], problem.message);
      assert.match(problem.message, /^shot\.environment: expected "studio", "none" or a file of the request, got /);
    }
  }
  const gltf = JSON.stringify({ asset: { version: '2.0' }, buffers: [{ uri: path.basename(file), byteLength: 8 }] });
  const problem = await problemOf(await post(url, THUMBNAILS, gltf, { shot: SHOT }, { 'content-type': 'model/gltf+json' }));
  assert.deepEqual([problem.status, problem.code], [422, 'E_URI_DENIED']);
});

test('what the owner throws is for the log, without its folders; the client is told where to look', async () => {
  const response = await fetch(at(url, THUMBNAILS, { model: 'shirt?token=hunter2', shot: SHOT }), {
    headers: { 'x-request-id': 'mine-1', authorization: SECRET },
  });
  const text = await response.text();
  const problem = JSON.parse(text);
  assert.deepEqual([problem.status, problem.code], [500, 'X_RESOLVE']);
  assert.equal(problem.message, `${ERRORS.X_RESOLVE.meaning}; the log of the service says more, under mine-1`);
  assert.ok(!text.includes(folder) && !text.includes(process.cwd()) && !text.includes(SECRET));
  const line = log.lines.find(({ request, msg }) => request === 'mine-1' && msg === 'failed');
  assert.equal(line.code, 'X_RESOLVE');
  assert.match(line.cause, /cannot open/);
  assert.ok(!line.message.includes(SECRET), 'nor what a reference is signed with');
});

test('an id of the caller that is none is not taken over', async () => {
  for (const id of ['a b', 'x'.repeat(65), '<script>']) {
    const response = await fetch(at(url, '/healthz'), { headers: { 'x-request-id': id } });
    assert.match(response.headers.get('x-request-id'), /^req-[0-9a-z]+$/);
  }
});

test('an address that leads nowhere is logged and counted as others are', async () => {
  const counted = async () => {
    const text = await (await fetch(at(url, '/metrics'))).text();
    return Number(/^telar_requests_total\{route="none",status="400",code="E_REQUEST"\} (\d+)$/m.exec(text)?.[1] ?? 0);
  };
  const before = await counted();
  const response = await fetch(at(url, '/v1/errors/%zz'), { headers: { 'x-request-id': 'mine-3' } });
  assert.deepEqual([response.status, response.headers.get('x-request-id'), (await response.json()).instance], [400, 'mine-3', 'mine-3']);
  assert.equal(response.headers.get('x-content-type-options'), 'nosniff');
  assert.equal(await counted(), before + 1);
  const lines = log.lines.filter(({ request }) => request === 'mine-3').map(({ msg, code, route }) => [msg, code, route]);
  assert.deepEqual(lines, [
    ['refused', 'E_REQUEST', 'none'],
    ['answered', 'E_REQUEST', 'none'],
  ]);
});

test('the log has one line an answer: no address, no header, no folder', async () => {
  await fetch(at(url, THUMBNAILS, { model: `at/${SECRET}` }), { headers: { 'x-request-id': 'mine-2', cookie: SECRET } });
  const lines = log.lines.filter(({ request, msg }) => request === 'mine-2' && msg === 'answered');
  assert.equal(lines.length, 1);
  const { time, ms, level, ...facts } = lines[0];
  assert.deepEqual(facts, { request: 'mine-2', method: 'GET', route: THUMBNAILS, status: 500, code: 'X_RESOLVE', msg: 'answered' });
  const answered = JSON.stringify(log.lines.filter(({ msg }) => msg === 'answered'));
  assert.ok(!answered.includes(SECRET) && !answered.includes(folder) && !answered.includes(process.cwd()));
});
