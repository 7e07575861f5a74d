import { open, readFile, realpath, stat } from 'node:fs/promises';
import path from 'node:path';

const GLB_MAGIC = 0x46546c67;
const GLB_HEADER_BYTES = 20;

/**
 * The glTF JSON of a .glb or .gltf file. Nothing in it is checked, unless telar has loaded the file before.
 * @param {string} file that is a regular one
 * @throws {Error} where it cannot be read, or holds no JSON
 */
export async function readDocument(file) {
  const handle = await open(file);
  try {
    const header = Buffer.alloc(GLB_HEADER_BYTES);
    const { bytesRead } = await handle.read(header, 0, GLB_HEADER_BYTES, 0);
    if (bytesRead < GLB_HEADER_BYTES || header.readUInt32LE(0) !== GLB_MAGIC) return JSON.parse(await readFile(file, 'utf8'));
    const { size } = await handle.stat();
    const chunk = Buffer.alloc(Math.min(header.readUInt32LE(12), size));
    await handle.read(chunk, 0, chunk.length, GLB_HEADER_BYTES);
    return JSON.parse(chunk.toString('utf8'));
  } finally {
    await handle.close();
  }
}

/** The glTF JSON of the bytes of a model. Throws where they hold none. */
export const documentOf = (bytes) => {
  const buffer = Buffer.from(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (buffer.length < GLB_HEADER_BYTES || buffer.readUInt32LE(0) !== GLB_MAGIC) return JSON.parse(buffer.toString('utf8'));
  return JSON.parse(buffer.toString('utf8', GLB_HEADER_BYTES, GLB_HEADER_BYTES + buffer.readUInt32LE(12)));
};

/** Path beneath the model's folder that a URI of the model means; undefined where it means none. */
function relativePath(uri) {
  if (typeof uri !== 'string' || /^[a-z][a-z\d+.-]*:/i.test(uri)) return undefined;
  try {
    const name = path.posix.normalize(decodeURIComponent(uri));
    return path.posix.isAbsolute(name) || name.startsWith('..') || /[\0\\]/.test(name) ? undefined : name;
  } catch {
    return undefined; // a broken % sequence
  }
}

/** Whether the path names a regular file without a symbolic link on the way from the folder, as the renderer wants it too. */
async function isPlainFile(folder, name) {
  try {
    const file = path.join(folder, name);
    return (await realpath(file)) === file && (await stat(file)).isFile();
  } catch {
    return false;
  }
}

const hasBasis = ({ extensionsUsed = [] }) => extensionsUsed.includes('KHR_texture_basisu');

/**
 * The files that a browser needs for a model: the model itself and the external files that it names.
 * @param {string | Uint8Array} source path of a model, or bytes of a GLB, that was loaded before
 * @returns {Promise<{folder?: string, files: Set<string>, hasBasis: boolean}>} `files` with / between folders, each beneath
 *   `folder`; hasBasis: whether there are KTX2 textures
 */
export async function modelFiles(source) {
  if (typeof source !== 'string') return { files: new Set(), hasBasis: hasBasis(documentOf(source)) };
  const file = source;
  const folder = await realpath(path.dirname(file));
  const name = path.basename(file);
  const document = await readDocument(file);
  const { buffers = [], images = [] } = document;
  const files = new Set([name]);
  for (const { uri } of [...buffers, ...images]) {
    const relative = relativePath(uri);
    if (relative && (await isPlainFile(folder, relative))) files.add(relative);
  }
  return { folder, files, hasBasis: hasBasis(document) };
}
