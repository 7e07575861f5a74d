/** A glTF file as bytes, that telar has loaded before: its JSON with new accessors, everything else as it is. */

const MAGIC = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;
const BIN_CHUNK = 0x004e4942;
const HEADER_BYTES = 12;
const CHUNK_HEADER_BYTES = 8;
const ALIGNMENT = 4;

const SHORT = 5122;
const ARRAY_BUFFER = 34962;

export class GltfFile {
  #isBinary;
  #bin;
  #added = [];
  #addedBytes = 0;
  #buffer;
  #start;
  #growsBin;

  /** @param {Buffer} bytes of a .glb or .gltf file */
  constructor(bytes) {
    this.#isBinary = bytes.length >= HEADER_BYTES && bytes.readUInt32LE(0) === MAGIC;
    if (!this.#isBinary) this.document = JSON.parse(bytes.toString('utf8'));
    else {
      for (const { type, data } of chunksOf(bytes)) {
        if (type === JSON_CHUNK) this.document ??= JSON.parse(data.toString('utf8'));
        if (type === BIN_CHUNK) this.#bin ??= data;
      }
    }
    // The file's own bytes grow where it is a GLB that has some; else the new ones are a buffer of their own.
    const buffers = (this.document.buffers ??= []);
    this.#growsBin = this.#isBinary && this.#bin !== undefined && buffers.length > 0 && buffers[0].uri === undefined;
    this.#buffer = this.#growsBin ? 0 : buffers.length;
    this.#start = this.#growsBin ? aligned(buffers[0].byteLength) : 0;
  }

  /** "glb" or "gltf". */
  get format() {
    return this.#isBinary ? 'glb' : 'gltf';
  }

  /** Relative references to files beside it. */
  get parts() {
    const { buffers = [], images = [] } = this.document;
    return [...buffers, ...images].map(({ uri }) => uri).filter((uri) => typeof uri === 'string' && !/^data:/i.test(uri));
  }

  /**
   * A VEC4 of normalized shorts for each vertex.
   * @param {Buffer} shorts 8 bytes a vertex
   * @returns {number} index of the accessor
   */
  addShorts(shorts) {
    const { bufferViews = [], accessors = [] } = this.document;
    Object.assign(this.document, { bufferViews, accessors });
    const byteOffset = this.#start + this.#addedBytes;
    bufferViews.push({ buffer: this.#buffer, byteOffset, byteLength: shorts.length, target: ARRAY_BUFFER });
    accessors.push({ bufferView: bufferViews.length - 1, componentType: SHORT, normalized: true, count: shorts.length / 8, type: 'VEC4' });
    this.#added.push(shorts);
    this.#addedBytes += shorts.length;
    return accessors.length - 1;
  }

  /** @returns {Buffer} The file with what was added. */
  bytes() {
    const added = Buffer.concat(this.#added);
    const { buffers } = this.document;
    if (added.length > 0 && this.#growsBin) {
      const own = this.#bin.subarray(0, buffers[0].byteLength);
      this.#bin = Buffer.concat([own, Buffer.alloc(this.#start - own.length), added]);
      buffers[0] = { ...buffers[0], byteLength: this.#bin.length };
    } else if (added.length > 0) {
      buffers.push({ byteLength: added.length, uri: `data:application/octet-stream;base64,${added.toString('base64')}` });
    }
    const json = Buffer.from(JSON.stringify(this.document));
    return this.#isBinary ? glbOf(json, this.#bin) : json;
  }
}

const aligned = (length) => Math.ceil(length / ALIGNMENT) * ALIGNMENT;

function* chunksOf(bytes) {
  for (let at = HEADER_BYTES; at + CHUNK_HEADER_BYTES <= bytes.length; ) {
    const length = bytes.readUInt32LE(at);
    const data = at + CHUNK_HEADER_BYTES;
    yield { type: bytes.readUInt32LE(at + 4), data: bytes.subarray(data, data + length) };
    at = data + aligned(length);
  }
}

function glbOf(json, bin) {
  const chunks = [chunk(JSON_CHUNK, json, ' '), ...(bin ? [chunk(BIN_CHUNK, bin, '\0')] : [])];
  const header = Buffer.alloc(HEADER_BYTES);
  header.writeUInt32LE(MAGIC, 0);
  header.writeUInt32LE(2, 4);
  header.writeUInt32LE(HEADER_BYTES + chunks.reduce((sum, { length }) => sum + length, 0), 8);
  return Buffer.concat([header, ...chunks]);
}

function chunk(type, data, filler) {
  const header = Buffer.alloc(CHUNK_HEADER_BYTES);
  header.writeUInt32LE(aligned(data.length), 0);
  header.writeUInt32LE(type, 4);
  return Buffer.concat([header, data, Buffer.alloc(aligned(data.length) - data.length, filler)]);
}
