import { randomBytes } from 'node:crypto';
import { existsSync, readdirSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { encodePng } from '../compare/files.mjs';
import { TelarError, toTelarError } from '../error/index.mjs';
import { HttpError, bodyOf, askedOf, jsonOf, send, sendFile, signalOf } from './http.mjs';

/** Where js/build/page.mjs puts the page. */
const PAGE = fileURLToPath(new URL('../dist/view/', import.meta.url));

/** The cloths that `materials` of a shot puts on. */
const CLOTHS = fileURLToPath(new URL('../assets/cloths/', import.meta.url));

const HOST = '127.0.0.1';
const TOKEN_BYTES = 24;
const MAX_SHOT_BYTES = 1 << 20;
/** One point of measure: 64 points and texts of at most 500 characters. */
const MAX_MEASURE_BYTES = 1 << 16;
/** As the command line reads at most. */
const MAX_SPEC_BYTES = 1 << 23;
/** 8192 x 8192 RGBA. */
const MAX_PIXEL_BYTES = 2 ** 28;

/** Milliseconds in which the headers of a request, and all of it, are there; and between two looks at connections that are late. */
const TIMES = { headersMs: 10_000, requestMs: 40_000, lookMs: 500 };

/**
 * Nothing but this server is reached from the page; blob: and data: are how loaders hand on what the model holds.
 * @param {boolean} mayEvaluate for three's KTX2 transcoder, and for models with such textures alone
 * @param {string} [importMap] hash of the one script that stands in the page
 */
const policyOf = (mayEvaluate, importMap) =>
  [
    "default-src 'none'",
    `script-src 'self' 'wasm-unsafe-eval'${mayEvaluate ? " 'unsafe-eval'" : ''}${importMap ? ` '${importMap}'` : ''}`,
    "style-src 'self'",
    "img-src 'self' blob: data:",
    "connect-src 'self' blob: data:",
    "worker-src 'self' blob:",
    "base-uri 'none'",
    "form-action 'none'",
    "frame-ancestors 'none'",
  ].join('; ');

const HEADERS = {
  'cross-origin-opener-policy': 'same-origin',
  'cross-origin-resource-policy': 'same-origin',
  'referrer-policy': 'no-referrer',
  'x-content-type-options': 'nosniff',
  'cache-control': 'no-store',
};

/**
 * Names this machine goes by in the address bar. A page of another name that has its name resolve to this machine (DNS
 * rebinding) sends that name.
 */
const isOwnHost = (host, port) => [`${HOST}:${port}`, `localhost:${port}`].includes(host);

const isOwnOrigin = (origin, port) => origin === undefined || (/^http:\/\//.test(origin) && isOwnHost(origin.slice(7), port));

/** RFC 9457. Faults of HTTP itself (no such page, malformed JSON) carry their status and are the sender's. */
function problemOf(thrown) {
  const isHttp = thrown instanceof HttpError;
  const error = isHttp ? new TelarError('E_USAGE', thrown.message) : toTelarError(thrown);
  return { status: isHttp ? thrown.status : error.http, ...error.toJSON() };
}

/** The page's own files by their name in its address: what is not among them cannot be asked for. */
function pageFiles(decoders = new Map()) {
  const entries = readdirSync(PAGE, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile());
  const files = entries.map((entry) => path.join(entry.parentPath ?? entry.path, entry.name));
  const cloths = readdirSync(CLOTHS).map((name) => [`cloths/${name}`, path.join(CLOTHS, name)]);
  return new Map([...files.map((file) => [path.relative(PAGE, file).split(path.sep).join('/'), file]), ...cloths, ...decoders]);
}

/** The page's own script, and the tag of the one that imports three.js by its name. */
const BUNDLED = /<script type="module" src="page\/page\.js"><\/script>/;
const withOwnThree = (html, { importMap }) => html.replace(BUNDLED, `${importMap}\n<script type="module" src="page/own.js"></script>`);

const sendJson = (response, value) => send(response, 200, 'application/json; charset=utf-8', JSON.stringify(value));

/** What a page asks of the spec that it edits. */
const specRoutesOf = (session) => ({
  'GET spec': async ({ response }) => sendJson(response, await session.describeSpec()),
  'POST measure': async ({ request, response }) => {
    const body = await jsonOf(request, MAX_MEASURE_BYTES);
    sendJson(response, await session.measure(body, signalOf(response)));
  },
  'POST spec': async ({ request, response }) => sendJson(response, await session.saveSpec(await jsonOf(request, MAX_SPEC_BYTES))),
});

/** What lies beneath the token, by method and first part of the path; `name` is the rest of it, decoded. */
const routesOf = (session, page, three) => ({
  'GET ': async ({ response }) => {
    if (!three) return sendFile(response, page.get('index.html'));
    return send(response, 200, 'text/html; charset=utf-8', withOwnThree(await readFile(page.get('index.html'), 'utf8'), three));
  },
  'GET three': ({ response, name }) => sendFile(response, three?.files.get(name)),
  'GET page': ({ response, name }) => sendFile(response, page.get(name)),
  'GET session': async ({ response }) => sendJson(response, await session.describe(signalOf(response))),
  'GET model': ({ response, name }) => {
    const found = session.modelFile(name);
    if (found instanceof Uint8Array) return send(response, 200, 'model/gltf-binary', found);
    return sendFile(response, found && path.join(found.folder, found.file));
  },
  'GET environment': ({ response, name }) => sendFile(response, session.environmentFile(name)),
  'POST draw': async ({ request, response }) => {
    const shot = await jsonOf(request, MAX_SHOT_BYTES);
    const { data, info } = await session.draw(shot, signalOf(response));
    const form = new FormData();
    form.set('info', JSON.stringify(info));
    form.set('pixels', new Blob([data]));
    const multipart = new Response(form);
    send(response, 200, multipart.headers.get('content-type'), Buffer.from(await multipart.arrayBuffer()));
  },
  // The same as it grows: a line of JSON and its pixels for each picture so far, then for the finished one.
  'POST grow': async ({ request, response }) => {
    const shot = await jsonOf(request, MAX_SHOT_BYTES);
    const tell = (what, data = Buffer.alloc(0)) => {
      if (!response.headersSent) response.writeHead(200, { 'content-type': 'application/octet-stream' });
      response.write(`${JSON.stringify({ ...what, bytes: data.length })}\n`);
      response.write(data);
    };
    try {
      const { data, info } = await session.draw(shot, signalOf(response), ({ data: pixels, ...preview }) => tell({ preview }, pixels));
      tell({ info }, data);
    } catch (thrown) {
      // Before the first picture it is an answer like any other.
      if (!response.headersSent) throw thrown;
      tell({ problem: problemOf(thrown) });
    }
    response.end();
  },
  ...(session.hasSpec && specRoutesOf(session)),
  // Encodes pixels of the page, so that no canvas rounds their colours under alpha.
  'POST png': async ({ request, response, query }) => {
    const data = await bodyOf(request, 'application/octet-stream', MAX_PIXEL_BYTES);
    const [width, height] = ['width', 'height'].map((name) => Number(query.get(name)));
    send(response, 200, 'image/png', await encodePng({ width, height, data }, { signal: signalOf(response) }));
  },
});

/** Answers a request, whatever becomes of it. */
async function answer(request, response, { token, routes, session, three }) {
  for (const [name, value] of Object.entries({ ...HEADERS, 'content-security-policy': policyOf(session.hasBasis, three?.hash) }))
    response.setHeader(name, value);
  const { localPort } = request.socket;
  if (!isOwnHost(request.headers.host, localPort) || !isOwnOrigin(request.headers.origin, localPort)) {
    return send(response, 403, 'text/plain; charset=utf-8', 'Open this page by the address that telar view printed.\n');
  }
  try {
    const asked = askedOf(request, token);
    const route = asked && routes[asked.route];
    if (!route) throw new HttpError(404, 'Not found.');
    await route({ request, response, ...asked });
  } catch (thrown) {
    if (response.headersSent) return response.destroy();
    if (thrown instanceof HttpError && thrown.status === 404) return send(response, 404, 'text/plain; charset=utf-8', 'Not found.\n');
    const problem = problemOf(thrown);
    send(response, problem.status, 'application/problem+json; charset=utf-8', JSON.stringify(problem));
  }
}

/**
 * Serves a session to browsers on this machine, and to nobody else: on the loopback interface, under a secret path.
 * @param {object} options
 * @param {import('./session.mjs').Session} options.session
 * @param {number} [options.port=0] 0 = a free one
 * @param {Partial<typeof TIMES>} [options.times]
 * @param {import('./three_folder.mjs').OwnThree} [options.three] draws the page's pictures in place of the bundled three.js
 * @returns {Promise<{url: string, port: number, close: () => Promise<void>}>}
 * @throws {TelarError} X_INSTALL, X_PORT
 */
export async function startServer({ session, port = 0, times, three }) {
  if (!existsSync(path.join(PAGE, 'page.js'))) {
    throw new TelarError('X_INSTALL', 'the page of telar view is not built; `npm run build:js` in a checkout builds it');
  }
  const token = randomBytes(TOKEN_BYTES).toString('base64url');
  const routes = routesOf(session, pageFiles(three?.decoders), three);
  const { headersMs, requestMs, lookMs } = { ...TIMES, ...times };
  // Node answers what is late with 408, and ends the connection.
  const server = createServer({ headersTimeout: headersMs, requestTimeout: requestMs, connectionsCheckingInterval: lookMs }, (request, response) => {
    void answer(request, response, { token, routes, session, three });
  });
  await new Promise((resolve, reject) => {
    server.once('error', (cause) =>
      reject(new TelarError('X_PORT', `port ${port} cannot be taken (${cause.code ?? cause.message}); without --port a free one is`, { cause })),
    );
    server.listen({ host: HOST, port }, resolve);
  });
  const { port: taken } = server.address();
  const close = () =>
    new Promise((resolve) => {
      server.close(() => resolve());
      // The page keeps its connections open.
      server.closeAllConnections();
    });
  return { url: `http://${HOST}:${taken}/${token}/`, port: taken, close };
}
