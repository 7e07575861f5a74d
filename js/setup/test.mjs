import { existsSync, readdirSync, readFileSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { ensureBuild } from '../build/addon.mjs';
import { main, ROOT, runKept, runShown, SetupError } from '../machine/step.mjs';
import { setUp } from './index.mjs';
import { lint } from './lint.mjs';

// npm test: all set-up, then every test and lint; C++'s tests are compiled while those of JavaScript run. `node js/setup/test.mjs cpp`, `lint` or `js [FILE...]` runs one of them.
// JavaScript's tests run on this terminal; what the others say meanwhile is kept, and shown after them where one fails.

const PRESET = 'dev';
const BUILD = path.join(ROOT, 'out', PRESET);
/** What JavaScript's tests run. */
const FOR_JS = ['addon/all', 'programs'];

/** Some tests end only when the work that they stop has stopped: one that hangs has failed. Milliseconds for a file. */
const HANGS_AFTER_MS = 1_800_000;

/** Files tested at once. They wait for a third of their time, in which those in C++ are compiled and run. */
const AT_ONCE = os.availableParallelism();

/** All test files under test/, as paths from the root: node 20 takes no glob here. The longest first, so that no core waits for one at the end. */
function testFiles() {
  const files = readdirSync(path.join(ROOT, 'test'), { recursive: true })
    .filter((file) => file.endsWith('.test.mjs'))
    .map((file) => path.join('test', file))
    .sort();
  const rank = (file) => LONGEST.indexOf(file) >>> 0;
  return files.sort((a, b) => rank(a) - rank(b));
}
const LONGEST = [
  'test/parity/faults.test.mjs',
  'test/parity/parity.test.mjs',
  'test/js/server/job_faults.test.mjs',
  'test/js/view/page_spec.test.mjs',
  'test/js/view/page_models.test.mjs',
  'test/js/view/page.test.mjs',
  'test/js/docs/recipes.test.mjs',
  'test/families/prefilter.test.mjs',
  'test/js/queue/processes.test.mjs',
];

async function runNodeTests({ files }) {
  const log = path.join(ROOT, 'out/setup/skipped-js.log');
  const wanted = { files: files.length ? files : testFiles(), concurrency: AT_ONCE, timeout: HANGS_AFTER_MS, log };
  const args = [path.join(ROOT, 'js/setup/run_tests.mjs'), JSON.stringify({ ...wanted, files: wanted.files.map((file) => path.resolve(file)) })];
  const status = await runShown(process.execPath, args, { env: { TELAR_BUILD_DIR: BUILD } });
  return { status, skipped: existsSync(log) ? readFileSync(log, 'utf8').trim().split('\n').filter(Boolean) : [] };
}

/** Compiles C++'s tests where they are not there yet, by half of the cores: JavaScript's tests run beside. @returns {Promise<string>} what failed */
async function buildRest() {
  try {
    await ensureBuild(PRESET, () => {}, { compilers: Math.ceil(os.availableParallelism() / 2) });
    return '';
  } catch (error) {
    if (!(error instanceof SetupError)) throw error;
    return error.message;
  }
}

async function runCpp({ shown }) {
  const failed = await buildRest();
  if (failed) return { status: 1, text: failed };
  const args = ['--preset', PRESET, '--no-tests=error'];
  const { status, text } = shown ? { status: await runShown('ctest', args), text: '' } : await runKept('ctest', args, { log: 'ctest.log' });
  // ctest counts a program as one test, whatever googletest left out in it.
  const said = readFileSync(path.join(BUILD, 'Testing/Temporary/LastTest.log'), 'utf8');
  return { status, text, skipped: [...new Set([...said.matchAll(/^\[ {2}SKIPPED \] (\S+)$/gm)].map(([, name]) => name))] };
}

async function runLint({ shown }) {
  const said = [];
  const run = shown
    ? runShown
    : async (command, args) => {
        const { status, text } = await runKept(command, args, { log: `lint-${path.basename(command)}.log` });
        if (status !== 0) said.push(text);
        return status;
      };
  const { status, lines } = await lint(run);
  return { status, text: said.join('\n'), lines };
}

const SUITES = {
  js: { title: 'JavaScript (node --test)', run: runNodeTests },
  cpp: { title: 'C++ (compiled, ctest)', run: runCpp },
  lint: { title: 'Lint', run: runLint },
};

/** Runs suites one after the other. */
async function runAll(names, options) {
  const results = [];
  for (const name of names) {
    const started = performance.now();
    results.push({ title: SUITES[name].title, ...(await SUITES[name].run(options)), seconds: (performance.now() - started) / 1000 });
  }
  return results;
}

/** What came of all, for the end of the output. */
function summary(results) {
  const skipped = results.flatMap((result) => result.skipped ?? []);
  return [
    ...results.map(({ title, status, seconds, lines = [] }) =>
      [`${title}: ${status === 0 ? 'passed' : `FAILED (exit ${status})`} in ${seconds.toFixed(0)} s`, ...lines.map((line) => `  ${line}`)].join('\n'),
    ),
    `Skipped tests: ${skipped.length || 'none'}`,
    ...skipped.map((line) => `  ${line}`),
  ].join('\n');
}

await main(async () => {
  const [only, ...files] = process.argv.slice(2);
  const targets = only === 'cpp' || only === 'lint' ? [] : FOR_JS;
  await setUp({ groups: ['build', 'run', 'test', 'lint'], presets: [PRESET], targets });
  const chains = only ? [runAll([only], { shown: true, files })] : [runAll(['js'], { files }), runAll(['cpp', 'lint'], { shown: false })];
  const results = (await Promise.all(chains)).flat();
  for (const { title, status, text } of results) if (status !== 0 && text) process.stdout.write(`\n== ${title}\n${text}\n`);
  process.stdout.write(`\n${summary(results)}\n`);
  return results.some(({ status }) => status !== 0) ? 1 : 0;
});
