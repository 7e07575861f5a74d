import { modelBytes } from './held_models.mjs';

let lastId = 0;

/** How a worker comes to a model: the file and how it is loaded, or a step from another model. A worker that has it is told its id alone. */
export class Recipe {
  /** Of the facts, once they are known: a worker that loads it again must come to the same. */
  sha256;
  /** What it takes in a worker. */
  bytes;

  /** @param {{input?: object, loading?: object, from?: Recipe, step?: object}} how */
  constructor({ input, loading, from, step }) {
    this.id = ++lastId;
    this.input = input;
    this.loading = loading;
    this.from = from;
    this.step = step;
  }

  /** That of the file. */
  get root() {
    return this.from ? this.from.root : this;
  }

  /** This one and those that it is made of. */
  get chain() {
    return this.from ? [...this.from.chain, this] : [this];
  }

  /** @param {import('../index.js').ModelFacts} facts */
  know(facts) {
    this.sha256 = facts.sha256;
    this.bytes = modelBytes(facts);
  }
}
