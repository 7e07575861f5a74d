import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import sharp from 'sharp';
import { encodeAvif } from '../../../js/api/avif.mjs';
import { wantedOf } from '../../../js/server/answer.mjs';
import { MODELS, SHOT, bytesOf, openPool, post, problemOf, serve } from './support.mjs';

// AVIF where sharp is installed, and what is said where it is not.

const THUMBNAILS = '/v1/thumbnails';
const AVIF = { accept: 'image/avif' };
/** Mean difference of two encodings of one picture in lossy AVIF, of 255. */
const NEAR = 6;

let pool, service, url, glb, folder;
before(async () => {
  [pool, glb] = await Promise.all([openPool(), MODELS.cloth()]);
  folder = mkdtempSync(path.join(tmpdir(), 'telar-avif-'));
  service = await serve({ pool, store: folder });
  ({ url } = service);
});
after(async () => {
  await service.drain();
  await pool.close();
  rmSync(folder, { recursive: true });
});

/** Pixels of an encoded picture as others read it: RGBA. */
const pixelsOf = (bytes) => sharp(bytes).ensureAlpha().raw().toBuffer();

/** Mean difference of what is seen: colours count as much as they cover. */
async function difference(first, second) {
  const [a, b] = await Promise.all([pixelsOf(first), pixelsOf(second)]);
  assert.equal(a.length, b.length);
  let sum = 0;
  for (let i = 0; i < a.length; i += 4) {
    for (let c = 0; c < 3; ++c) sum += Math.abs((a[i + c] * a[i + 3] - b[i + c] * b[i + 3]) / 255);
    sum += Math.abs(a[i + 3] - b[i + 3]);
  }
  return sum / a.length;
}

test('the picture as AVIF: the pixels of the PNG, with its transparency, and a tag of its own', async () => {
  const response = await post(url, THUMBNAILS, glb, { shot: SHOT }, AVIF);
  const bytes = await bytesOf(response);
  assert.deepEqual([response.status, response.headers.get('content-type')], [200, 'image/avif']);
  assert.equal(response.headers.get('content-disposition'), 'inline; filename="thumbnail.avif"');
  assert.equal(bytes.subarray(4, 12).toString(), 'ftypavif');
  const png = (await pool.render(glb, SHOT)).data;
  const off = await difference(bytes, png);
  assert.ok(off < NEAR, `${off}`);
  const other = (await pool.render(glb, { ...SHOT, exposure: 0.3 })).data;
  assert.ok((await difference(bytes, other)) > NEAR, 'planted: a darker picture');
  const tag = response.headers.get('etag');
  assert.match(tag, /^"[0-9a-f]{64}-avif"$/);
  assert.equal((await post(url, THUMBNAILS, glb, { shot: SHOT }, { ...AVIF, 'if-none-match': tag })).status, 412);
  const again = await post(url, THUMBNAILS, glb, { shot: SHOT }, AVIF);
  assert.deepEqual([again.headers.get('etag'), (await bytesOf(again)).equals(bytes)], [tag, true]);
});

test('quality of the shot counts, and the tag tells it', async () => {
  const tagOf = async (output) => (await post(url, THUMBNAILS, glb, { shot: { ...SHOT, output } }, AVIF)).headers.get('etag');
  // Without one it is the encoder's own, and not that of the shot's other formats.
  assert.equal(new Set([await tagOf({}), await tagOf({ quality: 90 }), await tagOf({ quality: 91 })]).size, 3);
  const sizeOf = async (quality) => (await bytesOf(await post(url, THUMBNAILS, glb, { shot: { ...SHOT, output: { quality } } }, AVIF))).length;
  assert.ok((await sizeOf(10)) < (await sizeOf(95)));
});

test('a browser gets WebP as before; who likes AVIF best gets it; a shot with layers has none', async () => {
  const typeOf = async (accept, shot = SHOT) => (await post(url, THUMBNAILS, glb, { shot }, { accept })).headers.get('content-type');
  assert.equal(await typeOf('image/avif,image/webp,image/apng,image/svg+xml,image/*,*/*;q=0.8'), 'image/webp');
  assert.equal(await typeOf('image/avif,image/webp;q=0.9'), 'image/avif');
  assert.equal(await typeOf('image/avif,*/*;q=0.1', { ...SHOT, layers: ['beauty', 'normal'] }), 'image/png');
  assert.equal((await problemOf(await post(url, THUMBNAILS, glb, { shot: { ...SHOT, output: { format: 'png' } } }, AVIF))).code, 'E_ACCEPT');
  const wrong = await problemOf(await post(url, THUMBNAILS, glb, { shot: { ...SHOT, output: { quality: 1000 } } }, AVIF));
  assert.deepEqual([wrong.status, wrong.code], [400, 'E_SHOT']);
});

test('what AVIF does not have is told by its key, and the next type that has it is the answer', async () => {
  const png = await post(url, THUMBNAILS, glb, { shot: { ...SHOT, output: { ppi: 300, icc: true } } }, { accept: 'image/avif, image/png;q=0.5' });
  assert.equal(png.headers.get('content-type'), 'image/png');
  assert.equal((await sharp(await bytesOf(png)).metadata()).density, 300);
  const all = { ...SHOT, layers: ['beauty', 'depth'], output: { bitDepth: 16, ppi: 300, icc: true } };
  const problem = await problemOf(await post(url, THUMBNAILS, glb, { shot: all }, AVIF));
  assert.deepEqual([problem.status, problem.code], [406, 'E_ACCEPT']);
  assert.match(
    problem.detail,
    /^image\/avif is one picture of 8 bits a channel, without ppi and profile: leave out shot\.layers, shot\.output\.bitDepth, shot\.output\.ppi, shot\.output\.icc; the answer can be /,
  );
  assert.doesNotMatch(problem.detail, /raw/);
  const named = await problemOf(await post(url, THUMBNAILS, glb, { shot: { ...SHOT, output: { format: 'png' } } }, AVIF));
  assert.match(named.detail, /: leave out shot\.output\.format; /);
  const typeOf = (shot) => wantedOf({ kind: 'thumbnail', asked: { shot }, files: {} }, 'image/avif', { avif: true }).type;
  for (const output of [{ bitDepth: 8, ppi: 0, icc: false }, { effort: 3 }, {}]) assert.equal(typeOf({ output }), 'image/avif');
  assert.equal(typeOf({ scale: '1:10', output: { ppi: 150 } }), 'image/avif', 'ppi makes its size');
  // Wrong in every format: that of the shot is the message.
  assert.equal(typeOf({ output: { ppi: 'many', icc: 1 } }), 'image/avif');
});

test('without sharp: 406 that names it, and other types as before', () => {
  const task = { kind: 'thumbnail', asked: { shot: SHOT }, files: {} };
  const hint = /image\/avif can be had where the package sharp is installed/;
  assert.throws(() => wantedOf(task, 'image/avif', { avif: false }), { code: 'E_ACCEPT', message: hint });
  assert.throws(
    () => wantedOf(task, 'text/html', { avif: false }),
    ({ code, message }) => code === 'E_ACCEPT' && !hint.test(message),
  );
  assert.equal(wantedOf(task, 'image/avif, image/webp;q=0.1', { avif: false }).type, 'image/webp');
  assert.equal(wantedOf(task, 'image/avif', { avif: true }).type, 'image/avif');
});

test('what sharp refuses is typed', async () => {
  await assert.rejects(encodeAvif({ data: Buffer.alloc(3), width: 1, height: 1 }), { code: 'X_OUTPUT' });
});
