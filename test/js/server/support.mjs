import { once } from 'node:events';
import net from 'node:net';
import { listen } from '../../../js/server/index.mjs';
import { MODELS } from '../../fixtures/index.mjs';

export { ENDLESS, SHOT, open as openPool } from '../pool/support.mjs';
export { MODELS };

export const GLB = 'model/gltf-binary';
export const HOURS = 80_000_000;

/** A service on a free port. */
export const serve = (options, io) => listen({ port: 0, ...options }, io);

/** Lines of a log, as objects. */
export function logLines() {
  const lines = [];
  return { lines, write: (text) => lines.push(...text.trim().split('\n').map(JSON.parse)) };
}

/** Address of a route with values of its parameters. */
export function at(url, route, asked = {}) {
  const address = new URL(route, url);
  for (const [key, value] of Object.entries(asked)) address.searchParams.set(key, typeof value === 'string' ? value : JSON.stringify(value));
  return address;
}

/** Posts a model as the body. */
export const post = (url, route, body, asked, headers = {}, signal = undefined) =>
  fetch(at(url, route, asked), { method: 'POST', body, headers: { 'content-type': GLB, ...headers }, signal });

/** Posts a form: texts as they are, bytes and [bytes, name] as files. */
export function postForm(url, route, fields, headers = {}) {
  const form = new FormData();
  for (const [name, value] of Object.entries(fields)) {
    for (const one of Array.isArray(value) && Array.isArray(value[0]) ? value : [value]) {
      const [content, file = 'a file'] = Array.isArray(one) ? one : [one];
      if (content instanceof Uint8Array) form.append(name, new Blob([content]), file);
      else form.append(name, typeof content === 'string' ? content : JSON.stringify(content));
    }
  }
  return fetch(at(url, route), { method: 'POST', body: form, headers });
}

export const bytesOf = async (response) => Buffer.from(await response.arrayBuffer());

/** The problem that an answer tells, with its status. */
export async function problemOf(response) {
  const { status } = response;
  return { status, type: response.headers.get('content-type'), ...(await response.json()) };
}

export const readiness = async (url) => (await fetch(new URL('/readyz', url))).json();

/** A socket to the service, and all that came from it once it is closed. */
export async function connect({ port }) {
  const socket = net.connect(port, '127.0.0.1');
  const chunks = [];
  socket.on('data', (chunk) => chunks.push(chunk)).on('error', () => {});
  // A connection that is cut while its client still writes is reset: what came before counts.
  const said = new Promise((resolve) => {
    socket.once('close', () => resolve(Buffer.concat(chunks).toString('latin1')));
  });
  await once(socket, 'connect');
  return { socket, said };
}

/** Head of a request without its end. */
export const head = (route, headers = {}) =>
  [`POST ${route} HTTP/1.1`, 'host: here', ...Object.entries(headers).map(([name, value]) => `${name}: ${value}`), '', ''].join('\r\n');
