import { checkObject, wrongOption } from './options.mjs';

/**
 * An animated WebP file out of still ones: their compressed pictures stay as they are, so that no frame loses anything.
 * src: RFC 9649 (2024), "WebP Image Format", sections 2.5 to 2.7
 */

/** Longest time of a frame: 24 bits. */
const MILLISECONDS_MAX = 2 ** 24 - 1;

const ANIMATION = 0x02;
const ALPHA = 0x10;
/** A frame replaces what was there before, rather than be blended with it. */
const NO_BLEND = 0x02;

/** Least bytes of chunks that tell the size. */
const HEADER_BYTES = { VP8X: 10, 'VP8 ': 10, VP8L: 5 };

/** Chunks that hold a picture; others (profile, metadata) are left out. */
const PICTURE = ['ALPH', 'VP8 ', 'VP8L'];

function chunk(name, data) {
  const head = Buffer.alloc(8);
  head.write(name, 'latin1');
  head.writeUInt32LE(data.length, 4);
  return Buffer.concat([head, data, Buffer.alloc(data.length % 2)]);
}

/** The chunks of a still file. @returns {{name: string, data: Buffer}[]} */
function chunksOf(file, index) {
  const bytes = Buffer.from(file.buffer, file.byteOffset, file.byteLength);
  const isWebp = bytes.length >= 12 && bytes.toString('latin1', 0, 4) === 'RIFF' && bytes.toString('latin1', 8, 12) === 'WEBP';
  if (!isWebp) throw wrongOption(`frames[${index}]`, 'a WebP file', 'other bytes');
  const chunks = [];
  for (let at = 12; at + 8 <= bytes.length; ) {
    const size = bytes.readUInt32LE(at + 4);
    if (at + 8 + size > bytes.length) throw wrongOption(`frames[${index}]`, 'a whole WebP file', `${bytes.length} bytes`);
    chunks.push({ name: bytes.toString('latin1', at, at + 4), data: bytes.subarray(at + 8, at + 8 + size) });
    at += 8 + size + (size % 2);
  }
  return chunks;
}

/** Width and height of a picture, and whether it has transparency. */
function headerOf(chunks, index) {
  const dataOf = (wanted) => chunks.find(({ name, data }) => name === wanted && data.length >= HEADER_BYTES[wanted])?.data;
  const [extended, lossy, lossless] = ['VP8X', 'VP8 ', 'VP8L'].map(dataOf);
  // An animation has its pictures within chunks of frames.
  if (!lossy && !lossless) throw wrongOption(`frames[${index}]`, 'a still WebP picture', 'a file without one');
  if (extended) return { width: 1 + extended.readUIntLE(4, 3), height: 1 + extended.readUIntLE(7, 3), alpha: (extended[0] & ALPHA) !== 0 };
  if (lossy) return { width: lossy.readUInt16LE(6) & 0x3fff, height: lossy.readUInt16LE(8) & 0x3fff, alpha: false };
  const bits = lossless.readUInt32LE(1);
  return { width: 1 + (bits & 0x3fff), height: 1 + ((bits >>> 14) & 0x3fff), alpha: ((bits >>> 28) & 1) !== 0 };
}

function frameOf({ chunks, header }, milliseconds) {
  const head = Buffer.alloc(16);
  head.writeUIntLE(header.width - 1, 6, 3);
  head.writeUIntLE(header.height - 1, 9, 3);
  head.writeUIntLE(milliseconds, 12, 3);
  head[15] = NO_BLEND;
  const picture = chunks.filter(({ name }) => PICTURE.includes(name));
  return chunk('ANMF', Buffer.concat([head, ...picture.map(({ name, data }) => chunk(name, data))]));
}

/** Documented in js/api/animated_webp.d.ts. */
export function animateWebp(frames, options = {}) {
  checkObject('options', options, ['frameMs', 'loops']);
  const { frameMs = 100, loops = 0 } = options;
  if (!Array.isArray(frames) || frames.length === 0) throw wrongOption('frames', 'a list of WebP files', frames);
  const isWhole = (x, max) => Number.isInteger(x) && x >= 0 && x <= max;
  if (!isWhole(frameMs, MILLISECONDS_MAX)) throw wrongOption('options.frameMs', `whole milliseconds from 0 to ${MILLISECONDS_MAX}`, frameMs);
  if (!isWhole(loops, 65535)) throw wrongOption('options.loops', 'a whole number from 0 to 65535', loops);
  const read = frames.map((file, i) => {
    if (!(file instanceof Uint8Array)) throw wrongOption(`frames[${i}]`, 'bytes', file);
    const chunks = chunksOf(file, i);
    return { chunks, header: headerOf(chunks, i) };
  });
  const [{ header: first }] = read;
  read.forEach(({ header: { width, height } }, i) => {
    if (width !== first.width || height !== first.height)
      throw wrongOption(`frames[${i}]`, `${first.width} x ${first.height} pixels, as the first frame`, `${width} x ${height}`);
  });
  const extended = Buffer.alloc(10);
  extended[0] = ANIMATION | (read.some(({ header }) => header.alpha) ? ALPHA : 0);
  extended.writeUIntLE(first.width - 1, 4, 3);
  extended.writeUIntLE(first.height - 1, 7, 3);
  const animation = Buffer.alloc(6);
  animation.writeUInt16LE(loops, 4);
  const body = Buffer.concat([
    Buffer.from('WEBP', 'latin1'),
    chunk('VP8X', extended),
    chunk('ANIM', animation),
    ...read.map((frame) => frameOf(frame, frameMs)),
  ]);
  return chunk('RIFF', body);
}
