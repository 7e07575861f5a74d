import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { chromium } from 'playwright-core';
import sharp from 'sharp';
import { inspect } from '../../js/index.mjs';
import { glb, quad } from './glb.mjs';

// Which damaged textures failOn "none" leaves out: those that Chromium does not decode, by the call with which GLTFLoader decodes.

const SIDE = 64;
const noise = Buffer.from(Uint8Array.from({ length: SIDE * SIDE * 3 }, (_, i) => (i * 7919) >> 3));
const base = () => sharp(noise, { raw: { width: SIDE, height: SIDE, channels: 3 } });
const half = (bytes) => bytes.subarray(0, bytes.length >> 1);
const flipped = (bytes, at) => {
  const copy = Buffer.from(bytes);
  copy[at] ^= 0x55;
  return copy;
};

const [png, jpeg, progressive, webp, gif] = await Promise.all([
  base().png().toBuffer(),
  base().jpeg({ quality: 90 }).toBuffer(),
  base().jpeg({ quality: 90, progressive: true }).toBuffer(),
  base().webp({ lossless: true }).toBuffer(),
  base().gif().toBuffer(),
]);
const pixels = png.indexOf('IDAT');
const afterPixels = pixels + 4 + png.readUInt32BE(pixels - 4);

const IMAGES = {
  'a whole PNG': png,
  'half a PNG': half(png),
  'a PNG without its end': png.subarray(0, -12),
  'a PNG with a wrong checksum': flipped(png, afterPixels + 1),
  'a PNG with wrong pixels early': flipped(png, pixels + 60),
  'a PNG with wrong pixels late': flipped(png, afterPixels - 200),
  'a PNG with a wrong signature': flipped(png, 1),
  'a whole JPEG': jpeg,
  'half a JPEG': half(jpeg),
  'a JPEG of 200 bytes': jpeg.subarray(0, 200),
  'half a progressive JPEG': half(progressive),
  'a JPEG without its end': jpeg.subarray(0, -2),
  'a JPEG with wrong pixels': flipped(jpeg, jpeg.length - 300),
  'a whole WebP': webp,
  'half a WebP': half(webp),
  text: Buffer.from('hello, this is text'),
};

/** Chromium draws these and telar does not, with W_TEXTURE: it reads no GIF, and takes no JPEG that its decoder warns about. */
const STRICTER = ['a GIF', 'a JPEG with wrong pixels'];

let browser, page;
before(async () => {
  browser = await chromium.launch({ executablePath: process.env.TELAR_CHROMIUM ?? '/usr/bin/chromium', args: ['--no-sandbox'] });
  page = await browser.newPage();
});
after(() => browser.close());

const decodedByChromium = (bytes) =>
  page.evaluate(async (text) => {
    const blob = new Blob([Uint8Array.from(atob(text), (c) => c.charCodeAt(0))]);
    return createImageBitmap(blob, { premultiplyAlpha: 'none', colorSpaceConversion: 'none' }).then(
      () => true,
      () => false,
    );
  }, bytes.toString('base64'));

async function decodedByTelar(image) {
  const { warnings } = await inspect(glb(quad({ image })), { failOn: 'none' });
  return !warnings.some(({ code }) => code === 'W_TEXTURE');
}

for (const [name, image] of Object.entries({ ...IMAGES, 'a GIF': gif })) {
  test(name, async () => {
    const [expected, actual] = await Promise.all([decodedByChromium(image), decodedByTelar(image)]);
    assert.equal(actual, expected && !STRICTER.includes(name), `Chromium ${expected ? 'decodes' : 'refuses'} it`);
  });
}
