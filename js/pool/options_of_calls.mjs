import { checkObject, checkSignal, isObject, loading, wrongOption } from '../api/options.mjs';
import { bytesOf } from '../api/source.mjs';
import { TelarError } from '../error/index.mjs';
import { checkShared } from '../sheet/shared_shot.mjs';

/** Options of the methods that a pool has beside those of a renderer. */

const flag = (name, value = false) => {
  if (typeof value === 'boolean') return value;
  throw wrongOption(`options.${name}`, 'true or false', value);
};

/** A copy of what crosses to another process. @param {(expected: string) => Error} wrong */
function copied(value, wrong) {
  try {
    return structuredClone(value);
  } catch (error) {
    throw wrong(`plain data as in JSON (${error.message.split('\n')[0]})`);
  }
}

/** @throws {TelarError} E_OPTION */
const plain = (name, value) => copied(value, (expected) => wrongOption(name, expected, value));

/** @throws {TelarError} E_SPEC */
const plainSpec = (spec) => copied(spec, (expected) => new TelarError('E_SPEC', `spec: expected ${expected}`, { pointer: '' }));

/**
 * Options of Pool.inspect: {shot, measure, timeoutMs, failOn, resolve, ambientVisibility, signal}.
 * @param {import('../api/options.mjs').Loading} defaults of the pool
 */
export function inspectOptions(options, defaults) {
  checkObject('options', options, ['shot', 'measure', 'timeoutMs', 'failOn', 'resolve', 'ambientVisibility', 'signal']);
  const { shot = {}, measure = [], signal } = options;
  if (!Array.isArray(measure)) throw wrongOption('options.measure', 'a list of what to measure', measure);
  return { shot, measure: plain('options.measure', measure), loading: loading(options, defaults), signal: checkSignal(signal) };
}

/**
 * Options of Pool.compare: {gate, thresholds, resize, heatMap, timeoutMs, signal}.
 * @param {import('../api/options.mjs').Loading} defaults of the pool
 */
export function compareOptions(options, defaults) {
  checkObject('options', options, ['gate', 'thresholds', 'resize', 'heatMap', 'timeoutMs', 'signal']);
  const { gate, thresholds = {}, timeoutMs, signal } = options;
  if (!isObject(thresholds)) throw wrongOption('options.thresholds', 'an object', thresholds);
  return {
    asked: { gate, thresholds: plain('options.thresholds', thresholds), resize: flag('resize', options.resize), heatMap: flag('heatMap', options.heatMap) },
    timeoutMs: loading({ timeoutMs }, defaults).timeoutMs,
    signal: checkSignal(signal),
  };
}

/** Copies: the caller may write to the bytes at once. @throws {TelarError} E_OPTION */
function copyOf(name, value) {
  const bytes = bytesOf(value);
  if (!bytes) throw wrongOption(name, 'bytes (Buffer, Uint8Array, ArrayBuffer)', value);
  return { bytes: Buffer.from(bytes) };
}

/**
 * Options of Pool.sheet: {name, format, fonts, images, templates, shot, previous, timeoutMs, signal, onProgress}.
 * @param {import('../api/options.mjs').Loading} defaults of the pool
 */
export function sheetOptions(spec, options, defaults) {
  checkObject('options', options, ['name', 'format', 'fonts', 'images', 'templates', 'shot', 'previous', 'timeoutMs', 'signal', 'onProgress']);
  const { name = '', format = 'pdf', fonts = [], images, templates = {}, shot = {}, previous, timeoutMs, signal, onProgress } = options;
  if (typeof name !== 'string') throw wrongOption('options.name', 'a text', name);
  if (!isObject(shot)) throw wrongOption('options.shot', 'an object', shot);
  checkShared(shot);
  if (!Array.isArray(fonts)) throw wrongOption('options.fonts', 'a list of fonts', fonts);
  if (images !== undefined && !isObject(images)) throw wrongOption('options.images', 'an object of bytes by name', images);
  if (onProgress !== undefined && typeof onProgress !== 'function') throw wrongOption('options.onProgress', 'a function', onProgress);
  const others = [
    ...fonts.map((font, i) => [`font ${i}`, copyOf(`options.fonts[${i}]`, font)]),
    ...Object.entries(images ?? {}).map(([name, bytes]) => [`image ${name}`, copyOf('options.images', bytes)]),
  ];
  const asked = {
    spec: plainSpec(spec),
    previous: plain('options.previous', previous),
    ...plain('options', { name, format, templates, images: images ? Object.keys(images) : null, fonts: fonts.length }),
  };
  return { asked, others, shot, loading: loading({ timeoutMs }, defaults), onProgress, signal: checkSignal(signal) };
}
