import { ERRORS, TelarError } from '../error/index.mjs';
import { bodyOf } from './answer.mjs';
import { tagOf } from './conditional.mjs';
import { descriptionHandlers } from './description.mjs';
import { errorLine, answerLine } from './log.mjs';
import { readOptions } from './options.mjs';
import { jobHandlers, jobJson } from './job_handlers.mjs';
import { errorOf, problemOf } from './problem.mjs';
import { linger } from './receive.mjs';
import { ROUTES } from './routes.mjs';
import { isAsync } from './scope.mjs';
import { Service } from './service.mjs';

const PROBLEM = 'application/problem+json; charset=utf-8';
const METHODS = ['GET', 'POST', 'PUT', 'PATCH', 'DELETE'];
/** Seconds after which a service that has no workers, or ends, may be asked again. */
const RETRY_UNREADY = 5;

const queryOf = ({ raw }) => new URLSearchParams(raw.url.split(/\?(.*)/s)[1] ?? '');

/** Of a caller: short, and of characters that logs and headers hold. */
const requestId = ({ headers }, own) => (/^[\w.-]{1,64}$/.test(headers['x-request-id'] ?? '') ? headers['x-request-id'] : own);

/**
 * The Fastify plugin. js/server/index.d.ts documents it and its options.
 * @param {import('fastify').FastifyInstance} fastify
 * @param {object} given
 */
export async function telarServer(fastify, given = {}) {
  const { prefix: _, ...own } = given;
  const options = readOptions(own);
  const service = await Service.open(options);
  fastify.addHook('onClose', () => service.close());
  await mount(fastify, service, options);
}

/** The routes on a service that is open. */
export async function mount(fastify, service, { cacheSeconds, metrics: isMetered }) {
  const { prefix } = fastify;
  const { metrics } = service;
  // Bodies are read by the routes, within their own bounds.
  fastify.removeAllContentTypeParsers();
  fastify.addContentTypeParser('*', (request, payload, done) => done(null));

  const account = (request, { raw }) => {
    linger(request.raw);
    const { start, route, code = raw.writableFinished ? '' : 'X_CANCELLED' } = request.telar;
    const status = raw.writableFinished ? raw.statusCode : ERRORS.X_CANCELLED.http;
    const seconds = (performance.now() - start) / 1000;
    metrics.requests.inc({ route, status, code });
    metrics.seconds.observe({ route }, seconds);
    answerLine(request, { status, seconds, code });
    request.telar.span.end({ attributes: { 'http.response.status_code': status }, code, isFault: status >= 500 });
  };
  fastify.decorateRequest('telar', null);
  fastify.addHook('onRequest', async (request, reply) => {
    const { method, headers, routeOptions } = request;
    const route = routeOptions.url ?? 'none';
    const span = service.spans.request(headers, `${method} ${route}`, { 'http.request.method': method, 'http.route': route });
    request.telar = { start: performance.now(), id: requestId(request, request.id), route, span };
    reply.header('x-request-id', request.telar.id);
    reply.header('x-content-type-options', 'nosniff');
    // Also of clients that are gone: Fastify's own hooks are for answers that were sent.
    reply.raw.once('close', () => account(request, reply));
  });
  fastify.setErrorHandler((thrown, request, reply) => {
    const error = errorOf(thrown);
    request.telar.code = error.code;
    errorLine(request, error);
    if (error.code === 'X_BUSY') reply.header('retry-after', String(service.admission.retryAfter));
    else if (error.http === 503) reply.header('retry-after', String(RETRY_UNREADY));
    if (error.code === 'X_SHUTDOWN') reply.header('connection', 'close');
    reply
      .code(error.http)
      .header('cache-control', 'no-store')
      .type(PROBLEM)
      .send(JSON.stringify(problemOf(error, { prefix, id: request.telar.id })));
  });
  fastify.setNotFoundHandler((request) => {
    throw new TelarError('E_NOT_FOUND', 'there is no such route; /openapi.json lists them');
  });

  const maxAge = ({ telar: { expires } }) =>
    expires === undefined ? cacheSeconds : Math.max(0, Math.min(cacheSeconds, expires - Math.ceil(Date.now() / 1000)));
  const send = (request, reply, { result, kind, type, waited, worked }) => {
    const { method } = request;
    const isCached = method === 'GET' || method === 'HEAD';
    reply.header('vary', 'accept').header('cache-control', isCached ? `public, max-age=${maxAge(request)}` : 'no-cache');
    const { type: own, body, headers } = bodyOf(result, { kind, type });
    if (result.key) reply.header('etag', tagOf(result.key, type));
    request.telar.key = result.key;
    if (waited !== undefined) reply.header('server-timing', `wait;dur=${Math.round(1000 * waited)}, work;dur=${Math.round(1000 * worked)}`);
    return reply
      .headers(headers || {})
      .type(own)
      .send(body);
  };

  const work = (kind) => (request, reply) =>
    answer(kind, { method: request.method, query: queryOf(request), raw: request.raw, span: request.telar.span }, request, reply);
  const answer = async (kind, asked, request, reply) => {
    const { raw, method } = asked;
    if (method === 'POST' && isAsync(raw)) {
      const job = jobJson(await service.submit(kind, asked, reply.raw), prefix);
      return reply.code(202).headers({ location: job.links.self, 'preference-applied': 'respond-async', 'cache-control': 'no-store' }).send(job);
    }
    const { result, tag, ...answer } = await service.answer(kind, asked, reply.raw);
    if (result) return send(request, reply, { ...answer, result });
    return reply
      .headers({ vary: 'accept', 'cache-control': `public, max-age=${maxAge(request)}`, etag: tag })
      .code(304)
      .send();
  };

  const handlers = {
    signed(request, reply) {
      const { raw, method } = request;
      const { query, expires } = service.signatures.open(request.params['*'], Date.now());
      request.telar.expires = expires;
      return answer('thumbnail', { method, query: new URLSearchParams(query), raw, span: request.telar.span, isSigned: true }, request, reply);
    },
    async error({ params: { code } }) {
      if (!Object.hasOwn(ERRORS, code)) throw new TelarError('E_NOT_FOUND', 'there is no such code');
      return { code, ...ERRORS[code] };
    },
    health: async () => ({ status: 'ok' }),
    async readiness(request, reply) {
      const state = await service.state();
      reply.code(state.status === 'ready' ? 200 : 503).header('cache-control', 'no-store');
      return state;
    },
    ...(isMetered && {
      async metrics(request, reply) {
        reply.header('content-type', metrics.registry.contentType);
        return metrics.registry.metrics();
      },
    }),
    ...jobHandlers(service.queue, prefix, send),
    ...(await descriptionHandlers(prefix, { metrics: isMetered })),
  };

  for (const [name, { url, pattern = url, methods, kind }] of Object.entries(ROUTES)) {
    const handler = kind ? work(kind) : handlers[name];
    if (handler) addRoute(fastify, pattern, methods, handler);
  }
}

/** A route, and an answer to the methods that it does not take. */
function addRoute(fastify, url, methods, handler) {
  fastify.route({ method: methods, url, handler });
  const others = METHODS.filter((method) => !methods.includes(method));
  fastify.route({
    method: others,
    url,
    handler: (request, reply) => {
      reply.header('allow', methods.join(', '));
      throw new TelarError('E_METHOD', `this route takes ${methods.join(' and ')}`);
    },
  });
}
