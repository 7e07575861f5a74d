import os from 'node:os';
import path from 'node:path';
import { TelarError } from '../error/index.mjs';
import { nearest, shown } from '../shot/complain.mjs';
import { isObject, wrongOption } from './option_check.mjs';
import { raysOption, visibilityOption } from './visibility.mjs';

export { isObject, wrongOption };

export const BACKENDS = Object.freeze(['auto', 'egl-device', 'egl-surfaceless', 'osmesa']);
const MAX_WAITING = 1024;
/** Some two hundred prefiltered environments. */
const CACHE_BYTES = 256 * 2 ** 20;

/** As many keys as a message can hold. */
const MAX_LISTED = 12;

/** @throws {TelarError} E_OPTION where it is no object, or has a key beside the known ones */
export function checkObject(name, value, known) {
  if (!isObject(value)) throw wrongOption(name, 'an object', value);
  for (const key of Object.keys(value)) {
    if (known.includes(key)) continue;
    const near = nearest(key, known);
    const all =
      known.length <= MAX_LISTED
        ? `expected one of ${known.join(', ')}`
        : `the nearest of ${known.length} is ${nearest(key, known, Infinity)}; js/docs/errors.md has them all`;
    const hint = near ? `did you mean ${near}?` : all;
    throw new TelarError('E_OPTION', `${name}.${shown(key).slice(1, -1)}: unknown key, ${hint}`);
  }
}

/** @throws {TelarError} E_OPTION unless it is a whole number of at least `min` */
export function count(name, value, min) {
  if (Number.isSafeInteger(value) && value >= min) return value;
  throw wrongOption(name, `a whole number of at least ${min}`, value);
}

function limitsOption(value, known) {
  checkObject('options.limits', value, known);
  return Object.fromEntries(
    Object.entries(value)
      .filter(([, max]) => max !== undefined)
      .map(([name, max]) => [name, count(`options.limits.${name}`, max, 0)]),
  );
}

/** Where prefiltered environments and ambient visibility are kept between processes; null where the user has no folder. */
export function defaultCache() {
  if (process.env.XDG_CACHE_HOME) return path.join(process.env.XDG_CACHE_HOME, 'telar');
  try {
    return path.join(os.homedir(), '.cache/telar');
  } catch {
    return null; // no HOME, and a user id without a name
  }
}

function directory(name, value) {
  if (value === null) return '';
  if (typeof value !== 'string' || value === '' || value.includes('\0')) throw wrongOption(name, 'a path, or null for none', value);
  return path.resolve(value);
}

/** @returns {{cacheDirectory: string, cacheBytes: number}} Empty = nothing is kept. @throws {TelarError} E_OPTION */
const cacheOptions = ({ cacheDirectory = defaultCache(), cacheBytes = CACHE_BYTES }) => ({
  cacheDirectory: directory('options.cacheDirectory', cacheDirectory),
  cacheBytes: count('options.cacheBytes', cacheBytes, 0),
});

/** @throws {TelarError} E_OPTION unless it is an AbortSignal or undefined */
export function checkSignal(signal, name = 'options.signal') {
  if (signal === undefined || (isObject(signal) && typeof signal.aborted === 'boolean' && typeof signal.addEventListener === 'function')) return signal;
  throw wrongOption(name, 'an AbortSignal', signal);
}

const MAX_TIMEOUT_MS = 2 ** 31 - 1;

/** @throws {TelarError} E_OPTION unless it is milliseconds, null or undefined */
function timeoutOption(value) {
  if (value === undefined || value === null || (Number.isSafeInteger(value) && value >= 1 && value <= MAX_TIMEOUT_MS)) return value;
  throw wrongOption('options.timeoutMs', `whole milliseconds from 1 to ${MAX_TIMEOUT_MS}, or null for any time`, value);
}

/** What makes a call fail, mildest last. */
export const FAIL_ON = Object.freeze(['error', 'warning', 'none']);

/**
 * What decides how a model is loaded and how long work on it may take, where the caller does not say it again. timeoutMs: see
 * Work; undefined where nobody said it.
 * @typedef {{failOn: 'error' | 'warning' | 'none', resolve?: (uri: string, options: {signal?: AbortSignal}) => unknown, timeoutMs?: number | null,
 *   ambientVisibility?: number}} Loading ambientVisibility: rays of each side of a vertex
 */

/** @returns {Loading} @throws {TelarError} E_OPTION */
export function loading({ failOn, resolve, timeoutMs, ambientVisibility }, defaults) {
  if (failOn !== undefined && !FAIL_ON.includes(failOn)) throw wrongOption('options.failOn', FAIL_ON.map((name) => JSON.stringify(name)).join(', '), failOn);
  if (resolve !== undefined && typeof resolve !== 'function') throw wrongOption('options.resolve', 'a function', resolve);
  const time = timeoutOption(timeoutMs);
  return {
    failOn: failOn ?? defaults.failOn,
    resolve: resolve ?? defaults.resolve,
    timeoutMs: time === undefined ? defaults.timeoutMs : time,
    ambientVisibility: visibilityOption(ambientVisibility) ?? defaults.ambientVisibility,
  };
}

/** @type {Loading} */
export const STRICT = { failOn: 'error' };

/**
 * Options of one call: {signal}.
 * @returns {{signal: AbortSignal | undefined}}
 */
export function callOptions(options) {
  checkObject('options', options, ['signal']);
  return { signal: checkSignal(options.signal) };
}

/**
 * Options of a call that loads: {signal, timeoutMs, failOn, resolve, ambientVisibility}.
 * @param {object} options
 * @param {Loading} defaults of the renderer
 * @returns {Loading & {signal: AbortSignal | undefined}}
 */
export function loadOptions(options, defaults) {
  checkObject('options', options, ['signal', 'timeoutMs', 'failOn', 'resolve', 'ambientVisibility']);
  return { ...loading(options, defaults), signal: checkSignal(options.signal) };
}

const DRAW_KEYS = ['signal', 'timeoutMs', 'onProgress', 'failOn', 'resolve', 'ambientVisibility'];

/**
 * Options of a drawing: those of a call, and onProgress.
 * @param {object} options
 * @param {Loading} defaults of the renderer
 * @param {string[]} [keys] that are known
 * @returns {Loading & {signal: AbortSignal | undefined, onProgress: ((part: number) => void) | undefined}}
 */
export function drawOptions(options, defaults, keys = DRAW_KEYS) {
  checkObject('options', options, keys);
  const { signal, onProgress } = options;
  if (onProgress !== undefined && typeof onProgress !== 'function') throw wrongOption('options.onProgress', 'a function', onProgress);
  return { ...loading(options, defaults), signal: checkSignal(signal), onProgress };
}

/** Options of render: those of a drawing, onPreview, and reached. */
export function renderOptions(options, defaults) {
  const known = drawOptions(options, defaults, [...DRAW_KEYS, 'onPreview', 'reached']);
  const { onPreview, reached = false } = options;
  if (typeof reached !== 'boolean') throw wrongOption('options.reached', 'true or false', reached);
  if (onPreview !== undefined && typeof onPreview !== 'function') throw wrongOption('options.onPreview', 'a function', onPreview);
  return { ...known, onPreview, reached };
}

/** Options of a renderer's own render: those, and enough. A pool has no such one. */
export function growingOptions(options, defaults) {
  if (!isObject(options)) return renderOptions(options, defaults);
  const { enough, ...others } = options;
  return { ...renderOptions(others, defaults), enough: checkSignal(enough, 'options.enough') };
}

/** Options of renderAll: those of a drawing, and settled. */
export function drawAllOptions(options, defaults) {
  const known = drawOptions(options, defaults, [...DRAW_KEYS, 'settled']);
  const { settled = false } = options;
  if (typeof settled !== 'boolean') throw wrongOption('options.settled', 'true or false', settled);
  return { ...known, settled };
}

/** Keys of the options of createRenderer. */
export const RENDERER_KEYS = Object.freeze([
  'backend',
  'cacheDirectory',
  'cacheBytes',
  'limits',
  'maxWaiting',
  'timeoutMs',
  'failOn',
  'resolve',
  'ambientVisibility',
  'allFeatures',
  'signal',
]);

/**
 * Options of createRenderer with every default written out.
 * @param {object} options see createRenderer
 * @param {string[]} limitNames
 */
export function rendererOptions(options, limitNames) {
  checkObject('options', options, RENDERER_KEYS);
  const { backend = 'auto', limits = {}, maxWaiting = MAX_WAITING, allFeatures = false, signal } = options;
  if (!BACKENDS.includes(backend)) throw wrongOption('options.backend', BACKENDS.map((name) => JSON.stringify(name)).join(', '), backend);
  if (typeof allFeatures !== 'boolean') throw wrongOption('options.allFeatures', 'true or false', allFeatures);
  return {
    backend,
    ...cacheOptions(options),
    limits: limitsOption(limits, limitNames),
    maxWaiting: count('options.maxWaiting', maxWaiting, 0),
    loading: loading(options, STRICT),
    allFeatures,
    signal: checkSignal(signal),
  };
}

/**
 * Options of inspect: {shot, measure, limits, timeoutMs, failOn, resolve, ambientVisibility, signal}.
 * @param {string[]} limitNames
 */
export function inspectOptions(options, limitNames) {
  checkObject('options', options, ['shot', 'measure', 'limits', 'timeoutMs', 'failOn', 'resolve', 'ambientVisibility', 'signal']);
  const { shot = {}, measure = [], limits = {}, signal } = options;
  if (!Array.isArray(measure)) throw wrongOption('options.measure', 'a list of what to measure', measure);
  return { shot, measure, limits: limitsOption(limits, limitNames), ...loading(options, STRICT), signal: checkSignal(signal) };
}

/**
 * Options of pictureKey: {limits, resolve, ambientVisibility, signal}.
 * @param {string[]} limitNames
 */
export function keyOptions(options, limitNames) {
  checkObject('options', options, ['limits', 'resolve', 'ambientVisibility', 'signal']);
  const { limits = {}, resolve, ambientVisibility, signal } = options;
  return { limits: limitsOption(limits, limitNames), ...loading({ resolve, ambientVisibility }, STRICT), signal: checkSignal(signal) };
}

/**
 * Options of bake: {rays, cacheDirectory, cacheBytes, limits, timeoutMs, failOn, resolve, signal}.
 * @param {string[]} limitNames
 */
export function bakeOptions(options, limitNames) {
  checkObject('options', options, ['rays', 'cacheDirectory', 'cacheBytes', 'limits', 'timeoutMs', 'failOn', 'resolve', 'signal']);
  const { rays, limits = {}, timeoutMs, failOn, resolve, signal } = options;
  return {
    ...loading({ timeoutMs, failOn, resolve }, STRICT),
    ambientVisibility: raysOption(rays),
    ...cacheOptions(options),
    limits: limitsOption(limits, limitNames),
    signal: checkSignal(signal),
  };
}

/**
 * Options of what reads a file: {limits, signal}.
 * @param {string[]} limitNames
 */
export function fileOptions(options, limitNames) {
  checkObject('options', options, ['limits', 'signal']);
  const { limits = {}, signal } = options;
  return { limits: limitsOption(limits, limitNames), signal: checkSignal(signal) };
}
