// node test/parity/run.mjs [--all] [--fast] [--swiftshader] [--trace] [--keep] [--browser-only] [--own-text]
//   [--today | --families | --revision LIST] [--swap SLOT=TERM] [--explain] [filter...]
//   [--random COUNT [--seed N] [--shading NAME]]
// Draws the gate's cases, or those whose name contains a filter, with three.js in headless Chromium and with telar, prints
// a line a case, writes out/parity/index.html and junit.xml. Exit code 1 when a case is over the bar. Without a filter or another
// choice of cases, draws those of older releases of three.js, too.
//   --all           the extended set too
//   --fast          only what `npm test` draws
//   --swiftshader   also three.js on SwiftShader: telar must be no farther from it than three.js on Mesa is
//   --trace         follow the worst pixel of each case that differs at all, not only of those that differ by more than 1/255
//   --keep          leave the browser's pictures, the models and the shots in out/parity/browser
//   --browser-only  only that, without telar
//   --today         the gate's cases alone
//   --families      in their place those of test/families, with one release of three.js a family (fetched from npm, their pictures
//                   kept in out/families) and with telar drawing as they do
//   --revision 160,180  the same with these releases
//   --swap dfg=karis  telar draws these releases with another term in a slot: a planted fault; may stand several times
//   --explain       finds the term that explains each case of them that is over the bar, not of the first few alone
//   --random 100    in place of the cases so many random scenes in random light; --seed: of the first one; --shading: "three" unless given
//   --own-text      three.js shaded by telar's text of stock three.js in telar's place
import { mkdirSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { Browser } from './browser/chromium.mjs';
import { CASES, GATE_CASES } from './cases.mjs';
import { randomCases } from './cases_random.mjs';
import { Comparer } from './comparer.mjs';
import { drawCases } from './draw_cases.mjs';
import { saveReference } from './files.mjs';
import { KNOWN_CASES, KNOWN_DIFFERENCES } from './known_differences.mjs';
import { OUT } from './places.mjs';
import { familyName, familyOf } from '../../js/shot/three_terms.mjs';
import { explained, explanationText } from '../families/explain.mjs';
import { casesOf, fetchAhead, isShown, GATED_REVISIONS, parseSwaps, sidesOf } from '../families/gate.mjs';
import { Report } from './report.mjs';
import { openOwnText } from './own_text.mjs';
import { openServer } from './server.mjs';
import { traceOf } from './trace.mjs';

const flags = ['all', 'fast', 'swiftshader', 'trace', 'keep', 'browser-only', 'own-text', 'today', 'families', 'explain'];
const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    ...Object.fromEntries(flags.map((name) => [name, { type: 'boolean', default: false }])),
    revision: { type: 'string' },
    swap: { type: 'string', multiple: true },
    random: { type: 'string' },
    seed: { type: 'string', default: '0' },
    shading: { type: 'string', default: 'three' },
  },
});

const started = performance.now();
mkdirSync(OUT, { recursive: true });
const chosen = (items) =>
  items
    .filter(({ name }) => positionals.length === 0 || positionals.some((filter) => name.includes(filter)))
    .filter((item) => !values.fast || item.fast)
    .filter(({ shot }) => !values['own-text'] || shot.shading === 'three');
const random = values.random === undefined ? undefined : await randomCases(values.random, values.seed, values.shading);
const isWhole = !random && positionals.length === 0 && !flags.some((name) => !['all', 'explain', 'families'].includes(name) && values[name]);
const asksOlder = values.families || values.revision !== undefined;
const revisions = values.revision?.split(',').map(Number) ?? (values.families || isWhole ? GATED_REVISIONS : []);
const swaps = parseSwaps(values.swap);
const rounds = revisions.map((revision) => ({ revision, cases: random?.filter(isShown(revision)) ?? chosen(casesOf(revision)) }));
const current = asksOlder ? [] : (random ?? chosen(values.all || positionals.length > 0 ? CASES : GATE_CASES));
const cases = [...current, ...rounds.flatMap((round) => round.cases)];
const knownCases = asksOlder || random || values['browser-only'] || values['own-text'] ? [] : chosen(KNOWN_CASES);
if (cases.length + knownCases.length === 0) throw new Error(`no case has one of these in its name: ${positionals.join(' ')}`);

/** Cases followed through the shaders without --trace: each takes seconds, and one fault shows in many cases. */
const MAX_TRACES = 12;
let traces = 0;

/** Cases of older releases that are explained without --explain, where the gate is whole: each is drawn some fifty times. */
const MAX_EXPLAINED = values.revision === undefined ? 3 : 0;
let explanations = 0;

const report = new Report();
const releases = [];
const spent = {};
const sides = {};
const opening = Object.entries({
  browser: asksOlder ? undefined : Browser.start(),
  server: values['browser-only'] || values['own-text'] ? undefined : openServer(),
  other: values.swiftshader ? Browser.start({ rasterizer: 'swiftshader' }) : undefined,
}).map(async ([name, side]) => {
  sides[name] = await side;
});
void fetchAhead(revisions);
try {
  await Promise.all(opening);
  if (values['own-text']) sides.server = openOwnText(sides.browser);
  if (sides.server) sides.comparer = new Comparer();
  for await (const result of drawCases(current, sides)) await finishCase(result);
  for await (const result of drawCases(knownCases, { ...sides, other: undefined })) console.log(report.addKnown(result));
  for (const round of rounds) await drawRound(round);
} finally {
  await Promise.allSettled(opening);
  await Promise.all(Object.values(sides).map((side) => side?.close()));
}
for (const line of releases) console.log(line);
const summary = summaryOf();
console.log(summary);
if (!values['browser-only']) {
  const shown = KNOWN_DIFFERENCES.filter((entry) => knownCases.some(({ name }) => entry.cases.includes(name)));
  console.log(report.finish({ summary, knownDifferences: shown }));
}
process.exitCode = report.failed ? 1 : 0;

/** The cases of one older release. */
async function drawRound({ revision, cases: own }) {
  const { browser, server, shading } = await sidesOf(revision, { server: sides.server, swaps });
  const [begin, failed] = [performance.now(), report.failed];
  try {
    for await (const result of drawCases(own, { browser, server, comparer: sides.comparer })) await finishCase(result, shading);
  } finally {
    await browser.close();
  }
  const within = `${own.length - (report.failed - failed)} of ${own.length}`;
  releases.push(
    `${familyName(familyOf(revision))}, drawn by 0.${revision}: ${within} cases within the bar, ${((performance.now() - begin) / 1000).toFixed(1)} s`,
  );
}

/** Which term of a release explains a case that is over the bar. */
async function explanationOf(result, shading) {
  if (result.difference?.pass !== false || !(values.explain || ++explanations <= MAX_EXPLAINED)) return undefined;
  return explanationText(await explained(result, shading, sides.server));
}

/** @param {object} [shading] - Of telar where it draws as an older release. */
async function finishCase(result, shading = undefined) {
  const { item, inputs, expected, error, difference, milliseconds } = result;
  for (const [stage, time] of Object.entries(milliseconds)) spent[stage] = (spent[stage] ?? 0) + time;
  if (expected && (values.keep || values['browser-only'] || !difference.pass)) saveReference(item, inputs, expected);
  if (values['browser-only']) {
    console.log(
      error ? `FAIL ${item.name} ${error.message}` : `${item.name}  load ${milliseconds.load.toFixed()} ms, draw ${milliseconds.browser.toFixed()} ms`,
    );
    if (error) report.failed++;
    return;
  }
  // What a trace reads is of the text of today's three.js.
  if (shading) console.log(report.add(result, undefined, await explanationOf(result, shading)));
  else console.log(report.add(result, wantsTrace(difference) ? await traced(result) : undefined));
}

function wantsTrace(difference) {
  const most = difference?.interior?.max ?? 0;
  if (values.trace) return most > 0 || difference?.pass === false;
  return (most > 1 || difference?.pass === false) && ++traces <= MAX_TRACES;
}

/** The worst pixel of the region that is over the bar, or of the interior. */
async function traced(result) {
  const { interior, edge, verdict } = result.difference;
  const over = verdict.checks.find(({ pass }) => !pass)?.region;
  const pixel = { interior, edge }[over]?.worst ?? interior?.worst ?? edge?.worst;
  if (!pixel) return undefined;
  try {
    return await traceOf(result, sides, { pixel });
  } catch (error) {
    console.error(`${result.item.name} cannot be traced: ${error.message}`);
    return undefined;
  }
}

function summaryOf() {
  const stages = Object.entries(spent).map(([stage, time]) => `${stage} ${(time / 1000).toFixed(1)} s`);
  return `${cases.length} cases in ${((performance.now() - started) / 1000).toFixed(1)} s (side by side: ${stages.join(', ')})`;
}
