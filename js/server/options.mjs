import { isObject, wrongOption } from '../api/option_check.mjs';
import { bytesOf } from '../api/source.mjs';
import { storeOption } from '../queue/result_store.mjs';
import { complaint } from '../shot/complain.mjs';
import { zodOf } from '../shot/schema.mjs';
import { readSigningKeys } from './signature.mjs';
import { OPTIONS, PLUGIN_OPTIONS, SERVICE } from './table.mjs';

/** What complaints are about. */
const ABOUT = Object.freeze({ name: 'options', code: 'E_OPTION' });

const schemas = { plugin: zodOf(PLUGIN_OPTIONS), service: zodOf(SERVICE) };

/** Options that are no plain data. */
const OWN = ['pool', 'queue', 'resolve', 'environments', 'templates', 'signingKeys', 'store'];

const isFunctionOr = (value) => value === undefined || typeof value === 'function';

/** @param {Record<string, unknown>} given @returns {Record<string, Uint8Array>} */
function environmentsOf(given) {
  if (!isObject(given)) throw wrongOption('options.environments', 'an object of bytes by name', given);
  return Object.fromEntries(
    Object.entries(given).map(([name, value]) => {
      const bytes = bytesOf(value);
      if (!bytes) throw wrongOption(`options.environments.${name}`, 'bytes of a .hdr or .exr file', value);
      return [name, bytes];
    }),
  );
}

/**
 * Options with every default written out.
 * @param {object} options js/server/index.d.ts documents them
 * @param {'plugin' | 'service'} of
 * @throws {import('../error/index.mjs').TelarError} E_OPTION
 */
export function readOptions(options, of = 'plugin') {
  if (!isObject(options)) throw wrongOption('options', 'an object', options);
  const given = Object.fromEntries(Object.entries(options).filter(([key, value]) => !OWN.includes(key) && value !== undefined));
  const parsed = schemas[of].safeParse(given);
  if (!parsed.success) throw complaint(parsed.error.issues, given, schemas[of], { about: ABOUT, known: OWN });
  const { pool, queue, resolve, environments = {}, templates = {}, signingKeys = [], store } = options;
  if (!isFunctionOr(resolve)) throw wrongOption('options.resolve', 'a function', resolve);
  if (pool !== undefined && !isObject(pool)) throw wrongOption('options.pool', 'a pool, or options of createPool', pool);
  if (queue !== undefined && !isObject(queue)) throw wrongOption('options.queue', 'a queue, or options of openQueue', queue);
  return {
    ...parsed.data,
    pool,
    queue,
    resolve,
    environments: environmentsOf(environments),
    templates,
    signingKeys: readSigningKeys(signingKeys),
    store: storeOption(store),
  };
}

/** Names of the options that are plain data, by what reads them. */
export const namesOf = (of) => Object.keys(OPTIONS).filter((name) => (OPTIONS[name].of ?? 'plugin') === of);
