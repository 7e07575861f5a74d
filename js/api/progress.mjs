/** Milliseconds between two looks at the jobs, and where previews are wanted. */
const INTERVAL = 100;
const PREVIEW_INTERVAL = 20;

/** Tells a caller how far several jobs are together: 0..1, never falling, 1 once and last, when all are done. */
export class ProgressReport {
  #tell;
  #show;
  #parts;
  #tokens = new Map();
  #timer;
  #said = 0;

  /**
   * @param {(part: number) => void} tell must not throw
   * @param {number} jobs
   * @param {(preview: object) => void} [show] each picture so far; must not throw
   */
  constructor(tell, jobs, show) {
    this.#tell = tell;
    this.#show = show;
    this.#parts = new Array(jobs).fill(0);
  }

  /** @param {number} job @param {{progress(): number, askPreviews(): void, takePreview(): object | undefined}} token native, of the job that begins */
  begin(job, token) {
    this.#tokens.set(job, token);
    // Nobody waits for the timer itself: the job keeps the event loop alive.
    this.#timer ??= setInterval(() => this.#look(), this.#show ? PREVIEW_INTERVAL : INTERVAL).unref();
    if (this.#show) token.askPreviews();
  }

  /** @param {number} job that is done */
  finish(job) {
    this.#tokens.delete(job);
    this.#parts[job] = 1;
    this.#say();
  }

  /** No more is told. */
  stop() {
    clearInterval(this.#timer);
    this.#tokens.clear();
  }

  #look() {
    for (const [job, token] of this.#tokens) {
      this.#parts[job] = token.progress();
      const preview = this.#show && token.takePreview();
      if (preview) this.#show(preview);
    }
    // 1 is said when the file is there, not when its pixels are.
    this.#say(1 - Number.EPSILON);
  }

  #say(most = 1) {
    const part = Math.min(this.#parts.reduce((sum, each) => sum + each, 0) / this.#parts.length, most);
    if (part <= this.#said) return;
    this.#said = part;
    this.#tell(part);
  }
}
