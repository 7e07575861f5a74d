import { TelarError } from '../error/index.mjs';
import { problemOf } from './problem.mjs';

/** The routes of jobs: their state, their events, their results. */

/** Milliseconds between two signs of life on a stream of events. */
const BEAT_MS = 15_000;
/** Milliseconds after which a client may ask for the events again. */
const AGAIN_MS = 1000;

const isOver = ({ state }) => state !== 'waiting' && state !== 'running';
const time = (ms) => new Date(ms).toISOString();

/** A job as its client is told of it. */
export function jobJson({ id, kind, state, progress, created, started, ended, error }, prefix) {
  const self = `${prefix}/v1/jobs/${id}`;
  return {
    id,
    kind,
    state,
    progress,
    created: time(created),
    ...(started && { started: time(started) }),
    ...(ended && { ended: time(ended) }),
    ...(error && { error: problemOf(error, { prefix }) }),
    links: { self, events: `${self}/events`, ...(state === 'done' && { result: `${self}/result` }) },
  };
}

const event = (name, data) => `event: ${name}\ndata: ${JSON.stringify(data)}\n\n`;

/** Tells a job's states until it is over (Server-sent events, WHATWG HTML 9.2). */
function stream(raw, first, queue, prefix) {
  // A client that went away while the job was looked up is told by no event any more.
  if (raw.destroyed) return;
  raw.writeHead(200, { 'content-type': 'text/event-stream; charset=utf-8', 'cache-control': 'no-store', 'x-accel-buffering': 'no' });
  raw.write(`retry: ${AGAIN_MS}\n\n${event(first.state, jobJson(first, prefix))}`);
  if (isOver(first)) return raw.end();
  const beat = setInterval(() => raw.write(':\n\n'), BEAT_MS);
  const stop = () => {
    clearInterval(beat);
    stopWatching();
  };
  const stopWatching = queue.watch(first.id, (state, preview) => {
    // A client that does not read misses progress and previews, and no end.
    if (!isOver(state) && raw.writableNeedDrain) return;
    if (preview) {
      const { png, ...shown } = preview;
      return void raw.write(event('preview', { id: state.id, ...shown, data: png.toString('base64') }));
    }
    raw.write(event(state.state, jobJson(state, prefix)));
    if (!isOver(state)) return;
    stop();
    raw.end();
  });
  raw.once('close', stop);
}

/**
 * Handlers by the names of ROUTES.
 * @param {import('../queue/job_queue.mjs').JobQueue} queue
 * @param {string} prefix
 * @param {(request: object, reply: object, answer: object) => unknown} send as the routes that work send their answers
 */
export function jobHandlers(queue, prefix, send) {
  const found = async (id) => {
    const state = await queue.get(id);
    if (!state) throw new TelarError('E_NOT_FOUND', 'there is no such job, or what came of it is no longer kept');
    return state;
  };
  return {
    async job({ method, params: { id } }, reply) {
      await found(id);
      reply.header('cache-control', 'no-store');
      return jobJson(method === 'DELETE' ? await queue.cancel(id) : await found(id), prefix);
    },
    async jobEvents({ method, params: { id } }, reply) {
      const state = await found(id);
      if (method === 'HEAD') return reply.type('text/event-stream').send();
      const kept = reply.getHeaders();
      reply.hijack();
      for (const [name, value] of Object.entries(kept)) reply.raw.setHeader(name, value);
      stream(reply.raw, state, queue, prefix);
    },
    async jobResult(request, reply) {
      const { state, error } = await found(request.params.id);
      if (error) throw error;
      const kept = await queue.result(request.params.id);
      if (!kept) {
        reply.header('retry-after', '1');
        throw new TelarError('E_NOT_FOUND', `the job has no result yet; it is ${state}`);
      }
      return send(request, reply, { ...kept.meta, result: kept.result });
    },
  };
}
