import type { ResolvedShot, Shot } from '../shot/shot.js';
import type { CallOptions, Limits, Resolve, Source } from './loading.js';

export interface PictureKeyOptions extends CallOptions {
  /**
   * What an input may cost, by the L_* names.
   * @default {}: the limits in js/docs/errors.md
   */
  limits?: Limits;
  /**
   * As LoadingOptions has it.
   * @default undefined: files are read beside the model
   */
  resolve?: Resolve;
  /**
   * As LoadingOptions has it.
   * @default false
   */
  ambientVisibility?: boolean | { rays?: number };
}

/**
 * Gives the key that a picture will have as `info.key`. It neither draws the picture nor decodes the model. A service can answer
 * "not modified" by it, and a batch can leave out what has not changed.
 * @param options - limits, resolve, ambientVisibility, signal.
 * @returns 64 hex digits
 * @throws {TelarError} E_SHOT, E_OPTION
 * @example
 * const etag = await pictureKey('shirt.glb', { camera: { view: 'back' } });
 */
export function pictureKey(source: Source, shot?: Shot | ResolvedShot, options?: PictureKeyOptions): Promise<string>;
