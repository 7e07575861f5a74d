import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { checkShared } from './shared_shot.mjs';

/** Options of createSheet. */

export const SHEET_FORMATS = Object.freeze(['pdf', 'svg', 'png']);

const wrong = (name, expected, value) => new TelarError('E_OPTION', `options.${name}: expected ${expected}, got ${shown(value)}`);

const KNOWN = {
  renderer: ['a renderer of createRenderer', (value) => typeof value?.renderAll === 'function'],
  format: [`one of ${SHEET_FORMATS.join(', ')}`, (value) => SHEET_FORMATS.includes(value)],
  fonts: ['a list of bytes of fonts', (value) => Array.isArray(value) && value.every((font) => font instanceof Uint8Array)],
  resolve: ['a function', (value) => typeof value === 'function'],
  templates: ['folders by name', (value) => isObject(value) && Object.values(value).every((folder) => typeof folder === 'string' && folder !== '')],
  shot: ['an object', (value) => isObject(value)],
  previous: ['a spec', (value) => isObject(value)],
  limits: ['an object', (value) => isObject(value)],
  timeoutMs: ['a number of milliseconds above 0, or null for no bound', (value) => value === null || (Number.isFinite(value) && value > 0)],
  signal: ['an AbortSignal', (value) => value instanceof AbortSignal],
  onProgress: ['a function', (value) => typeof value === 'function'],
};

const isObject = (value) => typeof value === 'object' && value !== null && !Array.isArray(value);

const DEFAULTS = { format: 'pdf', fonts: [], templates: {}, shot: {} };

/** @param {object} options @throws {TelarError} E_OPTION */
export function readOptions(options) {
  if (!isObject(options)) throw new TelarError('E_OPTION', `options: expected an object, got ${shown(options)}`);
  for (const [key, value] of Object.entries(options)) {
    if (!Object.hasOwn(KNOWN, key))
      throw new TelarError('E_OPTION', `options.${shown(key).slice(1, -1)}: unknown key, expected one of ${Object.keys(KNOWN).join(', ')}`);
    const [expected, isRight] = KNOWN[key];
    if (value !== undefined && !isRight(value)) throw wrong(key, expected, value);
  }
  if (!options.renderer) throw wrong('renderer', KNOWN.renderer[0], options.renderer);
  checkShared(options.shot ?? {});
  return { ...DEFAULTS, ...Object.fromEntries(Object.entries(options).filter(([, value]) => value !== undefined)) };
}
