import { readFileSync } from 'node:fs';

// Shots at random out of the published JSON Schema: a key that is new there is tried too.

const schema = JSON.parse(readFileSync(new URL('../../../js/shot/schema.json', import.meta.url), 'utf8'));

/** Numbers at which ranges begin and end, denormals among them. */
const EDGES = [
  0,
  5e-324,
  1e-310,
  1e-300,
  1e-100,
  1e-46,
  1e-38,
  1e-31,
  1e-30,
  1e-12,
  1e-9,
  1e-6,
  1e-3,
  0.1,
  0.5,
  1,
  2,
  45,
  90,
  1e3,
  1e6,
  1e9,
  1.1e9,
  2 ** 31 - 1,
  2 ** 31,
  2 ** 53,
  3e38,
  4e38,
  1e29,
  1e30,
];

/** Strings of each kind that a shot holds; which of them a key takes its pattern says. */
const STRINGS = [
  '',
  'studio',
  'none',
  'transparent',
  'environment',
  'target',
  'maps/loft.hdr',
  'maps/ü \u{1f9f5}.exr',
  '\ud800.hdr',
  'white',
  '#1c3',
  'hsl(200 50% 40%)',
  'rgb(1e-9, 300, 7)',
  'navy',
  'Sleeve',
  'wool "raw" \\ /',
  '\u{1f9f5}',
  '\ud800',
  'a\udc00b',
  '\u2028',
  'x'.repeat(3000),
];

/** A generator of numbers [0, 1) that repeats itself. src: Steele et al. 2014, SplitMix; mulberry32 by T. Ettinger */
export function randomNumbers(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

export class RandomShots {
  #random;

  constructor(seed) {
    this.#random = randomNumbers(seed);
  }

  /** A shot that the schema takes; resolveShot may refuse it for what its keys mean together. */
  next() {
    return this.#value(schema, 0.3);
  }

  #pick(list) {
    return list[Math.floor(this.#random() * list.length)];
  }

  /** @param {number} share of the keys that need not be there */
  #value(node, share = 0.4) {
    if (node.const !== undefined) return node.const;
    if (node.enum) return this.#pick(node.enum);
    const branches = node.anyOf ?? node.oneOf;
    if (branches) return this.#value(this.#pick(branches), share);
    const type = Array.isArray(node.type) ? this.#pick(node.type) : node.type;
    return {
      object: () => this.#object(node, share),
      array: () => this.#array(node),
      number: () => this.#number(node, false),
      integer: () => this.#number(node, true),
      string: () => this.#string(node),
      boolean: () => this.#random() < 0.5,
      null: () => null,
    }[type]();
  }

  #object({ properties, additionalProperties, required = [] }, share) {
    if (!properties) return this.#random() < share ? { 'Body*': this.#value(additionalProperties), 0: this.#value(additionalProperties) } : {};
    const keys = Object.keys(properties).filter((key) => required.includes(key) || this.#random() < share);
    return Object.fromEntries(keys.map((key) => [key, this.#value(properties[key])]));
  }

  #array({ prefixItems, items, minItems = 0, maxItems = 3 }) {
    if (prefixItems) return prefixItems.map((item) => this.#value(item));
    return Array.from({ length: minItems + Math.floor(this.#random() * (maxItems - minItems + 1)) }, () => this.#value(items));
  }

  /** In half of the cases what a person would write, else an end of the range or a number near zero. */
  #number({ minimum = -Infinity, maximum = Infinity, exclusiveMinimum = -Infinity, default: usual }, integer) {
    const tame = [usual, 1, 2, 16, 64, 0.25, 3.5, -2, 30 * this.#random(), Math.floor(100 * this.#random())];
    const wild = [
      ...EDGES,
      ...EDGES.map((x) => -x),
      minimum,
      maximum,
      maximum * (1 - 2 ** -53),
      (maximum + Math.max(minimum, exclusiveMinimum)) / 2,
      10 ** (60 * this.#random() - 30),
    ];
    const fits = (x) => Number.isFinite(x) && x >= minimum && x <= maximum && x > exclusiveMinimum && (!integer || Number.isSafeInteger(x));
    const [first, second] = (this.#random() < 0.5 ? [tame, wild] : [wild, tame]).map((list) => list.filter(fits));
    return this.#pick(first.length > 0 ? first : second);
  }

  #string({ pattern }) {
    const fits = pattern === undefined ? STRINGS : STRINGS.filter((text) => new RegExp(pattern, 'u').test(text));
    return this.#pick(fits);
  }
}
