import { Wipe } from './wipe.mjs';

const BLINK_MS = 700;

const paint = (canvas, { width, height, data }) => {
  Object.assign(canvas, { width, height });
  canvas.getContext('2d').putImageData(new ImageData(data, width, height), 0, 0);
};

/**
 * The two pictures and their difference, and the ways to look at them: side by side, with a slider, in turn, as a map.
 */
export class Stage {
  #root;
  #serverCanvas;
  #mapCanvas;
  #maps = {};
  #timer;
  #isPaused = matchMedia('(prefers-reduced-motion: reduce)').matches;

  constructor(root) {
    this.#root = root;
    this.#serverCanvas = root.querySelector('#server-picture canvas');
    this.#mapCanvas = root.querySelector('#map-picture canvas');
    new Wipe(root.querySelector('#wipe'), root);
  }

  get mode() {
    return this.#root.dataset.mode;
  }

  set mode(mode) {
    this.#root.dataset.mode = mode;
    this.#root.dataset.shown = 'browser';
    clearInterval(this.#timer);
    if (mode === 'blink' && !this.#isPaused) this.#timer = setInterval(() => this.#swap(), BLINK_MS);
    this.#showMap();
  }

  set size({ width, height }) {
    this.#root.style.setProperty('--aspect', width / height);
  }

  #swap() {
    this.#root.dataset.shown = this.#root.dataset.shown === 'browser' ? 'server' : 'browser';
  }

  /** Stops the blinking and shows the other picture; goes on when it was stopped. @returns {boolean} whether it blinks at all */
  pause() {
    if (this.mode !== 'blink') return false;
    this.#isPaused = !this.#isPaused;
    const shown = this.#root.dataset.shown;
    this.mode = 'blink';
    this.#root.dataset.shown = shown;
    if (this.#isPaused) this.#swap();
    return true;
  }

  showServer(image) {
    paint(this.#serverCanvas, image);
    this.#root.classList.remove('stale');
  }

  /** The server's picture so far: the maps are still of an older shot. */
  showGrowing(image) {
    paint(this.#serverCanvas, image);
  }

  /** The server's picture and the maps are of an older shot. */
  markStale() {
    this.#root.classList.add('stale');
  }

  /** @param {{difference: Uint8ClampedArray, flip: Uint8ClampedArray, comparison: object}} maps RGBA of the shot's size */
  showMaps({ difference, flip, comparison: { width, height, frame } }) {
    const map = (title, data) => ({ image: { width, height, data }, caption: frame.max === 0 ? `${title}: none` : title });
    this.#maps = { difference: map('Difference \u00d716', difference), flip: map('FLIP', flip) };
    this.#showMap();
  }

  #showMap() {
    const map = this.#maps[this.mode];
    if (!map) return;
    paint(this.#mapCanvas, map.image);
    this.#root.querySelector('#map-picture figcaption').textContent = map.caption;
  }
}
