// npm run scale [-- --runs N] [--price P] [--busy PART] [--write]: what a picture costs here, beside Chromium's, and how that grows. With --write into
// js/docs/scale.md, else to the terminal. --peers FILE, --growth FILE: measured before, by the --json of test/bench/peers.mjs and scale.mjs.
// What a GPU changes is kept in gpu.json, by test/bench/gpu.mjs where one is.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { createRenderer } from '../../js/index.mjs';
import { scalePage } from './page.mjs';

const SELF = fileURLToPath(import.meta.url);
const ROOT = fileURLToPath(new URL('../..', import.meta.url));
const { values } = parseArgs({
  options: {
    runs: { type: 'string', default: '9' },
    price: { type: 'string', default: '0.04' },
    busy: { type: 'string', default: '0.7' },
    peers: { type: 'string' },
    growth: { type: 'string' },
    write: { type: 'boolean', default: false },
    picture: { type: 'string' },
    side: { type: 'string' },
  },
});
const runs = Number(values.runs);
const load = os.loadavg()[0];

/** What a benchmark writes by --json. */
function benchmark(name, times, kept) {
  const file = kept ?? path.join(folder, `${name}.json`);
  if (!kept) {
    const { status } = spawnSync(process.execPath, [path.join(ROOT, `test/bench/${name}.mjs`), '--runs', String(times), '--json', file], {
      stdio: ['ignore', 2, 2],
    });
    if (status !== 0) throw new Error(`test/bench/${name}.mjs ended with ${status}`);
  }
  return JSON.parse(readFileSync(file, 'utf8'));
}

/** A picture's bytes, and the memory of drawing it again and again. */
async function pictureOf(renderer, { model, side }) {
  let drawn;
  for (let i = 0; i <= runs; i++) drawn = await renderer.render(model, { size: { width: side, height: side } });
  const { data, info } = drawn;
  return { facts: { bytes: data.length, mib: info.peakBytes / 2 ** 20 }, gl: info.gl };
}

/** In a process of its own that makes no models, so that its memory is that of one. */
function pictureApart({ model, side = 512 }, index) {
  const file = path.join(folder, `${index}.glb`);
  writeFileSync(file, typeof model === 'string' ? readFileSync(model) : model);
  const { stdout, stderr, status } = spawnSync(process.execPath, [SELF, '--picture', file, '--side', String(side), '--runs', values.runs], {
    encoding: 'utf8',
  });
  if (status !== 0) throw new Error(`picture ${index}: ${stderr}`);
  return JSON.parse(stdout);
}

if (values.picture) {
  const renderer = await createRenderer();
  process.stdout.write(JSON.stringify(await pictureOf(renderer, { model: values.picture, side: Number(values.side) })));
  await renderer.close();
  process.exit();
}
const folder = mkdtempSync(path.join(os.tmpdir(), 'telar-scale-'));
const { cases } = await import('../bench/peer_models.mjs');
const all = await cases();
const apart = all.map(pictureApart);
const pictures = Object.fromEntries(all.map(({ name }, index) => [name, apart[index].facts]));
const [{ gl }] = apart;
const machine = {
  cores: os.availableParallelism(),
  cpu: os.cpus()[0].model.trim(),
  gl: `${/Mesa [\d.]+/.exec(gl.version)?.[0] ?? gl.version} ${gl.renderer.split(' ')[0]}`,
  node: process.versions.node,
  load,
  runs,
};
const gpu = JSON.parse(readFileSync(new URL('gpu.json', import.meta.url), 'utf8'));
const told = { machine, gpu, pictures, peers: benchmark('peers', runs, values.peers), growth: benchmark('scale', Math.ceil(runs / 3), values.growth) };
rmSync(folder, { recursive: true });
const text = scalePage(told, { price: Number(values.price), busy: Number(values.busy), command: 'npm run scale -- --write' });
if (values.write) writeFileSync(path.join(ROOT, 'js/docs/scale.md'), text);
else process.stdout.write(text);
