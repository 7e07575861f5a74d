import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, realpathSync, rmSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { main, ROOT, runShown, SetupError } from '../machine/step.mjs';
import { setUp } from './index.mjs';

// npm run sanitize [-- cpp | js [FILE...]]: C++'s tests and those of JavaScript that reach the addon, with the address and undefined behaviour sanitizers. Ends with 1
// where a test fails, and where a sanitizer said anything in any process, also one whose end a test expects.

const PRESET = 'asan-ubsan';
const BUILD = path.join(ROOT, 'out', PRESET);
const REPORTS = path.join(ROOT, 'out/sanitize');
const LEAKS = path.join(ROOT, 'test/sanitize/leaks.txt');
const HANGS_AFTER_MS = 3_600_000;
/** CPU that a refusal may take here: a tenth of the speed, beside other work. */
const REFUSE_MS = 5000;
/** How long a worker of a queue may be silent. */
const LEASE_MS = 10_000;

/** Tests of JavaScript that reach the addon or its tools. */
const FOLDERS = ['test/robust', ...['api', 'cli', 'pool', 'queue', 'server', 'sheet', 'shot'].map((name) => `test/js/${name}`)];
const FILES = ['determinism', 'environment_texels', 'ktx2_texels', 'meshopt_bytes', 'output_formats'].map((name) => `test/js/${name}.test.mjs`);

/** Of those, files that say nothing here, and why. */
export const LEFT_OUT = {
  'test/js/pool/ends.test.mjs': 'signals that a test sends are told as faults',
  'test/js/pool/faults.test.mjs': 'allocations fail by an allocator that is preloaded, and the sanitizer has its own',
  'test/js/pool/first_steps.test.mjs': 'libtelar_worker.so is preloaded, which has no place beside a sanitizer',
  'test/js/pool/soak.test.mjs': 'the sanitizer keeps memory that was freed',
  'test/js/api/leak.test.mjs': 'the sanitizer keeps memory that was freed',
  'test/js/api/scarce.test.mjs': 'it limits the address space, of which the sanitizer takes terabytes',
  'test/js/server/page/page.test.mjs': 'Chromium ends with the sanitizer preloaded',
  'test/js/shot/browser.test.mjs': 'Chromium ends with the sanitizer preloaded',
  'test/js/sheet/readers.test.mjs': 'Chromium ends with the sanitizer preloaded',
  'test/robust/damaged_images.test.mjs': 'Chromium ends with the sanitizer preloaded',
};

/** Files below the folders, without those that are left out. */
export function sanitizedFiles() {
  const below = FOLDERS.flatMap((folder) => readdirSync(path.join(ROOT, folder), { recursive: true }).map((file) => path.join(folder, file)));
  return [...below.filter((file) => file.endsWith('.test.mjs')), ...FILES].filter((file) => !(file in LEFT_OUT)).sort();
}

/** What sanitizers wrote, of any process: one file each. @returns {string[]} */
const textsIn = (folder) => (existsSync(folder) ? readdirSync(folder).map((name) => readFileSync(path.join(folder, name), 'utf8')) : []);

/** The search for leaks gives up at times, in processes with threads of the GL: nothing was found then, and nothing was looked for. */
const gaveUp = (text) => /LeakSanitizer has encountered a fatal error/.test(text) && !/ERROR:|runtime error/.test(text);

/** What sanitizers found. @returns {string[]} */
export const reportsIn = (folder) => textsIn(folder).filter((text) => !gaveUp(text));
/** @returns {number} processes in which the search for leaks gave up */
export const givenUpIn = (folder) => textsIn(folder).filter(gaveUp).length;

const joined = (options) =>
  Object.entries(options)
    .map(([key, value]) => `${key}=${value}`)
    .join(':');

/**
 * @param {boolean} withLeaks whether what is left at the end counts: not in Node, which leaves V8's heap, nor in a worker, whose filter stops the search
 */
function environment(withLeaks) {
  const log = { log_path: path.join(REPORTS, 'report') };
  return {
    // An allocation that is too large fails, as it does without a sanitizer. Each library has its own copy of the layers that it links.
    ASAN_OPTIONS: joined({
      ...log,
      allocator_may_return_null: 1,
      detect_odr_violation: 0,
      detect_leaks: Number(withLeaks),
      quarantine_size_mb: 64,
      handle_abort: 1,
    }),
    // Its library writes to standard errors alone, which a test may keep to itself: the end that it makes is reported by the other one.
    UBSAN_OPTIONS: joined({ ...log, print_stacktrace: 1, abort_on_error: 1 }),
    LSAN_OPTIONS: joined({ suppressions: LEAKS, print_suppressions: 0 }),
    TELAR_BUILD_DIR: BUILD,
    TELAR_REFUSE_MS: String(REFUSE_MS),
    TELAR_LEASE_MS: String(LEASE_MS),
  };
}

/** Node has no sanitizer: its library has to be there before all others, and libstdc++ for the exceptions that it looks at. */
function preloaded() {
  const fileOf = (name) => realpathSync(execFileSync('g++', [`-print-file-name=${name}`], { encoding: 'utf8' }).trim());
  return ['libasan.so', 'libstdc++.so.6'].map(fileOf).join(' ');
}

/** What an addon with a fault leads to: a report, or nothing is found here. */
const PLANTED = { address: /heap-buffer-overflow/, undefined: /AddressSanitizer: ABRT/ };

/** @throws {SetupError} where a fault that was planted is not found */
async function checkPlanted() {
  const addon = path.join(BUILD, 'addon/telar_planted.node');
  for (const [TELAR_PLANTED, expected] of Object.entries({ ...PLANTED, none: undefined })) {
    emptyReports();
    const status = await runShown(process.execPath, ['-e', 'require(process.argv[1])', addon], {
      env: { ...environment(false), LD_PRELOAD: preloaded(), TELAR_PLANTED },
    });
    const reports = reportsIn(REPORTS);
    const isRight = expected ? status !== 0 && reports.some((text) => expected.test(text)) : status === 0 && reports.length === 0;
    if (!isRight) throw new SetupError(`sanitizers: the planted fault "${TELAR_PLANTED}" ended with ${status} and ${reports.length} reports`);
  }
  process.stdout.write('the planted faults are found\n');
}

function emptyReports() {
  rmSync(REPORTS, { recursive: true, force: true });
  mkdirSync(REPORTS, { recursive: true });
}

/** C++'s tests whose code has faults planted on purpose, which a sanitizer finds. */
const PLANTED_TESTS = '_faults$';

/** Runs of a test whose search for leaks gave up. What fails without that is not run again. */
const MOST_RUNS = 3;

async function runCpp() {
  const run = (withLeaks, ...more) =>
    runShown('ctest', ['--preset', PRESET, '--no-tests=error', '--exclude-regex', PLANTED_TESTS, ...more], { env: environment(withLeaks) });
  let status = await run(true);
  let before = 0;
  const gaveUpAgain = () => status !== 0 && givenUpIn(REPORTS) > before;
  for (let i = 1; i < MOST_RUNS && gaveUpAgain(); ++i) {
    before = givenUpIn(REPORTS);
    status = await run(true, '--rerun-failed');
  }
  if (!gaveUpAgain()) return status;
  process.stdout.write(`the search for leaks gave up ${MOST_RUNS} times: once more without it\n`);
  return run(false, '--rerun-failed');
}

function runJs(files) {
  const wanted = {
    files: files.map((file) => path.resolve(ROOT, file)),
    concurrency: 1,
    timeout: HANGS_AFTER_MS,
    log: path.join(ROOT, 'out/setup/skipped-sanitize.log'),
  };
  const env = { ...environment(false), LD_PRELOAD: preloaded() };
  return runShown(process.execPath, [path.join(ROOT, 'js/setup/run_tests.mjs'), JSON.stringify(wanted)], { env });
}

async function run([only, ...files]) {
  await setUp({ groups: ['build', 'run', 'test'], presets: [PRESET] });
  await checkPlanted();
  emptyReports();
  const status = [];
  if (only !== 'js') status.push(await runCpp());
  if (only !== 'cpp') status.push(await runJs(files.length > 0 ? files : sanitizedFiles()));
  const reports = reportsIn(REPORTS);
  for (const text of reports) process.stdout.write(`${text}\n`);
  process.stdout.write(`${reports.length || 'no'} reports of sanitizers\n`);
  return reports.length > 0 || status.some((code) => code !== 0) ? 1 : 0;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) await main(() => run(process.argv.slice(2)));
