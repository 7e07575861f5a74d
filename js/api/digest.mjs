import { knownDigest } from './handed_over.mjs';

/** JSON with the keys of every object in order. */
export const canonical = (value) =>
  JSON.stringify(value, (_, item) =>
    typeof item === 'object' && item !== null && !Array.isArray(item) ? Object.fromEntries(Object.entries(item).sort(([a], [b]) => (a < b ? -1 : 1))) : item,
  );

/** SHA-256, on another thread than the event loop's. @returns {Promise<string>} hex */
export async function digestOf(bytes) {
  const known = knownDigest(bytes);
  if (known) return known;
  // WebCrypto reads no shared memory.
  const own = bytes.buffer instanceof SharedArrayBuffer ? Uint8Array.from(bytes) : bytes;
  return Buffer.from(await crypto.subtle.digest('SHA-256', own)).toString('hex');
}
