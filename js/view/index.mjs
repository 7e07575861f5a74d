import { fileURLToPath } from 'node:url';
import { Session } from './session.mjs';
import { startServer } from './server.mjs';

/**
 * Opens the view of a model: its page on this machine, drawn by `renderer`.
 * @param {object} options
 * @param {object} options.renderer of createRenderer; stays the caller's to close
 * @param {string | Uint8Array} options.source path or file: URL of a .glb or .gltf, or bytes of a GLB
 * @param {object} options.shot where the page begins; not resolved
 * @param {number} [options.port=0] 0 = a free one
 * @param {AbortSignal} [options.signal] of the loading
 * @returns {Promise<{url: string, port: number, close: () => Promise<void>}>}
 * @throws {import('../error/index.mjs').TelarError} what loading throws; E_SHOT; X_INSTALL, X_PORT
 */
export async function openView({ renderer, source, shot, port, signal }) {
  const isUrl = typeof source === 'string' && source.startsWith('file:');
  const session = new Session({ renderer, source: isUrl ? fileURLToPath(source) : source, shot });
  await session.load(signal);
  await session.check();
  return startServer({ session, port });
}
