import { STATUS_CODES } from 'node:http';
import { TelarError } from '../error/index.mjs';
import { answerAddresses } from './hooks.mjs';
import { namesOf, readOptions } from './options.mjs';
import { mount } from './plugin.mjs';
import { problemOf } from './problem.mjs';
import { Service } from './service.mjs';

/** A server of its own around the plugin: what `telar serve` runs. */

/** Milliseconds between two looks at connections that are late. */
const LATE_LOOK_MS = 500;
/**
 * Milliseconds that an idle connection is kept. A request that comes as it is closed is lost, so whoever asks has to let go first: load balancers
 * and proxies do after 60 s.
 */
const KEEP_ALIVE_MS = 72_000;
/** Milliseconds in which the last answers are read. */
const FLUSH_MS = 2000;
/** Bytes of the headers, of which parameters of the address are the longest. */
const HEADER_BYTES = 65_536;

const pick = (options, names) => Object.fromEntries(Object.entries(options).filter(([name]) => names.includes(name)));

/** What is no HTTP, or comes too slowly, has no request that a route could answer. */
function onClientError(error, socket) {
  if (error.code === 'ECONNRESET' || !socket.writable) return socket.destroy();
  const late = error.code === 'ERR_HTTP_REQUEST_TIMEOUT';
  const told = late
    ? new TelarError('X_UPLOAD_TIME', 'the headers of the request are not there in time')
    : new TelarError('E_REQUEST', 'the request is not HTTP, or its headers are too long');
  const body = JSON.stringify(problemOf(told));
  socket.end(
    `HTTP/1.1 ${told.http} ${STATUS_CODES[told.http]}\r\ncontent-type: application/problem+json\r\ncontent-length: ${Buffer.byteLength(body)}\r\nconnection: close\r\n\r\n${body}`,
  );
}

/**
 * Listens.
 * @param {object} given options of the plugin and of the server
 * @param {{log?: import('node:stream').Writable}} [io] where lines of the log go
 * @returns {Promise<{url: string, port: number, drainMs: number, warnings: object[], drain: () => Promise<void>}>} warnings: of the queue; drain: lets no new work in, waits for what runs, and ends
 * @throws {TelarError} E_OPTION, X_PORT, and what createPool throws
 */
export async function listen(given, { log } = {}) {
  const options = readOptions(given, 'service');
  const { host, port, headersMs, connections, drainMs, logLevel, deadlineMs, uploadMs } = pick(options, namesOf('server').concat('deadlineMs', 'uploadMs'));
  const { default: Fastify, LogController } = await import('fastify');
  const service = await Service.open(options);
  try {
    const fastify = Fastify({
      logger: log && logLevel !== 'silent' ? { level: logLevel, stream: log, base: null } : false,
      logController: new LogController({ disableRequestLogging: true }),
      clientErrorHandler: onClientError,
      frameworkErrors: answerAddresses(service),
      // A client that reads nothing of its answer, or writes nothing at all.
      connectionTimeout: deadlineMs + uploadMs + headersMs,
      keepAliveTimeout: KEEP_ALIVE_MS,
      requestTimeout: headersMs + uploadMs + LATE_LOOK_MS,
      forceCloseConnections: 'idle',
      http: { headersTimeout: headersMs, connectionsCheckingInterval: LATE_LOOK_MS, maxHeaderSize: HEADER_BYTES },
    });
    fastify.server.maxConnections = connections;
    // Connections that wait for nothing keep nobody out.
    fastify.server.on('drop', () => fastify.server.closeIdleConnections());
    await mount(fastify, service, options);
    await take(fastify, { host, port });
    const { port: taken } = fastify.server.address();
    const url = `http://${host.includes(':') ? `[${host}]` : host}:${taken}`;
    return { url, port: taken, drainMs, warnings: service.queue.warnings, drain: () => drain(fastify, service, drainMs) };
  } catch (error) {
    await service.close();
    throw error;
  }
}

async function take(fastify, where) {
  try {
    await fastify.listen(where);
  } catch (cause) {
    if (!cause.syscall) throw cause;
    throw new TelarError('X_PORT', `${where.host} port ${where.port} cannot be taken (${cause.code}); --port names another one, 0 a free one`, { cause });
  }
}

/** New work is refused with 503 while what runs is finished, so that whoever asks meanwhile is told to ask elsewhere. */
async function drain(fastify, service, ms) {
  service.end();
  const late = setTimeout(() => service.abort(), ms);
  await service.idle();
  clearTimeout(late);
  const stuck = setTimeout(() => fastify.server.closeAllConnections(), FLUSH_MS);
  await fastify.close();
  clearTimeout(stuck);
  await service.close();
}
