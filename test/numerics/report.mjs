// node test/numerics/report.mjs [--only PART] [--quick]: measures every figure at its full count and writes js/docs/numerics.md.
// A check that this very build has measured at the full count is not measured again: a run that was stopped goes on.
// With --only it measures the checks whose name holds PART, with either it prints the tables in place of writing them.
import { execFile } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs, promisify } from 'node:util';
import { createRenderer } from '../../js/index.mjs';
import { IMAGE_CHECKS } from './image_checks.mjs';
import { numericsPage } from './report_page.mjs';

const PAGE = new URL('../../js/docs/numerics.md', import.meta.url);
const FAULTS = new URL('faults/faults.json', import.meta.url);
const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const BUILD = path.resolve(ROOT, process.env.TELAR_BUILD_DIR ?? 'out/dev');
const PROGRAM = path.join(BUILD, 'bin/telar_numerics');
process.env.TELAR_LIBRARY_DIR ??= path.join(BUILD, 'addon');

/** What telar_numerics prints: one JSON object a line. */
async function program(args) {
  const { stdout } = await promisify(execFile)(PROGRAM, args, { maxBuffer: 2 ** 26 }).catch((error) => {
    // 1: a figure is outside of its bar, 3: one looked at too few points, which is told below.
    if (error.code === 1 || error.code === 3) return error;
    throw new Error(`telar_numerics ${args.join(' ')} ended with ${error.signal ?? error.code}: ${error.stderr}`);
  });
  return stdout
    .split('\n')
    .filter(Boolean)
    .map((line) => JSON.parse(line));
}

/** The figures of one check of telar_numerics; `kept` where this build has measured them before. */
async function measured({ name }, { quick }, folder) {
  if (quick) return (await program(['--check', name]))[0];
  const file = path.join(folder, `${name.replaceAll(/[^\w-]/g, '_')}.json`);
  if (existsSync(file)) return { ...JSON.parse(readFileSync(file, 'utf8')), kept: true };
  const [check] = await program(['--full', '--check', name]);
  writeFileSync(file, JSON.stringify(check));
  return check;
}

/** Every check, in the order of the page: {topic, name, run(): check}. */
async function planned({ only = '', quick }) {
  const stamp = createHash('sha256').update(readFileSync(PROGRAM)).digest('hex').slice(0, 16);
  const folder = path.join(BUILD, 'numerics', stamp);
  mkdirSync(folder, { recursive: true });
  const listed = await program(['--list', '--only', only]);
  const images = IMAGE_CHECKS.filter(({ name }) => name.includes(only));
  return [
    ...listed.map((check) => ({ ...check, run: () => measured(check, { quick }, folder) })),
    ...images.map(({ topic, name, run }) => ({
      topic,
      name,
      run: async (renderer) => {
        const started = performance.now();
        const figures = await run(renderer);
        return { topic, name, figures, seconds: (performance.now() - started) / 1000 };
      },
    })),
  ];
}

const { values: options } = parseArgs({ options: { only: { type: 'string' }, quick: { type: 'boolean', default: false } } });
const plan = await planned(options);
const checks = [];
const renderer = await createRenderer({ backend: 'egl-surfaceless' });
try {
  for (const { name, run } of plan) {
    const check = await run(renderer);
    checks.push(check);
    const off = check.figures.filter(({ holds }) => !holds).length;
    process.stderr.write(
      `[${checks.length}/${plan.length}] ${name}: ${check.figures.length} figures ` +
        `${check.kept ? 'as measured before' : `in ${check.seconds.toFixed(0)} s`}${off ? `, ${off} outside of their bars` : ''}\n`,
    );
  }
} finally {
  await renderer.close();
}

const figures = checks.flatMap((check) => check.figures);
const page = numericsPage(checks, JSON.parse(readFileSync(FAULTS, 'utf8')));
const short = options.quick ? [] : figures.filter(({ points, full }) => points < full);
for (const { what, shading, points, full } of short) process.stderr.write(`${what}, ${shading}: ${points} points, the table names ${full}\n`);
if (options.only || options.quick) process.stdout.write(page);
else if (short.length === 0) writeFileSync(PAGE, page);
process.exitCode = short.length > 0 || figures.some(({ holds }) => !holds) ? 1 : 0;
