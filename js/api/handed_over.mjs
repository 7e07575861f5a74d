/**
 * Bytes that their owner will not write to again, so that nobody has to copy them, with their SHA-256 where it is known. By their memory, since views of it
 * come and go; of each memory by place, since several files may lie in one. @type {WeakMap<ArrayBuffer, Map<string, {sha256?: string}>>}
 */
const known = new WeakMap();

const placeOf = ({ byteOffset, byteLength }) => `${byteOffset}+${byteLength}`;

/**
 * @param {Uint8Array} bytes in memory that is not shared with another thread
 * @param {string} [sha256] hex
 * @returns {Uint8Array} the same
 */
export function handOver(bytes, sha256) {
  const places = known.get(bytes.buffer) ?? new Map();
  known.set(bytes.buffer, places.set(placeOf(bytes), { sha256 }));
  return bytes;
}

const factsOf = (bytes) => known.get(bytes.buffer)?.get(placeOf(bytes));

export const isHandedOver = (bytes) => factsOf(bytes) !== undefined;

/** @returns {string | undefined} */
export const knownDigest = (bytes) => factsOf(bytes)?.sha256;
