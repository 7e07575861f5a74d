const STEP = 2;
const PAGE_STEP = 10;

/** The handle between two pictures that lie over each other: ARIA's slider. Left of it is the browser's. */
export class Wipe {
  #handle;
  #stage;
  #percent = 50;

  constructor(handle, stage) {
    this.#handle = handle;
    this.#stage = stage;
    handle.addEventListener('keydown', (event) => this.#onKey(event));
    handle.addEventListener('pointerdown', (event) => {
      event.stopPropagation();
      handle.setPointerCapture(event.pointerId);
    });
    handle.addEventListener('pointermove', (event) => {
      if (!handle.hasPointerCapture(event.pointerId)) return;
      const { left, width } = handle.parentElement.getBoundingClientRect();
      this.#set((100 * (event.clientX - left)) / width);
    });
    this.#set(this.#percent);
  }

  #onKey(event) {
    const wanted = {
      ArrowLeft: this.#percent - STEP,
      ArrowDown: this.#percent - STEP,
      ArrowRight: this.#percent + STEP,
      ArrowUp: this.#percent + STEP,
      PageDown: this.#percent - PAGE_STEP,
      PageUp: this.#percent + PAGE_STEP,
      Home: 0,
      End: 100,
    }[event.key];
    if (wanted === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    this.#set(wanted);
  }

  #set(percent) {
    this.#percent = Math.round(Math.max(0, Math.min(100, percent)));
    this.#handle.setAttribute('aria-valuenow', this.#percent);
    this.#handle.setAttribute('aria-valuetext', `browser ${this.#percent} %, server ${100 - this.#percent} %`);
    this.#stage.style.setProperty('--wipe', `${this.#percent}%`);
  }
}
