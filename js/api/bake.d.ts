import type { Warning } from './facts.js';
import type { CallOptions, Limits, LoadingOptions, Source } from './loading.js';

export interface BakeOptions extends CallOptions, Pick<LoadingOptions, 'failOn' | 'resolve'> {
  /**
   * Rays of each side of a vertex, 16 to 4096.
   * @default 256
   */
  rays?: number;
  /**
   * Folder of what rays have found, by the content of the file; null = none.
   * @default telar's folder in the user's cache
   */
  cacheDirectory?: string | null;
  /**
   * Bytes that the folder may hold. The files that were used longest ago are deleted first.
   * @default 268435456
   */
  cacheBytes?: number;
  /**
   * What the input may cost, by the L_* names.
   * @default {}: the limits in js/docs/errors.md
   */
  limits?: Limits;
  /**
   * Milliseconds before it ends with X_TIMEOUT; null = no bound.
   * @default null
   */
  timeoutMs?: number | null;
}

export interface BakedFile {
  /** The file with its new attributes. */
  data: Buffer;
  info: {
    format: 'glb' | 'gltf';
    /** The files that it names, beside which it has to lie. */
    parts: string[];
    /** That have got attributes. */
    primitives: number;
    vertices: number;
    rays: number;
    warnings: Warning[];
  };
}

/**
 * Writes the ambient visibility of a model into its vertices (js/docs/visibility.md), for the shading "fabric" on the server and in
 * browsers. Everything else in the file stays as it is. Needs no GL, but libembree3-3.
 * @param options - rays, limits, failOn, resolve, timeoutMs, signal.
 * @throws {TelarError} What Renderer.load() throws, L_VISIBILITY_RAYS, X_LIBRARY_MISSING
 * @example
 * const { data } = await bake('shirt.glb', { rays: 64 });
 */
export function bake(source: Source, options?: BakeOptions): Promise<BakedFile>;
