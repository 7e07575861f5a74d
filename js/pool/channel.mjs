/** Bytes of a number in a frame. */
const U32 = 4;
/** More byte strings than any job has. */
const MOST_PARTS = 65_536;

/** Frames of more bytes than are taken. */
export class TooLarge extends Error {
  constructor(bytes) {
    super('a frame is too large');
    this.bytes = bytes;
  }
}

/**
 * Reads frames: yields how many bytes it needs next, and is given them.
 * @param {() => number | null} most bytes of a frame now
 * @param {(header: Buffer, parts: Buffer[]) => void} take
 */
function* readFrames(most, take) {
  for (;;) {
    const beginning = yield 2 * U32;
    const count = beginning.readUInt32LE(U32);
    if (count > MOST_PARTS) throw new TooLarge(Infinity);
    const list = yield count * U32;
    const lengths = [beginning.readUInt32LE(0), ...Array.from({ length: count }, (_, i) => list.readUInt32LE(i * U32))];
    const bytes = lengths.reduce((sum, each) => sum + each, 0);
    // Before anything is allocated for it.
    if (most() !== null && bytes > most()) throw new TooLarge(bytes);
    const pieces = [];
    for (const length of lengths) pieces.push(yield length);
    const [header, ...parts] = pieces;
    take(header, parts);
  }
}

/**
 * Frames over one stream: a header, and byte strings beside it that are written as they are. Each end writes headers in its own way.
 * A frame is: length of the header, count of the byte strings, the length of each (u32, little endian), the header, the byte strings.
 */
export class Channel {
  /** Bytes that a frame may have; null = any number. */
  maxBytes = null;
  #stream;
  #encode;
  #refuse;
  #reader;
  #piece;
  #filled = 0;

  /**
   * @param {import('node:stream').Duplex} stream
   * @param {object} ends
   * @param {(message: object) => Buffer} ends.encode
   * @param {(header: Buffer) => object} ends.decode
   * @param {(message: object, parts: Buffer[]) => void} ends.take a frame
   * @param {(error: Error) => void} ends.refuse a frame is TooLarge, or decode or take threw; nothing is read any more
   * @param {boolean} [ends.isFed] whoever reads the stream calls read()
   */
  constructor(stream, { encode, decode, take, refuse, isFed = false }) {
    this.#stream = stream;
    this.#encode = encode;
    this.#refuse = refuse;
    this.#reader = readFrames(
      () => this.maxBytes,
      (header, parts) => take(decode(header), parts),
    );
    this.#next();
    if (!isFed) stream.on('data', (chunk) => this.read(chunk));
  }

  /**
   * @param {object} message
   * @param {Uint8Array[]} [parts] not written to until they are sent
   */
  send(message, parts = []) {
    if (!this.#stream.writable) return;
    const header = this.#encode(message);
    const beginning = Buffer.from(Uint32Array.of(header.length, parts.length, ...parts.map(({ byteLength }) => byteLength)).buffer);
    this.#stream.cork();
    for (const bytes of [beginning, header, ...parts]) if (bytes.byteLength > 0) this.#stream.write(bytes);
    this.#stream.uncork();
  }

  /** Ends this side. */
  end() {
    this.#stream.end();
  }

  /** @param {Buffer} chunk what came next; it is copied */
  read(chunk) {
    for (let at = 0; at < chunk.length && this.#piece; ) {
      const copied = chunk.copy(this.#piece, this.#filled, at);
      at += copied;
      this.#filled += copied;
      if (this.#filled === this.#piece.length) this.#next(this.#piece);
    }
  }

  /** Hands a piece over and makes room for the next one that has bytes. */
  #next(piece) {
    try {
      let length = this.#reader.next(piece).value;
      while (length === 0) length = this.#reader.next(Buffer.alloc(0)).value;
      this.#piece = Buffer.allocUnsafeSlow(length);
      this.#filled = 0;
    } catch (error) {
      this.#piece = undefined;
      this.#refuse(error);
    }
  }
}
