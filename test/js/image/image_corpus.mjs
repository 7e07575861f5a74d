import { crc32, deflateSync } from 'node:zlib';
import sharp from 'sharp';

const WIDTH = 53;
const HEIGHT = 37;

/** Noise that is the same in every run. */
function noise(length, seed = 1) {
  const bytes = Buffer.alloc(length);
  let state = seed;
  for (let i = 0; i < length; i++) {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    bytes[i] = state >>> 24;
  }
  return bytes;
}

/** RGBA picture of smooth slopes, hard edges, some noise, alpha from 0 to 255. */
function picture(channels) {
  const grain = noise(WIDTH * HEIGHT * channels);
  const bytes = Buffer.alloc(WIDTH * HEIGHT * channels);
  for (let y = 0; y < HEIGHT; y++) {
    for (let x = 0; x < WIDTH; x++) {
      const checks = (((x >> 3) + (y >> 3)) % 2) * 255;
      const smooth = [(x * 255) / WIDTH, (y * 255) / HEIGHT, checks, ((x + y) * 255) / (WIDTH + HEIGHT)];
      for (let c = 0; c < channels; c++) {
        const i = (y * WIDTH + x) * channels + c;
        bytes[i] = Math.min(255, Math.max(0, smooth[channels < 3 && c === channels - 1 && c ? 3 : c] + grain[i] / 16));
      }
    }
  }
  return bytes;
}

function chunk(type, data) {
  const body = Buffer.concat([Buffer.from(type, 'latin1'), data]);
  const frame = Buffer.alloc(8);
  frame.writeUInt32BE(data.length, 0);
  frame.writeUInt32BE(crc32(body), 4);
  return Buffer.concat([frame.subarray(0, 4), body, frame.subarray(4)]);
}

const CHANNELS = { 0: 1, 2: 3, 3: 1, 4: 2, 6: 4 };

/** A PNG of noise in any colour type and bit depth, which encoders seldom offer; `extra` chunks go before IDAT. */
function noisePng(colorType, bitDepth, extra = []) {
  const rowBytes = Math.ceil((WIDTH * CHANNELS[colorType] * bitDepth) / 8);
  const rows = noise((rowBytes + 1) * HEIGHT, colorType * 16 + bitDepth);
  for (let y = 0; y < HEIGHT; y++) rows[y * (rowBytes + 1)] = y % 5; // every filter
  const header = Buffer.alloc(13);
  header.writeUInt32BE(WIDTH, 0);
  header.writeUInt32BE(HEIGHT, 4);
  header.set([bitDepth, colorType, 0, 0, 0], 8);
  return Buffer.concat([
    Buffer.from('\x89PNG\r\n\x1a\n', 'latin1'),
    chunk('IHDR', header),
    ...extra,
    chunk('IDAT', deflateSync(rows)),
    chunk('IEND', Buffer.alloc(0)),
  ]);
}

function pngs() {
  const list = [];
  const depths = { 0: [1, 2, 4, 8, 16], 2: [8, 16], 3: [1, 2, 4, 8], 4: [8, 16], 6: [8, 16] };
  for (const colorType of [0, 2, 3, 4, 6]) {
    for (const depth of depths[colorType]) {
      const palette = colorType === 3 ? [chunk('PLTE', noise(3 << depth, 7))] : [];
      list.push([`png type ${colorType} depth ${depth}`, noisePng(colorType, depth, palette)]);
    }
  }
  const word = (...values) => Buffer.from(values.flatMap((v) => [v >> 8, v & 255]));
  list.push(['png palette with tRNS', noisePng(3, 8, [chunk('PLTE', noise(768, 7)), chunk('tRNS', noise(200, 9))])]);
  list.push(['png grey 4 bit with tRNS', noisePng(0, 4, [chunk('tRNS', word(5))])]);
  list.push(['png grey 16 bit with tRNS', noisePng(0, 16, [chunk('tRNS', word(0x1234))])]);
  list.push(['png rgb with tRNS', noisePng(2, 8, [chunk('tRNS', word(1, 2, 3))])]);
  list.push(['png with gAMA', noisePng(2, 8, [chunk('gAMA', Buffer.from([0, 1, 0x86, 0xa0]))])]);
  list.push(['png with sBIT', noisePng(2, 8, [chunk('sBIT', Buffer.from([5, 6, 5]))])]);
  return list;
}

/** A segment of EXIF whose entries of Orientation are these. */
function exif(orientations, fill = 0) {
  const word = (value) => [value >> 8, value & 255];
  const entries = orientations.flatMap((value) => [...word(0x112), ...word(3), 0, 0, 0, 1, ...word(value), 0, 0]);
  const body = [...Buffer.from('Exif\0'), fill, ...Buffer.from('MM\0*'), 0, 0, 0, 8, ...word(orientations.length), ...entries, 0, 0, 0, 0];
  return Buffer.from([0xff, 0xe1, ...word(body.length + 2), ...body]);
}

/** A JPEG with a segment before its first or its last marker of that kind. */
function withSegment(file, segment, marker, last = false) {
  const wanted = Buffer.from([0xff, marker]);
  const place = last ? file.lastIndexOf(wanted) : file.indexOf(wanted);
  return Buffer.concat([file.subarray(0, place), segment, file.subarray(place)]);
}

/** Where browsers look for EXIF, and what of it they take. */
async function jpegsWithExif() {
  const [FRAME, SCAN] = [0xc2, 0xda];
  const file = await raw(3).jpeg({ progressive: true }).toBuffer();
  return [
    ['jpeg EXIF behind the frame header', withSegment(file, exif([6]), SCAN)],
    ['jpeg EXIF between scans', withSegment(file, exif([6]), SCAN, true)],
    ['jpeg EXIF with a filled byte', withSegment(file, exif([6], 255), FRAME)],
    ['jpeg EXIF with an orientation of 0 before another', withSegment(file, exif([0, 6]), FRAME)],
  ];
}

const raw = (channels) => sharp(picture(channels), { raw: { width: WIDTH, height: HEIGHT, channels } });

async function fromSharp() {
  const list = [];
  const add = async (name, image) => list.push([name, await image.toBuffer()]);
  await add('png interlaced rgba', raw(4).png({ progressive: true }));
  await add('png with ICC profile', raw(3).withIccProfile('p3').png());
  await add('jpeg 4:2:0', raw(3).jpeg({ quality: 80 }));
  await add('jpeg 4:4:4', raw(3).jpeg({ quality: 95, chromaSubsampling: '4:4:4' }));
  await add('jpeg quality 20', raw(3).jpeg({ quality: 20 }));
  await add('jpeg progressive', raw(3).jpeg({ progressive: true }));
  await add('jpeg progressive 4:4:4', raw(3).jpeg({ progressive: true, chromaSubsampling: '4:4:4' }));
  await add('jpeg grey', raw(1).toColourspace('b-w').jpeg());
  await add('jpeg with ICC profile', raw(3).withIccProfile('p3').jpeg());
  for (let orientation = 2; orientation <= 8; orientation++) {
    await add(`jpeg EXIF orientation ${orientation}`, raw(3).withMetadata({ orientation }).jpeg());
  }
  await add('png EXIF orientation 6', raw(3).withMetadata({ orientation: 6 }).png());
  await add('webp EXIF orientation 6', raw(3).withMetadata({ orientation: 6 }).webp());
  await add('jpeg CMYK', raw(3).toColourspace('cmyk').jpeg());
  await add('webp lossy', raw(3).webp());
  await add('webp lossy with alpha', raw(4).webp({ quality: 60 }));
  await add('webp lossless', raw(3).webp({ lossless: true }));
  await add('webp lossless with alpha', raw(4).webp({ lossless: true, exact: true }));
  await add('webp with ICC profile', raw(3).withIccProfile('p3').webp());
  return list;
}

/** @returns {Promise<[name: string, file: Buffer][]>} Small images in every form that a texture may have. */
export async function imageCorpus() {
  return [...pngs(), ...(await fromSharp()), ...(await jpegsWithExif())];
}
