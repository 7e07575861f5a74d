import { TABLE } from './table.mjs';

// Copies of this module (ESM beside CommonJS, two versions in one tree) recognise each other's errors by this symbol.
const BRAND = Symbol.for('telar.TelarError');
const MESSAGE_MAX = 300;
/** What an error may say beside its row of the table. */
const FACTS = ['pointer', 'offset', 'limit', 'index', 'signal', 'input'];

const factsOf = (error) => Object.fromEntries(FACTS.filter((key) => error?.[key] !== undefined).map((key) => [key, error[key]]));

/**
 * The one error type of telar.
 * @property {string} code a row of js/error/table.mjs
 * @property {string} kind class of the error: usage, input, denied, unsupported, limit, time, memory, cancelled, busy,
 *   machine, crash, internal
 * @property {boolean} retryable the same call may succeed later
 * @property {string} [pointer] JSON pointer into the document that is wrong: the glTF, or the shot for E_SHOT
 * @property {number} [offset] byte offset in the file
 * @property {{name: string, max: number, actual: number}} [limit]
 * @property {number} [index] of renderAll: which of the shots, from 0
 * @property {string} [signal] of X_CRASH: what ended the worker, as "SIGSEGV"
 * @property {string} [input] of X_CRASH and X_QUARANTINE: SHA-256 of the model's bytes, 64 hex digits
 */
export class TelarError extends Error {
  /**
   * @param {string} code
   * @param {string} message what is wrong, where, and what to do; cut at 300 characters
   * @param {{pointer?: string, offset?: number, limit?: {name: string, max: number, actual: number}, index?: number, signal?: string,
   *   input?: string, cause?: unknown}} [facts]
   */
  constructor(code, message, facts = {}) {
    super(cut(message), facts.cause === undefined ? undefined : { cause: facts.cause });
    const row = TABLE[code] ?? TABLE.X_INTERNAL;
    this.code = code;
    this.kind = row.kind;
    this.retryable = row.retryable;
    for (const key of FACTS) {
      if (facts[key] !== undefined) this[key] = facts[key];
    }
    Object.defineProperty(this, BRAND, { value: true });
  }

  get name() {
    return 'TelarError';
  }

  /** Exit code of the CLI for this error. */
  get exit() {
    return (TABLE[this.code] ?? TABLE.X_INTERNAL).exit;
  }

  /** HTTP status for this error. */
  get http() {
    return (TABLE[this.code] ?? TABLE.X_INTERNAL).http;
  }

  /** Plain data for JSON: no stack, no cause (either may hold a path of the server). */
  toJSON() {
    const { code, kind, message, retryable } = this;
    return { code, kind, message, retryable, ...factsOf(this) };
  }

  static [Symbol.hasInstance](value) {
    if (this === TelarError) return typeof value === 'object' && value !== null && value[BRAND] === true;
    return Function.prototype[Symbol.hasInstance].call(this, value);
  }
}

function cut(message) {
  const text = String(message);
  return text.length <= MESSAGE_MAX ? text : `${text.slice(0, MESSAGE_MAX - 3)}...`;
}

/**
 * Makes a TelarError of the plain data that native code, a worker or toJSON() gives.
 * An unknown code becomes X_INTERNAL and stays in the message.
 * @param {{code?: string, message?: string, pointer?: string, offset?: number, limit?: object, index?: number, signal?: string, input?: string}} plain
 * @returns {TelarError}
 */
export function fromNative(plain) {
  if (plain instanceof Error && plain.code === undefined) return toTelarError(plain);
  if (plain instanceof TelarError) return plain;
  const { code, message = 'no message' } = plain ?? {};
  if (Object.hasOwn(TABLE, code ?? '')) return new TelarError(code, message, factsOf(plain));
  return new TelarError('X_INTERNAL', code === undefined ? message : `${code}: ${message}`, factsOf(plain));
}

/**
 * Any thrown value as a TelarError: a fault that is not one of ours is internal and keeps its cause.
 * @param {unknown} thrown
 * @returns {TelarError}
 */
export function toTelarError(thrown) {
  if (thrown instanceof TelarError) return thrown;
  if (thrown?.name === 'AbortError' || thrown?.name === 'TimeoutError') {
    return new TelarError(thrown.name === 'AbortError' ? 'X_CANCELLED' : 'X_TIMEOUT', thrown.message, { cause: thrown });
  }
  // Of C++ outside of a job's own thread: node-addon-api makes it an Error.
  if (thrown?.message === 'std::bad_alloc') return new TelarError('X_MEMORY', 'there is not enough memory for this job', { cause: thrown });
  return new TelarError('X_INTERNAL', thrown instanceof Error ? thrown.message : String(thrown), { cause: thrown });
}

export { TABLE as ERRORS, worstExit } from './table.mjs';
