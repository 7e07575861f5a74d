import { ERRORS, TelarError } from '../error/index.mjs';
import { descriptionHandlers } from './description.mjs';
import { answerErrors, watchRequests } from './hooks.mjs';
import { readOptions } from './options.mjs';
import { jobHandlers } from './job_handlers.mjs';
import { Replies } from './replies.mjs';
import { ROUTES } from './routes.mjs';
import { Service } from './service.mjs';

const METHODS = ['GET', 'POST', 'PUT', 'PATCH', 'DELETE', 'OPTIONS', 'TRACE'];

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
  // Bodies are read by the routes, within their own bounds.
  fastify.removeAllContentTypeParsers();
  fastify.addContentTypeParser('*', (request, payload, done) => done(null));
  watchRequests(fastify, service);
  answerErrors(fastify, service);

  const replies = new Replies(service, prefix, cacheSeconds);
  const handlers = {
    signed: (request, reply) => replies.ofSigned(request, reply),
    ...stateHandlers(service),
    ...(isMetered && metricsHandlers(service.metrics)),
    ...jobHandlers(service.queue, prefix, (request, reply, answer) => replies.ofJob(request, reply, answer)),
    ...(await descriptionHandlers(prefix, { metrics: isMetered })),
  };
  for (const [name, { url, pattern = url, methods, kind }] of Object.entries(ROUTES)) {
    const handler = kind ? (request, reply) => replies.ofWork(kind, request, reply) : handlers[name];
    if (handler) addRoute(fastify, pattern, methods, handler);
  }
}

/** Handlers by the names of ROUTES: whether the service lives and works, and what its errors mean. */
const stateHandlers = (service) => ({
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
});

const metricsHandlers = ({ registry }) => ({
  async metrics(request, reply) {
    reply.header('content-type', registry.contentType);
    return registry.metrics();
  },
});

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
