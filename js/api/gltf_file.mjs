/** A glTF file as bytes, that telar has loaded before: its JSON with new accessors, everything else as it is. */

const MAGIC = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;
const BIN_CHUNK = 0x004e4942;
const HEADER_BYTES = 12;
const CHUNK_HEADER_BYTES = 8;
const ALIGNMENT = 4;

const DATA_URI = 'data:application/octet-stream;base64,';
const SHORT = 5122;
/** An accessor of normalized shorts, and its bytes an element. */
const SHORTS = { componentType: SHORT, normalized: true, type: 'VEC4' };
const SHORTS_BYTES = 8;
const ARRAY_BUFFER = 34962;

export class GltfFile {
  #isBinary;
  #bin;
  /** Chunks of other types, as they are. */
  #others = [];
  #added = [];
  #addedBytes = 0;
  #buffer;
  #start;
  #growsBin;
  /** Accessors that were written again. */
  #again = new Set();
  /** Bytes of buffers of data: URIs that were written again, by index. */
  #decoded = new Map();

  /** @param {Buffer} bytes of a .glb or .gltf file */
  constructor(bytes) {
    this.#isBinary = bytes.length >= HEADER_BYTES && bytes.readUInt32LE(0) === MAGIC;
    if (!this.#isBinary) this.document = JSON.parse(bytes.toString('utf8'));
    else {
      for (const { type, data } of chunksOf(bytes)) {
        if (type === JSON_CHUNK) this.document ??= JSON.parse(data.toString('utf8'));
        else if (type === BIN_CHUNK) this.#bin ??= data;
        else this.#others.push(chunk(type, data, '\0'));
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
   * @param {number} [earlier] accessor of an earlier bake: its bytes are used again where they can be, so that a file does not grow with each
   * @returns {number} index of the accessor
   */
  addShorts(shorts, earlier) {
    const place = this.#placeOf(earlier, shorts.length);
    if (place) {
      shorts.copy(place);
      this.#again.add(earlier);
      return earlier;
    }
    const { bufferViews = [], accessors = [] } = this.document;
    Object.assign(this.document, { bufferViews, accessors });
    const byteOffset = this.#start + this.#addedBytes;
    bufferViews.push({ buffer: this.#buffer, byteOffset, byteLength: shorts.length, target: ARRAY_BUFFER });
    accessors.push({ bufferView: bufferViews.length - 1, ...SHORTS, count: shorts.length / SHORTS_BYTES });
    this.#added.push(shorts);
    this.#addedBytes += shorts.length;
    return accessors.length - 1;
  }

  /** Bytes of an accessor as this class writes it, which hold these alone. @returns {Buffer | undefined} */
  #placeOf(index, length) {
    const { bufferView, count, byteOffset = 0, ...kind } = this.document.accessors?.[index] ?? {};
    const view = this.document.bufferViews?.[bufferView];
    const isOurs = JSON.stringify(kind) === JSON.stringify(SHORTS) && view && view.byteStride === undefined && view.extensions === undefined;
    if (!isOurs || count * SHORTS_BYTES !== length || this.#again.has(index)) return undefined;
    const from = (view.byteOffset ?? 0) + byteOffset;
    return this.#bytesOf(view.buffer)?.subarray(from, from + length);
  }

  /** Of a buffer within the file. @returns {Buffer | undefined} */
  #bytesOf(index) {
    if (this.#growsBin && index === 0) return this.#bin;
    const { uri } = this.document.buffers[index];
    if (!this.#decoded.has(index) && uri?.startsWith(DATA_URI)) this.#decoded.set(index, Buffer.from(uri.slice(DATA_URI.length), 'base64'));
    return this.#decoded.get(index);
  }

  /** @returns {Buffer} The file with what was added. */
  bytes() {
    const added = Buffer.concat(this.#added);
    const { buffers } = this.document;
    for (const [index, bytes] of this.#decoded) buffers[index].uri = DATA_URI + bytes.toString('base64');
    if (added.length > 0 && this.#growsBin) {
      const own = this.#bin.subarray(0, buffers[0].byteLength);
      this.#bin = Buffer.concat([own, Buffer.alloc(this.#start - own.length), added]);
      buffers[0] = { ...buffers[0], byteLength: this.#bin.length };
    } else if (added.length > 0) {
      buffers.push({ byteLength: added.length, uri: DATA_URI + added.toString('base64') });
    }
    const json = Buffer.from(JSON.stringify(this.document));
    return this.#isBinary ? glbOf(json, this.#bin, this.#others) : json;
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

function glbOf(json, bin, others) {
  const chunks = [chunk(JSON_CHUNK, json, ' '), ...(bin ? [chunk(BIN_CHUNK, bin, '\0')] : []), ...others];
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
