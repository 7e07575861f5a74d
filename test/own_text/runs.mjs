// Runs of equal tokens that two sets of texts share.

/**
 * Calls back with each token and its line, from 1: words, numbers' digits and single characters of punctuation. `1.0` is three
 * tokens, so that no other way of counting finds a longer run. Comments and white space are left out.
 * @param {string} text
 * @param {(token: string, line: number) => void} found
 */
export function forEachToken(text, found) {
  let line = 1;
  for (const [token] of text.matchAll(/\/\*[\s\S]*?\*\/|\/\/[^\n]*|\n|\w+|[^\s\w]/g)) {
    if (token === '\n') line++;
    else if (token.startsWith('/*') && token.length > 1) line += token.split('\n').length - 1;
    else if (!token.startsWith('//')) found(token, line);
  }
}

/** Texts as one list of numbers, the same number for the same token; a number of its own parts two texts. */
class TokenList {
  #files = [];

  /**
   * @param {Iterable<[string, string]>} texts - Name and text.
   * @param {Map<string, number>} numbers - Of tokens seen so far; grows.
   */
  constructor(texts, numbers) {
    const list = [];
    this.lines = [];
    for (const [name, text] of texts) {
      this.#files.push({ name, from: list.length });
      forEachToken(text, (token, line) => {
        let number = numbers.get(token);
        if (number === undefined) numbers.set(token, (number = numbers.size));
        list.push(number);
        this.lines.push(line);
      });
      numbers.set(Symbol(name), numbers.size);
      list.push(numbers.size - 1);
      this.lines.push(0);
    }
    this.numbers = Uint32Array.from(list);
  }

  /** @returns {string} `name:line` of a token. */
  place(at) {
    const file = this.#files.findLast(({ from }) => from <= at);
    return `${file.name}:${this.lines[at]}`;
  }
}

const hashOf = (numbers, from, length) => {
  let hash = 0;
  for (let i = from; i < from + length; i++) hash = (Math.imul(hash, FACTOR) + numbers[i]) | 0;
  return hash;
};
const FACTOR = 0x01000193;

/**
 * @param {Map<string, string>} ours - Name to text.
 * @param {Map<string, string>} theirs - Name to text.
 * @param {number} length - Tokens, even.
 * @returns {{ours: string, theirs: string, tokens: number}[]} Runs of this length or more, as `name:line` of their first
 *   tokens; of each place in `ours` the longest.
 */
export function sharedRuns(ours, theirs, length) {
  const numbers = new Map();
  const own = new TokenList(ours, numbers),
    other = new TokenList(theirs, numbers);
  // A run holds a block of half its length that begins at a multiple of that length.
  const block = length / 2;
  const blocks = new Map();
  for (let at = 0; at + block <= own.numbers.length; at += block) {
    const hash = hashOf(own.numbers, at, block);
    blocks.set(hash, [...(blocks.get(hash) ?? []), at]);
  }
  let power = 1;
  for (let i = 1; i < block; i++) power = Math.imul(power, FACTOR);
  const longest = new Map();
  let hash = hashOf(other.numbers, 0, block);
  for (let at = 0; at + block <= other.numbers.length; at++) {
    for (const start of blocks.get(hash) ?? []) {
      const run = extended(own.numbers, other.numbers, start, at);
      if (run.tokens >= length && run.tokens > (longest.get(run.own)?.tokens ?? 0)) longest.set(run.own, run);
    }
    hash = (Math.imul(hash - Math.imul(other.numbers[at], power), FACTOR) + other.numbers[at + block]) | 0;
  }
  return [...longest.values()].map((run) => ({ ours: own.place(run.own), theirs: other.place(run.other), tokens: run.tokens }));
}

/** The run of equal tokens around two places. */
function extended(own, other, ownAt, otherAt) {
  let back = 0,
    on = 0;
  while (back < Math.min(ownAt, otherAt) && own[ownAt - back - 1] === other[otherAt - back - 1]) back++;
  while (ownAt + on < own.length && otherAt + on < other.length && own[ownAt + on] === other[otherAt + on]) on++;
  return { own: ownAt - back, other: otherAt - back, tokens: back + on };
}
