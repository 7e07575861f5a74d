import { HOUR, MIB, milliseconds, whole } from '../queue/option_rows.mjs';
import { BOUNDS, STORE } from '../queue/table.mjs';
import { boolean, choice, list, object, text } from '../shot/table/rows.mjs';

/** The options of the service: what `telar serve` takes as flags, the plugin as options, and the pages list. */

const { jobs, jobBytes, resultMs, resultBytes } = BOUNDS;

/** Of the plugin. */
const PLUGIN = {
  deadlineMs: milliseconds(
    'Milliseconds from the last byte of a request to its answer, waiting included; `prefer: wait=N` may shorten it',
    '--deadline-ms <ms>',
    {
      default: 30_000,
    },
  ),
  uploadMs: milliseconds('Milliseconds in which the body of a request is there', '--upload-ms <ms>', { default: 30_000 }),
  requestBytes: whole('Bytes of a request: the model, and the files beside it', {
    flag: '--request-bytes <n>',
    unit: 'bytes',
    min: 1,
    max: 2 ** 32,
    default: 128 * MIB,
  }),
  uploads: whole('Bodies that are received at once; one more is X_BUSY', { flag: '--uploads <n>', min: 1, max: 65_536, default: 64 }),
  uploadBytes: whole('Bytes of the requests that are received, wait and are answered, together; more is X_BUSY, but for one request alone', {
    flag: '--upload-bytes <n>',
    unit: 'bytes',
    min: 1,
    max: 2 ** 40,
    default: 1024 * MIB,
  }),
  waiting: whole('Jobs that wait for a worker; one more is X_BUSY. By default four for each worker', {
    flag: '--waiting <n>',
    min: 0,
    max: 65_536,
    optional: true,
  }),
  jobs,
  jobBytes,
  jobMs: milliseconds('Milliseconds that a job may work, waiting aside', '--job-ms <ms>', { default: HOUR / 6 }),
  resultMs,
  resultBytes,
  drawJobs: { ...boolean('Draw jobs of the queue in this process too; otherwise `telar worker` does', { default: true }), flag: '--no-draw-jobs' },
  tenantHeader: {
    ...text('Header that names the tenant of a request; what stands before the service sets it', 'the name of a header', {
      max: 64,
      optional: true,
    }),
    flag: '--tenant-header <name>',
  },
  side: whole('Most pixels of a side of a picture', { flag: '--side <px>', unit: 'pixels', min: 1, max: 8192, default: 4096 }),
  cacheSeconds: whole('Seconds for which caches may keep the answer to a GET without asking again', {
    flag: '--cache-seconds <s>',
    unit: 'seconds',
    min: 0,
    max: 31_536_000,
    default: 300,
  }),
  ...STORE,
  allowHosts: {
    ...list(
      'Hosts from which models are fetched by https, as in models.example.com; a whole origin as in http://store:9000 allows its own scheme and port',
      text('A host or an origin', 'a host or an origin', { max: 255 }),
      'a list of hosts',
      { max: 256, default: [] },
    ),
    flag: '--allow-host <host>',
  },
  metrics: { ...boolean('Answer /metrics', { default: true }), flag: '--no-metrics' },
};

/** Of the server that `telar serve` makes around it. */
const SERVER = {
  host: { ...text('Address to listen on', 'an address', { max: 255, default: '127.0.0.1' }), flag: '--host <address>', of: 'server' },
  port: whole('Port to listen on; 0 = a free one', { flag: '--port <port>', of: 'server', min: 0, max: 65_535, default: 8080 }),
  headersMs: milliseconds('Milliseconds in which the headers of a request are there', '--headers-ms <ms>', { of: 'server', default: 10_000 }),
  connections: whole('Connections at once; more are closed', { flag: '--connections <n>', of: 'server', min: 1, max: 65_536, default: 1024 }),
  drainMs: milliseconds('Milliseconds that running work gets after SIGTERM', '--drain-ms <ms>', { of: 'server', default: 25_000 }),
  logLevel: {
    ...choice('What is logged, as JSON lines on stderr', ['fatal', 'error', 'warn', 'info', 'debug', 'silent'], { default: 'info' }),
    flag: '--log-level <level>',
    of: 'server',
  },
};

/** @type {Record<string, import('../queue/option_rows.mjs').OptionRow>} */
export const OPTIONS = Object.freeze({ ...SERVER, ...PLUGIN });

const shapeOf = (rows) => object('Options', rows, { expected: 'an object' });

export const SERVICE = shapeOf(OPTIONS);
export const PLUGIN_OPTIONS = shapeOf(PLUGIN);
