import { createReadStream } from 'node:fs';
import { stat } from 'node:fs/promises';
import path from 'node:path';
import { pipeline } from 'node:stream/promises';
import { TelarError } from '../error/index.mjs';

// What node:http leaves to its user.

/** A request that no route answers with what it asks for. */
export class HttpError extends Error {
  /** @param {number} status @param {string} message */
  constructor(status, message) {
    super(message);
    this.status = status;
  }
}

const TYPES = {
  '.css': 'text/css; charset=utf-8',
  '.gltf': 'model/gltf+json',
  '.glb': 'model/gltf-binary',
  '.html': 'text/html; charset=utf-8',
  '.jpg': 'image/jpeg',
  '.js': 'text/javascript; charset=utf-8',
  '.png': 'image/png',
  '.svg': 'image/svg+xml',
  '.txt': 'text/plain; charset=utf-8',
  '.wasm': 'application/wasm',
  '.webp': 'image/webp',
};

/**
 * The route that a request asks for, beneath the secret path.
 * @returns {{route: string, name: string, query: URLSearchParams} | undefined} undefined for another path
 * @throws {HttpError} 400
 */
export function askedOf({ url, method }, token) {
  const [address, query = ''] = url.split(/\?(.*)/s);
  if (!address.startsWith(`/${token}/`)) return undefined;
  const [first, ...rest] = address.slice(token.length + 2).split('/');
  try {
    return { route: `${method === 'HEAD' ? 'GET' : method} ${first}`, name: decodeURIComponent(rest.join('/')), query: new URLSearchParams(query) };
  } catch {
    throw new HttpError(400, 'the path has a broken % sequence');
  }
}

/** @param {import('node:http').ServerResponse} response @param {Uint8Array | string} body */
export function send(response, status, type, body) {
  response.writeHead(status, { 'content-type': type, 'content-length': Buffer.byteLength(body) }).end(body);
}

/**
 * @param {import('node:http').ServerResponse} response
 * @param {string} [file] undefined: there is none
 * @throws {HttpError} 404 for what is no regular file
 */
export async function sendFile(response, file) {
  const facts = file && (await stat(file).catch(() => undefined));
  if (!facts?.isFile()) throw new HttpError(404, 'Not found.');
  response.writeHead(200, { 'content-type': TYPES[path.extname(file)] ?? 'application/octet-stream' });
  await pipeline(createReadStream(file), response);
}

/**
 * @param {import('node:http').IncomingMessage} request
 * @param {string} type that the body must have
 * @param {number} maxBytes
 * @returns {Promise<Buffer>}
 * @throws {HttpError} 413, 415
 */
export async function bodyOf(request, type, maxBytes) {
  if ((request.headers['content-type'] ?? '').split(';')[0].trim().toLowerCase() !== type) throw new HttpError(415, `the body must be ${type}`);
  const chunks = [];
  let bytes = 0;
  for await (const chunk of request) {
    bytes += chunk.length;
    if (bytes > maxBytes) throw new HttpError(413, `the body has more than ${maxBytes} bytes`);
    chunks.push(chunk);
  }
  return Buffer.concat(chunks);
}

/** @throws {HttpError} 400, 413, 415 */
export async function jsonOf(request, maxBytes) {
  const text = (await bodyOf(request, 'application/json', maxBytes)).toString('utf8');
  try {
    return JSON.parse(text);
  } catch (error) {
    throw new HttpError(400, `the body is not JSON: ${error.message}`);
  }
}

/** Fires when the browser no longer waits for the answer: its page asks for something newer, or is gone. */
export function signalOf(response) {
  const gone = new AbortController();
  response.once('close', () => {
    if (!response.writableFinished) gone.abort(new TelarError('X_CANCELLED', 'the page no longer waits for this picture'));
  });
  return gone.signal;
}
