// Every output format, decoded by another library than the one that wrote it and compared pixel by pixel: PNG, JPEG, WebP and
// TIFF by sharp (libspng, its own libjpeg, libwebp and libtiff), EXR by three.js's EXRLoader, which is written in JavaScript.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { setTimeout as sleep } from 'node:timers/promises';
import sharp from 'sharp';
import { DataUtils, FloatType, HalfFloatType } from 'three';
import { EXRLoader } from 'three/examples/jsm/loaders/EXRLoader.js';
import { createRenderer } from '../../js/index.mjs';
import { MODELS } from '../fixtures/index.mjs';
import { imageTool } from './image/image_tool.mjs';

/** Of neither a whole strip of TIFF, nor a block of JPEG. */
const WIDTH = 203;
const HEIGHT = 117;

let folder;
before(() => {
  folder = mkdtempSync(join(tmpdir(), 'telar-output-'));
});
after(() => rmSync(folder, { recursive: true, force: true }));

/** Noise over a slope: every value of every channel, alpha from 0 to 255. */
function bytesFrame({ opaque = false } = {}) {
  let state = 7;
  return Uint8Array.from({ length: WIDTH * HEIGHT * 4 }, (_, i) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    if (i % 4 === 3) return opaque ? 255 : (i >> 2) & 255;
    return opaque ? ((i >> 2) % WIDTH) + (state >>> 29) : state >>> 24;
  });
}

/** Linear light from far below to far above 1, of both signs; alpha 0..1. */
const floatsFrame = () =>
  Float32Array.from({ length: WIDTH * HEIGHT * 4 }, (_, i) =>
    i % 4 === 3 ? ((i >> 2) % 256) / 255 : (i % 3 === 0 ? -1 : 1) * 2 ** (((i * 37) % 9000) / 300 - 14) * 1.00003,
  );

function encode(frame, options) {
  const path = join(folder, 'frame');
  writeFileSync(path, new Uint8Array(frame.buffer, frame.byteOffset, frame.byteLength));
  const words = Object.entries({ frame: path, width: WIDTH, height: HEIGHT, ...options }).map(([name, value]) => `${name}=${value}`);
  return execFileSync(imageTool(), ['encode', ...words], { maxBuffer: 1 << 28 });
}

/** @returns {Promise<{width, height, channels, data}>} samples as they stand in the file: 8 or 16 bits, no profile applied */
async function bySharp(file, bits = 8) {
  const image = sharp(file, { failOn: 'warning', ignoreIcc: true }).toColourspace(bits === 16 ? 'rgb16' : 'srgb');
  const { data, info } = await image.raw({ depth: bits === 16 ? 'ushort' : 'uchar' }).toBuffer({ resolveWithObject: true });
  return { ...info, data: bits === 16 ? new Uint16Array(data.buffer, data.byteOffset, data.length / 2) : data };
}

/** RGBA, row 0 on top, as doubles; EXRLoader has row 0 at the bottom. */
function byThree(file, type) {
  const { width, height, data } = new EXRLoader().setDataType(type).parse(file.buffer.slice(file.byteOffset, file.byteOffset + file.length));
  const values = type === HalfFloatType ? Array.from(data, (half) => DataUtils.fromHalfFloat(half)) : Array.from(data);
  return {
    width,
    height,
    channels: 4,
    data: Array.from({ length: height }, (_, y) => values.slice((height - 1 - y) * width * 4, (height - y) * width * 4)).flat(),
  };
}

/** Number of samples that differ, and the greatest and mean difference. */
function differences(expected, actual) {
  assert.equal(actual.length, expected.length);
  const out = { count: 0, max: 0, mean: 0 };
  for (let i = 0; i < expected.length; ++i) {
    const difference = Math.abs(expected[i] - actual[i]);
    if (!(difference === 0)) out.count++;
    out.max = Math.max(out.max, difference);
    out.mean += difference / expected.length;
  }
  return out;
}

function assertSame(picture, expected, { width = WIDTH, height = HEIGHT } = {}) {
  assert.deepEqual([picture.width, picture.height, picture.channels], [width, height, 4]);
  assert.deepEqual(differences(expected, picture.data), { count: 0, max: 0, mean: 0 });
}

for (const format of ['png', 'tiff']) {
  for (const bits of [8, 16]) {
    for (const icc of [0, 1]) {
      test(`${format} of ${bits} bits${icc ? ' with a profile' : ''}: sharp reads the frame`, async () => {
        const frame = bytesFrame();
        const file = encode(frame, { format, bits, icc, ppi: 300 });
        const { width, height, depth, density, hasAlpha, hasProfile } = await sharp(file).metadata();
        assert.deepEqual([width, height, depth, hasAlpha, hasProfile], [WIDTH, HEIGHT, bits === 16 ? 'ushort' : 'uchar', true, icc === 1]);
        assert.equal(Math.round(density), 300);
        assertSame(await bySharp(file, bits), bits === 16 ? Array.from(frame, (value) => value * 257) : frame);
      });
    }
  }
}

test('webp at quality 100 is the frame; below alpha is', async () => {
  const frame = bytesFrame();
  assertSame(await bySharp(encode(frame, { format: 'webp', quality: 100 })), frame);
  const { data } = await bySharp(encode(frame, { format: 'webp', quality: 90 }));
  const alphaOf = (bytes) => bytes.filter((_, i) => i % 4 === 3);
  assert.equal(differences(alphaOf(frame), alphaOf(data)).count, 0);
});

/**
 * Quality 100 has quantisation steps of 1: a rounding of Y, Cb and Cr (standard deviation 0.29 each), one of their DCT's coefficients
 * (0.29, the transform keeps it) and one of the result. B = Y + 1.77 Cb has the most: sqrt(2 (1 + 1.77^2) / 12 + 1/12) = 0.88, of
 * which 71 000 samples reach 4.5 times, 4; none reaches 6 in rounded values, 6.2 times. The mean of normal errors is 0.8 of their
 * deviation. Measured: 4 and 0.49.
 */
const JPEG_100 = { max: 5, mean: 0.7 };

test('jpeg: sharp reads what the frame holds, up to the roundings of JPEG', async () => {
  const frame = bytesFrame({ opaque: true });
  const rgb = frame.filter((_, i) => i % 4 !== 3);
  const { width, height, channels, data } = await bySharp(encode(frame, { format: 'jpeg', quality: 100 }));
  assert.deepEqual([width, height, channels], [WIDTH, HEIGHT, 3]);
  const { max, mean } = differences(rgb, data);
  assert.ok(max <= JPEG_100.max && mean <= JPEG_100.mean, `${max} ${mean}`);
});

test('exr of 16 and 32 bits: EXRLoader reads the frame', () => {
  const frame = floatsFrame();
  assertSame(byThree(encode(frame, { format: 'exr', bits: 32 }), FloatType), frame);
  // A half is the float rounded to 11 bits, or to steps of 2^-24 below 2^-14.
  const halves = byThree(encode(frame, { format: 'exr', bits: 16 }), HalfFloatType);
  frame.forEach((value, i) => {
    const step = 2 ** Math.max(Math.floor(Math.log2(Math.abs(value) || 1)) - 10, -24);
    assert.ok(Math.abs(halves.data[i] - value) <= step / 2, `${value} is ${halves.data[i]}`);
  });
});

test('raw is the frame', () => {
  for (const [frame, bits] of [
    [bytesFrame(), 8],
    [floatsFrame(), 32],
  ]) {
    assert.ok(encode(frame, { format: 'raw', bits }).equals(Buffer.from(frame.buffer)));
  }
});

// The comparison sees one sample that is off by one, and a TIFF whose header points past its picture, as it did once.
test('planted faults are told', async () => {
  const frame = bytesFrame();
  const changed = frame.slice();
  changed[4321] ^= 1;
  assert.equal(differences(frame, (await bySharp(encode(changed, { format: 'tiff', bits: 8 }))).data).count, 1);
  const exif = Buffer.alloc(2 + 12 * 2 + 4);
  exif.writeUInt16LE(2, 0);
  exif.set([0x01, 0xa0, 3, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0x02, 0xa0, 3, 0, 1, 0, 0, 0, 1, 0, 0, 0], 2);
  const file = encode(frame, { format: 'tiff', bits: 8 });
  const astray = Buffer.concat([file, Buffer.alloc(file.length % 2), exif]);
  astray.writeUInt32LE(astray.length - exif.length, 4);
  await assert.rejects(bySharp(astray), /unsupported image format|tiff/i);
});

const EVERY = [
  ...[8, 16].flatMap((bits) => [0, 1].flatMap((icc) => ['png', 'tiff'].map((format) => ({ format, bits, icc, ppi: 96 })))),
  { format: 'jpeg', icc: 1, ppi: 96 },
  { format: 'webp' },
  { format: 'webp', quality: 100 },
  { format: 'exr', bits: 16 },
  { format: 'exr', bits: 32 },
  { format: 'raw', bits: 8 },
];

test('the same bytes a second later, and no time in a file', async () => {
  const files = () => EVERY.map((options) => encode(options.format === 'exr' ? floatsFrame() : bytesFrame({ opaque: true }), options));
  const first = files();
  await sleep(1100); // file formats tell whole seconds
  files().forEach((file, i) => assert.ok(file.equals(first[i]), JSON.stringify(EVERY[i])));
  const now = new Date();
  for (const file of first) assert.doesNotMatch(file.toString('latin1'), new RegExp(`capDate|${now.getFullYear()}[:-]`));
});

test('a rendered picture: all formats hold what raw holds', async () => {
  const renderer = await createRenderer({ cacheDirectory: null });
  try {
    const model = await renderer.load(await MODELS.cloth());
    const draw = async (output, rest = {}) => (await renderer.render(model, { size: { width: 96, height: 64 }, output, ...rest })).data;
    const size = { width: 96, height: 64 };
    const bytes = await draw({ format: 'raw' });
    assert.ok(new Set(bytes).size > 50, 'there is a picture');
    for (const output of [
      { format: 'png' },
      { format: 'tiff' },
      { format: 'webp', quality: 100 },
      { format: 'png', icc: true },
      { format: 'tiff', icc: true },
    ]) {
      assertSame(await bySharp(await draw(output)), bytes, size);
    }
    for (const format of ['png', 'tiff'])
      assertSame(
        await bySharp(await draw({ format, bitDepth: 16 }), 16),
        Array.from(bytes, (value) => value * 257),
        size,
      );
    const floats = await draw({ format: 'raw', bitDepth: 32 });
    assertSame(
      byThree(await draw({ format: 'exr', bitDepth: 32 }), FloatType),
      new Float32Array(floats.buffer.slice(floats.byteOffset, floats.byteOffset + floats.length)),
      size,
    );
    const background = { background: '#f2efe9' };
    const opaque = (await draw({ format: 'raw' }, background)).filter((_, i) => i % 4 !== 3);
    const jpeg = await bySharp(await draw({ format: 'jpeg', quality: 100 }, background));
    const { max, mean } = differences(opaque, jpeg.data);
    assert.ok(max <= JPEG_100.max && mean <= JPEG_100.mean, `${max} ${mean}`);
  } finally {
    await renderer.close();
  }
});
