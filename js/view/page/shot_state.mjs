import { resolveShot } from '../../shot/resolve.mjs';

/**
 * The shot that the page shows: what the caller of telar would write, and the same with every default written out.
 * Fires `change`.
 */
export class ShotState extends EventTarget {
  #shot;
  #resolved;
  #measure;

  /**
   * @param {object} shot not resolved
   * @param {(shot: object) => object} measure facts of the model as the shot poses it
   * @throws {import('../../error/index.mjs').TelarError} as resolveShot
   */
  constructor(shot, measure) {
    super();
    this.#measure = measure;
    this.#shot = shot;
    this.#resolved = this.#resolve(shot);
  }

  #resolve(shot) {
    return resolveShot(shot, this.#measure(shot));
  }

  get shot() {
    return this.#shot;
  }

  get resolved() {
    return this.#resolved;
  }

  /**
   * Puts another shot in its place; on an error the old one stays.
   * @throws {import('../../error/index.mjs').TelarError}
   */
  replace(shot) {
    this.#resolved = this.#resolve(shot);
    this.#shot = shot;
    this.dispatchEvent(new Event('change'));
  }

  /** Changes some keys. */
  change(keys) {
    this.replace({ ...this.#shot, ...keys });
  }

  /** Whether the keys would change nothing of the picture. */
  isShowing(keys) {
    return JSON.stringify(this.#resolve({ ...this.#shot, ...keys })) === JSON.stringify(this.#resolved);
  }
}
