import { createReadStream } from 'node:fs';
import { stat } from 'node:fs/promises';
import { createServer } from 'node:http';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { shadingModule } from '../../../js/build/shading/index.mjs';

const ROOT = fileURLToPath(new URL('../../../', import.meta.url));

/** Folders of the project that the page may read. */
const SERVED = ['/js/', '/test/parity/browser/', '/test/families/browser/'];

/** The page's three.js, wherever it lies. */
const THREE = '/node_modules/three/';

/** Text of shaders/ for three.js, made of what lies there now and not of what js/dist was built from. */
const SHADING = /^\/js\/dist\/shading\/(\w+)\.mjs$/;

const CONTENT_TYPE = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.mjs': 'text/javascript',
  '.wasm': 'application/wasm',
  '.png': 'image/png',
  '.jpg': 'image/jpeg',
  '.gltf': 'model/gltf+json',
};

/**
 * HTTP on the loopback interface for the parity page: the project's files, offered bytes, and results sent back by PUT.
 *
 * @param {object} [options]
 * @param {string} [options.three] - Folder of the three.js to serve; the development dependency where it is left out.
 * @param {Map<string, string>} [options.edited] - Texts in place of files of that folder, by their path in it.
 * @returns {Promise<{origin: string, offerBytes: Function, withdraw: Function, offerFile: Function,
 *   hasResult: Function, takeResult: Function, close: Function}>}
 */
export async function startServer({ three = path.join(ROOT, THREE), edited = new Map() } = {}) {
  const offered = new Map();
  const folders = [];
  const results = new Map();
  const server = createServer((request, response) => {
    const url = decodeURIComponent(new URL(request.url, 'http://localhost').pathname);
    if (request.method === 'PUT') receive(request, response, results, url);
    else if (offered.has(url)) response.end(offered.get(url));
    else if (SHADING.test(url)) sendShading(response, url);
    else if (url.startsWith(THREE)) sendThree(response, url.slice(THREE.length), three, edited);
    else sendFile(response, resolveFile(url, folders));
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  return {
    origin: `http://127.0.0.1:${server.address().port}`,
    offerBytes(name, bytes) {
      offered.set(`/data/${name}`, bytes);
      return `/data/${name}`;
    },
    withdraw: (url) => offered.delete(url),
    offerFile(file) {
      const folder = path.dirname(file);
      if (!folders.includes(folder)) folders.push(folder);
      return `/folder/${folders.indexOf(folder)}/${path.basename(file)}`;
    },
    hasResult: (url) => results.has(url),
    takeResult(url) {
      const bytes = results.get(url);
      if (!bytes) throw new Error(`the page sent nothing to ${url}`);
      results.delete(url);
      return bytes;
    },
    close: () => new Promise((resolve) => server.close(resolve).closeAllConnections()),
  };
}

/** File of a URL, or null where it is not served. */
function resolveFile(url, folders) {
  const [, id, rest] = /^\/folder\/(\d+)\/(.+)$/.exec(url) ?? [];
  if (id) return beneath(folders[Number(id)], rest);
  if (SERVED.some((prefix) => url.startsWith(prefix))) return beneath(ROOT, url.slice(1));
  return null;
}

function beneath(folder, relative) {
  const file = path.resolve(folder, relative);
  return file.startsWith(path.resolve(folder) + path.sep) ? file : null;
}

function sendShading(response, url) {
  response.writeHead(200, { 'Content-Type': CONTENT_TYPE['.mjs'] }).end(shadingModule(SHADING.exec(url)[1]));
}

function sendThree(response, file, folder, edited) {
  if (edited.has(file)) response.writeHead(200, { 'Content-Type': CONTENT_TYPE['.js'] }).end(edited.get(file));
  else sendFile(response, beneath(folder, file));
}

async function sendFile(response, file) {
  const facts = file ? await stat(file).catch(() => null) : null;
  if (!facts?.isFile()) {
    response.writeHead(404).end();
    return;
  }
  response.writeHead(200, { 'Content-Type': CONTENT_TYPE[path.extname(file)] ?? 'application/octet-stream' });
  createReadStream(file).pipe(response);
}

async function receive(request, response, results, url) {
  const chunks = [];
  for await (const chunk of request) chunks.push(chunk);
  const bytes = Buffer.concat(chunks);
  results.set(url, new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.length));
  response.writeHead(204).end();
}
