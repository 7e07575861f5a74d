import assert from 'node:assert/strict';
import { test } from 'node:test';
import sharp from 'sharp';
import { embedShot, MAX_SHOT_BYTES, readEmbeddedShot, SHOT_KEYWORD } from '../../../js/compare/embedded_shot.mjs';

const SHOT = { camera: { view: 'front' }, variant: 'Añil – 藍', exposure: 1.25 };
const picture = async (format = 'png') =>
  new Uint8Array(
    await sharp({ create: { width: 5, height: 3, channels: 4, background: { r: 200, g: 100, b: 50, alpha: 0.5 } } })
      [format]()
      .toBuffer(),
  );
const isError = (code, text) => (error) => error.code === code && error.message.includes(text);

test('a shot comes back from the PNG that it was saved in', async () => {
  assert.deepEqual(readEmbeddedShot(embedShot(await picture(), SHOT)), SHOT);
});

test('the pixels stay, other decoders accept the file and show the text', async () => {
  const plain = await picture();
  const saved = embedShot(plain, SHOT);
  const pixels = async (bytes) => (await sharp(bytes, { failOn: 'warning' }).raw().toBuffer()).toString('hex');
  assert.equal(await pixels(saved), await pixels(plain));
  // libpng checks the chunk's CRC and hands its text out.
  const { comments } = await sharp(saved).metadata();
  assert.deepEqual(comments?.map(({ keyword }) => keyword).filter((keyword) => keyword.includes(SHOT_KEYWORD)).length, 1);
});

test('a second shot takes the place of the first', async () => {
  const once = embedShot(await picture(), { exposure: 1 });
  assert.deepEqual(embedShot(once, SHOT), embedShot(await picture(), SHOT));
});

test('a PNG without a shot, a JPEG and an empty file have none', async () => {
  assert.equal(readEmbeddedShot(await picture()), null);
  assert.equal(readEmbeddedShot(await picture('jpeg')), null);
  assert.equal(readEmbeddedShot(new Uint8Array()), null);
});

test('bytes within a larger buffer are read at their own offset', async () => {
  const saved = embedShot(await picture(), SHOT);
  const larger = new Uint8Array(saved.length + 7);
  larger.set(saved, 7);
  assert.deepEqual(readEmbeddedShot(larger.subarray(7)), SHOT);
});

test('every cut of the file ends with an error or with the whole shot', async () => {
  const saved = embedShot(await picture(), SHOT);
  for (let length = 9; length < saved.length; length++) {
    try {
      const shot = readEmbeddedShot(saved.subarray(0, length));
      if (shot !== null) assert.deepEqual(shot, SHOT);
    } catch (error) {
      assert.equal(error.code, 'E_IMAGE_CORRUPT', error.stack);
    }
  }
});

test('a flipped byte of the shot, a length beyond the file and a compressed chunk are damage', async () => {
  const saved = embedShot(await picture(), SHOT);
  const at = Buffer.from(saved).indexOf(SHOT_KEYWORD);
  const changed = (offset, value) => Uint8Array.from(saved, (byte, i) => (i === offset ? value : byte));
  assert.throws(() => readEmbeddedShot(changed(at + 30, 0x21)), isError('E_IMAGE_CORRUPT', 'damaged'));
  assert.throws(() => readEmbeddedShot(changed(at - 8, 0xff)), isError('E_IMAGE_CORRUPT', 'within a chunk'));
  assert.throws(() => readEmbeddedShot(changed(at + SHOT_KEYWORD.length + 1, 1)), isError('E_IMAGE_CORRUPT', ''));
});

test('what is no object, no PNG or too long is refused', async () => {
  const png = await picture();
  for (const value of [[1], 'text', 7]) {
    assert.throws(() => readEmbeddedShot(embedShot(png, value)), isError('E_IMAGE_CORRUPT', 'no JSON object'));
  }
  assert.throws(() => embedShot(new Uint8Array([1, 2, 3]), SHOT), isError('E_IMAGE_FORMAT', 'PNG'));
  assert.throws(() => embedShot(png, { variant: 'x'.repeat(MAX_SHOT_BYTES) }), isError('E_SHOT', String(MAX_SHOT_BYTES)));
});
