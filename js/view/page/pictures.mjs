import { Comparer } from './comparison.mjs';
import { showFigures } from './figures.mjs';
import { isLong } from '../../shot/quality.mjs';
import { draw, grow } from './remote.mjs';
import { shotDifferences } from './shot_differences.mjs';

/** How long a shot must stand still before the server draws it. */
const SETTLE_MS = 150;

const $ = (id) => document.getElementById(id);

/** Draws the state on both sides and compares them; only what was asked for last is shown. */
export class Pictures {
  #state;
  #client;
  #stage;
  #serverGl;
  #setPhase;
  #fail;
  #comparer = new Comparer();
  #request = new AbortController();
  #timer;
  #drawing;
  #isWanted = false;

  /** What the pictures show: {browser, server: pixels, resolved}; empty before the first. */
  shown = {};

  /**
   * @param {object} options
   * @param {import('./shot_state.mjs').ShotState} options.state
   * @param {import('./client.mjs').Client} options.client
   * @param {import('./stage.mjs').Stage} options.stage
   * @param {string} options.serverGl name of the GL that the server draws with
   * @param {(phase: 'drawing' | 'comparing' | 'ready') => void} options.setPhase
   * @param {(error: Error) => void} options.fail
   */
  constructor({ state, client, stage, serverGl, setPhase, fail }) {
    this.#state = state;
    this.#client = client;
    this.#stage = stage;
    this.#serverGl = serverGl;
    this.#setPhase = setPhase;
    this.#fail = fail;
    state.addEventListener('change', () => void this.update());
  }

  /** @returns {Promise<void>} when the browser's picture stands */
  update() {
    clearTimeout(this.#timer);
    this.#request.abort();
    this.#comparer.cancel();
    this.#stage.markStale();
    this.#setPhase('drawing');
    const request = new AbortController();
    this.#request = request;
    this.#timer = setTimeout(() => this.#drawServer(request.signal), SETTLE_MS);
    return this.#drawClient();
  }

  /** The browser's picture follows every change; what comes while it draws is drawn after it, once. */
  #drawClient() {
    this.#isWanted = true;
    this.#drawing ??= this.#drawWanted()
      .catch((error) => {
        this.#request.abort();
        this.#fail(error);
      })
      .finally(() => {
        this.#drawing = undefined;
      });
    return this.#drawing;
  }

  async #drawWanted() {
    while (this.#isWanted) {
      this.#isWanted = false;
      const { resolved } = this.#state;
      await this.#client.draw(resolved).catch((error) => {
        if (!this.#isWanted) throw error;
      });
      this.#stage.size = resolved.size;
    }
  }

  async #drawServer(signal) {
    const { shot, resolved } = this.#state;
    try {
      // The picture as it is shown, whatever file it was meant for: jpeg, for one, has a background of its own.
      const { output, ...seen } = shot;
      const asked = { ...seen, background: resolved.background, output: { ppi: resolved.output.ppi } };
      const { image, info } = await (isLong(resolved.quality) ? grow(asked, signal, (...sofar) => this.#showGrowing(...sofar)) : draw(asked, signal));
      await this.#drawing;
      if (signal.aborted) return;
      this.shown = { browser: this.#client.pixels(), server: image, resolved };
      this.#stage.showServer(image);
      this.#tell(info, resolved);
      await this.#compare(signal);
    } catch (error) {
      if (!signal.aborted) this.#fail(error);
    }
  }

  #showGrowing(image, samples) {
    this.#stage.showGrowing(image);
    $('server-time').textContent = `${samples} samples so far`;
  }

  /** Known once the browser has drawn. Another GL rounds, filters and antialiases otherwise; the browser's name of one holds the server's. */
  get gate() {
    return this.#client.glName.includes(this.#serverGl.split(' ')[0]) ? 'parity' : 'other-gl';
  }

  async #compare(signal) {
    this.#setPhase('comparing');
    const result = await this.#comparer.compare(this.shown.browser, this.shown.server, { gate: this.gate, mask: this.#client.mask() });
    if (!result || signal.aborted) return;
    this.#stage.showMaps(result);
    showFigures(result, { table: $('figures'), checks: $('checks'), pill: $('verdict'), ssim: $('ssim'), hint: $('gl-hint') });
    this.#setPhase('ready');
  }

  #tell({ milliseconds, warnings, shot }, resolved) {
    $('server-time').textContent = `${Math.round(milliseconds.total)} ms`;
    const differences = shotDifferences(resolved, shot).map(
      ({ path, ours, theirs }) => `The two sides resolved the shot differently: ${path} is ${ours} in the browser, ${theirs} on the server.`,
    );
    const notes = [...differences, ...warnings.map(({ message }) => message)];
    $('notes').replaceChildren(...notes.map((text) => Object.assign(document.createElement('li'), { textContent: text })));
  }
}
