import { ERRORS, TelarError } from '../error/index.mjs';
import { answerLine, errorLine } from './log.mjs';
import { errorOf, isOwners, problemOf } from './problem.mjs';
import { linger } from './receive.mjs';

/** What is done for each request, whatever its route: its id, its line of the log, its figures, its error. */

const PROBLEM = 'application/problem+json; charset=utf-8';
/** Seconds after which a service that has no workers, or ends, may be asked again. */
const RETRY_UNREADY = 5;

/** Of a caller: short, and of characters that logs and headers hold. */
const requestId = ({ headers }, own) => (/^[\w.-]{1,64}$/.test(headers['x-request-id'] ?? '') ? headers['x-request-id'] : own);

/** Counts a request that is over. */
function account(request, { raw }, { metrics }) {
  linger(request.raw);
  const { start, route, code = raw.writableFinished ? '' : 'X_CANCELLED' } = request.telar;
  const status = raw.writableFinished ? raw.statusCode : ERRORS.X_CANCELLED.http;
  const seconds = (performance.now() - start) / 1000;
  metrics.requests.inc({ route, status, code });
  metrics.seconds.observe({ route }, seconds);
  answerLine(request, { status, seconds, code });
  request.telar.span.end({ attributes: { 'http.response.status_code': status }, code, isFault: status >= 500 });
}

/** Gives a request `request.telar`, and counts it when it is over. */
function watch(request, reply, service) {
  const { method, headers, routeOptions } = request;
  const route = routeOptions?.url ?? 'none';
  const span = service.spans.request(headers, `${method} ${route}`, { 'http.request.method': method, 'http.route': route });
  request.telar = { start: performance.now(), id: requestId(request, request.id), route, span };
  reply.header('x-request-id', request.telar.id);
  reply.header('x-content-type-options', 'nosniff');
  // Also of clients that are gone: Fastify's own hooks are for answers that were sent.
  reply.raw.once('close', () => account(request, reply, service));
}

/**
 * @param {import('fastify').FastifyInstance} fastify
 * @param {import('./service.mjs').Service} service
 */
export function watchRequests(fastify, service) {
  fastify.decorateRequest('telar', null);
  fastify.addHook('onRequest', async (request, reply) => watch(request, reply, service));
}

function tellError(error, request, reply, { admission, prefix }) {
  request.telar.code = error.code;
  errorLine(request, error);
  if (error.code === 'X_BUSY') reply.header('retry-after', String(admission.retryAfter));
  else if (error.http === 503) reply.header('retry-after', String(RETRY_UNREADY));
  if (error.code === 'X_SHUTDOWN') reply.header('connection', 'close');
  reply
    .code(error.http)
    .header('cache-control', 'no-store')
    .type(PROBLEM)
    .send(JSON.stringify(problemOf(error, { prefix, id: request.telar.id })));
}

/**
 * Errors are answered as problem+json, that there is no such route too; what a hook of the owner's server refuses, as that server answers it.
 * @param {import('fastify').FastifyInstance} fastify
 * @param {import('./service.mjs').Service} service
 */
export function answerErrors(fastify, { admission }) {
  const { prefix } = fastify;
  fastify.setErrorHandler((thrown, request, reply) => {
    // Without `telar` a hook of the owner's server has refused it before the one above.
    if (!request.telar || isOwners(thrown)) throw thrown;
    tellError(errorOf(thrown), request, reply, { admission, prefix });
  });
  fastify.setNotFoundHandler(() => {
    throw new TelarError('E_NOT_FOUND', 'there is no such route; /openapi.json lists them');
  });
}

/** Of addresses that lead to no route, so that no hook above sees them: by the code of Fastify's error. */
const ADDRESSES = {
  FST_ERR_BAD_URL: () => new TelarError('E_REQUEST', 'the address is malformed: a % in it is followed by no two hexadecimal digits of UTF-8'),
  FST_ERR_MAX_PARAM_LENGTH: () => new TelarError('E_NOT_FOUND', 'nothing has a name as long as one in the address'),
};

/**
 * Fastify's `frameworkErrors`: told, logged and counted as all others.
 * @param {import('./service.mjs').Service} service
 */
export const answerAddresses = (service) => (thrown, request, reply) => {
  watch(request, reply, service);
  tellError(ADDRESSES[thrown.code]?.() ?? errorOf(thrown), request, reply, { admission: service.admission, prefix: '' });
};
