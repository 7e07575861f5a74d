import { measure } from './remote.mjs';

/** What of a row its length does not depend on. */
const whereOf = ({ code: _code, description: _description, how: _how, tolerance: _tolerance, values: _values, grade: _grade, ...where }) =>
  JSON.stringify(where);

const hasPlace = ({ points, girth, border }) => Boolean(points || girth || border);

/** The lengths of points of measure, from the server: each place is asked for once, the newest row first. */
export class Lengths {
  #known = new Map();
  #wanted = [];
  #isAsking = false;
  #onKnown;

  /** @param {() => void} onKnown one more is known */
  constructor(onKnown) {
    this.#onKnown = onKnown;
  }

  /** @returns {{text: string, millimetres: number, path: number[][], isLoop: boolean, warnings: string[]} | undefined} */
  known(row) {
    const found = this.#known.get(whereOf(row));
    return found?.error ? undefined : found;
  }

  /** What a reader is told of a row. */
  told(row) {
    if (!hasPlace(row)) return { text: 'not on the model' };
    const found = this.#known.get(whereOf(row));
    if (found?.error) return { text: found.error.message, isWrong: true };
    if (!found) return { text: '\u2026' };
    if (found.warnings.length === 0) return { text: found.text };
    return { text: `${found.text}: ${found.warnings[0].replace(/^spec\.measures: /, '')}`, isWrong: true };
  }

  /** @param {object[]} measures all that there are */
  want(measures) {
    this.#wanted = measures;
    if (!this.#isAsking) void this.#ask();
  }

  async #ask() {
    this.#isAsking = true;
    for (;;) {
      const index = this.#wanted.findLastIndex((row) => hasPlace(row) && !this.#known.has(whereOf(row)));
      if (index < 0) break;
      const row = this.#wanted[index];
      const { tolerance: _tolerance, values: _values, grade: _grade, ...asked } = row;
      const found = await measure({ measure: asked, index }).catch((error) => ({ error }));
      this.#known.set(whereOf(row), found);
      this.#onKnown();
    }
    this.#isAsking = false;
  }
}
