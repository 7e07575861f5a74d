// node test/parity/trace.mjs CASE [X Y] [--dump FOLDER]
// Draws each quantity of the shading (quantities.mjs) of a case in the browser and with telar and prints both values at a
// pixel (from the top left; the picture's worst one where X Y are left out), their difference, and the first quantity
// that differs beyond rounding. --dump writes the whole pictures as FOLDER/QUANTITY.{browser,telar}.f32: RGBA fp32, top
// row first; of the browser's shader a few more than telar has.
import { mkdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { Browser } from './browser/chromium.mjs';
import { CASES } from './cases.mjs';
import { Comparer } from './comparer.mjs';
import { drawCases } from './draw_cases.mjs';
import { QUANTITIES, QUANTITY_NAMES } from './quantities.mjs';
import { openServer } from './server.mjs';

/**
 * The shading of one pixel on both sides.
 * @typedef {object} Trace
 * @property {[number, number]} pixel - Counted from the top left.
 * @property {Step[]} terms - In the order of computation.
 * @property {string | null} first - Name of the first that differs beyond rounding.
 * @property {string} cause - A sentence for people.
 *
 * @typedef {object} Step
 * @property {string} term - Name in quantities.mjs.
 * @property {number[] | null} browser - 3 components; null where the material has no such quantity, or nothing is drawn.
 * @property {number[] | null} telar
 * @property {number} difference - Largest of the components, in the quantity's own unit; Infinity where one side is null.
 * @property {boolean} differs - Beyond rounding.
 */

/**
 * Follows one pixel of a case through both shaders. Both draw it again, without antialiasing, into floats.
 * @param {{item: import('./cases.mjs').Case, inputs: object, difference?: object}} result - Of draw_cases.mjs.
 * @param {{browser: Browser, server: import('./server.mjs').Server}} sides
 * @param {object} [options]
 * @param {[number, number]} [options.pixel] - Counted from the top left; the worst one where it is left out.
 * @param {string | null} [options.through] - Last quantity that is followed; all of them where it is left out or null.
 * @returns {Promise<Trace>}
 */
export async function traceOf({ item, inputs, difference }, { browser, server }, { pixel = worstPixel(difference), through } = {}) {
  const input = { shot: item.shot, ...inputs };
  const names = through ? QUANTITY_NAMES.slice(0, QUANTITY_NAMES.indexOf(through) + 1) : QUANTITY_NAMES;
  const expected = await browser.terms({ ...input, terms: names, pixel });
  const actual = await server.debug(input, names);
  const at = pixel[1] * item.shot.size.width + pixel[0];
  const terms = names.map((term) => compareTerm(term, valueAt(expected[term], 0), valueAt(actual[term], at)));
  return { pixel, terms, ...causeOf(terms) };
}

/** Of the region that is over the bar, else of the interior. */
function worstPixel({ interior, edge, verdict }) {
  const over = verdict.checks.find(({ pass }) => !pass)?.region;
  return (over === 'edge' ? edge : (interior ?? edge)).worst;
}

const valueAt = (frame, i) => (frame[i * 4 + 3] === 1 ? Array.from(frame.subarray(i * 4, i * 4 + 3)) : null);

/** @returns {Step} */
export function compareTerm(term, browser, telar) {
  if (!browser && !telar) return { term, browser, telar, difference: 0, differs: false };
  if (!browser || !telar) return { term, browser, telar, difference: Infinity, differs: true };
  const difference = Math.max(...browser.map((value, c) => (Object.is(value, telar[c]) ? 0 : Math.abs(value - telar[c]))));
  const { share, floor } = QUANTITIES[term].rounding;
  // A comparison with NaN is false: what is not a number on one side only differs.
  const within = difference === 0 || difference <= share * Math.max(...browser.map(Math.abs)) + floor;
  return { term, browser, telar, difference, differs: !within };
}

/**
 * @param {Step[]} terms
 * @returns {{first: string | null, cause: string}}
 */
export function causeOf(terms) {
  const first = terms.find(({ differs }) => differs) ?? null;
  return { first: first?.term ?? null, cause: sentenceOf(first, terms) };
}

function sentenceOf(first, terms) {
  if (terms.every(({ browser, telar }) => !browser && !telar))
    return 'nothing is drawn at the centre of this pixel on either side: look at coverage and the background';
  if (!first) return "nothing differs beyond rounding at the pixel's centre: look at coverage, at antialiasing and at what is blended below";
  const { what, look } = QUANTITIES[first.term];
  if (first.browser && first.telar) return `${first.term} (${what}) is the first that differs: look at ${look}`;
  return `only ${first.browser ? 'the browser' : 'telar'} draws a surface with ${first.term} here: look at coverage, depth order and the kind of material`;
}

/** A trace as a table of text. */
export function traceText({ pixel, terms, cause }) {
  const values = (list) => (list ? list.map((value) => value.toPrecision(7).padStart(13)).join(' ') : '-').padStart(41);
  const lines = terms
    .filter(({ browser, telar }) => browser || telar)
    .map(
      ({ term, browser, telar, difference, differs }) =>
        `${differs ? '>' : ' '} ${term.padEnd(20)} ${values(browser)} | ${values(telar)} | ${difference.toExponential(2)}`,
    );
  const head = `  ${'quantity'.padEnd(20)} ${'browser'.padStart(41)} | ${'telar'.padStart(41)} | difference`;
  return [`pixel ${pixel.join(' ')}`, head, ...lines, cause].join('\n');
}

async function main() {
  const { values, positionals } = parseArgs({ allowPositionals: true, options: { dump: { type: 'string' } } });
  const [name, ...numbers] = positionals;
  const item = CASES.find((candidate) => candidate.name === name);
  if (!item) throw new Error(`usage: node test/parity/trace.mjs CASE [X Y] [--dump FOLDER]; cases: ${CASES.map((c) => c.name).join(' ')}`);
  const sides = { browser: await Browser.start(), server: await openServer(), comparer: new Comparer() };
  try {
    for await (const result of drawCases([item], sides)) {
      if (result.error) throw result.error;
      const pixel = numbers.length === 2 ? numbers.map(Number) : undefined;
      console.log(`${name}\n${traceText(await traceOf(result, sides, { pixel }))}`);
      if (values.dump) await dump(values.dump, { shot: item.shot, ...result.inputs }, sides);
    }
  } finally {
    await Promise.all(Object.values(sides).map((side) => side.close()));
  }
}

async function dump(folder, input, { browser, server }) {
  mkdirSync(folder, { recursive: true });
  const save = (frames, side) => {
    for (const [name, frame] of Object.entries(frames)) writeFileSync(path.join(folder, `${name}.${side}.f32`), frame);
  };
  save(await browser.terms({ ...input, terms: null }), 'browser');
  save(await server.debug(input, QUANTITY_NAMES), 'telar');
}

if (process.argv[1] === fileURLToPath(import.meta.url)) await main();
