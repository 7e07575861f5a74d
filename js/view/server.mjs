import { randomBytes } from 'node:crypto';
import { existsSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import fastifyStatic from '@fastify/static';
import Fastify from 'fastify';
import { encodePng } from '../compare/files.mjs';
import { TelarError, toTelarError } from '../error/index.mjs';

/** Where js/build/page.mjs puts the page. */
const PAGE = fileURLToPath(new URL('../dist/view/', import.meta.url));

const HOST = '127.0.0.1';
const TOKEN_BYTES = 24;
const MAX_SHOT_BYTES = 1 << 20;
/** 8192 x 8192 RGBA. */
const MAX_PIXEL_BYTES = 2 ** 28;

/**
 * Nothing but this server is reached from the page; blob: and data: are how loaders hand on what the model holds.
 * @param {boolean} mayEvaluate for three's KTX2 transcoder, and for models with such textures alone
 */
const policyOf = (mayEvaluate) => [
  "default-src 'none'", `script-src 'self' 'wasm-unsafe-eval'${mayEvaluate ? " 'unsafe-eval'" : ''}`, "style-src 'self'", "img-src 'self' blob: data:",
  "connect-src 'self' blob: data:", "worker-src 'self' blob:", "base-uri 'none'", "form-action 'none'", "frame-ancestors 'none'",
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

/** Fires when the browser no longer waits for the answer: its page asks for something newer, or is gone. */
function signalOf(reply) {
  const gone = new AbortController();
  reply.raw.once('close', () => {
    if (!reply.raw.writableFinished) gone.abort(new TelarError('X_CANCELLED', 'the page no longer waits for this picture'));
  });
  return gone.signal;
}

/** RFC 9457. Faults of HTTP itself (no such page, malformed JSON) carry their status and are the sender's. */
function problemOf(thrown) {
  const isHttp = thrown.statusCode >= 400 && thrown.statusCode < 500;
  const error = isHttp ? new TelarError('E_USAGE', thrown.message) : toTelarError(thrown);
  return { status: isHttp ? thrown.statusCode : error.http, ...error.toJSON() };
}

function guard(app, session) {
  app.addHook('onRequest', async (request, reply) => {
    reply.headers(HEADERS).header('content-security-policy', policyOf(session.hasBasis));
    const { localPort } = request.socket;
    if (isOwnHost(request.headers.host, localPort) && isOwnOrigin(request.headers.origin, localPort)) return;
    await reply.code(403).type('text/plain').send('Open this page by the address that telar view printed.\n');
  });
  app.setErrorHandler((thrown, _request, reply) => {
    const problem = problemOf(thrown);
    reply.code(problem.status).type('application/problem+json').send(problem);
  });
  app.setNotFoundHandler((_request, reply) => reply.code(404).type('text/plain').send('Not found.\n'));
}

/** Routes beneath the token. */
async function routes(app, { session }) {
  await app.register(fastifyStatic, { root: PAGE, prefix: '/page/', cacheControl: false, index: false });
  app.addContentTypeParser('application/octet-stream', { parseAs: 'buffer', bodyLimit: MAX_PIXEL_BYTES }, (_request, body, done) => done(null, body));

  app.get('/', (_request, reply) => reply.sendFile('index.html', PAGE));

  app.get('/session', async (_request, reply) => session.describe(signalOf(reply)));

  app.get('/model/*', (request, reply) => {
    const found = session.modelFile(request.params['*']);
    if (!found) return reply.callNotFound();
    if (found instanceof Uint8Array) return reply.type('model/gltf-binary').send(found);
    return reply.sendFile(found.file, found.folder);
  });

  app.get('/environment/:map', (request, reply) => {
    const file = session.environmentFile(request.params.map);
    return file ? reply.sendFile(path.basename(file), path.dirname(file)) : reply.callNotFound();
  });

  app.post('/draw', { bodyLimit: MAX_SHOT_BYTES }, async (request, reply) => {
    const { data, info } = await session.draw(request.body, signalOf(reply));
    const form = new FormData();
    form.set('info', JSON.stringify(info));
    form.set('pixels', new Blob([data]));
    return new Response(form);
  });

  // Encodes pixels of the page, so that no canvas rounds their colours under alpha.
  app.post('/png', async (request, reply) => {
    const { width, height } = request.query;
    const png = await encodePng({ width: Number(width), height: Number(height), data: request.body }, { signal: signalOf(reply) });
    return reply.type('image/png').send(png);
  });
}

/**
 * Serves a session to browsers on this machine, and to nobody else: on the loopback interface, under a secret path.
 * @param {object} options
 * @param {import('./session.mjs').Session} options.session
 * @param {number} [options.port=0] 0 = a free one
 * @returns {Promise<{url: string, port: number, close: () => Promise<void>}>}
 * @throws {TelarError} X_INSTALL, X_PORT
 */
export async function startServer({ session, port = 0 }) {
  if (!existsSync(path.join(PAGE, 'page.js'))) {
    throw new TelarError('X_INSTALL', 'the page of telar view is not built; `npm run build:js` in a checkout builds it');
  }
  const app = Fastify({ forceCloseConnections: true, routerOptions: { maxParamLength: 4096 } });
  guard(app, session);
  const token = randomBytes(TOKEN_BYTES).toString('base64url');
  await app.register(routes, { prefix: `/${token}`, session });
  try {
    await app.listen({ host: HOST, port });
  } catch (cause) {
    await app.close();
    throw new TelarError('X_PORT', `port ${port} cannot be taken (${cause.code ?? cause.message}); without --port a free one is`, { cause });
  }
  const taken = app.server.address().port;
  return { url: `http://${HOST}:${taken}/${token}/`, port: taken, close: () => app.close() };
}
