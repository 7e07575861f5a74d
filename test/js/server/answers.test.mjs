import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { pictureKey } from '../../../js/index.mjs';
import { FORMATS } from '../../../js/shot/table/output.mjs';
import { editedGlb } from '../../fixtures/edited_glb.mjs';
import { gradient } from '../../fixtures/environment.mjs';
import { BROKEN_MODELS } from '../../fixtures/index.mjs';
import { MODELS, SHOT, at, bytesOf, openPool, post, postForm, problemOf, serve } from './support.mjs';

// What the service answers is what its pool gives, in every way that a request may be written, and every type that it may be answered in.

/** Larger than what Fastify itself would take as a body. */
const TSHIRT = readFileSync(new URL('../../../js/assets/tshirt.glb', import.meta.url));
const SKY = gradient(16);
const THUMBNAILS = '/v1/thumbnails';

let pool, service, url, glb, drawn;
before(async () => {
  [pool, glb] = await Promise.all([openPool(), MODELS.cloth()]);
  service = await serve({ pool, resolve: (name) => (name === 'cloth' ? glb : null), environments: { sky: SKY } });
  ({ url } = service);
  drawn = (await pool.render(glb, SHOT)).data;
});
after(async () => {
  await service.drain();
  await pool.close();
});

/** The bytes of an answer that went well. */
async function good(answering) {
  const response = await answering;
  const bytes = await bytesOf(response);
  assert.equal(response.status, 200, bytes.toString());
  return bytes;
}

const asJson = (body) => [body, { method: 'POST', body: JSON.stringify(body), headers: { 'content-type': 'application/json' } }][1];

const WAYS = {
  'a model as the body, the shot in the address': () => post(url, THUMBNAILS, glb, { shot: SHOT }),
  'a body whose length is not said': () => {
    const stream = new Blob([glb]).stream();
    return fetch(at(url, THUMBNAILS, { shot: SHOT }), {
      method: 'POST',
      body: stream,
      duplex: 'half',
      headers: { 'content-type': 'application/octet-stream' },
    });
  },
  'a form': () => postForm(url, THUMBNAILS, { model: glb, shot: SHOT }),
  'a form whose shot is a file': () => postForm(url, THUMBNAILS, { shot: Buffer.from(JSON.stringify(SHOT)), model: glb }),
  'JSON with a reference': () => fetch(at(url, THUMBNAILS), asJson({ model: 'cloth', shot: SHOT })),
  'a form with a reference': () => postForm(url, THUMBNAILS, { model: 'cloth', shot: SHOT }),
  'GET with a reference': () => fetch(at(url, THUMBNAILS, { model: 'cloth', shot: SHOT })),
};
for (const [name, ask] of Object.entries(WAYS)) {
  test(`a thumbnail by ${name}`, async () => assert.ok((await good(ask())).equals(drawn)));
}

test('a model of some megabytes, as the body and in a form', async () => {
  const expected = (await pool.render(TSHIRT, SHOT)).data;
  assert.ok(TSHIRT.length > 2 ** 21 && !expected.equals(drawn));
  assert.ok((await good(post(url, THUMBNAILS, TSHIRT, { shot: SHOT }))).equals(expected));
  assert.ok((await good(postForm(url, THUMBNAILS, { model: TSHIRT, shot: SHOT }))).equals(expected));
});

for (const [format, { mediaType }] of Object.entries(FORMATS)) {
  test(`accept: ${mediaType}`, async () => {
    const response = await post(url, THUMBNAILS, glb, { shot: SHOT }, { accept: mediaType });
    assert.equal(response.headers.get('content-type'), mediaType);
    assert.equal(response.headers.get('vary'), 'accept');
    const { data } = await pool.render(glb, { ...SHOT, output: { format } });
    assert.ok((await bytesOf(response)).equals(data));
  });
}

test('what a browser accepts is a PNG or a WebP; a format of the shot is that one', async () => {
  const browser = { accept: 'image/avif,image/webp,image/apng,image/svg+xml,image/*,*/*;q=0.8' };
  assert.equal((await post(url, THUMBNAILS, glb, { shot: SHOT }, browser)).headers.get('content-type'), 'image/webp');
  const jpeg = { ...SHOT, output: { format: 'jpeg' } };
  assert.equal((await post(url, THUMBNAILS, glb, { shot: jpeg }, browser)).headers.get('content-type'), 'image/jpeg');
  const refused = await problemOf(await post(url, THUMBNAILS, glb, { shot: jpeg }, { accept: 'image/png' }));
  assert.deepEqual([refused.status, refused.code], [406, 'E_ACCEPT']);
  assert.equal(refused.message, 'the answer can be image/jpeg, application/json; the header accept is "image/png"');
});

test('as JSON: info, and the picture with its layers', async () => {
  const shot = { ...SHOT, layers: ['beauty', 'normal'] };
  const { key, info, files } = JSON.parse(await good(post(url, THUMBNAILS, glb, { shot }, { accept: 'application/json' })));
  const { data, layers, info: own } = await pool.render(glb, shot);
  assert.deepEqual(
    files.map(({ name, type, data: text }) => [name, type, Buffer.from(text, 'base64')]),
    [
      ['thumbnail.png', 'image/png', data],
      ['normal.png', 'image/png', layers.normal],
    ],
  );
  assert.equal(key, own.key);
  assert.deepEqual(info.shot, JSON.parse(JSON.stringify(own.shot)));
});

test('files beside a model, an environment as a file, and one that the owner has named', async () => {
  const [gltf, bin] = split(glb);
  assert.ok((await good(postForm(url, THUMBNAILS, { model: gltf, part: [bin, 'geometry data.bin'], shot: SHOT }))).equals(drawn));
  const missing = await problemOf(await postForm(url, THUMBNAILS, { model: gltf, part: [bin, 'other.bin'], shot: SHOT }));
  assert.deepEqual([missing.status, missing.code, missing.pointer], [422, 'E_URI_MISSING', '/buffers/0/uri']);
  const lit = { ...SHOT, environment: { map: SKY, rotation: 30 } };
  const expected = (await pool.render(glb, lit)).data;
  assert.ok(!expected.equals(drawn));
  assert.ok(
    (await good(postForm(url, THUMBNAILS, { model: glb, environment: Buffer.from(SKY), shot: { ...SHOT, environment: { rotation: 30 } } }))).equals(expected),
  );
  const named = await post(url, THUMBNAILS, glb, { shot: { ...SHOT, environment: { map: 'sky', rotation: 30 } } }, { accept: 'application/json' });
  const { files, info } = await named.json();
  assert.ok(Buffer.from(files[0].data, 'base64').equals(expected));
  assert.equal(info.shot.environment.map, null, 'its bytes are no part of the answer');
});

test('inspect: as inspect() of the pool, with lengths', async () => {
  const measure = [
    {
      points: [
        [0, 0, 0],
        [0.1, 0, 0],
      ],
    },
  ];
  const ask = (asked) => post(url, '/v1/inspect', glb, { shot: SHOT, ...asked });
  assert.deepEqual(JSON.parse(await good(ask())), JSON.parse(JSON.stringify(await pool.inspect(glb, { shot: SHOT }))));
  assert.deepEqual(JSON.parse(await good(ask({ measure }))).measures, (await pool.inspect(glb, { measure })).measures);
});

test('compare: figures and verdict, or the heat map', async () => {
  const other = (await pool.render(glb, { ...SHOT, camera: { view: 'back' } })).data;
  const expected = JSON.parse(JSON.stringify(await pool.compare(drawn, other, { gate: 'draft' })));
  assert.deepEqual(JSON.parse(await good(postForm(url, '/v1/compare', { expected: drawn, actual: other, gate: 'draft' }))), expected);
  assert.equal(expected.verdict.pass, false);
  const same = JSON.parse(await good(postForm(url, '/v1/compare', { expected: drawn, actual: drawn, gate: 'exact' })));
  assert.equal(same.verdict.pass, true);
  const { heatMap } = await pool.compare(drawn, other, { heatMap: true });
  assert.ok((await good(postForm(url, '/v1/compare', { expected: drawn, actual: other }, { accept: 'image/png' }))).equals(heatMap));
});

test('sheets: one PDF, one page as it is, several as multipart/mixed', async () => {
  const spec = { header: { style: 'TL-01' }, views: [{ name: 'front', title: 'Front', view: 'front', cover: true }] };
  assert.equal((await good(postForm(url, '/v1/sheets', { model: glb, spec }))).subarray(0, 5).toString(), '%PDF-');
  const [page] = (await pool.sheet(glb, spec, { format: 'svg' })).files;
  assert.ok((await good(postForm(url, '/v1/sheets', { model: glb, spec, format: 'svg' }))).equals(page));
  const { files } = await pool.sheet(glb, null, { format: 'svg', name: 'Square' });
  assert.ok(files.length > 1);
  const response = await post(url, '/v1/sheets', glb, { name: 'Square' }, { accept: 'image/svg+xml' });
  const [, boundary] = /^multipart\/mixed; boundary=(.+)$/.exec(response.headers.get('content-type'));
  const part = (file, i) => `\r\ncontent-type: image/svg+xml\r\ncontent-disposition: attachment; filename="sheet-${i + 1}.svg"\r\n\r\n${file}\r\n`;
  assert.deepEqual((await bytesOf(response)).toString().split(`--${boundary}`), ['', ...files.map(part), '--\r\n']);
});

test('the tag of an answer is the key of the picture: known beforehand, and asked for by it nothing is drawn', async () => {
  const first = await post(url, THUMBNAILS, glb, { shot: SHOT });
  const tag = first.headers.get('etag');
  assert.equal(tag, `"${(await pool.render(glb, SHOT)).info.key}"`);
  assert.equal(tag, `"${await pictureKey(glb, SHOT)}"`);
  const before = await jobs();
  const again = await post(url, THUMBNAILS, glb, { shot: SHOT }, { 'if-none-match': `"other", W/${tag}` });
  assert.deepEqual([again.status, (await problemOf(again)).code], [412, 'E_PRECONDITION']);
  const ask = (shot, headers) => fetch(at(url, THUMBNAILS, { model: 'cloth', shot }), { headers });
  const unchanged = await ask(SHOT, { 'if-none-match': tag });
  assert.deepEqual([unchanged.status, unchanged.headers.get('etag'), (await bytesOf(unchanged)).length], [304, tag, 0]);
  assert.equal(unchanged.headers.get('cache-control'), 'public, max-age=300');
  assert.equal(await jobs(), before, 'no worker was asked');
  const asJpeg = { ...SHOT, output: { format: 'jpeg' } };
  for (const [shot, headers] of [[{ ...SHOT, exposure: 2 }], [asJpeg], [SHOT, { accept: 'image/webp' }], [SHOT, { accept: 'application/json' }]]) {
    const other = await ask(shot, { ...headers, 'if-none-match': tag });
    assert.equal(other.status, 200);
    assert.notEqual(other.headers.get('etag'), tag);
    await bytesOf(other);
  }
  assert.equal(await jobs(), before + 4);
});

/** Jobs that workers have done. */
const jobs = async () =>
  [...(await (await fetch(new URL('/metrics', url))).text()).matchAll(/^telar_work_seconds_count\{.*\} (\d+)$/gm)].reduce((sum, [, n]) => sum + Number(n), 0);

test('warnings of a sheet are named in a header: of the model, the spec and the pictures', async () => {
  const other = editedGlb(glb, (json) => (json.extensionsUsed = [...(json.extensionsUsed ?? []), 'VENDOR_unknown']));
  const spec = {
    header: { style: 'TL-01' },
    measures: [
      {
        code: 'A',
        description: 'off',
        points: [
          [9, 9, 9],
          [0, 0, 0],
        ],
      },
    ],
  };
  const response = await postForm(url, '/v1/sheets', { model: other, spec });
  await bytesOf(response);
  assert.deepEqual([response.status, response.headers.get('telar-warnings')], [200, 'W_EXT_IGNORED, W_SHEET_POINT']);
});

test('warnings of a model are named in a header', async () => {
  const broken = await BROKEN_MODELS['broken-required-extensions']();
  const refused = await problemOf(await post(url, THUMBNAILS, broken, { shot: SHOT }));
  assert.deepEqual([refused.status, refused.code], [415, 'E_EXT_REQUIRED']);
  const response = await post(url, THUMBNAILS, broken, { shot: SHOT, failOn: 'none' });
  assert.deepEqual([response.status, response.headers.get('telar-warnings')], [200, 'W_EXT_REQUIRED']);
  // What was drawn in spite of a fault is not the answer to whom that is none.
  const known = { 'if-none-match': response.headers.get('etag') };
  assert.equal((await post(url, THUMBNAILS, broken, { shot: SHOT, failOn: 'none' }, known)).status, 412);
  assert.equal((await post(url, THUMBNAILS, broken, { shot: SHOT }, known)).status, 415);
});

test('HEAD has the headers of GET', async () => {
  const response = await fetch(at(url, THUMBNAILS, { model: 'cloth', shot: SHOT }), { method: 'HEAD' });
  assert.deepEqual([response.status, response.headers.get('content-length')], [200, String(drawn.length)]);
});

/** A GLB as a .gltf and the file beside it. */
function split(whole) {
  const view = new DataView(whole.buffer, whole.byteOffset, whole.byteLength);
  const end = 20 + view.getUint32(12, true);
  const json = JSON.parse(new TextDecoder().decode(whole.subarray(20, end)));
  json.buffers[0].uri = 'textures/geometry%20data.bin';
  return [Buffer.from(JSON.stringify(json)), Buffer.from(whole.subarray(end + 8, end + 8 + view.getUint32(end, true)))];
}
