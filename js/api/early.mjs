import { stat } from 'node:fs';
import path from 'node:path';
import { loadNative } from './native.mjs';
import { onAbort } from './on_abort.mjs';
import { rendererOptions } from './options.mjs';
import { beginRenderer } from './renderer.mjs';

/**
 * A renderer with the default options that begins while a command line is still being read, which takes as long as to load the libraries of the GL; and the
 * load of the model that the command line seems to name. Whoever wants the same takes it; else it is closed.
 */
export class EarlyRenderer {
  #native;
  #begun;
  #file;
  #load;
  #unwanted = new AbortController();

  /**
   * @param {string} [file] of a model
   * @param {object} [native] the addon's exports
   * @throws {TelarError} X_NATIVE_MISSING
   */
  constructor(file = undefined, native = loadNative()) {
    // Node starts its threads for files with the first use of one, and who starts a thread waits while another loads libraries: before the GL, then.
    stat('.', () => {});
    this.#native = native;
    this.#begun = beginRenderer({}, native);
    // Whoever takes it tells.
    this.#begun.opened.catch(() => {});
    if (file === undefined) return;
    this.#file = path.resolve(file);
    this.#load = this.#begun.beginLoad(file, this.#unwanted.signal);
  }

  /**
   * @param {object} options of createRenderer
   * @returns {ReturnType<typeof beginRenderer> | undefined} once, where these are the default ones; whoever has it closes it
   */
  take(options) {
    const names = Object.keys(this.#native.limits);
    const said = ({ signal, ...rest }) => JSON.stringify(rest);
    if (!this.#begun || said(rendererOptions(options, names)) !== said(rendererOptions({}, names))) return undefined;
    const { renderer, opened, beginLoad } = this.#begun;
    this.#begun = undefined;
    return { renderer, opened, beginLoad: (source, signal) => this.#begunLoad(source, signal) ?? beginLoad(source, signal) };
  }

  /** The load that is on its way, once, where it is of this source. */
  #begunLoad(source, signal) {
    const load = this.#load;
    if (!load || path.resolve(source) !== this.#file) return undefined;
    this.#load = undefined;
    if (signal) onAbort(signal, (reason) => this.#unwanted.abort(reason));
    return load;
  }

  /** Ends what nobody has taken. */
  async close() {
    if (this.#load) this.#unwanted.abort();
    await this.#begun?.renderer.close();
  }
}
