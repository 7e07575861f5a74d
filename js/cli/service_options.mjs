import { Option } from 'commander';
import { BOUNDS, PLACES, STORE, TRIES } from '../queue/table.mjs';
import { OPTIONS } from '../server/table.mjs';
import { collect } from './shot_options.mjs';

/** Flags of `telar serve` and `telar worker`, from the tables of the options of service and queue. */

/** Numbers as such; what is none is told by the table's own message. */
const numberOf = (text) => (/^\d{1,15}$/.test(text) ? Number(text) : text);

/** @param {import('../queue/option_rows.mjs').OptionRow} row @returns {Option} */
function flagOf({ flag, doc, kind, values, default: value }) {
  const isSaid = value !== undefined && typeof value !== 'boolean' && !Array.isArray(value);
  const option = new Option(flag, kind === 'boolean' ? `do not: ${doc}` : `${doc}${isSaid ? ` (${value} by default)` : ''}`);
  if (values) option.choices(values);
  if (kind === 'number') option.argParser(numberOf);
  if (kind === 'list') option.argParser(collect);
  return option;
}

/** Options of a queue beside those that the service has itself. */
const { taskBytes: _, ...tries } = TRIES;
const OF_SERVED = { ...PLACES, ...tries };

/** Of `telar worker`: it adds no job. */
const { tenantJobs: _jobs, tenantMs: _ms, waitMs: _wait, ...ofWork } = tries;
const OF_WORKER = { ...PLACES, ...ofWork, resultMs: BOUNDS.resultMs, resultBytes: BOUNDS.resultBytes };
const WORK = { jobMs: OPTIONS.jobMs, drainMs: OPTIONS.drainMs, ...STORE };

const add = (command, rows) => Object.values(rows).reduce((whole, row) => whole.addOption(flagOf(row)), command);

/** Values of rows, by the names of the rows. */
const valuesOf = (options, rows) => Object.fromEntries(Object.entries(rows).map(([name, row]) => [name, options[flagOf(row).attributeName()]]));

/** The queue of a command line; REDIS_URL says where it is if nothing else does. */
function queueOf(options, rows, { REDIS_URL }) {
  const queue = valuesOf(options, rows);
  if (queue.redis === undefined && queue.sqlite === undefined && REDIS_URL) queue.redis = REDIS_URL;
  return queue;
}

/** @param {import('commander').Command} command */
export const addServiceOptions = (command) => add(command, { ...OPTIONS, ...OF_SERVED });
export const addWorkerOptions = (command) => add(command, { ...WORK, ...OF_WORKER });

/** @returns {object} options of listen() that are plain data, with those of its queue */
export const serviceOptions = (options, env) => ({ ...valuesOf(options, OPTIONS), queue: queueOf(options, OF_SERVED, env) });

/** @returns {{queue: object, jobMs?: number, drainMs?: number, storeBytes?: number}} */
export const workerOptions = (options, env) => ({ ...valuesOf(options, WORK), queue: queueOf(options, OF_WORKER, env) });
