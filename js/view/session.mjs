import path from 'node:path';
import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';
import { resolveShot } from '../shot/resolve.mjs';
import { Environments } from './environments.mjs';
import { modelFiles } from './model_files.mjs';

/** Pixels as they are: RGBA8, straight alpha, top row first. Pixels per inch decide the size of a picture in scale; of others they are the file's alone. */
const pixelsOf = ({ scale = 'none', output }) => ({ format: 'raw', ...(scale !== 'none' && { ppi: output?.ppi }) });

/** Name of a model that came as bytes. */
const BYTES_NAME = 'model.glb';

/**
 * What one `telar view` shows: a model and the shot that it begins with.
 */
export class Session {
  #renderer;
  #source;
  #shot;
  #environments;
  #spec;
  #model;
  #files;
  #isFresh = false;

  /**
   * @param {object} what
   * @param {Awaited<ReturnType<import('../api/renderer.mjs').createRenderer>>} what.renderer
   * @param {string | Uint8Array} what.source path, or bytes of a GLB
   * @param {object} what.shot not resolved
   * @param {import('./spec_file.mjs').SpecFile} [what.spec] the spec of a tech sheet that the page edits
   */
  constructor({ renderer, source, shot, spec }) {
    this.#renderer = renderer;
    this.#source = source;
    this.#spec = spec;
    this.#environments = new Environments(shot);
    this.#shot = this.#environments.forPage(shot);
  }

  /** @returns {string} file name, without its folder */
  get name() {
    return typeof this.#source === 'string' ? path.basename(this.#source) : BYTES_NAME;
  }

  /**
   * Reads the model; again when it was read before, as the file may have changed.
   * @param {AbortSignal} [signal]
   * @throws {import('../error/index.mjs').TelarError}
   */
  async load(signal) {
    const model = await this.#renderer.load(this.#source, { signal });
    this.#files = await this.#namedFiles();
    const old = this.#model;
    this.#model = model;
    this.#isFresh = true;
    if (old) await this.#renderer.release(old);
  }

  async #namedFiles() {
    try {
      return await modelFiles(this.#source);
    } catch (cause) {
      throw new TelarError('E_FILE', `${shown(this.name)} cannot be read (${cause.code ?? cause.message})`, { cause });
    }
  }

  /** @throws {import('../error/index.mjs').TelarError} where the shot that the view begins with is wrong for the model */
  async check() {
    resolveShot(this.#shot, await this.#renderer.factsOf(this.#model, this.#shot));
  }

  /**
   * What a page needs to begin. Each page gets the model as the file is now.
   * @param {AbortSignal} [signal]
   * @returns {Promise<object>}
   */
  async describe(signal) {
    if (!this.#isFresh) await this.load(signal);
    this.#isFresh = false;
    const { backend, gl } = this.#renderer;
    return {
      name: this.name,
      shot: this.#shot,
      environments: this.#environments.list(),
      spec: this.#spec?.name ?? null,
      server: { backend, renderer: gl.renderer, version: gl.version },
    };
  }

  /**
   * Draws a shot of the page.
   * @param {object} shot not resolved; of its output only the pixels per inch of a scale count
   * @param {AbortSignal} signal
   * @param {(preview: import('../index.js').Preview) => void} [onPreview] each picture so far
   * @returns {Promise<{data: Buffer, info: object}>} RGBA8, straight alpha, top row first; `info.shot` as the page knows it
   * @throws {import('../error/index.mjs').TelarError}
   */
  async draw(shot, signal, onPreview) {
    if (typeof shot !== 'object' || shot === null) throw new TelarError('E_SHOT', 'shot: expected an object', { pointer: '' });
    const known = this.#environments.forRenderer(shot);
    if (!known) {
      const names = this.#environments
        .list()
        .map(({ map }) => shown(map))
        .join(', ');
      throw new TelarError('E_SHOT', `shot.environment: this view has ${names}; open it with --environment to use another file`, { pointer: '/environment' });
    }
    const { data, info } = await this.#renderer.render(this.#model, { ...known, output: pixelsOf(known) }, { signal, onPreview });
    const { width, height, milliseconds, warnings } = info;
    return { data, info: { width, height, milliseconds, warnings, shot: this.#environments.forPage(info.shot) } };
  }

  /** @returns what a spec is read against: the model's facts, and the style's name where it has none */
  get #about() {
    return { facts: this.#model.facts, style: typeof this.#source === 'string' ? path.parse(this.#source).name : '' };
  }

  /** Whether a spec is edited. */
  get hasSpec() {
    return this.#spec !== undefined;
  }

  /** @see SpecFile.describe */
  describeSpec() {
    return this.#spec.describe(this.#about);
  }

  /** @see SpecFile.measure */
  measure(body, signal) {
    return this.#spec.measure(body, { ...this.#about, model: this.#model, signal });
  }

  /** @see SpecFile.save */
  saveSpec(body) {
    return this.#spec.save(body, this.#about);
  }

  /** Whether the model has KTX2 textures: three's transcoder for them makes functions of text. */
  get hasBasis() {
    return this.#files.hasBasis;
  }

  /** @returns {string | undefined} path of an environment's file */
  environmentFile(map) {
    return this.#environments.fileOf(map);
  }

  /**
   * A file of the model.
   * @param {string} name as the browser asks for it, decoded
   * @returns {{folder: string, file: string} | Uint8Array | undefined} undefined where the model names no such file
   */
  modelFile(name) {
    if (typeof this.#source !== 'string') return name === BYTES_NAME ? this.#source : undefined;
    return this.#files.files.has(name) ? { folder: this.#files.folder, file: name } : undefined;
  }
}
