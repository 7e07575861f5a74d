import { isObject, wrongOption } from '../api/option_check.mjs';
import { complaint } from '../shot/complain.mjs';
import { zodOf } from '../shot/schema.mjs';
import { QUEUE_OPTIONS } from './table.mjs';

const ABOUT = Object.freeze({ name: 'options', code: 'E_OPTION' });
const schema = zodOf(QUEUE_OPTIONS);

/** Urgencies of RFC 9218: 0 first. */
export const LAST_PRIORITY = 7;
const PRIORITY = 3;
/** Characters of the name of a tenant. */
const TENANT = 256;

/**
 * Options with every default written out.
 * @param {object} options js/queue/index.d.ts documents them
 * @throws {import('../error/index.mjs').TelarError} E_OPTION
 */
export function readQueueOptions(options) {
  if (!isObject(options)) throw wrongOption('options', 'an object', options);
  const given = Object.fromEntries(Object.entries(options).filter(([, value]) => value !== undefined));
  const parsed = schema.safeParse(given);
  if (!parsed.success) throw complaint(parsed.error.issues, given, schema, { about: ABOUT });
  const { redis, sqlite, folder, name } = parsed.data;
  if (redis !== undefined && sqlite !== undefined) throw wrongOption('options.sqlite', 'nothing, as options.redis is there', sqlite);
  if (redis !== undefined && !/^rediss?:\/\/./.test(redis))
    throw wrongOption('options.redis', 'an address that begins with redis:// or rediss://', 'another one');
  if (folder !== undefined && redis === undefined) throw wrongOption('options.folder', 'nothing, as options.redis is not there', folder);
  if (!/^[\w-]+$/.test(name)) throw wrongOption('options.name', 'letters, digits, - and _', name);
  return parsed.data;
}

/**
 * What is said with a job, checked.
 * @param {{meta?: object, tenant?: string, priority?: number, put?: string[]}} [how]
 * @throws {import('../error/index.mjs').TelarError} E_OPTION
 */
export function readAdding({ meta = {}, tenant = '', priority = PRIORITY, put, ...rest } = {}) {
  const [unknown] = Object.keys(rest);
  if (unknown) throw wrongOption(`options.${unknown}`, 'meta, tenant, priority or put', rest[unknown]);
  if (!isObject(meta)) throw wrongOption('options.meta', 'an object', meta);
  if (typeof tenant !== 'string' || tenant.length > TENANT) throw wrongOption('options.tenant', `a text of at most ${TENANT} characters`, tenant);
  if (!Number.isInteger(priority) || priority < 0 || priority > LAST_PRIORITY)
    throw wrongOption('options.priority', `a whole number in [0, ${LAST_PRIORITY}]`, priority);
  const isAddress = (url) => typeof url === 'string' && URL.canParse(url) && /^https?:$/.test(new URL(url).protocol);
  if (put !== undefined && !(Array.isArray(put) && put.length > 0 && put.every(isAddress))) throw wrongOption('options.put', 'a list of addresses', put);
  return { meta, tenant, priority, put };
}
