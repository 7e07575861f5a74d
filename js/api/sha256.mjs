import { createRequire } from 'node:module';

const require = createRequire(import.meta.url);

/**
 * SHA-256. The addon hashes a text where it is there, and node:crypto is loaded where it is needed: that takes 5 ms, of a process that draws one picture.
 * @param {string | Uint8Array} data
 * @param {{hashText(text: string): string}} [native]
 * @returns {string} 64 hex digits
 */
export function sha256(data, native) {
  if (native && typeof data === 'string') return native.hashText(data);
  return require('node:crypto').createHash('sha256').update(data).digest('hex');
}
