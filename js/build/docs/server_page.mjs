import * as z from '../../dist/zod.mjs';
import { zodOf } from '../../shot/schema.mjs';
import { REQUESTS } from '../../server/requests.mjs';
import { OPTIONS as QUEUE_ROWS, QUEUE_OPTIONS } from '../../queue/table.mjs';
import { OPTIONS, PLUGIN_OPTIONS, SERVICE } from '../../server/table.mjs';
import { heading, row } from './tables.mjs';
import { interfaceText } from './types.mjs';

/** The tables of js/docs/server.md and js/docs/queue.md, and the types of the options of service and queue. */

const between = (name, source) => [`<!-- ${name}: written by js/build/docs/generate.mjs from js/${source} -->`, `<!-- end of ${name} -->`];

function replaced(page, name, lines, source = 'server') {
  const [begin, end] = between(name, source);
  const [from, to] = [page.indexOf(begin), page.indexOf(end)];
  if (from < 0 || to < from) throw new Error(`js/docs/${source}.md has no place for the table of ${name}`);
  return [page.slice(0, from) + begin, '', ...lines, '', page.slice(to)].join('\n');
}

const code = (value) => `\`${value}\``;
const shownDefault = (value) => (value === undefined ? '' : code(typeof value === 'object' ? JSON.stringify(value) : value));

const optionRows = (options) => [
  ...heading(['option', 'flag', 'default', 'meaning']),
  ...Object.entries(options).map(([name, { flag, doc, default: value, expected }]) => {
    const range = /in (\[.*\])$/.exec(expected)?.[1];
    return row([code(name), code(flag), shownDefault(value), `${doc}${range ? `; ${range}` : ''}`]);
  }),
];

const requestRows = (kind) => {
  const { keys, files } = REQUESTS[kind];
  return [
    ...heading(['key', 'default', 'meaning']),
    ...Object.entries(keys).map(([name, { doc, default: value, kind: type, values }]) =>
      row([code(name), shownDefault(value), `${doc}${type === 'choice' ? `: ${values.map(code).join(' ')}` : ''}`]),
    ),
    ...Object.entries(files).map(([name, { doc, many }]) => row([code(name), '', `file: ${doc}${many ? '; may be given again' : ''}`])),
  ];
};

/** @param {string} page @returns {string} the page with its tables */
export function withServerTables(page) {
  const tables = { options: optionRows(OPTIONS), ...Object.fromEntries(Object.keys(REQUESTS).map((kind) => [`keys of ${kind}`, requestRows(kind)])) };
  return Object.entries(tables).reduce((text, [name, lines]) => replaced(text, name, lines), page);
}

/** @param {string} page @returns {string} the page with its table */
export const withQueueTable = (page) => replaced(page, 'options', optionRows(QUEUE_ROWS), 'queue');

const draft = (options) => z.toJSONSchema(zodOf(options), { io: 'input', unrepresentable: 'any' });

/** @returns {string} js/server/options.d.ts */
export const serverOptionTypes = (header) => {
  const service = draft(SERVICE);
  const plugin = draft(PLUGIN_OPTIONS);
  const own = Object.fromEntries(Object.entries(service.properties).filter(([name]) => !Object.hasOwn(plugin.properties, name)));
  return [
    header,
    interfaceText('PluginSettings', 'Options of the plugin that are plain data.', plugin),
    interfaceText('ServiceSettings', 'Options of the server that listen() makes, beside those of the plugin.', { ...service, properties: own }),
  ].join('\n');
};

/** @returns {string} js/queue/options.d.ts */
export const queueOptionTypes = (header) =>
  [header, interfaceText('QueueSettings', 'Options of a queue. js/docs/queue.md is the table of them.', draft(QUEUE_OPTIONS))].join('\n');
