import { AVIF_TYPE, encodeAvif } from '../api/avif.mjs';
import { bytesOf } from '../api/source.mjs';
import { FORMATS } from '../shot/table/output.mjs';
import { answerKey } from './key.mjs';
import { drawSized } from './picture_size.mjs';

/**
 * Does what a task asks for, in a pool.
 * @typedef {object} Result
 * @property {string} [key] of a picture, answerKey()
 * @property {object} info plain data
 * @property {{name: string, type: string, data: Buffer}[]} files
 */

export const SHEET_TYPES = Object.freeze({ pdf: 'application/pdf', svg: 'image/svg+xml', png: 'image/png' });

/** Files by the names that follow their field. */
const named = (files, field) =>
  Object.fromEntries(
    Object.entries(files)
      .filter(([name]) => name.startsWith(`${field} `))
      .map(([name, bytes]) => [name.slice(field.length + 1), bytes]),
  );

/** Answers for the files that a model names; senders of forms give file names without folders. */
function resolverOf(files) {
  const parts = named(files, 'part');
  if (Object.keys(parts).length === 0) return {};
  const find = (uri) => [uri, uri.split('/').at(-1)].find((name) => Object.hasOwn(parts, name));
  return { resolve: (uri) => parts[find(uri)] ?? null };
}

/** As JSON: bytes of an environment are the client's own. */
function plainInfo(info) {
  const { environment } = info.shot;
  return bytesOf(environment?.map) ? { ...info, shot: { ...info.shot, environment: { ...environment, map: null } } } : info;
}

/** @type {Record<string, (pool: import('../pool/index.js').Pool, task: import('./job_queue.mjs').Task, how: object) => Promise<Result>>} */
const KINDS = {
  async thumbnail(pool, { asked, files }, how) {
    const { shot = {}, failOn, ambientVisibility, encode, side } = asked;
    const drawing = { ...how, failOn, ambientVisibility, ...resolverOf(files) };
    const drawn = side === undefined ? pool.render(files.model, shot, drawing) : drawSized(pool, files.model, shot, { ...drawing, side });
    const { data, layers = {}, info } = await drawn;
    if (encode === 'avif') {
      const { quality } = shot.output;
      const file = { name: 'thumbnail.avif', type: AVIF_TYPE, data: await encodeAvif({ ...info, data }, { quality }) };
      return { key: answerKey(info.key, asked), info: { ...plainInfo(info), format: 'avif' }, files: [file] };
    }
    const { extensions, mediaType } = FORMATS[info.format];
    const beside = Object.entries(layers).map(([name, bytes]) => ({ name: `${name}${extensions[0]}`, type: mediaType, data: bytes }));
    return { key: answerKey(info.key, asked), info: plainInfo(info), files: [{ name: `thumbnail${extensions[0]}`, type: mediaType, data }, ...beside] };
  },
  async inspect(pool, { asked, files }, { onProgress, onPreview, ...how }) {
    const { shot = {}, failOn, measure } = asked;
    return { info: await pool.inspect(files.model, { ...how, shot, failOn, measure, ...resolverOf(files) }), files: [] };
  },
  async sheet(pool, { asked, files }, { onPreview, ...how }) {
    const { spec, previous, shot = {}, name, format } = asked;
    const images = named(files, 'image');
    const made = await pool.sheet(files.model, spec ?? null, {
      ...how,
      name,
      format,
      previous,
      shot,
      fonts: Object.values(named(files, 'font')),
      ...(Object.keys(images).length > 0 && { images }),
    });
    const page = (i) => (made.files.length > 1 ? `-${i + 1}` : '');
    return { info: made.info, files: made.files.map((data, i) => ({ name: `sheet${page(i)}.${format}`, type: SHEET_TYPES[format], data })) };
  },
  async compare(pool, { asked, files }, { onProgress, onPreview, ...how }) {
    const { heatMap, ...info } = await pool.compare(files.expected, files.actual, { ...how, ...asked });
    return { info, files: heatMap ? [{ name: 'heat_map.png', type: 'image/png', data: heatMap }] : [] };
  },
};

/**
 * @param {import('../pool/index.js').Pool} pool
 * @param {import('./job_queue.mjs').Task} task
 * @param {{signal: AbortSignal, timeoutMs?: number | null, onProgress?: (part: number) => void, onPreview?: (preview: object) => void, templates?: Record<string, string>}} how
 * @returns {Promise<Result>}
 * @throws {import('../error/index.mjs').TelarError}
 */
export function perform(pool, task, { templates, ...how }) {
  return KINDS[task.kind](pool, task, task.kind === 'sheet' && templates ? { ...how, templates } : how);
}
