// Basis Universal textures give the texels of three.js's own transcoder, byte for byte, level by level.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { DataUtils } from 'three';
import { KTX2Loader } from 'three/examples/jsm/loaders/KTX2Loader.js';
import { etc1sKtx2 } from '../fixtures/etc1s.mjs';
import { BLOCK_FORMATS } from '../fixtures/gpu_blocks.mjs';
import { SUPERCOMPRESSION, ktx2File, mipChain, rawKtx2 } from '../fixtures/ktx2.mjs';
import { RAW_FORMATS, REFUSED_FORMATS, rawFormatKtx2 } from '../fixtures/raw_formats.mjs';
import { uastcBlocks, uastcKtx2 } from '../fixtures/uastc.mjs';
import { zstdStored } from '../fixtures/zstd_frame.mjs';
import { referenceLevels } from './image/basis_reference.mjs';
import { imageTool } from './image/image_tool.mjs';

const SHARED = fileURLToPath(new URL('../../../shared/models/textures_ktx2/', import.meta.url));

let folder;
before(() => {
  folder = mkdtempSync(join(tmpdir(), 'telar-ktx2-'));
});
after(() => rmSync(folder, { recursive: true, force: true }));

/** telar's levels; null where it refuses the file as damaged. */
function decoded(bytes) {
  const file = join(folder, 'image.ktx2');
  writeFileSync(file, bytes);
  let out;
  try {
    out = execFileSync(imageTool(), ['levels', file], { maxBuffer: 256 << 20, stdio: ['ignore', 'pipe', 'pipe'] });
  } catch (error) {
    if (!/^E_IMAGE_CORRUPT: /.test(error.stderr)) throw new Error(String(error.stderr));
    return null;
  }
  const count = out.readUInt32LE(4);
  const type = ['bytes', 'halves', 'floats'][out.readUInt32LE(8)];
  const texelBytes = { bytes: 4, halves: 8, floats: 16 }[type];
  const levels = [];
  for (let i = 0, at = 12; i < count; ++i) {
    const [width, height] = [out.readUInt32LE(at), out.readUInt32LE(at + 4)];
    levels.push({ width, height, pixels: out.subarray(at + 8, at + 8 + width * height * texelBytes) });
    at += 8 + width * height * texelBytes;
  }
  return { coding: out.readUInt32LE(0), type, levels };
}

/** The upper left of a level: where a single level is as large as its blocks, the transcoder gives the image alone. */
function cropped({ width, pixels }, to) {
  const rows = Array.from({ length: to.height }, (_, y) => pixels.subarray(y * width * 4, (y * width + to.width) * 4));
  return Buffer.concat(rows);
}

async function checkEqual(bytes, name) {
  const expected = await referenceLevels(bytes);
  assert.ok(expected, `${name}: the reference refuses it`);
  const actual = decoded(bytes);
  assert.ok(actual, `${name}: telar refuses it`);
  assert.equal(actual.levels.length, expected.length, name);
  expected.forEach((level, i) => {
    const own = cropped(actual.levels[i], level);
    const wrong = level.pixels.findIndex((value, at) => value !== own[at]);
    assert.equal(
      wrong,
      -1,
      `${name}, level ${i}, x ${(wrong >> 2) % level.width} y ${Math.floor((wrong >> 2) / level.width)}: ` +
        `${[...level.pixels.subarray(wrong & ~3, (wrong & ~3) + 4)]}, telar ${[...own.subarray(wrong & ~3, (wrong & ~3) + 4)]}`,
    );
  });
  return actual;
}

/** Numbers in 0..1 that are the same at each run. */
function random(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

/** Soft colours with a few hard edges and, where asked for, alpha. */
function picture(width, height, { alpha = false, noise = 0, seed = 1 } = {}) {
  const next = random(seed);
  const pixels = new Uint8Array(width * height * 4);
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      const edge = (x >> 3) + (y >> 3) === 3 ? 90 : 0;
      const color = [40 + 3 * x + edge, 200 - 2 * y - edge, 128 + 80 * Math.sin(x / 7) * Math.cos(y / 5), alpha ? 255 - 3 * y : 255];
      color.forEach((value, c) => {
        pixels[(y * width + x) * 4 + c] = Math.min(255, Math.max(0, value + (c < 3 ? noise * (next() - 0.5) : 0)));
      });
    }
  }
  return { width, height, pixels };
}

const SIZES = [
  [4, 4],
  [16, 16],
  [64, 32],
  [40, 40],
  [13, 7],
  [1, 1],
  [2, 9],
];

test('ETC1S', async () => {
  for (const [width, height] of SIZES) {
    for (const alpha of [false, true]) {
      for (const options of [{}, { singleLevel: true, rawSelectors: true }, { historySize: 2 }]) {
        const image = picture(width, height, { alpha, noise: width > 16 ? 4 : 60 });
        await checkEqual(etc1sKtx2(image, { alpha, ...options }), `${width}x${height} alpha ${alpha} ${JSON.stringify(options)}`);
      }
    }
  }
  // Runs of predictions and of selectors longer than their symbols say.
  const flat = { width: 256, height: 128, pixels: new Uint8Array(256 * 128 * 4).fill(77) };
  await checkEqual(etc1sKtx2(flat), 'flat');
});

test('UASTC', async () => {
  for (const [width, height] of SIZES) {
    const image = picture(width, height, { alpha: width === 40, noise: 10 });
    await checkEqual(uastcKtx2(image), `${width}x${height}`);
    await checkEqual(uastcKtx2(image, { singleLevel: true }), `${width}x${height}, one level`);
  }
});

test('UASTC with zstd gives the same as without', async () => {
  const image = picture(40, 24, { alpha: true });
  const plain = mipChain(image).map(uastcBlocks);
  const file = ktx2File({
    width: 40,
    height: 24,
    levels: plain.map(zstdStored),
    sizes: plain.map((level) => level.length),
    supercompression: SUPERCOMPRESSION.zstd,
    channels: [3],
  });
  assert.deepEqual(decoded(file), decoded(uastcKtx2(image)));
  await checkEqual(file, 'zstd');
});

/** Lowest bits of a block by mode, and how many; src: renderer/ktx2/uastc_modes.h, and the code that means no mode. */
const CODES = [
  [0x01, 4],
  [0x35, 6],
  [0x1d, 5],
  [0x03, 5],
  [0x13, 5],
  [0x0b, 5],
  [0x1b, 5],
  [0x07, 5],
  [0x17, 5],
  [0x0f, 5],
  [0x02, 3],
  [0x00, 2],
  [0x06, 3],
  [0x1f, 5],
  [0x0d, 5],
  [0x05, 7],
  [0x15, 6],
  [0x25, 6],
  [0x09, 4],
];

function randomBlock(next, [code, bits]) {
  const block = Buffer.from(Array.from({ length: 16 }, () => Math.floor(next() * 256)));
  block[0] = (block[0] & ~((1 << bits) - 1)) | code;
  return block;
}

const oneBlock = (block) => ktx2File({ width: 4, height: 4, levels: [block], channels: [3] });

test('random UASTC blocks of every mode, those that are refused among them', async () => {
  const next = random(7);
  const good = [];
  let refused = 0;
  for (let i = 0; i < 60 * CODES.length; ++i) {
    const block = randomBlock(next, CODES[i % CODES.length]);
    if (await referenceLevels(oneBlock(block))) good.push(block);
    else if (++refused <= 10) assert.equal(decoded(oneBlock(block)), null, `mode ${i % CODES.length}`);
  }
  assert.ok(refused > 10 && good.length > 40 * CODES.length, `${good.length} good, ${refused} refused`);
  const columns = 32;
  while (good.length % columns) good.push(good[0]);
  await checkEqual(ktx2File({ width: columns * 4, height: (good.length / columns) * 4, levels: [Buffer.concat(good)], channels: [3] }), 'random blocks');
  assert.equal(decoded(oneBlock(Buffer.alloc(16, 69))), null, 'the code that means no mode');
});

test('coding: what the descriptor says, and R8 and RG8 never sRGB', () => {
  const image = picture(8, 8);
  const [BY_USE, SRGB, LINEAR] = [0, 1, 2];
  assert.equal(decoded(uastcKtx2(image)).coding, SRGB);
  assert.equal(decoded(uastcKtx2(image, { transfer: 1 })).coding, BY_USE);
  assert.equal(decoded(uastcKtx2(image, { primaries: 0 })).coding, BY_USE);
  assert.equal(decoded(uastcKtx2(image, { primaries: 10 })).coding, SRGB);
  const raw = decoded(rawKtx2(image));
  assert.equal(raw.coding, SRGB);
  assert.deepEqual([...raw.levels[0].pixels], [...image.pixels]);
  assert.deepEqual(
    raw.levels.map(({ width }) => width),
    [8, 4, 2, 1],
  );
  const red = decoded(ktx2File({ width: 2, height: 1, levels: [Buffer.of(9, 250)], vkFormat: 15, model: 1 }));
  assert.equal(red.coding, LINEAR);
  assert.deepEqual([...red.levels[0].pixels], [9, 0, 0, 255, 250, 0, 0, 255]);
  const redGreen = decoded(ktx2File({ width: 1, height: 1, levels: [Buffer.of(9, 250)], vkFormat: 16, model: 1 }));
  assert.deepEqual([...redGreen.levels[0].pixels], [9, 250, 0, 255]);
});

/** A level's texels as numbers. */
function numbersOf({ type, levels }, level = 0) {
  const { pixels } = levels[level];
  const bytes = pixels.buffer.slice(pixels.byteOffset, pixels.byteOffset + pixels.length);
  if (type === 'halves') return Array.from(new Uint16Array(bytes), (half) => DataUtils.fromHalfFloat(half));
  return type === 'floats' ? Array.from(new Float32Array(bytes)) : Array.from(pixels, (value) => value / 255);
}

test('every uncompressed format of KTX2Loader: texels, lacking components, levels, coding', () => {
  const [BY_USE, SRGB, LINEAR] = [0, 1, 2];
  const image = picture(12, 10, { alpha: true, noise: 30 });
  for (const [name, { components }] of Object.entries(RAW_FORMATS)) {
    for (const zstd of [false, true]) {
      const actual = decoded(rawFormatKtx2(name, image, { zstd }));
      assert.ok(actual, name);
      // A step of each below 1; toHalfFloat cuts, the shared exponent rounds.
      const tolerance = { b10g11r11: 2 ** -6, e5b9g9r9: 2 ** -10, r16f: 2 ** -11, rg16f: 2 ** -11, rgba16f: 2 ** -11 }[name] ?? 1e-7;
      numbersOf(actual).forEach((value, i) => {
        const expected = i % 4 < components ? image.pixels[i] / 255 : Number(i % 4 === 3);
        assert.ok(Math.abs(value - expected) <= tolerance, `${name}, value ${i}: ${value}, ${expected}`);
      });
      assert.deepEqual(
        actual.levels.map(({ width, height }) => [width, height]),
        [
          [12, 10],
          [6, 5],
          [3, 2],
          [1, 1],
        ],
      );
      assert.equal(actual.coding, components < 4 || actual.type !== 'bytes' ? LINEAR : SRGB, name);
    }
  }
  assert.equal(decoded(rawFormatKtx2('rgba8', image, { transfer: 1 })).coding, BY_USE);
  for (const vkFormat of Object.values(REFUSED_FORMATS))
    assert.throws(() => decoded(ktx2File({ width: 1, height: 1, levels: [Buffer.alloc(16)], vkFormat, model: 1 })), /E_IMAGE_FORMAT/);
});

/** Why three.js's own loader does not take a file; undefined where it does. */
async function refusalOfThree(bytes) {
  const loader = new KTX2Loader();
  loader.workerConfig = {}; // of a GPU that reads no blocks: nothing here needs a transcoder
  const copy = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
  return new Promise((resolve) => {
    loader.parse(
      copy,
      () => resolve(undefined),
      (error) => resolve(error.message),
    );
  });
}

// PVRTC and ASTC HDR are for GPUs that no server has.
const FOREIGN = [1000054000, 1000054001, 1000054004, 1000054005, 1000066000, 1000066004];

test('formats: telar reads those that KTX2Loader reads, and refuses the others as it does', async () => {
  const fileOf = (vkFormat) => ktx2File({ width: 4, height: 4, levels: [Buffer.alloc(256)], vkFormat, model: 1 });
  const read = [];
  for (let vkFormat = 1; vkFormat <= 184; ++vkFormat) {
    const refusal = await refusalOfThree(fileOf(vkFormat));
    if (!refusal) read.push(vkFormat);
    if (refusal) assert.equal(refusal, `THREE.KTX2Loader: Unsupported vkFormat: ${vkFormat}`);
    // The size of the level is wrong for most: then telar knows the format.
    if (refusal) assert.throws(() => decoded(fileOf(vkFormat)), /E_IMAGE_FORMAT: .* which three\.js 0\.187 refuses as well/, `${vkFormat}`);
    else decoded(fileOf(vkFormat));
  }
  assert.deepEqual(
    read,
    [...Object.values(RAW_FORMATS), ...Object.values(BLOCK_FORMATS)]
      .map(({ vkFormat }) => vkFormat)
      .concat(133, 137, 157, 165)
      .sort((a, b) => a - b),
  );
  for (const vkFormat of FOREIGN) assert.throws(() => decoded(fileOf(vkFormat)), /E_IMAGE_FORMAT: .* which telar does not draw/);
});

/** src: OpenGL ES 3.0, sections 2.1.3 and 2.1.4: floats of 11 and 10 bits without a sign. */
function smallFloat(bits, mantissaBits) {
  const [exponent, mantissa] = [bits >> mantissaBits, bits & ((1 << mantissaBits) - 1)];
  return exponent === 0 ? mantissa * 2 ** (-14 - mantissaBits) : 2 ** (exponent - 15) * (1 + mantissa / 2 ** mantissaBits);
}

test('packed floats, every exponent', () => {
  const next = random(11);
  const words = Uint32Array.from({ length: 4096 }, () => Math.floor(next() * 2 ** 32));
  const unpack = {
    e5b9g9r9: (word) => [0, 9, 18].map((shift) => ((word >>> shift) & 511) * 2 ** ((word >>> 27) - 24)),
    b10g11r11: (word) => [smallFloat(word & 2047, 6), smallFloat((word >>> 11) & 2047, 6), smallFloat(word >>> 22, 5)],
  };
  for (const [name, numbers] of Object.entries(unpack)) {
    const finite = words.filter((word) => name === 'e5b9g9r9' || numbers(word).every((value) => value < 65536));
    assert.ok(finite.length > 3000);
    const file = ktx2File({
      width: 16,
      height: finite.length >> 4,
      levels: [Buffer.from(finite.buffer, 0, (finite.length >> 4) * 64)],
      vkFormat: RAW_FORMATS[name].vkFormat,
      model: 1,
    });
    const expected = [...finite.subarray(0, (finite.length >> 4) * 16)].flatMap((word) => [...numbers(word), 1]);
    assert.deepEqual(numbersOf(decoded(file)), expected);
  }
});

test('real files', { skip: !existsSync(SHARED) && 'no ../shared/models' }, async () => {
  for (const name of ['2d_etc1s', '2d_uastc', 'playcanvas', 'test']) await checkEqual(readFileSync(join(SHARED, `${name}.ktx2`)), name);
  for (const name of ['2d_rgba8', '2d_rgba16_linear', '2d_rgba32_linear']) assert.equal(decoded(readFileSync(join(SHARED, `${name}.ktx2`))).levels.length, 6);
  assert.throws(() => decoded(readFileSync(join(SHARED, '2d_rgb8.ktx2'))), /is in the format RGB8/);
});
