import { explodeOptions } from '../api/explode.mjs';
import { flatOptions } from '../api/flat_options.mjs';
import { measureOptions } from '../api/measure_options.mjs';
import { wrongOption } from '../api/options.mjs';
import { swatchOptions } from '../api/swatch.mjs';
import { unpackFlat } from './pictures.mjs';
import { Recipe } from './recipe.mjs';

/** What crosses to another process. @throws {TelarError} E_OPTION */
function plain(options) {
  try {
    return structuredClone(options);
  } catch (error) {
    throw wrongOption('options', `plain data as in JSON (${error.message.split('\n')[0]})`, options);
  }
}

/** A model that workers of a pool have loaded, or load when a job needs it. js/api/model.d.ts documents the methods. */
export class PoolModel {
  #recipe;
  #pool;

  /**
   * @internal
   * @param {Recipe} recipe
   * @param {object} facts
   * @param {{ask(request: object, signal?: AbortSignal): Promise<unknown>, readShot(shot: object): object, model(recipe: Recipe, facts: object): PoolModel}} pool
   */
  constructor(recipe, facts, pool) {
    this.#recipe = recipe;
    this.#pool = pool;
    /** As those of a model of a renderer. */
    this.facts = facts;
  }

  async measure(options) {
    const { timeoutMs } = measureOptions(options);
    const { signal, ...asked } = options;
    return this.#pool.ask({ method: 'measure', recipe: this.#recipe, args: [plain(asked)], timeoutMs, unpack: (value) => value }, signal);
  }

  async flat(shot = {}, options = {}) {
    const { timeoutMs } = flatOptions(options);
    const { signal, ...asked } = options;
    const read = this.#pool.readShot(shot);
    const unpack = (value) => unpackFlat(value, read.map);
    return this.#pool.ask({ method: 'flat', recipe: this.#recipe, shots: [read], args: [plain(asked)], timeoutMs, unpack }, signal);
  }

  async swatch(options) {
    const { timeoutMs } = swatchOptions(options);
    const { signal, timeoutMs: _, ...asked } = options;
    return this.#derive({ method: 'swatch', args: [plain(asked)], timeoutMs }, signal);
  }

  async explode(distance, options = {}) {
    const { signal, timeoutMs } = explodeOptions(distance, options);
    return this.#derive({ method: 'explode', args: [distance, {}], timeoutMs }, signal);
  }

  /** Documented in js/api/ranges.mjs. @internal */
  async rangesAlong(axes, options = {}) {
    const { signal, ...asked } = options;
    return this.#pool.ask(
      { method: 'rangesAlong', recipe: this.#recipe, args: [axes, plain(asked)], timeoutMs: asked.timeoutMs, unpack: (value) => value },
      signal,
    );
  }

  async #derive(step, signal) {
    const recipe = new Recipe({ from: this.#recipe, step });
    const { timeoutMs } = step;
    const facts = await this.#pool.ask({ method: 'derive', recipe, timeoutMs, unpack: (value) => value }, signal);
    return this.#pool.model(recipe, facts);
  }

  /** @internal */
  static recipeOf(model) {
    return model.#recipe;
  }

  /** @internal */
  static isModel(value) {
    return typeof value === 'object' && value !== null && #recipe in value;
  }
}
