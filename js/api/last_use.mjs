/** Whose it is to let a scene go: of the job that draws it last, with its picture or where it does not come to one. */
export class LastUse {
  #isLast;
  #hasEnded = false;

  /** @param {() => boolean} isLast whether nobody draws the scene after this job; it is asked once, as it counts the jobs */
  constructor(isLast) {
    let known;
    this.#isLast = () => (known ??= isLast());
  }

  /** The drawing that follows is the last of this job. @returns {boolean} whether it lets the scene go */
  end() {
    this.#hasEnded = true;
    return this.#isLast();
  }

  /** The job is over. @returns {boolean} whether it has to let the scene go itself */
  isLeft() {
    return !this.#hasEnded && this.#isLast();
  }
}
