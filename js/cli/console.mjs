import { writeAll } from './streams.mjs';

/**
 * What a command says: the result on stdout (text, or one JSON object), everything else on stderr.
 *
 * @typedef {object} Io
 * @property {import('node:stream').Readable} stdin
 * @property {import('node:stream').Writable & {isTTY?: boolean}} stdout
 * @property {import('node:stream').Writable & {isTTY?: boolean}} stderr
 * @property {Record<string, string | undefined>} env
 * @property {AbortSignal} [signal]
 */
export class Console {
  #io;
  #json;
  #quiet;

  /**
   * @param {Io} io
   * @param {{json?: boolean, quiet?: boolean}} [options]
   */
  constructor(io, { json = false, quiet = false } = {}) {
    this.#io = io;
    this.#json = json;
    this.#quiet = quiet;
  }

  /** The result: `object` with --json, else the lines. */
  async result(object, lines = []) {
    if (this.#json) return writeAll(this.#io.stdout, `${JSON.stringify(object)}\n`);
    return lines.length > 0 ? writeAll(this.#io.stdout, `${lines.join('\n')}\n`) : undefined;
  }

  /** Bytes as the result. */
  bytes(data) {
    return writeAll(this.#io.stdout, data);
  }

  /** A line on the way; --quiet drops it. */
  note(text) {
    if (!this.#quiet) this.#io.stderr.write(`${text}\n`);
  }

  /** @param {import('../error/index.mjs').TelarError} error @param {string} [about] the model */
  error(error, about) {
    const where = [error.pointer && `at ${error.pointer}`, error.offset !== undefined && `at byte ${error.offset}`].filter(Boolean);
    const text = `${about ? `${about}: ` : ''}${error.message} [${[error.code, ...where].join(' ')}]`;
    this.#io.stderr.write(`${this.#paint('31', 'telar:')} ${text}\n`);
  }

  /** @param {{code: string, message: string, pointer?: string}} warning @param {string} about the model */
  warning({ code, message, pointer }, about) {
    this.note(`${this.#paint('33', 'warning:')} ${about}: ${message} [${code}${pointer ? ` at ${pointer}` : ''}]`);
  }

  /**
   * A progress bar over `total` steps where a person watches.
   * @param {number} total
   * @param {{gradual?: boolean}} [options] gradual: steps take long and tell how far they are
   * @returns {Promise<{step(name: string, index: number): void, reach?: (index: number, part: number) => void, stop(): void}>} `reach` where it is shown
   */
  async progress(total, { gradual = false } = {}) {
    const { stderr, env } = this.#io;
    if ((total < 2 && !gradual) || !stderr.isTTY || env.CI || this.#quiet) return { step() {}, stop() {} };
    const {
      default: { SingleBar },
    } = await import('cli-progress');
    const count = gradual ? '{percentage}%' : '{value}/{total}';
    const bar = new SingleBar({
      stream: stderr,
      clearOnComplete: true,
      hideCursor: true,
      etaBuffer: 20,
      format: `{bar} ${count}  {eta_formatted} left  {name}`,
      barCompleteChar: '#',
      barIncompleteChar: '-',
      barsize: 24,
    });
    const start = () => bar.start(total, 0, { name: '' });
    if (total > 1) start();
    if (!gradual) return { step: (name) => bar.increment({ name }), stop: () => bar.stop() };
    const parts = new Array(total).fill(0);
    const reach = (index, part, payload = {}) => {
      // One picture alone may be drawn by the raster, which tells its end only: there is no bar then.
      if (!bar.isActive && part === 1) return;
      if (!bar.isActive) start();
      parts[index] = part;
      bar.update(
        parts.reduce((sum, each) => sum + each, 0),
        payload,
      );
    };
    return { reach, step: (name, index) => reach(index, 1, { name }), stop: () => bar.stop() };
  }

  /** Colour where a terminal shows it and NO_COLOR (no-color.org) does not forbid it. */
  #paint(colour, text) {
    const { stderr, env } = this.#io;
    return stderr.isTTY && !env.NO_COLOR && env.TERM !== 'dumb' ? `\u001b[${colour}m${text}\u001b[0m` : text;
  }
}
