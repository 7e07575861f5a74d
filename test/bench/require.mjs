import { execFileSync, spawnSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import path from 'node:path';
import { median } from '../median.mjs';

// What require('telar') costs, its addon included, against require('sharp'): node test/bench/require.mjs [runs].
// Each run is a process of its own, the two in turn; medians. Exit 1 when telar takes more than twice sharp's time.

const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const RUNS = Number(process.argv[2] ?? 15);
const MAX_RATIO = 2;
const addon = path.join(process.env.TELAR_BUILD_DIR ?? path.join(ROOT, 'out/release'), 'addon/telar.node');

// sharp loads its native part in require(); telar with its first call, so here it is added to the account.
const CASES = { telar: `require('telar'); require(${JSON.stringify(addon)});`, sharp: "require('sharp');" };

function measure(text) {
  const script = `const start = performance.now(); ${text}
    console.log(JSON.stringify({ ms: performance.now() - start, mebibytes: process.memoryUsage.rss() / 2 ** 20 }));`;
  const { status, stdout, stderr } = spawnSync(process.execPath, ['-e', script], { cwd: ROOT, encoding: 'utf8' });
  if (status !== 0) throw new Error(stderr);
  return JSON.parse(stdout);
}

execFileSync(process.execPath, [path.join(ROOT, 'js/build/dist.mjs')]);
const samples = { telar: [], sharp: [], nothing: [] };
for (const [name, text] of Object.entries(CASES)) measure(text, name); // file caches
for (let run = 0; run < RUNS; ++run) {
  for (const name of Object.keys(samples)) samples[name].push(measure(CASES[name] ?? ''));
}

const of = (name, key) => median(samples[name].map((sample) => sample[key]));
for (const name of Object.keys(CASES)) {
  const memory = of(name, 'mebibytes') - of('nothing', 'mebibytes');
  console.log(`require('${name}')  ${of(name, 'ms').toFixed(1)} ms, ${memory.toFixed(1)} MiB (median of ${RUNS})`);
}
const ratio = of('telar', 'ms') / of('sharp', 'ms');
console.log(`ratio ${ratio.toFixed(2)} (at most ${MAX_RATIO})`);
process.exitCode = ratio <= MAX_RATIO ? 0 : 1;
