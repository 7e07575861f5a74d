// A model drawn again with all its triangles, against without those that are hidden at every sample: CPU time of a frame, medians over
// processes that take turns; how many are left out; and whether the bytes are the same.
// npm run bench -- hidden      node test/bench/hidden.mjs [MODEL...]      needs the dev build (npm test makes it)
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import '../js/api/support/real.mjs';
import { inspect } from '../../js/index.mjs';
import { resolveShot } from '../../js/shot/index.mjs';
import { jacket, skirt } from '../fixtures/garments/index.mjs';
import { median } from '../median.mjs';

const root = fileURLToPath(new URL('../../', import.meta.url));
const tool = path.resolve(root, process.env.TELAR_BUILD_DIR ?? 'out/dev', 'bin/telar_draw');
const folder = mkdtempSync(path.join(tmpdir(), 'telar-bench-'));
const TURNS = 5;
const FRAMES = 8;
/** The first frames compile, and fill caches. */
const WARM = 3;
const SIDES = ['never', 'always'];

const file = (name) => path.join(folder, name);

function frames(model, side) {
  const run = spawnSync(tool, [model, file('shot.json'), file(side), '--repeat', String(WARM + FRAMES), '--hidden', side], { encoding: 'utf8' });
  if (run.status !== 0) throw new Error(run.stderr || `telar_draw: ${run.error ?? run.signal}`);
  const lines = run.stdout.trim().split('\n').slice(WARM);
  return lines.map((line) => JSON.parse(line));
}

async function compare(name, model) {
  const { bounds } = await inspect(model);
  writeFileSync(file('shot.json'), JSON.stringify(resolveShot({ size: { width: 512, height: 512 } }, bounds)));
  const drawn = { never: [], always: [] };
  for (let turn = 0; turn < TURNS; ++turn) {
    for (const side of turn % 2 === 0 ? SIDES : [...SIDES].reverse()) drawn[side].push(...frames(model, side));
  }
  const [all, less] = SIDES.map((side) => median(drawn[side].map(({ cpuMs }) => cpuMs)));
  const { triangles, hiddenTriangles } = drawn.always[0];
  const look = median(drawn.always.map(({ ms }) => ms.visibility));
  const same = Buffer.compare(readFileSync(file('never')), readFileSync(file('always'))) === 0;
  console.log(
    `${name.padEnd(16)} ${triangles} triangles, ${hiddenTriangles} left out; CPU ${all.toFixed(0)} and ${less.toFixed(0)} ms, ratio ` +
      `${(less / all).toFixed(2)}, ${look.toFixed(1)} ms of it (wall) to find them; bytes ${same ? 'the same' : 'DIFFER'}`,
  );
  return same;
}

try {
  writeFileSync(file('jacket.glb'), await jacket());
  writeFileSync(file('skirt.glb'), await skirt());
  const models = process.argv.length > 2 ? process.argv.slice(2) : [path.join(root, 'js/assets/tshirt.glb'), file('jacket.glb'), file('skirt.glb')];
  for (const model of models) {
    if (!(await compare(path.basename(model), model))) process.exitCode = 1;
  }
} finally {
  rmSync(folder, { recursive: true });
}
