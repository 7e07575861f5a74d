// One frame with only the features that the scene uses, against all features forced on: CPU time of the first draw (with
// compilation, Mesa's disk cache off) and of a steady draw, in one run, medians of 5 processes. The pictures are compared too.
// node test/bench/features.mjs      needs the dev build (npm test makes it)
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { resolveShot } from '../../js/shot/index.mjs';
import { MODELS } from '../fixtures/index.mjs';
import { median } from '../median.mjs';

const root = fileURLToPath(new URL('../../', import.meta.url));
const tool = path.join(root, process.env.TELAR_BUILD_DIR ?? 'out/dev', 'bin/telar_draw');
const folder = mkdtempSync(path.join(tmpdir(), 'telar-bench-'));
const RUNS = 5;
const STEADY = 10;

const file = (name) => path.join(folder, name);

/** CPU ms of the first frame and of a later one, from one process that draws `1 + STEADY` frames. */
function measure(model, out, extra) {
  const env = { ...process.env, MESA_SHADER_CACHE_DISABLE: 'true' };
  const run = spawnSync(tool, [model, file('shot.json'), file(out), '--repeat', String(1 + STEADY), ...extra], { encoding: 'utf8', env });
  if (run.status !== 0) throw new Error(run.stderr || `telar_draw: ${run.error ?? run.signal}`);
  const frames = run.stdout
    .trim()
    .split('\n')
    .map((line) => JSON.parse(line));
  return { first: frames[0].cpuMs, steady: median(frames.slice(1).map((frame) => frame.cpuMs)), features: frames[0].features.length };
}

function compare(name, model, shot) {
  writeFileSync(file('shot.json'), JSON.stringify(shot));
  const needed = [];
  const all = [];
  for (let i = 0; i < RUNS; ++i) {
    needed.push(measure(model, 'needed.raw', []));
    all.push(measure(model, 'all.raw', ['--all-features']));
  }
  const of = (list, key) => median(list.map((item) => item[key]));
  const a = readFileSync(file('needed.raw'));
  const b = readFileSync(file('all.raw'));
  const difference = a.reduce((most, byte, i) => Math.max(most, Math.abs(byte - b[i])), 0);
  for (const key of ['first', 'steady']) {
    const [few, many] = [of(needed, key), of(all, key)];
    console.log(
      `${name.padEnd(12)} ${key.padEnd(7)} needed ${few.toFixed(1).padStart(7)} ms  all ${many.toFixed(1).padStart(7)} ms  ratio ${(many / few).toFixed(2)}`,
    );
  }
  console.log(`${name.padEnd(12)} features ${needed[0].features} and ${all[0].features}, pictures differ by at most ${difference}/255`);
}

try {
  const bounds = { min: [-1, -1, -1], max: [1, 1, 1] };
  writeFileSync(file('ball.glb'), await MODELS.ball());
  compare('ball, sun', file('ball.glb'), resolveShot({ environment: 'none', lights: [{ type: 'directional', position: [1, 2, 3] }] }, bounds));
  compare('ball, studio', file('ball.glb'), resolveShot({}, bounds));
  const shirt = { min: [-0.45, 0, -0.2], max: [0.45, 0.75, 0.2] };
  compare('shirt', path.join(root, 'js/assets/tshirt.glb'), resolveShot({}, shirt));
} finally {
  rmSync(folder, { recursive: true });
}
