import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, truncateSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import sharp from 'sharp';
import { encodePng, readImage } from '../../../js/compare/index.mjs';
import { noise } from './support.mjs';

const folder = mkdtempSync(path.join(tmpdir(), 'telar-compare-'));
after(() => rmSync(folder, { recursive: true }));
const image = noise(17, 9, 4);
const raw = () => sharp(image.data, { raw: { width: 17, height: 9, channels: 4 } });

test('PNG and lossless WebP come back as they were, from a path, a URL and bytes', async () => {
  const files = { 'a.png': await raw().png().toBuffer(), 'a.webp': await raw().webp({ lossless: true }).toBuffer() };
  for (const [name, bytes] of Object.entries(files)) {
    const file = path.join(folder, name);
    writeFileSync(file, bytes);
    for (const source of [file, pathToFileURL(file), bytes]) {
      const { width, height, data } = await readImage(source);
      assert.deepEqual([width, height, Buffer.from(data).equals(Buffer.from(image.data))], [17, 9, true], name);
    }
  }
});

test('a JPEG comes close', async () => {
  const { width, height, data } = await readImage(
    await sharp({ create: { width: 8, height: 8, channels: 3, background: '#4080c0' } })
      .jpeg({ quality: 95 })
      .toBuffer(),
  );
  assert.deepEqual([width, height, data[3]], [8, 8, 255]);
  [0x40, 0x80, 0xc0].forEach((value, c) => assert.ok(Math.abs(data[c] - value) <= 2));
});

test('encodePng writes what sharp and readImage read', async () => {
  const png = await encodePng(image);
  const { data, info } = await sharp(png).raw().toBuffer({ resolveWithObject: true });
  assert.deepEqual([info.width, info.height, info.channels, data.equals(Buffer.from(image.data))], [17, 9, 4, true]);
  assert.deepEqual(new Uint8Array((await readImage(png)).data), image.data);
});

test('bad input has a typed error', async () => {
  const cut = path.join(folder, 'cut.png');
  writeFileSync(cut, await encodePng(image));
  truncateSync(cut, 300);
  await assert.rejects(readImage(cut), { code: 'E_IMAGE_CORRUPT', exit: 3 });
  await assert.rejects(readImage(Buffer.from('no image')), { code: 'E_IMAGE_FORMAT', exit: 3 });
  await assert.rejects(readImage(path.join(folder, 'none.png')), { code: 'E_FILE', exit: 3, message: /^none\.png cannot be read \(ENOENT\)/ });
  await assert.rejects(readImage(folder), { code: 'E_FILE' });
  await assert.rejects(readImage(42), { code: 'E_OPTION' });
  await assert.rejects(readImage(cut, { signal: {} }), { code: 'E_OPTION' });
  await assert.rejects(encodePng({ ...image, width: 16 }), { code: 'E_OPTION' });
});

test('limits and signals hold', async () => {
  const png = await encodePng(image);
  const file = path.join(folder, 'whole.png');
  writeFileSync(file, png);
  await assert.rejects(readImage(png, { limits: { L_IMAGE_DIMENSION: 16 } }), { code: 'L_IMAGE_DIMENSION', exit: 4 });
  for (const source of [png, file]) {
    await assert.rejects(readImage(source, { limits: { L_FILE_BYTES: 100 } }), {
      code: 'L_FILE_BYTES',
      limit: { name: 'L_FILE_BYTES', max: 100, actual: png.length },
    });
  }
  const reason = new Error('enough');
  await assert.rejects(readImage(png, { signal: AbortSignal.abort(reason) }), reason);
  await assert.rejects(readImage(file, { signal: AbortSignal.abort(reason) }), reason);
});
