import { randomBytes } from 'node:crypto';
import { FORMATS, SHOWN_FORMATS } from '../shot/table/output.mjs';
import { AVIF_TYPE } from '../api/avif.mjs';
import { isObject } from '../api/option_check.mjs';
import { TelarError } from '../error/index.mjs';
import { withLook } from '../shot/looks.mjs';
import { negotiate } from './negotiate.mjs';
import { SHEET_TYPES } from '../queue/perform.mjs';

/** From results to answers of HTTP. */

export const JSON_TYPE = 'application/json';
export { AVIF_TYPE };

const IMAGE_TYPES = Object.fromEntries(Object.entries(FORMATS).map(([format, { mediaType }]) => [mediaType, format]));
const SHEET_FORMATS = Object.fromEntries(Object.entries(SHEET_TYPES).map(([format, type]) => [type, format]));

/** In the order of preference: formats with transparency first, those that browsers do not show last. */
const PICTURES = SHOWN_FORMATS.toSorted((a, b) => FORMATS[b].alpha - FORMATS[a].alpha).map((format) => FORMATS[format].mediaType);
const OTHERS = Object.keys(IMAGE_TYPES).filter((type) => !PICTURES.includes(type));

const NO_AVIF = 'image/avif can be had where the package sharp is installed beside the service';

const outputOf = (shot) => (isObject(shot?.output) ? shot.output : {});

/** What a shot asks for that an answer in AVIF does not have, by key. Values that are wrong in every format are the worker's to refuse. */
const LACKS = {
  'shot.layers': ({ layers }) => layers !== undefined,
  'shot.output.bitDepth': ({ output }) => output?.bitDepth !== undefined && output.bitDepth !== 8,
  // With a scale it makes the size of the picture, and any format may have it.
  'shot.output.ppi': (shot) => typeof shot.output?.ppi === 'number' && shot.output.ppi > 0 && (withLook(shot).scale ?? 'none') === 'none',
  'shot.output.icc': ({ output }) => output?.icc === true,
};

const lackedBy = (shot) => Object.keys(LACKS).filter((key) => LACKS[key](shot));

/** It takes longest to encode, so that it comes after the others. */
const avifOf = (shot, { avif }) => (avif && (shot.output === undefined || isObject(shot.output)) && lackedBy(shot).length === 0 ? [AVIF_TYPE] : []);

const asPixels = (shot) => ({ ...shot, output: { ...shot.output, format: 'raw', bitDepth: 8 } });

/** Why a client that takes AVIF alone does not get it; undefined where the shot itself is wrong. */
function whyNoAvif(shot, { avif }) {
  if (!avif) return NO_AVIF;
  const named = [...(outputOf(shot).format === undefined ? [] : ['shot.output.format']), ...lackedBy(shot)];
  return named.length === 0 ? undefined : `image/avif is one picture of 8 bits a channel, without ppi and profile: leave out ${named.join(', ')}`;
}

function negotiatedPicture(accept, offered, shot, able) {
  try {
    return negotiate(accept, offered);
  } catch (error) {
    const why = /image\/avif/i.test(accept) ? whyNoAvif(shot, able) : undefined;
    // First, as messages have an end.
    throw why === undefined ? error : new TelarError('E_ACCEPT', `${why}; ${error.message}`);
  }
}

/**
 * What the client gets, by `accept` and by what the task says: the task with the format of its file, and the type of the answer.
 * @type {Record<string, (task: import('./task.mjs').Task, accept: string | undefined, able: {avif: boolean}) => {task: import('./task.mjs').Task, type: string}>}
 */
const WANTED = {
  thumbnail(task, accept, able) {
    const { shot = {} } = task.asked;
    const { format } = outputOf(shot);
    // A wrong one is the worker's to refuse, with the message of the shot.
    const offered = format === undefined ? [...PICTURES, ...avifOf(shot, able), JSON_TYPE, ...OTHERS] : [FORMATS[format]?.mediaType ?? JSON_TYPE, JSON_TYPE];
    const type = negotiatedPicture(accept, offered, shot, able);
    if (type === AVIF_TYPE) return { task: { ...task, asked: { ...task.asked, shot: asPixels(shot), encode: 'avif' } }, type };
    if (format !== undefined || !IMAGE_TYPES[type] || (shot.output !== undefined && !isObject(shot.output))) return { task, type };
    return { task: { ...task, asked: { ...task.asked, shot: { ...shot, output: { ...shot.output, format: IMAGE_TYPES[type] } } } }, type };
  },
  inspect: (task, accept) => ({ task, type: negotiate(accept, [JSON_TYPE]) }),
  sheet(task, accept) {
    const { format } = task.asked;
    const type = negotiate(accept, format ? [SHEET_TYPES[format], JSON_TYPE] : [...Object.values(SHEET_TYPES), JSON_TYPE]);
    return { task: { ...task, asked: { ...task.asked, format: format ?? SHEET_FORMATS[type] ?? 'pdf' } }, type };
  },
  compare(task, accept) {
    const type = negotiate(accept, [JSON_TYPE, 'image/png']);
    return { task: { ...task, asked: { ...task.asked, heatMap: type === 'image/png' } }, type };
  },
};

/**
 * @param {{avif: boolean}} able what can be encoded beside telar's own formats
 * @throws {TelarError} E_ACCEPT
 */
export const wantedOf = (task, accept, able) => WANTED[task.kind](task, accept, able);

/** All of a result: bytes in base64. */
const jsonOf = ({ key, info, files }) =>
  JSON.stringify({
    ...(key && { key }),
    info,
    files: files.map(({ name, type, data }) => ({ name, type, data: Buffer.from(data.buffer, data.byteOffset, data.byteLength).toString('base64') })),
  });

/** Several files (RFC 2046, 5.1). */
function mixed(files) {
  const boundary = `telar-${randomBytes(16).toString('hex')}`;
  const parts = files.flatMap(({ name, type, data }) => [
    Buffer.from(`--${boundary}\r\ncontent-type: ${type}\r\ncontent-disposition: attachment; filename="${name}"\r\n\r\n`),
    data,
    Buffer.from('\r\n'),
  ]);
  return { type: `multipart/mixed; boundary=${boundary}`, body: Buffer.concat([...parts, Buffer.from(`--${boundary}--\r\n`)]) };
}

const codesOf = (warnings = []) => [...new Set(warnings.map(({ code }) => code))].join(', ');

/**
 * @param {import('../queue/perform.mjs').Result} result
 * @param {{kind: string, type: string}} wanted
 * @returns {{type: string, body: Buffer | string, headers: Record<string, string>}}
 */
export function bodyOf(result, { kind, type }) {
  const codes = codesOf(result.info.warnings);
  const headers = codes && { 'telar-warnings': codes };
  if (type === JSON_TYPE) {
    const text = kind === 'thumbnail' || kind === 'sheet' ? jsonOf(result) : JSON.stringify(result.info);
    return { type: `${JSON_TYPE}; charset=utf-8`, body: text, headers };
  }
  if (kind === 'sheet' && result.files.length > 1) return { ...mixed(result.files), headers };
  const [{ type: own, name, data }] = result.files;
  return { type: own, body: data, headers: { ...headers, 'content-disposition': `inline; filename="${name}"` } };
}
