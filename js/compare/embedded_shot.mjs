import { TelarError } from '../error/index.mjs';

/**
 * The shot inside the picture that shows it: an international text chunk (iTXt) of a PNG, uncompressed JSON. So a
 * screenshot says by itself what was drawn. Runs in browsers and in Node.
 */

/** Keyword of the chunk. */
export const SHOT_KEYWORD = 'telar:shot';

/** The JSON of a shot is a few kilobytes; more is not one. */
export const MAX_SHOT_BYTES = 1 << 20;

const SIGNATURE = [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a];

/** Bytes of a chunk beside its data: length, type, CRC. */
const CHUNK_OVERHEAD = 12;

/** CRC-32 (polynomial 0xedb88320) of each byte, as PNG uses it. */
const CRC_TABLE = Uint32Array.from({ length: 256 }, (_, byte) => {
  let crc = byte;
  for (let bit = 0; bit < 8; bit++) crc = crc & 1 ? (crc >>> 1) ^ 0xedb88320 : crc >>> 1;
  return crc;
});

function crc32(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) crc = CRC_TABLE[(crc ^ byte) & 0xff] ^ (crc >>> 8);
  return ~crc >>> 0;
}

const isPng = (bytes) => bytes.length > SIGNATURE.length && SIGNATURE.every((byte, i) => bytes[i] === byte);

const corrupt = (message) => new TelarError('E_IMAGE_CORRUPT', `${message}; save the picture again`);

/** Chunks of a PNG: [{type, start, end, data}], `start` to `end` being the whole chunk. */
function* chunks(png) {
  const view = new DataView(png.buffer, png.byteOffset, png.byteLength);
  for (let start = SIGNATURE.length; start < png.length; ) {
    const length = start + CHUNK_OVERHEAD <= png.length ? view.getUint32(start) : Infinity;
    const end = start + CHUNK_OVERHEAD + length;
    if (end > png.length) throw corrupt('the PNG ends within a chunk');
    const type = String.fromCharCode(...png.subarray(start + 4, start + 8));
    yield { type, start, end, data: png.subarray(start + 8, end - 4) };
    start = end;
  }
}

const HEADER = new TextEncoder().encode(SHOT_KEYWORD);

/** Keyword, and a zero byte after it. */
const isShotChunk = ({ type, data }) => type === 'iTXt' && HEADER.every((byte, i) => data[i] === byte) && data[HEADER.length] === 0;

/** Text of an iTXt chunk: after keyword, compression flag and method, language and translated keyword. */
function textOf(data) {
  const flags = HEADER.length + 1;
  if (data[flags] !== 0) throw corrupt('the shot in the PNG is compressed, which telar never writes');
  const language = data.indexOf(0, flags + 2);
  const keyword = language < 0 ? -1 : data.indexOf(0, language + 1);
  if (keyword < 0) throw corrupt('the shot in the PNG is cut');
  if (data.length - keyword - 1 > MAX_SHOT_BYTES) throw corrupt(`the shot in the PNG has more than ${MAX_SHOT_BYTES} bytes`);
  return new TextDecoder().decode(data.subarray(keyword + 1));
}

function shotChunk(shot) {
  const text = new TextEncoder().encode(JSON.stringify(shot));
  if (text.length > MAX_SHOT_BYTES) throw new TelarError('E_SHOT', `shot: expected JSON of at most ${MAX_SHOT_BYTES} bytes, got ${text.length}`);
  // After the keyword's zero: not compressed, method 0, no language, no translated keyword.
  const data = new Uint8Array([...HEADER, 0, 0, 0, 0, 0, ...text]);
  const chunk = new Uint8Array(CHUNK_OVERHEAD + data.length);
  const view = new DataView(chunk.buffer);
  view.setUint32(0, data.length);
  chunk.set(new TextEncoder().encode('iTXt'), 4);
  chunk.set(data, 8);
  view.setUint32(8 + data.length, crc32(chunk.subarray(4, 8 + data.length)));
  return chunk;
}

/**
 * A copy of a PNG file with the shot that it shows inside, in place of one that it has.
 * @param {Uint8Array} png the file's bytes
 * @param {object} shot what resolveShot takes: plain JSON
 * @returns {Uint8Array}
 * @throws {TelarError} E_IMAGE_FORMAT for what is no PNG, E_IMAGE_CORRUPT for a cut one, E_SHOT for a shot above 1 MiB
 */
export function embedShot(png, shot) {
  if (!isPng(png)) throw new TelarError('E_IMAGE_FORMAT', 'a shot can be saved in a PNG only');
  const added = shotChunk(shot);
  const parts = [png.subarray(0, SIGNATURE.length)];
  for (const chunk of chunks(png)) {
    if (isShotChunk(chunk)) continue;
    parts.push(png.subarray(chunk.start, chunk.end));
    if (chunk.type === 'IHDR') parts.push(added);
  }
  const result = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let offset = 0;
  for (const part of parts) {
    result.set(part, offset);
    offset += part.length;
  }
  return result;
}

/**
 * The shot inside a picture.
 * @param {Uint8Array} bytes of an image file
 * @returns {object | null} as it was embedded, unchecked: resolveShot judges it; null where there is none, or no PNG
 * @throws {TelarError} E_IMAGE_CORRUPT for a cut PNG or a damaged shot
 */
export function readEmbeddedShot(bytes) {
  if (!isPng(bytes)) return null;
  for (const chunk of chunks(bytes)) {
    if (!isShotChunk(chunk)) continue;
    const crc = new DataView(bytes.buffer, bytes.byteOffset + chunk.end - 4, 4).getUint32(0);
    if (crc !== crc32(bytes.subarray(chunk.start + 4, chunk.end - 4))) throw corrupt('the shot in the PNG is damaged');
    return parsed(textOf(chunk.data));
  }
  return null;
}

function parsed(text) {
  let shot;
  try {
    shot = JSON.parse(text);
  } catch (cause) {
    throw new TelarError('E_IMAGE_CORRUPT', 'the shot in the PNG is not JSON; save the picture again', { cause });
  }
  if (typeof shot !== 'object' || shot === null || Array.isArray(shot)) throw corrupt('the shot in the PNG is no JSON object');
  return shot;
}
