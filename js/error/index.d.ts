import type { ErrorCode } from './codes.js';

export type { ErrorCode };
export type ErrorKind =
  | 'usage' | 'input' | 'denied' | 'unsupported' | 'limit' | 'time' | 'memory' | 'cancelled' | 'busy' | 'machine' | 'crash' | 'internal' | 'warning';

/** A limit that an input went over, in the unit that its name says. */
export interface LimitFact {
  name: string;
  max: number;
  actual: number;
}

export interface ErrorFacts {
  pointer?: string;
  offset?: number;
  limit?: LimitFact;
  index?: number;
  signal?: string;
  input?: string;
  cause?: unknown;
}

export interface PlainError {
  code: ErrorCode;
  kind: ErrorKind;
  message: string;
  retryable: boolean;
  pointer?: string;
  offset?: number;
  limit?: LimitFact;
  index?: number;
  signal?: string;
  input?: string;
}

/** The one error type of telar; js/docs/errors.md is the table of its codes. */
export class TelarError extends Error {
  constructor(code: ErrorCode, message: string, facts?: ErrorFacts);
  readonly code: ErrorCode;
  readonly kind: ErrorKind;
  /** The same call may succeed later. */
  readonly retryable: boolean;
  /** JSON pointer into the document that is wrong: the glTF, or the shot for E_SHOT. */
  readonly pointer?: string;
  /** Byte offset in the file. */
  readonly offset?: number;
  readonly limit?: LimitFact;
  /** Of renderAll: which of the shots, from 0. */
  readonly index?: number;
  /** Of X_CRASH: what ended the worker, as "SIGSEGV". */
  readonly signal?: string;
  /** Of X_CRASH and X_QUARANTINE: SHA-256 of the model's bytes, 64 hex digits. */
  readonly input?: string;
  /** Exit code of the command line for this error. */
  readonly exit: number;
  /** HTTP status for this error. */
  readonly http: number;
  toJSON(): PlainError;
}

/**
 * Any thrown value as a TelarError: an AbortSignal's reason is X_CANCELLED or X_TIMEOUT, what is not telar's own is X_INTERNAL with its cause.
 * @example
 * try {
 *   await renderer.render('shirt.glb');
 * } catch (thrown) {
 *   const { code, http } = toTelarError(thrown);
 *   console.error(code, http);
 * }
 */
export function toTelarError(thrown: unknown): TelarError;
