import { fileURLToPath } from 'node:url';
import { Session } from './session.mjs';
import { startServer } from './server.mjs';
import { SpecFile } from './spec_file.mjs';
import { openThree } from './three_folder.mjs';

/**
 * Opens the view of a model: its page on this machine, drawn by `renderer`.
 * @param {object} options
 * @param {object} options.renderer of createRenderer; stays the caller's to close
 * @param {string | Uint8Array} options.source path or file: URL of a .glb or .gltf, or bytes of a GLB
 * @param {object} options.shot where the page begins; not resolved
 * @param {{name: string, read: () => Promise<Uint8Array | undefined>, write: (bytes: Uint8Array) => Promise<void>}} [options.spec] file of
 *   a tech sheet's spec, which the page edits; `read` gives undefined where there is none yet, and the model then makes a first one
 * @param {number} [options.port=0] 0 = a free one
 * @param {string} [options.three] folder of the three.js that draws the page's pictures, 0.150 or later; the bundled one where it is
 *   left out. A shot without a shading gets its release.
 * @param {AbortSignal} [options.signal] of the loading
 * @returns {Promise<{url: string, port: number, close: () => Promise<void>}>}
 * @throws {import('../error/index.mjs').TelarError} what loading throws; E_SHOT; E_SPEC; E_USAGE; X_INSTALL, X_PORT
 */
export async function openView({ renderer, source, shot: given, spec, port, three: folder, signal }) {
  const three = folder === undefined ? undefined : openThree(folder);
  const shot = three && given.shading === undefined ? { ...given, shading: { base: 'three', revision: three.revision } } : given;
  const isUrl = typeof source === 'string' && source.startsWith('file:');
  const session = new Session({ renderer, source: isUrl ? fileURLToPath(source) : source, shot, spec: spec && new SpecFile(spec) });
  await session.load(signal);
  await session.check();
  if (spec) await session.describeSpec();
  return startServer({ session, port, three });
}
