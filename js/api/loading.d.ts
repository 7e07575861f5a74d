export type Backend = 'egl-device' | 'egl-surfaceless' | 'osmesa';

/** What an input may cost; js/docs/errors.md lists the L_* names. */
export type Limits = Partial<Record<`L_${string}`, number>>;

/** A path, a file: URL, or the bytes of a .glb or .gltf. */
export type Source = string | URL | ArrayBufferView | ArrayBuffer | SharedArrayBuffer;

/**
 * Gives the files that a model names. `uri` is the model's own relative reference, percent-decoded. Schemes, absolute paths and
 * ".." are refused before it is called. null or undefined: there is no such file. `signal` is that of the call.
 * @example
 * const resolve: Resolve = (uri, { signal }) => fetch(`https://models.example/${uri}`, { signal }).then((answer) => answer.arrayBuffer());
 */
export type Resolve = (uri: string, options: { signal?: AbortSignal }) => ResolvedBytes | Promise<ResolvedBytes>;
export type ResolvedBytes = ArrayBufferView | ArrayBuffer | SharedArrayBuffer | null | undefined;

/** How a model is loaded. A call without an option takes the renderer's. */
export interface LoadingOptions {
  /**
   * What makes a call fail.
   * - "error": anything that cannot be drawn as the file says.
   * - "warning": any warning too, as E_WARNING.
   * - "none": a texture that is missing, denied or damaged, and an unknown extension that the model requires, are only warnings
   *   (W_TEXTURE, W_EXT_REQUIRED). The picture is what three.js shows without them.
   *
   * A loaded model keeps what it was loaded with.
   * @default 'error'
   */
  failOn?: 'error' | 'warning' | 'none';
  /**
   * Gives the files that the model names. No file beside the model is opened then. The limits apply to what it gives. What it throws
   * is the cause of an X_RESOLVE.
   * @default undefined: files are read beside the model; a model given as bytes has none
   */
  resolve?: Resolve;
  /**
   * Milliseconds of work on one image, its loading included, before it ends with X_TIMEOUT; null = no bound. Each image of
   * renderAll has its own time, and so has the loading. Time spent waiting for a turn does not count. Where neither the call nor
   * the renderer gives it, a shot that asks for quality "high", quality "reference", more than 4 samples or a goal has no bound, nor has the loading for it.
   * @default 20000
   */
  timeoutMs?: number | null;
  /**
   * Finds by rays what each vertex sees of its surroundings, and darkens what the shading "fabric" draws of light from everywhere
   * there: folds, the inside of sleeves (js/docs/visibility.md). In place of what the file says of it. `rays`: of each side of a
   * vertex, 16 to 4096. Needs libembree3-3.
   * @default false: the file's attributes count, where it has them; true stands for { rays: 256 }
   */
  ambientVisibility?: boolean | { rays?: number };
}

export interface CallOptions {
  /**
   * Stops the work. The promise then rejects with the signal's reason.
   * @default undefined
   */
  signal?: AbortSignal;
}

export interface LoadOptions extends CallOptions, LoadingOptions {}
