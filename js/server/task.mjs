import { TelarError } from '../error/index.mjs';
import { isObject } from '../api/option_check.mjs';
import { complaint, nearest, shown, wrongValue } from '../shot/complain.mjs';
import { zodOf } from '../shot/schema.mjs';
import { object } from '../shot/table/rows.mjs';
import { receiveForm } from './form.mjs';
import { receiveBytes, receiveHashed } from './receive.mjs';
import { REQUESTS } from './requests.mjs';

/**
 * What a request asks for, read and checked as far as it is known before a worker sees it. Plain data and bytes: a queue can hold it.
 * @typedef {object} Task
 * @property {string} kind of REQUESTS
 * @property {Record<string, unknown>} asked by the keys of that row
 * @property {Record<string, Uint8Array>} files by field; of those that may be several by "field name"
 */

const ABOUT = Object.freeze({ name: 'request', code: 'E_REQUEST' });
export const MODEL_TYPES = ['model/gltf-binary', 'model/gltf+json', 'application/octet-stream'];
const JSON_BYTES = 2 ** 20;

const wrong = (message, pointer) => new TelarError('E_REQUEST', message, pointer === undefined ? {} : { pointer });
const givenTwice = (key) => wrong(`request.${key}: it is given twice`, `/${key}`);
const wrongKey = (key, expected, value) => wrongValue([key], expected, value, ABOUT);

const schemas = new Map();
/** Of the keys that are checked here. */
function schemaOf(kind) {
  if (!schemas.has(kind)) {
    const now = Object.entries(REQUESTS[kind].keys).filter(([, row]) => !row.late);
    schemas.set(kind, zodOf(object('Request', Object.fromEntries(now))));
  }
  return schemas.get(kind);
}

function parsed(text, key) {
  try {
    return JSON.parse(text);
  } catch (error) {
    throw wrong(`request.${key}: it is not JSON (${error.message.split('\n')[0]})`, `/${key}`);
  }
}

/** A text of a form or an address, as the row of its key has it. */
function read(text, key, row) {
  if (row.kind === 'text' || row.kind === 'choice') return text;
  return parsed(text, key);
}

/** @param {Iterable<[string, string]>} texts */
function fromTexts(kind, texts) {
  const { keys } = REQUESTS[kind];
  const asked = {};
  for (const [key, text] of texts) {
    refuseUnknown(kind, key);
    if (Object.hasOwn(asked, key)) throw givenTwice(key);
    asked[key] = read(text, key, keys[key]);
  }
  return asked;
}

function refuseUnknown(kind, key) {
  const known = Object.keys(REQUESTS[kind].keys);
  if (known.includes(key)) return;
  const near = nearest(key, known);
  throw wrong(`request.${shown(key).slice(1, -1)}: unknown key, ${near ? `did you mean ${near}?` : `expected one of ${known.join(', ')}`}`, '');
}

/** @returns {Record<string, unknown>} with the defaults of the keys that are checked here */
function checked(kind, given) {
  if (!isObject(given)) throw wrong(`request: expected an object, got ${shown(given)}`, '');
  for (const key of Object.keys(given)) refuseUnknown(kind, key);
  const { keys } = REQUESTS[kind];
  const lateOnes = Object.entries(given).filter(([key]) => keys[key].late);
  for (const [key, value] of lateOnes) {
    if (keys[key].kind === 'list' ? !Array.isArray(value) : !isObject(value)) throw wrongKey(key, keys[key].kind === 'list' ? 'a list' : 'an object', value);
  }
  for (const [key, value] of lateOnes) keys[key].check?.(value, `request.${key}`);
  const now = Object.fromEntries(Object.entries(given).filter(([key]) => !keys[key].late));
  const result = schemaOf(kind).safeParse(now);
  if (!result.success) throw complaint(result.error.issues, now, schemaOf(kind), { about: ABOUT });
  return { ...result.data, ...Object.fromEntries(lateOnes) };
}

/** Files of a form by field, and texts that came as files, as `curl -F shot=@shot.json` sends them. */
function sorted(kind, files) {
  const { keys, files: known } = REQUESTS[kind];
  const [texts, bytes] = [[], {}];
  for (const { field, name, bytes: content } of files) {
    if (Object.hasOwn(keys, field) && !Object.hasOwn(known, field)) {
      texts.push([field, content.toString('utf8')]);
      continue;
    }
    if (!Object.hasOwn(known, field)) throw wrong(`request.${shown(field).slice(1, -1)}: unknown file, expected one of ${Object.keys(known).join(', ')}`);
    const as = known[field].many ? `${field} ${name}` : field;
    if (Object.hasOwn(bytes, as)) throw wrong(`request.${shown(as).slice(1, -1)}: it is given twice`);
    bytes[as] = content;
  }
  return { texts, bytes };
}

/** Bodies are taken as they are: what is packed would have no bound on what it unpacks to. */
function refuseCoded({ headers }) {
  const coding = (headers['content-encoding'] ?? '').trim();
  if (coding === '' || coding.toLowerCase() === 'identity') return;
  throw new TelarError('E_MEDIA_TYPE', `the body has the content-encoding ${shown(coding)}; this route takes bodies without one`);
}

const mediaTypeOf = ({ headers }) => (headers['content-type'] ?? '').split(';')[0].trim().toLowerCase();

/**
 * @param {string} kind of REQUESTS
 * @param {{method: string, query: URLSearchParams, raw: import('node:http').IncomingMessage}} request
 * @param {object} bounds of receive(), with maxBytes of the whole and fileBytes of each file
 * @returns {Promise<{asked: Record<string, unknown>, files: Record<string, Uint8Array>}>}
 * @throws {TelarError} E_REQUEST, E_MEDIA_TYPE, and what receive() throws
 */
export async function readTask(kind, { method, query, raw }, { fileBytes, ...bounds }) {
  const { files: known } = REQUESTS[kind];
  const task = (asked, files = {}) => ({ kind, asked: checked(kind, asked), files });
  if (method === 'GET' || method === 'HEAD') return task(fromTexts(kind, query));
  refuseCoded(raw);
  const type = mediaTypeOf(raw);
  if (type === 'application/json') {
    const text = (await receiveBytes(raw, { ...bounds, maxBytes: JSON_BYTES })).toString('utf8');
    const [address, body] = [fromTexts(kind, query), parsedBody(text)];
    const twice = Object.keys(address).find((key) => Object.hasOwn(body, key));
    if (twice !== undefined) throw givenTwice(twice);
    return task({ ...address, ...body });
  }
  if (type === 'multipart/form-data') {
    const form = await receiveForm(raw, { ...bounds, fileBytes });
    const { texts, bytes } = sorted(kind, form.files);
    return task(fromTexts(kind, [...query, ...form.texts, ...texts]), bytes);
  }
  if (known.model && MODEL_TYPES.includes(type)) {
    const asked = checked(kind, fromTexts(kind, query));
    if (asked.model !== undefined) throw wrong('request.model: the body is the model already', '/model');
    return { kind, asked, files: { model: await receiveHashed(raw, { ...bounds, maxBytes: fileBytes, limit: 'L_FILE_BYTES' }) } };
  }
  const takes = ['multipart/form-data', ...(known.model ? ['application/json', ...MODEL_TYPES] : [])];
  throw new TelarError('E_MEDIA_TYPE', `the body is ${shown(type)}; this route takes ${takes.join(', ')}`);
}

function parsedBody(text) {
  let body;
  try {
    body = JSON.parse(text);
  } catch (error) {
    throw wrong(`the body is not JSON: ${error.message.split('\n')[0]}`, '');
  }
  if (!isObject(body)) throw wrong(`request: expected an object, got ${shown(body)}`, '');
  return body;
}
