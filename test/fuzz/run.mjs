// libFuzzer on what reads files of strangers: npm run fuzz [-- TARGET...] [--seconds N]
// The corpus grows in out/fuzz/corpus/TARGET from run to run. What ends a target is written to test/fuzz/regressions/TARGET, to stay: mend
// it, and keep the file. Exit code 1 where there was a finding.
import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { cpuBelow } from '../processes.mjs';
import { SEEDS } from './seeds.mjs';
import { fuzzSpec, plantedRead } from './spec.mjs';

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const BUILD = path.join(ROOT, 'out/fuzz');
const MOST_BYTES = 131_072;
const SPEC = 'spec';
const SPECS = path.join(ROOT, 'test/fuzz/regressions', SPEC);
const PLANTED_RUNS = 20_000;
/** Ten times as many as it takes: a fuzzer beside other work has little time. */
const PLANTED_SHOTS = 150_000;
const { values, positionals } = parseArgs({ options: { seconds: { type: 'string', default: '60' } }, allowPositionals: true });

function cmake(...args) {
  const { status } = spawnSync('cmake', args, { cwd: ROOT, stdio: ['ignore', 'ignore', 'inherit'] });
  if (status !== 0) throw new Error(`cmake ${args.join(' ')} ended with ${status}: it needs clang and libclang-rt-dev`);
}

/** Ends with an error where the fuzzer does not find a fault that was planted. */
async function checkPlanted() {
  // From the seeds alone: what earlier runs have found does not count.
  rmSync(path.join(BUILD, 'corpus/planted'), { recursive: true, force: true });
  const corpus = await corpusOf('planted', 'shot');
  const { status, stderr } = spawnSync(path.join(BUILD, 'bin/fuzz_planted'), [corpus, `-runs=${PLANTED_SHOTS}`, '-artifact_prefix=/dev/null'], {
    encoding: 'utf8',
    maxBuffer: 1 << 28,
  });
  if (status === 0 || !/fuzz_shot\.cpp.*out of bounds/.test(stderr)) throw new Error(`the planted fault was not found in ${PLANTED_SHOTS} runs`);
  console.log(`planted fault: found after ${stderr.match(/^#\d+/gm)?.at(-1)?.slice(1)} runs`);
}

/** Puts the seeds into the corpus. @returns {Promise<string>} Its folder. */
async function corpusOf(target, seeds = target) {
  const folder = path.join(BUILD, 'corpus', target);
  mkdirSync(folder, { recursive: true });
  for (const bytes of await SEEDS[seeds]()) {
    const file = path.join(folder, createHash('sha256').update(bytes).digest('hex').slice(0, 16));
    if (!existsSync(file)) writeFileSync(file, bytes);
  }
  return folder;
}

/** @returns {Promise<{runs: number, coverage: number, cpu: number, found: string[]}>} `coverage`: edges of the program that the corpus reaches; `cpu`: seconds */
async function fuzz(target) {
  const corpus = await corpusOf(target);
  const regressions = path.join(ROOT, 'test/fuzz/regressions', target);
  mkdirSync(regressions, { recursive: true });
  const before = new Set(readdirSync(regressions));
  const args = [
    corpus,
    regressions,
    `-max_total_time=${values.seconds}`,
    `-max_len=${MOST_BYTES}`,
    '-timeout=10',
    // What is slower ends the target; by default it would be told a second time.
    '-report_slow_units=600',
    '-rss_limit_mb=3000',
    '-malloc_limit_mb=1600',
  ];
  // A fuzzer beside other work gets less than the clock says.
  const cpuBefore = cpuBelow();
  const { stderr } = spawnSync(
    path.join(BUILD, 'bin', `fuzz_${target}`),
    [...args, `-artifact_prefix=${regressions}/`, '-print_final_stats=1', '-detect_leaks=1'],
    {
      encoding: 'utf8',
      maxBuffer: 1 << 28,
    },
  );
  const found = readdirSync(regressions).filter((name) => !before.has(name));
  if (found.length) process.stderr.write(stderr.slice(-4000));
  const last = stderr.match(/cov: \d+/g)?.at(-1) ?? 'cov: 0';
  return {
    runs: Number(/number_of_executed_units: *(\d+)/.exec(stderr)?.[1] ?? 0),
    coverage: Number(last.slice(5)),
    cpu: (cpuBelow() - cpuBefore) / 1000,
    found,
  };
}

/** The spec of a sheet, which JavaScript reads: its own changes of structure, and complaints in place of edges. */
function fuzzSpecs() {
  const planted = fuzzSpec({ runs: PLANTED_RUNS, read: plantedRead });
  if (!planted.fault?.includes('planted')) throw new Error(`the planted fault was not found in ${PLANTED_RUNS} runs`);
  console.log(`planted fault of a spec: found after ${planted.runs} runs`);
  const { runs, outcomes, fault, spec } = fuzzSpec({ seconds: Number(values.seconds), seed: Date.now() });
  if (fault) {
    const bytes = JSON.stringify(spec);
    mkdirSync(SPECS, { recursive: true });
    const file = path.join(SPECS, `${createHash('sha256').update(bytes).digest('hex').slice(0, 16)}.json`);
    writeFileSync(file, bytes);
    console.log(`${file}: ${fault}`);
    process.exitCode = 1;
  }
  console.log(`${SPEC}: ${runs} runs in ${values.seconds} s, ${outcomes} different complaints, ${fault ? 'found the above' : 'nothing found'}`);
}

const wanted = positionals.length ? positionals : [...Object.keys(SEEDS), SPEC];
if (wanted.includes(SPEC)) fuzzSpecs();
const compiled = wanted.filter((target) => target !== SPEC);
if (compiled.length > 0) {
  cmake('--preset', 'fuzz');
  cmake('--build', '--preset', 'fuzz');
  await checkPlanted();
}
for (const target of compiled) {
  const { runs, coverage, cpu, found } = await fuzz(target);
  console.log(
    `${target}: ${runs} runs in ${values.seconds} s, ${cpu.toFixed(0)} s of CPU, ${coverage} edges, ${found.length ? `found ${found.join(', ')}` : 'nothing found'}`,
  );
  if (found.length || runs === 0) process.exitCode = 1;
}
