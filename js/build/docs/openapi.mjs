import { readFileSync } from 'node:fs';
import * as z from '../../dist/zod.mjs';
import { ERRORS } from '../../error/index.mjs';
import { SHEET_TYPES } from '../../queue/perform.mjs';
import { AVIF_TYPE } from '../../server/answer.mjs';
import { REQUESTS } from '../../server/requests.mjs';
import { ROUTES, UNDESCRIBED } from '../../server/routes.mjs';
import { MODEL_TYPES } from '../../server/task.mjs';
import { zodOf } from '../../shot/schema.mjs';
import { FORMATS } from '../../shot/table/output.mjs';
import { shotJsonSchema, specJsonSchema } from './json_schema.mjs';

/** js/server/openapi.json (OpenAPI 3.1): from the tables of routes, requests, shot, sheet and errors. */

const { version } = JSON.parse(readFileSync(new URL('../../../package.json', import.meta.url), 'utf8'));

const JSON_TYPE = 'application/json';
const PROBLEM_TYPE = 'application/problem+json';
const ref = (kind, name) => ({ $ref: `#/components/${kind}/${name}` });
const json = (schema) => ({ content: { [JSON_TYPE]: { schema } } });
/** Bytes: OpenAPI 3.1 describes them by their media type alone. */
const binary = (types) => Object.fromEntries(types.map((type) => [type, {}]));
const text = (description) => ({ type: 'string', ...(description && { description }) });

/** Schemas that stand for keys which the worker checks. */
const LATE = {
  shot: ref('schemas', 'Shot'),
  spec: ref('schemas', 'Sheet'),
  previous: ref('schemas', 'Sheet'),
  measure: { type: 'array', items: { type: 'object' } },
};

function keySchema(name, row) {
  if (row.late) return { ...LATE[name], description: row.doc };
  const { $schema, ...schema } = z.toJSONSchema(zodOf(row), { io: 'input', unrepresentable: 'any' });
  return schema;
}

const keySchemas = (keys) => Object.fromEntries(Object.entries(keys).map(([name, row]) => [name, keySchema(name, row)]));
const isText = ({ kind }) => kind === 'text' || kind === 'choice';

/** Keys as parameters of the address: what is no text is written as JSON. */
const parameters = (keys) =>
  Object.entries(keys).map(([name, row]) => {
    const { description, ...schema } = keySchema(name, row);
    return { name, in: 'query', description, ...(isText(row) ? { schema } : json(schema)) };
  });

const HEADERS = {
  accept: { name: 'accept', in: 'header', description: 'Types of the answer', schema: text() },
  prefer: { name: 'prefer', in: 'header', description: '`wait=N`: seconds to wait for the answer; `respond-async`: a job', schema: text() },
  ifNoneMatch: { name: 'if-none-match', in: 'header', description: 'Tags of answers that the client has', schema: text() },
  requestId: {
    name: 'x-request-id',
    in: 'header',
    description: 'Id of the request in answers and in the log',
    schema: { ...text(), pattern: '^[\\w.-]{1,64}$' },
  },
};

/** A form: keys as fields, and files. */
function form({ keys, files }) {
  const fileSchemas = Object.fromEntries(
    Object.entries(files).map(([name, { doc, many }]) => [name, many ? { type: 'array', items: {}, description: doc } : { description: doc }]),
  );
  const fields = keySchemas(keys);
  // A model is a file or a reference.
  for (const name of Object.keys(fileSchemas)) if (fields[name]) fileSchemas[name] = { description: `${files[name].doc}; or ${fields[name].description}` };
  const encoding = Object.fromEntries(
    Object.entries(keys)
      .filter(([, row]) => !isText(row))
      .map(([name]) => [name, { contentType: JSON_TYPE }]),
  );
  return { schema: { type: 'object', properties: { ...fields, ...fileSchemas }, additionalProperties: false }, encoding };
}

function bodyOf({ keys, files }) {
  const content = { 'multipart/form-data': form({ keys, files }) };
  if (!files.model) return { required: true, content };
  const asked = { type: 'object', properties: keySchemas(keys), required: ['model'], additionalProperties: false };
  return { required: true, content: { ...content, [JSON_TYPE]: { schema: asked }, ...binary(MODEL_TYPES) } };
}

const FILES = {
  type: 'array',
  items: {
    type: 'object',
    properties: { name: text(), type: text('Media type'), data: { type: 'string', contentEncoding: 'base64' } },
    required: ['name', 'type', 'data'],
  },
};
const RESULT = { type: 'object', properties: { key: text('Content key'), info: { type: 'object' }, files: FILES }, required: ['info', 'files'] };

/** What goes well, by kind: types of the answer. */
const CONTENT = {
  thumbnail: { ...binary([...Object.values(FORMATS).map(({ mediaType }) => mediaType), AVIF_TYPE]), [JSON_TYPE]: { schema: RESULT } },
  inspect: { [JSON_TYPE]: { schema: { type: 'object' } } },
  compare: { [JSON_TYPE]: { schema: { type: 'object', required: ['comparison', 'verdict', 'hints'] } }, 'image/png': {} },
  sheet: { ...binary([...Object.values(SHEET_TYPES), 'multipart/mixed']), [JSON_TYPE]: { schema: RESULT } },
};

/** Codes by the status that they are told with; warnings have none. */
function statuses() {
  const found = new Map();
  for (const [code, { http }] of Object.entries(ERRORS).filter(([, row]) => row.http >= 400)) found.set(http, [...(found.get(http) ?? []), code]);
  return [...found].sort(([a], [b]) => a - b);
}

const problem = { [PROBLEM_TYPE]: { schema: ref('schemas', 'Problem') } };
const RETRY = { 'retry-after': { description: 'Seconds after which a place may be free', schema: { type: 'integer' } } };

const responses = () =>
  Object.fromEntries(
    statuses().map(([status, codes]) => [
      `e${status}`,
      { description: codes.join(', '), ...([429, 503].includes(status) && { headers: RETRY }), content: problem },
    ]),
  );

const refusals = () => Object.fromEntries(statuses().map(([status]) => [status, ref('responses', `e${status}`)]));

function work({ kind, doc }, method) {
  const request = REQUESTS[kind];
  const isGet = method === 'get';
  const headers = {
    etag: { description: 'Content key of a picture', schema: text() },
    'telar-warnings': { description: 'Codes of warnings of the model', schema: text() },
  };
  return {
    summary: doc,
    operationId: isGet ? `${kind}ByReference` : kind,
    parameters: [...parameters(request.keys), ...Object.keys(HEADERS).map((name) => ref('parameters', name))],
    ...(!isGet && { requestBody: bodyOf(request) }),
    responses: {
      200: { description: 'The result', headers, content: CONTENT[kind] },
      ...(isGet
        ? { 304: { description: 'The client has it' } }
        : { 202: { description: 'A job, where `prefer: respond-async` asks for one', ...json(ref('schemas', 'Job')) } }),
      ...refusals(),
    },
  };
}

/** What routes without keys of their own answer. */
const PLAIN = {
  signed: {
    200: { description: 'The picture', content: CONTENT.thumbnail },
    304: { description: 'The client has it' },
    ...refusals(),
  },
  job: { 200: { description: 'The job', ...json(ref('schemas', 'Job')) }, 404: ref('responses', 'e404') },
  jobEvents: {
    200: { description: 'Events named by the state of the job, with the job as data', content: { 'text/event-stream': { schema: text() } } },
    404: ref('responses', 'e404'),
  },
  jobResult: {
    200: { description: 'What the request would have got at once', content: Object.assign({}, ...Object.values(CONTENT)) },
    304: { description: 'The client has it' },
    ...refusals(),
  },
  error: { 200: { description: 'A row of the table of errors', ...json({ type: 'object' }) }, 404: ref('responses', 'e404') },
  health: { 200: { description: 'Alive', ...json({ type: 'object', properties: { status: { const: 'ok' } } }) } },
  readiness: { 200: { description: 'Ready', ...json(ref('schemas', 'Readiness')) }, 503: { description: 'Not ready', ...json(ref('schemas', 'Readiness')) } },
  metrics: { 200: { description: 'Figures', content: { 'text/plain': { schema: text() } } } },
  openapi: { 200: { description: 'OpenAPI 3.1', ...json({ type: 'object' }) } },
  page: { 200: { description: 'A page', content: { 'text/html': { schema: text() } } } },
};

const count = { type: 'integer', minimum: 0 };
const SCHEMAS = {
  Job: {
    type: 'object',
    properties: {
      id: text(),
      kind: { enum: Object.keys(REQUESTS) },
      state: { enum: ['waiting', 'running', 'done', 'failed', 'cancelled'] },
      progress: { type: 'number', minimum: 0, maximum: 1 },
      created: { type: 'string', format: 'date-time' },
      started: { type: 'string', format: 'date-time' },
      ended: { type: 'string', format: 'date-time' },
      error: ref('schemas', 'Problem'),
      links: { type: 'object', properties: { self: text(), events: text(), result: text() }, required: ['self', 'events'] },
    },
    required: ['id', 'kind', 'state', 'progress', 'created', 'links'],
  },
  Readiness: {
    type: 'object',
    properties: {
      status: { enum: ['ready', 'no workers', 'ending'] },
      workers: { type: 'object', properties: { idle: count, busy: count, starting: count } },
      running: count,
      waiting: count,
      jobs: { type: 'object', properties: { waiting: count, running: count, kept: count } },
    },
    required: ['status', 'workers', 'running', 'waiting'],
  },
  Problem: {
    type: 'object',
    description: 'RFC 9457, with the members of a TelarError',
    properties: {
      type: text('Address of the code'),
      title: text('What the code means'),
      status: { type: 'integer' },
      detail: text('What is wrong, where, and what is expected'),
      instance: text('Id of the request'),
      code: { enum: Object.keys(ERRORS) },
      kind: { enum: [...new Set(Object.values(ERRORS).map(({ kind }) => kind))] },
      message: text('The same as detail'),
      retryable: { type: 'boolean' },
      pointer: text('JSON pointer to the place (RFC 6901)'),
      offset: { ...count, description: 'Byte of the file' },
      limit: { type: 'object', properties: { name: text(), max: { type: 'number' }, actual: { type: 'number' } } },
    },
    required: ['type', 'title', 'status', 'detail', 'code', 'kind', 'message', 'retryable'],
  },
};

const pathOf = (url) => url.replaceAll(/:(\w+)/g, '{$1}');

/** Parameters in the path of a route. */
const inPath = (url) => [...url.matchAll(/:(\w+)/g)].map(([, name]) => ({ name, in: 'path', required: true, schema: text() }));

/** @returns {object} the document */
export function openapi() {
  const paths = {};
  for (const [name, route] of Object.entries(ROUTES).filter(([name]) => !UNDESCRIBED.includes(name))) {
    const { url, methods, doc, kind } = route;
    const operation = (method) =>
      kind ? work(route, method) : { summary: doc, operationId: method === 'get' ? name : `${name}${method}`, responses: PLAIN[name] };
    const fixed = inPath(url);
    paths[pathOf(url)] = {
      ...(fixed.length > 0 && { parameters: fixed }),
      ...Object.fromEntries(methods.map((method) => [method.toLowerCase(), operation(method.toLowerCase())])),
    };
  }
  const nested = ({ $schema, ...schema }) => schema;
  return {
    openapi: '3.1.0',
    info: { title: 'telar', version, description: 'Pictures of glTF models over HTTP' },
    paths,
    components: {
      schemas: { Shot: nested(shotJsonSchema()), Sheet: nested(specJsonSchema()), ...SCHEMAS },
      parameters: HEADERS,
      responses: responses(),
    },
  };
}
