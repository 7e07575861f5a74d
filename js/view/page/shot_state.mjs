import { resolveShot } from '../../shot/resolve.mjs';

/**
 * The shot that the page shows: what the caller of telar would write, and the same with every default written out.
 * Fires `change`.
 */
export class ShotState extends EventTarget {
  #shot;
  #resolved;
  #facts;

  /**
   * @param {object} shot not resolved
   * @param {object} facts of the model
   * @throws {import('../../error/index.mjs').TelarError} as resolveShot
   */
  constructor(shot, facts) {
    super();
    this.#facts = facts;
    this.#shot = shot;
    this.#resolved = resolveShot(shot, facts);
  }

  get shot() {
    return this.#shot;
  }

  get resolved() {
    return this.#resolved;
  }

  get facts() {
    return this.#facts;
  }

  /**
   * Puts another shot in its place; on an error the old one stays.
   * @throws {import('../../error/index.mjs').TelarError}
   */
  replace(shot) {
    this.#resolved = resolveShot(shot, this.#facts);
    this.#shot = shot;
    this.dispatchEvent(new Event('change'));
  }

  /** Changes some keys. */
  change(keys) {
    this.replace({ ...this.#shot, ...keys });
  }

  /** Whether the keys would change nothing of the picture. */
  isShowing(keys) {
    return JSON.stringify(resolveShot({ ...this.#shot, ...keys }, this.#facts)) === JSON.stringify(this.#resolved);
  }
}
