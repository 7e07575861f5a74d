// Small valid models that the hostile cases start from: one textured, indexed quad. Deterministic.
import { crc32, deflateSync } from './png_parts.mjs';

const FLOAT = 5126;
const USHORT = 5123;

/** Pads to a multiple of 4. */
export const padded = (buffer, fill = 0) => Buffer.concat([buffer, Buffer.alloc((4 - (buffer.length % 4)) % 4, fill)]);

export const u32 = (...values) => Buffer.from(Uint32Array.from(values).buffer);
export const floats = (...values) => Buffer.from(Float32Array.from(values).buffer);
export const ushorts = (...values) => Buffer.from(Uint16Array.from(values).buffer);

/** One PNG chunk. */
export function pngChunk(type, data, crc) {
  const body = Buffer.concat([Buffer.from(type, 'latin1'), data]);
  const out = Buffer.alloc(8 + data.length + 4);
  out.writeUInt32BE(data.length, 0);
  body.copy(out, 4);
  out.writeUInt32BE(crc ?? crc32(body), 8 + data.length);
  return out;
}

export function pngHeader(width, height, depth = 8, colorType = 6) {
  const data = Buffer.alloc(13);
  data.writeUInt32BE(width, 0);
  data.writeUInt32BE(height, 4);
  data.set([depth, colorType, 0, 0, 0], 8);
  return pngChunk('IHDR', data);
}

export const PNG_MAGIC = Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]);

/** A grey RGBA PNG. */
export function png(width = 4, height = 4) {
  const row = Buffer.concat([Buffer.of(0), Buffer.alloc(width * 4, 0x80)]);
  const pixels = deflateSync(Buffer.concat(Array.from({ length: height }, () => row)));
  return Buffer.concat([PNG_MAGIC, pngHeader(width, height), pngChunk('IDAT', pixels), pngChunk('IEND', Buffer.alloc(0))]);
}

/**
 * A model as an editable document and its binary buffer. Accessors: 0 POSITION, 1 TEXCOORD_0, 2 indices; view 3 is the
 * image.
 * @param {{image?: Buffer}} [options]
 */
export function quad({ image = png() } = {}) {
  const parts = [floats(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0), floats(0, 0, 1, 0, 1, 1, 0, 1), ushorts(0, 1, 2, 0, 2, 3), image];
  const doc = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, TEXCOORD_0: 1 }, indices: 2, material: 0 }] }],
    materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }],
    textures: [{ source: 0 }],
    images: [{ bufferView: 3, mimeType: 'image/png' }],
    accessors: [
      { bufferView: 0, componentType: FLOAT, count: 4, type: 'VEC3', min: [0, 0, 0], max: [1, 1, 0] },
      { bufferView: 1, componentType: FLOAT, count: 4, type: 'VEC2' },
      { bufferView: 2, componentType: USHORT, count: 6, type: 'SCALAR' },
    ],
    bufferViews: [],
    buffers: [],
  };
  const model = { doc, bin: Buffer.alloc(0) };
  for (const part of parts) addView(model, part);
  return model;
}

/** Appends bytes and a buffer view on them; returns the view's index. */
export function addView(model, bytes) {
  model.bin = padded(model.bin);
  model.doc.bufferViews.push({ buffer: 0, byteOffset: model.bin.length, byteLength: bytes.length });
  model.bin = Buffer.concat([model.bin, bytes]);
  model.doc.buffers = [{ byteLength: model.bin.length }];
  return model.doc.bufferViews.length - 1;
}

export const chunk = (type, data) => Buffer.concat([u32(data.length), Buffer.from(type, 'latin1'), data]);

export function container(...chunks) {
  const body = Buffer.concat(chunks);
  return Buffer.concat([Buffer.from('glTF'), u32(2, 12 + body.length), body]);
}

/** @param {string} [text] the JSON, when it is not model.doc as it is */
export const glb = ({ doc, bin }, text = JSON.stringify(doc)) => container(chunk('JSON', padded(Buffer.from(text), 0x20)), chunk('BIN\0', padded(bin)));

/** Text glTF whose buffer is at `uri`; by default a data: URI. */
export const gltf = ({ doc, bin }, uri = `data:application/octet-stream;base64,${bin.toString('base64')}`) =>
  Buffer.from(JSON.stringify({ ...doc, buffers: [{ byteLength: bin.length, uri }] }));
