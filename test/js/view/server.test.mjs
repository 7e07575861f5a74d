import assert from 'node:assert/strict';
import { once } from 'node:events';
import { mkdirSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { request as httpRequest } from 'node:http';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { TelarError } from '../../../js/error/index.mjs';
import { openView } from '../../../js/view/index.mjs';
import { grow } from '../../../js/view/page/remote.mjs';
import './support.mjs';
import '../built.mjs';

// The server with a stand-in for the renderer: who may ask for what, and what becomes of work that nobody waits for.

const folder = mkdtempSync(path.join(tmpdir(), 'telar-view-'));
const at = (...names) => path.join(folder, ...names);
after(() => rmSync(folder, { recursive: true }));

const SECRET = 'not for the page';
const GLTF = {
  asset: { version: '2.0' },
  buffers: [
    { uri: 'mesh.bin', byteLength: 4 },
    { uri: '../secret.txt', byteLength: 4 },
    { uri: '/etc/passwd', byteLength: 4 },
    { uri: 'data:application/octet-stream;base64,AAAA', byteLength: 3 },
    { uri: 'file:///etc/passwd', byteLength: 4 },
    { uri: '%zz', byteLength: 4 },
  ],
  images: [{ uri: 'maps/red%20wool.png' }, { uri: 'maps/../maps/link.png' }, { uri: 'maps' }, { uri: '..%2fsecret.txt' }, { bufferView: 0 }],
};

/** A renderer that draws 1 x 1 at once, or never where the shot's exposure is 0; one of 3 and 4 grows, and 4 fails then. */
function fakeRenderer() {
  const calls = { loaded: 0, released: [], rendered: [], aborted: [] };
  return {
    calls,
    backend: 'osmesa',
    gl: { renderer: 'stand-in', version: '1' },
    load: async () => ({ number: ++calls.loaded, facts: { bounds: { min: [0, 0, 0], max: [1, 1, 1] }, variants: [], cameras: [], warnings: [] } }),
    factsOf: async (model) => model.facts,
    release: async (model) => void calls.released.push(model.number),
    async render(model, shot, { signal, onPreview }) {
      calls.rendered.push(shot);
      if (shot.exposure === 0) {
        await once(signal, 'abort');
        calls.aborted.push(signal.reason.code);
        throw signal.reason;
      }
      if (shot.exposure < 0) throw new TelarError('E_SHOT', 'shot.exposure: expected a number', { pointer: '/exposure' });
      for (const samples of shot.exposure >= 3 ? [1, 2] : [])
        onPreview({ width: 1, height: 1, bitDepth: 8, samples, data: Buffer.from([10, samples, 123, 255]) });
      if (shot.exposure === 4) throw new TelarError('X_GL', 'lost');
      return { data: Buffer.from([1, 2, 3, 255]), info: { width: 1, height: 1, milliseconds: { total: 1 }, warnings: [], shot } };
    },
  };
}

let view;
let renderer;
before(async () => {
  mkdirSync(at('model/maps'), { recursive: true });
  writeFileSync(at('secret.txt'), SECRET);
  writeFileSync(at('model/other.bin'), SECRET);
  writeFileSync(at('model/mesh.bin'), 'mesh');
  writeFileSync(at('model/maps/red wool.png'), 'wool');
  symlinkSync(at('secret.txt'), at('model/maps/link.png'));
  writeFileSync(at('model/coat.gltf'), JSON.stringify(GLTF));
  writeFileSync(at('sky.hdr'), 'sky');
  renderer = fakeRenderer();
  view = await openView({ renderer, source: at('model/coat.gltf'), shot: { environment: { map: at('sky.hdr'), rotation: 5 } } });
});
after(() => view?.close());

/** A request whose path and headers no client library tidies up. */
async function get(target, headers = {}) {
  const { port, pathname } = new URL(view.url);
  const request = httpRequest({ host: '127.0.0.1', port, path: target.startsWith('/') ? target : pathname + target, headers });
  request.end();
  const [response] = await once(request, 'response');
  const chunks = [];
  for await (const chunk of response) chunks.push(chunk);
  return { status: response.statusCode, headers: response.headers, text: Buffer.concat(chunks).toString() };
}

const post = (target, body, options = {}) =>
  fetch(view.url + target, { method: 'POST', headers: { 'content-type': 'application/json' }, body: JSON.stringify(body), ...options });

test('the address is the loopback interface with a long secret', () => {
  assert.match(view.url, /^http:\/\/127\.0\.0\.1:\d+\/[\w-]{32}\/$/);
});

test('the page and its parts are there, and forbid every other server', async () => {
  for (const target of ['', 'page/page.js', 'page/style.css', 'page/compare_worker.js', 'page/draco/draco_decoder.wasm', 'page/basis/basis_transcoder.wasm']) {
    const { status, headers } = await get(target);
    assert.equal(status, 200, target);
    assert.match(headers['content-security-policy'], /^default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; /);
    assert.deepEqual(
      ['referrer-policy', 'x-content-type-options', 'cross-origin-resource-policy', 'cache-control'].map((name) => headers[name]),
      ['no-referrer', 'nosniff', 'same-origin', 'no-store'],
    );
  }
  const policy = (await get('')).headers['content-security-policy'];
  assert.doesNotMatch(policy, /https?:|\*|unsafe-inline|'unsafe-eval'/);
});

test('text is evaluated for models with KTX2 textures alone', async (t) => {
  writeFileSync(at('model/coded.gltf'), JSON.stringify({ asset: { version: '2.0' }, extensionsUsed: ['KHR_texture_basisu'] }));
  const coded = await openView({ renderer: fakeRenderer(), source: at('model/coded.gltf'), shot: {} });
  t.after(() => coded.close());
  const policy = (await fetch(coded.url)).headers.get('content-security-policy');
  assert.match(policy, /script-src 'self' 'wasm-unsafe-eval' 'unsafe-eval';/);
});

test('without the secret there is nothing', async () => {
  const wrong = 'A'.repeat(32);
  for (const target of ['/', '/session', `/${wrong}/`, `/${wrong}/session`, '/favicon.ico', `/${wrong}/model/coat.gltf`]) {
    const { status, text } = await get(target);
    assert.equal(status, 404, target);
    assert.ok(!text.includes(new URL(view.url).pathname), 'the secret is not told');
  }
});

test("another host's name is refused: DNS rebinding", async () => {
  const { port } = new URL(view.url);
  for (const host of ['evil.example', `evil.example:${port}`, '127.0.0.1', `127.0.0.1.evil.example:${port}`, `127.0.0.1:${Number(port) + 1}`, ' ']) {
    assert.equal((await get('session', { host })).status, 403, host);
  }
  assert.equal((await get('', { host: `localhost:${port}` })).status, 200);
});

test("another page's requests are refused", async () => {
  const { port } = new URL(view.url);
  for (const origin of ['http://evil.example', 'null', `https://127.0.0.1:${port}`, `http://127.0.0.1:${Number(port) + 1}`]) {
    assert.equal((await get('session', { origin })).status, 403, origin);
  }
  assert.equal((await get('', { origin: `http://127.0.0.1:${port}` })).status, 200);
});

test('the model and the files that it names beneath its folder are served, nothing else', async () => {
  assert.deepEqual(JSON.parse((await get('model/coat.gltf')).text), GLTF);
  assert.equal((await get('model/mesh.bin')).text, 'mesh');
  assert.equal((await get('model/maps/red%20wool.png')).text, 'wool');
  for (const name of [
    'other.bin',
    '../secret.txt',
    '..%2fsecret.txt',
    '%2e%2e/secret.txt',
    '%2e%2e%2fsecret.txt',
    '..%5csecret.txt',
    'maps/link.png',
    'maps',
    'maps/',
    '',
    '.',
    '/etc/passwd',
    '%2fetc%2fpasswd',
    'maps/..%2f..%2fsecret.txt',
    'mesh.bin%00.png',
    'mesh.bin/',
    '%zz',
    'coat.gltf/../../secret.txt',
  ]) {
    const { status, text } = await get(`model/${name}`);
    assert.ok([400, 404].includes(status), `${name}: ${status}`);
    assert.ok(!text.includes(SECRET) && !text.includes('root:'), name);
  }
  for (const name of ['../../../package.json', '..%2f..%2fpackage.json', '%2e%2e/%2e%2e/%2e%2e/package.json']) {
    const { status, text } = await get(`page/${name}`);
    assert.ok([400, 403, 404].includes(status), `${name}: ${status}`);
    assert.ok(!text.includes('"name"'), name);
  }
});

test('environments go by name: the page sees no path and names no file', async () => {
  const { shot, environments } = JSON.parse((await get('session')).text);
  assert.deepEqual(shot, { environment: { map: 'sky.hdr', rotation: 5 } });
  assert.deepEqual(environments, [
    { map: 'sky.hdr', format: 'hdr' },
    { map: 'studio', format: 'hdr' },
    { map: 'none', format: null },
  ]);
  assert.equal((await get('environment/sky.hdr')).text, 'sky');
  assert.equal((await get('environment/studio')).text.slice(0, 2), '#?');
  for (const name of ['none', 'other.hdr', '..%2fsky.hdr', encodeURIComponent(at('sky.hdr'))])
    assert.equal((await get(`environment/${name}`)).status, 404, name);

  const drawn = JSON.parse((await (await post('draw', { environment: { map: 'sky.hdr' } })).formData()).get('info'));
  assert.deepEqual(drawn.shot.environment, { map: 'sky.hdr' });
  assert.equal(renderer.calls.rendered.at(-1).environment.map, at('sky.hdr'));
  for (const environment of ['studio', { map: 'none' }]) {
    const other = JSON.parse((await (await post('draw', { environment })).formData()).get('info'));
    assert.deepEqual(other.shot.environment, environment, 'a named one stays what it is');
  }
  const refused = await post('draw', { environment: at('sky.hdr') });
  assert.equal(refused.status, 400);
  const { code, pointer, message } = await refused.json();
  assert.deepEqual([code, pointer], ['E_SHOT', '/environment']);
  assert.match(message, /this view has "sky\.hdr", "studio", "none"/);
});

test('a drawing in scale keeps the pixels per inch that decide its size', async () => {
  const response = await post('draw', { scale: '1:5', output: { format: 'jpeg', ppi: 300 } });
  assert.deepEqual(JSON.parse((await response.formData()).get('info')).shot, { scale: '1:5', output: { format: 'raw', ppi: 300 } });
});

test('a drawing is pixels as they are, with their facts', async () => {
  const response = await post('draw', { exposure: 2, output: { format: 'jpeg' } });
  const form = await response.formData();
  assert.deepEqual([...new Uint8Array(await form.get('pixels').arrayBuffer())], [1, 2, 3, 255]);
  assert.deepEqual(JSON.parse(form.get('info')).shot, { exposure: 2, output: { format: 'raw' } });
});

/** What the page's own module makes of the answer; `change`: of its bytes. */
async function grown(shot, change = (bytes) => bytes) {
  const { fetch } = globalThis;
  globalThis.fetch = async (name, options) => {
    const response = await fetch(new URL(name, view.url), options);
    const { status, headers } = response;
    const bytes = change(Buffer.from(await response.arrayBuffer()));
    // In chunks that end anywhere.
    const chunks = Array.from({ length: Math.ceil(bytes.length / 7) }, (_, i) => bytes.subarray(7 * i, 7 * i + 7));
    return new Response(ReadableStream.from(chunks), { status, headers });
  };
  try {
    const seen = [];
    const { image, info } = await grow(shot, new AbortController().signal, (picture, samples) => seen.push([samples, ...picture.data]));
    return { seen, data: [...image.data], info };
  } finally {
    globalThis.fetch = fetch;
  }
}

test('a picture that grows comes as it is, then finished', async () => {
  const { seen, data, info } = await grown({ exposure: 3 });
  assert.deepEqual(seen, [
    [1, 10, 1, 123, 255],
    [2, 10, 2, 123, 255],
  ]);
  assert.deepEqual([data, info.width, info.shot.exposure], [[1, 2, 3, 255], 1, 3]);
  assert.deepEqual((await grown({ exposure: 2 })).seen, [], 'one that does not grow');
  await assert.rejects(grown({ exposure: 4 }), { code: 'X_GL', message: /lost/ });
  await assert.rejects(grown({ exposure: -1 }), { code: 'E_SHOT' });
  await assert.rejects(
    grown({ exposure: 3 }, (bytes) => bytes.subarray(0, -1)),
    { code: 'X_CLOSED' },
    'planted fault: an answer that is cut off',
  );
});

test('errors come as problem+json with the codes of the table', async () => {
  const refused = await post('draw', { exposure: -1 });
  assert.equal(refused.headers.get('content-type'), 'application/problem+json; charset=utf-8');
  const { status, code, pointer } = await refused.json();
  assert.deepEqual([refused.status, status, code, pointer], [400, 400, 'E_SHOT', '/exposure']);
  for (const [body, expected] of [
    ['{', 400],
    ['3', 400],
    ['null', 400],
    ['', 400],
  ]) {
    const response = await post('draw', undefined, { body });
    assert.equal(response.status, expected, body);
    assert.match((await response.json()).code, /^E_(USAGE|SHOT)$/);
  }
});

test('what the page no longer waits for is cancelled', async () => {
  const leaving = new AbortController();
  const drawing = post('draw', { exposure: 0 }, { signal: leaving.signal });
  while (!renderer.calls.rendered.some(({ exposure }) => exposure === 0)) await new Promise(setImmediate);
  assert.deepEqual(renderer.calls.aborted, []);
  leaving.abort();
  await assert.rejects(drawing, { name: 'AbortError' });
  while (renderer.calls.aborted.length === 0) await new Promise(setImmediate);
  assert.deepEqual(renderer.calls.aborted, ['X_CANCELLED']);
  assert.equal((await post('draw', {})).status, 200, 'the next one is drawn');
});

test('a page that is opened again gets the model as the file is then', async () => {
  const before = renderer.calls.loaded;
  await get('session');
  assert.equal(renderer.calls.loaded, before + 1);
  assert.deepEqual(renderer.calls.released.at(-1), before);
});

test('pixels become a PNG; what is none is refused', async () => {
  const headers = { 'content-type': 'application/octet-stream' };
  const good = await post('png?width=2&height=1', undefined, { headers, body: new Uint8Array(8) });
  assert.deepEqual([good.status, good.headers.get('content-type')], [200, 'image/png']);
  assert.equal(Buffer.from(await good.arrayBuffer()).toString('latin1', 1, 4), 'PNG');
  const bad = await post('png?width=2&height=2', undefined, { headers, body: new Uint8Array(8) });
  assert.deepEqual([bad.status, (await bad.json()).code], [400, 'E_OPTION']);
});

test('a taken port is a typed error, and a wrong shot ends the opening', async () => {
  const source = at('model/coat.gltf');
  await assert.rejects(openView({ renderer: fakeRenderer(), source, shot: {}, port: view.port }), { code: 'X_PORT', message: /EADDRINUSE/ });
  await assert.rejects(openView({ renderer: fakeRenderer(), source, shot: { exposure: 'x' } }), { code: 'E_SHOT' });
});

test('closing ends what is being drawn', async () => {
  const own = fakeRenderer();
  const opened = await openView({ renderer: own, source: at('model/coat.gltf'), shot: {} });
  const drawing = fetch(`${opened.url}draw`, { method: 'POST', headers: { 'content-type': 'application/json' }, body: '{"exposure":0}' });
  while (own.calls.rendered.length === 0) await new Promise(setImmediate);
  await Promise.all([opened.close(), assert.rejects(drawing)]);
  assert.deepEqual(own.calls.aborted, ['X_CANCELLED']);
});
