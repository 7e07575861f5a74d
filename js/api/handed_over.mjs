/**
 * Bytes that their owner will not write to again, so that nobody has to copy them, with their SHA-256 where it is known. By their memory: views of it come
 * and go.
 */
const known = new WeakMap();

/**
 * @param {Uint8Array} bytes in memory that is not shared with another thread
 * @param {string} [sha256] hex
 * @returns {Uint8Array} the same
 */
export function handOver(bytes, sha256) {
  known.set(bytes.buffer, { at: bytes.byteOffset, length: bytes.byteLength, sha256 });
  return bytes;
}

function factsOf({ buffer, byteOffset, byteLength }) {
  const facts = known.get(buffer);
  return facts?.at === byteOffset && facts.length === byteLength ? facts : undefined;
}

export const isHandedOver = (bytes) => factsOf(bytes) !== undefined;

/** @returns {string | undefined} */
export const knownDigest = (bytes) => factsOf(bytes)?.sha256;
