import { readFileSync } from 'node:fs';
import { TelarError } from '../../js/error/index.mjs';
import { changesBetween, readSpec } from '../../js/sheet/index.mjs';
import { wordsOf } from '../../js/sheet/words.mjs';
import { between, oneOf, seeded } from '../js/sheet/random.mjs';
import { randomSpec } from '../js/sheet/random_specs.mjs';

// The reader of specs of sheets, on specs that are changed in their structure. What comes back says what is kept: a spec with a complaint that no other had is a
// new one to change.

const EXAMPLE = JSON.parse(readFileSync(new URL('../../js/docs/sheet/tshirt.json', import.meta.url), 'utf8'));
const FACTS = { variants: ['natural', 'indigo'] };
const RANDOM_SEEDS = 8;
const MOST_CHANGES = 4;
/** Part of the specs that are changed once more after a complaint. */
const PART_TOLD = 0.2;
/** How often a walk to a place ends at each step. */
const STOP = 0.2;
const MOST_CHARACTERS = 400_000;
/** The longest message of a TelarError. */
const MESSAGE_MAX = 300;
/** Milliseconds of CPU time that no spec takes: a thousand times the usual. */
const LONGEST_CPU_MS = 5000;

const NUMBERS = [0, -0, -1, 1, 0.5, 255, 65_536, 2 ** 31, 2 ** 53, 1e30, 1.7e308, -1.7e308, 5e-324];
const TEXTS = ['', ' ', '\0', '\n', '\ud800', '\u202e', '__proto__', 'constructor', 'toString', '1:0', '1:5', 'fit', 'front', '#fff', '../x', 'é'.repeat(5000)];
const SPECIAL = [null, true, false, [], {}, [[]], [null], { length: 1e9 }];
const KEYS = ['__proto__', 'constructor', 'length', 'toString', '', 'name', 'view', '\0'];

const copied = (value) => (value === undefined ? undefined : JSON.parse(JSON.stringify(value)));
const isHolder = (value) => typeof value === 'object' && value !== null;

/** Every place of a document: what holds it, and its key. */
function placesOf(value, found = []) {
  if (!isHolder(value)) return found;
  for (const key of Object.keys(value)) {
    found.push({ holder: value, key });
    placesOf(value[key], found);
  }
  return found;
}

/** A place by steps from the top, so that long lists do not draw all changes. */
function walked(random, spec) {
  for (let holder = spec; ; ) {
    const keys = Object.keys(holder);
    const key = oneOf(random, keys);
    if (random() < STOP || !isHolder(holder[key]) || Object.keys(holder[key]).length === 0) return { holder, key };
    holder = holder[key];
  }
}

/** As JSON.parse sets it: "__proto__" is a key as any other. */
const put = (holder, key, value) => Object.defineProperty(holder, key, { value, enumerable: true, writable: true, configurable: true });

function deep(random) {
  let value = 1;
  for (let i = Math.floor(between(random, 2, 400)); i > 0; --i) value = random() < 0.5 ? [value] : { a: value };
  return value;
}

const changeOf = {
  number: (random, { holder, key }) => put(holder, key, oneOf(random, NUMBERS)),
  text: (random, { holder, key }) => put(holder, key, oneOf(random, TEXTS)),
  special: (random, { holder, key }) => put(holder, key, copied(oneOf(random, SPECIAL))),
  deep: (random, { holder, key }) => put(holder, key, deep(random)),
  gone: (random, { holder, key }) => (Array.isArray(holder) ? holder.splice(Number(key), 1) : delete holder[key]),
  key: (random, { holder, key }) => {
    if (Array.isArray(holder)) return;
    const value = holder[key];
    delete holder[key];
    put(holder, oneOf(random, KEYS), value);
  },
  again: (random, { holder, key }) => {
    if (Array.isArray(holder)) holder.push(...Array.from({ length: Math.floor(between(random, 1, 60)) }, () => copied(holder[key])));
  },
  /** What stands in another place, of this document or of another. */
  other: (random, { holder, key }, { places, others }) => {
    const from = oneOf(random, random() < 0.5 ? places : others);
    put(holder, key, copied(from.holder[from.key]));
  },
};
const CHANGES = Object.values(changeOf);

/** Mostly of a good one and with one change: a complaint hides those that come after it. */
function changed(random, good, told) {
  const one = () => oneOf(random, told.length > 0 && random() < PART_TOLD ? told : good);
  const spec = copied(one());
  const others = placesOf(one());
  for (let i = random() < 0.5 ? 1 : Math.floor(between(random, 1, MOST_CHANGES + 1)); i > 0; --i) {
    const places = placesOf(spec);
    if (places.length > 0) oneOf(random, CHANGES)(random, random() < 0.5 ? oneOf(random, places) : walked(random, spec), { places, others });
  }
  return spec;
}

/** What is wrong with how a spec was taken, if anything, and what it was told. */
function taken(spec, read) {
  const before = JSON.stringify(spec);
  const start = process.cpuUsage();
  let told = 'accepted';
  try {
    wordsOf(read(spec, FACTS));
    changesBetween(EXAMPLE, spec);
  } catch (error) {
    if (!(error instanceof TelarError) || error.code !== 'E_SPEC') return { fault: `${error.stack}` };
    if (typeof error.pointer !== 'string' || error.message.length > MESSAGE_MAX) return { fault: `no pointer, or too long: ${error.message}` };
    told = `${error.pointer.replace(/\d+/g, '#')} ${/expected .{0,40}/.exec(error.message)?.[0] ?? error.message.slice(0, 40)}`;
  }
  const { user, system } = process.cpuUsage(start);
  if (user + system > 1000 * LONGEST_CPU_MS) return { fault: `it took ${((user + system) / 1000).toFixed(0)} ms of CPU time` };
  if (JSON.stringify(spec) !== before) return { fault: 'the spec of the caller was written to' };
  if ({}.a !== undefined || Object.keys(Object.prototype).length > 0) return { fault: 'Object.prototype was written to' };
  return { told };
}

/**
 * Changes specs and has them read.
 * @param {object} how
 * @param {number} [how.seconds] after which it ends; `runs` may end it before
 * @param {number} [how.runs]
 * @param {number} [how.seed]
 * @param {object[]} [how.corpus] specs beside the own ones
 * @param {(spec: object, facts: object) => object} [how.read] in place of readSpec(), to plant a fault
 * @returns {{runs: number, outcomes: number, fault?: string, spec?: object}} outcomes: complaints that differ; fault, spec: what was found
 */
export function fuzzSpec({ seconds = Number.POSITIVE_INFINITY, runs = Number.POSITIVE_INFINITY, seed = 1, corpus = [], read = readSpec }) {
  const random = seeded(seed);
  const good = [EXAMPLE, ...Array.from({ length: RANDOM_SEEDS }, (_, i) => copied(randomSpec(i + 1).spec)), ...corpus];
  const kept = [];
  const seen = new Set();
  const end = performance.now() + 1000 * seconds;
  let done = 0;
  for (const spec of good) {
    const { fault } = taken(copied(spec), read);
    if (fault) return { runs: done, outcomes: 0, fault, spec };
  }
  for (; done < runs && performance.now() < end; ++done) {
    const spec = changed(random, good, kept);
    if (JSON.stringify(spec).length > MOST_CHARACTERS) continue;
    const { fault, told } = taken(spec, read);
    if (fault) return { runs: done + 1, outcomes: seen.size, fault, spec };
    if (seen.has(told)) continue;
    seen.add(told);
    kept.push(spec);
  }
  return { runs: done, outcomes: seen.size };
}

/** readSpec() with a fault that a fuzzer has to find: a girth that is none ends in an error of JavaScript. */
export function plantedRead(spec, facts) {
  try {
    return readSpec(spec, facts);
  } catch (error) {
    if (/^\/measures\/\d+\/girth/.test(error.pointer)) throw new TypeError('planted');
    throw error;
  }
}
