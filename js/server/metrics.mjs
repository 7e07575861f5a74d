import { monitorEventLoopDelay } from 'node:perf_hooks';

/** Seconds: from a refusal to a picture by the path tracer. */
const BUCKETS = [0.005, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 30, 120, 600];
const NS = 1e9;
/** Between two looks at the event loop; what it waits beside that is the delay. */
const RESOLUTION_MS = 10;

/**
 * What Prometheus reads, in a registry of its own.
 * @param {{admission: import('./admission.mjs').Admission, queue: import('../queue/job_queue.mjs').JobQueue, pool: import('../pool/index.js').Pool}} of
 */
export async function openMetrics({ admission, queue, pool }) {
  const { Counter, Gauge, Histogram, Registry } = (await import('prom-client')).default;
  const registry = new Registry();
  const registers = [registry];
  const delay = monitorEventLoopDelay({ resolution: RESOLUTION_MS });
  delay.enable();
  const gauge = (name, help, collect, labelNames = []) => new Gauge({ name, help, registers, labelNames, collect });
  gauge('telar_jobs_running', 'Jobs that have a worker', function () {
    this.set(admission.running);
  });
  gauge('telar_jobs_waiting', 'Jobs that wait for a worker', function () {
    this.set(admission.waiting);
  });
  gauge('telar_uploads', 'Bodies that are being received', function () {
    this.set(admission.receiving);
  });
  gauge('telar_held_bytes', 'Bytes of requests in memory, from their bodies to their answers', function () {
    this.set(admission.heldBytes);
  });
  gauge(
    'telar_queue',
    'Jobs of the queue by state; kept: those that are over',
    async function () {
      // A queue that is away has no figures; the others are told.
      try {
        for (const [state, count] of Object.entries(await queue.counts())) this.set({ state }, count);
      } catch {
        this.reset();
      }
    },
    ['state'],
  );
  gauge(
    'telar_workers',
    'Workers by state',
    function () {
      for (const state of ['starting', 'idle', 'busy']) this.set({ state }, pool.workers.filter((worker) => worker.state === state).length);
    },
    ['state'],
  );
  gauge(
    'telar_event_loop_delay_seconds',
    'How long this process waited for its event loop since the last look',
    function () {
      for (const quantile of [50, 99]) this.set({ quantile: String(quantile / 100) }, Math.max(0, delay.percentile(quantile) / NS - RESOLUTION_MS / 1000));
      delay.reset();
    },
    ['quantile'],
  );
  return {
    registry,
    requests: new Counter({
      name: 'telar_requests_total',
      help: 'Answers by route, status and code of the error',
      registers,
      labelNames: ['route', 'status', 'code'],
    }),
    seconds: new Histogram({
      name: 'telar_request_seconds',
      help: 'From the headers of a request to its answer',
      registers,
      labelNames: ['route'],
      buckets: BUCKETS,
    }),
    waited: new Histogram({ name: 'telar_wait_seconds', help: 'How long jobs waited for a worker', registers, labelNames: ['kind'], buckets: BUCKETS }),
    worked: new Histogram({ name: 'telar_work_seconds', help: 'How long workers took for jobs', registers, labelNames: ['kind'], buckets: BUCKETS }),
    retries: new Counter({ name: 'telar_retries_total', help: 'Jobs that were given to a second worker, as the first one ended', registers }),
    stored: new Counter({
      name: 'telar_store_total',
      help: 'What came of looking into the store of results, and of writing there',
      registers,
      labelNames: ['outcome'],
    }),
    received: new Counter({ name: 'telar_received_bytes_total', help: 'Bytes of bodies', registers }),
    close: () => delay.disable(),
  };
}
