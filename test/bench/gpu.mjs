// What a GPU changes: the same pictures by the GL that telar takes here and by Mesa's llvmpipe, each in a process of its own. Wall and CPU time, how far
// the pictures are apart, and by which gates; the first picture of a process, twice, since drivers keep programs on the disk; a picture by a pool.
// npm run bench -- gpu      node test/bench/gpu.mjs [--runs N] [--json FILE] [--pictures FOLDER] [--cases fast|gate [CASE...]] [--part I/N] [--backend NAME]
// --pictures: keeps them there, and takes those of a side that lie there already; --cases: in place of the times, cases of the parity gate, which
// are drawn on both and compared; --part: every Nth of them from the Ith on, for several processes side by side; --backend: of the first side
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { compareImages, encodePng, judge, readImage } from '../../js/compare/index.mjs';
import { createRenderer } from '../../js/index.mjs';
import { createPool } from '../../js/pool/index.mjs';
import { median } from '../median.mjs';
import { cpuBelow, descendants, pssOf } from '../processes.mjs';

const SELF = fileURLToPath(import.meta.url);
const TSHIRT = fileURLToPath(new URL('../../js/assets/tshirt.glb', import.meta.url));
const DRAPE = fileURLToPath(new URL('../../js/assets/fabrics.glb', import.meta.url));
const WOOL = { camera: { azimuth: 25, elevation: 22 }, shading: 'fabric', variant: 'wool', environment: 'studio' };
/** Where Debian's Mesa says that it is there: libEGL asks no other then. */
const MESA = '/usr/share/glvnd/egl_vendor.d/50_mesa.json';
const GATES = ['parity', 'other-gl'];
/** A picture that takes long is drawn less often: as often as goes into this. */
const MOST_MS = 6000;
/** So long a pool draws. */
const RATE_MS = 4000;

const OPTIONS = {
  runs: { type: 'string', default: '15' },
  json: { type: 'string' },
  pictures: { type: 'string' },
  cases: { type: 'string' },
  part: { type: 'string', default: '0/1' },
  backend: { type: 'string', default: 'auto' },
  draw: { type: 'string' },
  first: { type: 'boolean' },
};
const { values, positionals } = parseArgs({ options: OPTIONS, allowPositionals: true });

/** What is drawn and timed. @returns {Promise<{name: string, model: string | Uint8Array, shot: object}[]>} */
async function timedPictures() {
  const { cases } = await import('./peer_models.mjs');
  const size = (side) => ({ width: side, height: side });
  return [
    ...(await cases()).map(({ name, model, side = 512 }) => ({ name, model, shot: { size: size(side) } })),
    { name: 'the T-shirt, 2048 x 2048', model: TSHIRT, shot: { size: size(2048) } },
    { name: 'drape of wool, shading fabric', model: DRAPE, shot: { ...WOOL, size: size(512) } },
    { name: 'the same in quality medium', model: DRAPE, shot: { ...WOOL, size: size(512), quality: 'medium' } },
  ];
}

/** Cases of the parity gate. */
async function gateCases() {
  const [{ GATE_CASES }, { loadInputs }, { withMap }] = await Promise.all([
    import('../parity/cases.mjs'),
    import('../parity/inputs.mjs'),
    import('../parity/tool.mjs'),
  ]);
  const [first, parts] = values.part.split('/').map(Number);
  // Those of `npm test` first: a side that is ended early has them.
  const chosen = GATE_CASES.filter(({ fast }) => values.cases === 'gate' || fast)
    .filter(({ name }) => positionals.length === 0 || positionals.includes(name))
    .toSorted((a, b) => Number(b.fast ?? false) - Number(a.fast ?? false))
    .filter((_, i) => i % parts === first);
  return chosen.map((item) => ({
    name: item.name,
    async open() {
      const { model, environment, bundled, failOn } = await loadInputs(item);
      return { model, shot: withMap(item.shot, bundled ? 'studio' : environment), options: { failOn } };
    },
  }));
}

const fileOf = (folder, name) => path.join(folder, `${name.replaceAll(/[^\w.-]+/g, '_')}.png`);
const cpuNow = () => Object.values(process.cpuUsage()).reduce((sum, us) => sum + us, 0) / 1000;

/** Wall and CPU milliseconds of a job, and what it gave. */
async function timed(job) {
  const [wall, cpu] = [performance.now(), cpuNow()];
  const value = await job();
  return { wall: performance.now() - wall, cpu: cpuNow() - cpu, value };
}

/** The same job again and again. @returns {Promise<{wall: number, cpu: number, stages: Record<string, number>, runs: number}>} medians */
async function again(job) {
  const samples = [];
  const end = performance.now() + MOST_MS;
  while (samples.length < Number(values.runs) && (samples.length < 3 || performance.now() < end)) samples.push(await timed(job));
  const of = (figure) => median(samples.map(figure));
  const names = Object.keys(samples[0].value.info.milliseconds);
  const stages = Object.fromEntries(names.map((name) => [name, of(({ value }) => value.info.milliseconds[name] ?? 0)]));
  return { wall: of(({ wall }) => wall), cpu: of(({ cpu }) => cpu), stages, runs: samples.length };
}

/** One side: its pictures into a folder, and what it took. */
async function drawTimed(renderer, folder, keep) {
  const pictures = {};
  for (const { name, model, shot } of await timedPictures()) {
    try {
      const first = await timed(() => renderer.render(model, shot));
      writeFileSync(fileOf(folder, name), first.value.data);
      const { info } = first.value;
      const file = await again(() => renderer.render(model, shot));
      const loaded = await renderer.load(model);
      await renderer.render(loaded, shot);
      const kept = await again(() => renderer.render(loaded, shot));
      await renderer.release(loaded);
      pictures[name] = {
        file,
        kept,
        first: { wall: first.wall, cpu: first.cpu, stages: info.milliseconds, programs: info.programsCompiled },
        facts: {
          triangles: info.triangles,
          hidden: info.hiddenTriangles,
          fragments: info.shadedFragments,
          covered: info.picture.coverage * info.width * info.height,
        },
      };
    } catch (error) {
      pictures[name] = { error: `${error.code}: ${error.message}` };
    }
    keep(pictures);
  }
  return pictures;
}

async function drawCases(renderer, folder, keep) {
  const pictures = {};
  for (const { name, open } of await gateCases()) {
    try {
      const { model, shot, options } = await open();
      const { wall, value } = await timed(() => renderer.render(model, { ...shot, output: { format: 'raw' } }, options));
      const { data, info } = value;
      writeFileSync(fileOf(folder, name), await encodePng({ width: info.width, height: info.height, data }));
      pictures[name] = { wall, compile: info.milliseconds.compile ?? 0, programs: info.programsCompiled };
    } catch (error) {
      pictures[name] = { error: `${error.code}: ${error.message}` };
    }
    keep(pictures);
  }
  return pictures;
}

/** The T-shirt by a worker of a pool, with what that gives up. */
async function drawByPool(options, folder) {
  try {
    const pool = await createPool({ ...options, size: 1 });
    const { data } = await pool.render(TSHIRT, { size: { width: 512, height: 512 } });
    const file = fileOf(folder, 'T-shirt of 58,000 triangles');
    const { gl, backend } = pool;
    const [{ isolation }] = pool.workers;
    const refused = isolation.filter(({ failure }) => failure !== null);
    await pool.close();
    return { gl, backend, refused, isSame: existsSync(file) ? Buffer.compare(data, readFileSync(file)) === 0 : undefined };
  } catch (error) {
    return { error: `${error.code}: ${error.message}` };
  }
}

const factsIn = (folder) => path.join(folder, `facts${values.part.replace('/', '_')}.json`);

/** Pictures a second of a pool with a worker a core, as many at once: the T-shirt, from its file. */
async function rateOfPool(options) {
  const size = os.availableParallelism();
  const pool = await createPool({ ...options, size });
  try {
    const draw = () => pool.render(TSHIRT, { size: { width: 512, height: 512 } });
    await Promise.all(Array.from({ length: 3 * size }, draw));
    const [start, before] = [performance.now(), cpuBelow()];
    let drawn = 0;
    const drawOn = async () => {
      for (; performance.now() < start + RATE_MS; drawn++) await draw();
    };
    await Promise.all(Array.from({ length: size }, drawOn));
    const seconds = (performance.now() - start) / 1000;
    return { workers: size, rate: drawn / seconds, cores: (cpuBelow() - before) / 1000 / seconds, mib: pssOf(descendants()) };
  } finally {
    await pool.close();
  }
}

/** Of this process: bytes that it may write to, reserved or not, and those that are there. */
const memoryNow = () =>
  Object.fromEntries([...readFileSync('/proc/self/status', 'utf8').matchAll(/^(VmData|VmRSS|VmHWM):\s+(\d+)/gm)].map(([, key, kib]) => [key, kib / 1024]));

async function drawSide(folder) {
  mkdirSync(folder, { recursive: true });
  const options = { backend: values.backend };
  const context = await timed(() => createRenderer(options));
  const renderer = context.value;
  const facts = { gl: renderer.gl, backend: renderer.backend, context: { wall: context.wall, cpu: context.cpu } };
  const keep = (more) => writeFileSync(factsIn(folder), JSON.stringify(Object.assign(facts, more)));
  await (values.cases ? drawCases : drawTimed)(renderer, folder, (pictures) => keep({ pictures }));
  await renderer.close();
  if (values.cases) return;
  keep({ pool: await drawByPool(options, folder) });
  keep({ rate: await rateOfPool(options).catch((error) => ({ error: `${error.code}: ${error.message}` })) });
}

/** The first picture of a process, by its parts. */
async function drawFirst() {
  const context = await timed(() => createRenderer({ backend: values.backend }));
  const { value, wall, cpu } = await timed(() => context.value.render(TSHIRT, { size: { width: 512, height: 512 } }));
  const memory = memoryNow();
  await context.value.close();
  const { compile, environment } = value.info.milliseconds;
  process.stdout.write(
    JSON.stringify({ context: context.wall, wall, cpu, compile, environment, sinceStart: performance.now(), cpuSinceStart: cpuNow(), memory }),
  );
}

function run(words, env) {
  const { status, stdout, signal } = spawnSync(process.execPath, [SELF, ...words], {
    env: { ...process.env, ...env },
    encoding: 'utf8',
    stdio: ['ignore', 'pipe', 'inherit'],
  });
  if (status !== 0) throw new Error(`${words.join(' ')} ended with ${status ?? signal}`);
  return stdout;
}

/** Both sides, by name: environment and backend. */
const SIDES = {
  here: { env: {}, backend: values.backend },
  llvmpipe: {
    env: { LIBGL_ALWAYS_SOFTWARE: '1', GALLIUM_DRIVER: 'llvmpipe', ...(existsSync(MESA) && { __EGL_VENDOR_LIBRARY_FILENAMES: MESA }) },
    backend: 'egl-surfaceless',
  },
};

/** Two processes one after the other, with no program of a driver on the disk before. */
function startsOf(words, env) {
  const fresh = mkdtempSync(path.join(os.tmpdir(), 'telar-bench-'));
  try {
    return ['none', 'kept'].map((programs) => ({ programs, ...JSON.parse(run(['--first', ...words], { ...env, HOME: fresh, XDG_CACHE_HOME: fresh })) }));
  } finally {
    rmSync(fresh, { recursive: true });
  }
}

/** A side's facts, with its pictures in the folder. */
function sideIn(folder, name) {
  const own = path.join(folder, name);
  if (!existsSync(factsIn(own))) {
    const { env, backend } = SIDES[name];
    const words = ['--backend', backend, '--part', values.part];
    const starts = values.cases ? [] : startsOf(words, env);
    run(['--draw', own, '--runs', values.runs, ...(values.cases ? ['--cases', values.cases, ...positionals] : []), ...words], env);
    writeFileSync(factsIn(own), JSON.stringify({ ...JSON.parse(readFileSync(factsIn(own), 'utf8')), starts }));
  }
  return JSON.parse(readFileSync(factsIn(own), 'utf8'));
}

/** How far one picture is from the other one. */
async function distance(folder, name) {
  const [expected, actual] = await Promise.all(['llvmpipe', 'here'].map((side) => readImage(fileOf(path.join(folder, side), name))));
  const comparison = compareImages(expected, actual);
  const { frame, object, interior } = comparison;
  if (!object) return { max: frame.max, interiorMax: 0, mean: frame.mean, flip: 0, deltaE: 0, passes: GATES.map(() => true) };
  return {
    max: frame.max,
    interiorMax: interior?.max ?? null,
    interiorP999: interior?.p999 ?? null,
    mean: object.mean,
    flip: object.flip.mean,
    deltaE: object.deltaE.p95,
    passes: GATES.map((gate) => judge(comparison, gate).pass),
  };
}

const ms = (value) => (value < 10 ? value.toFixed(1) : value.toFixed(0));
const word = (passes) => GATES.filter((_, i) => passes[i]).join(', ') || 'none';

const timesOf = ({ wall, cpu }) => ({ wall, cpu });
const machine = () => ({ cpu: os.cpus()[0].model.trim(), cores: os.availableParallelism(), node: process.versions.node });

/** What of a side is kept with --json, its pictures apart. */
const sideFacts = ({ gl, backend, starts, pool, rate }) => ({ gl, backend, starts, pool, rate });

/** Of all cases: how many are within each gate, and how far they are apart. */
function summaryOf(found) {
  const flips = found.map(({ flip }) => flip).toSorted((a, b) => a - b);
  const within = Object.fromEntries(GATES.map((gate, i) => [gate, found.filter(({ passes }) => passes[i]).length]));
  return { drawn: found.length, within, flip: { median: median(flips), ninetyFive: flips[Math.floor(0.95 * flips.length)] } };
}

/** Into the file of --json, beside what it holds of the other kind of run. */
function tell(more) {
  if (!values.json) return;
  const kept = existsSync(values.json) ? JSON.parse(readFileSync(values.json, 'utf8')) : {};
  writeFileSync(values.json, `${JSON.stringify({ ...kept, ...more }, null, 1)}\n`);
}

async function compareSides(folder) {
  const [here, llvmpipe] = Object.keys(SIDES).map((name) => sideIn(folder, name));
  for (const [name, { gl, backend }] of Object.entries({ here, llvmpipe })) console.log(`${name}: ${gl.vendor}, ${gl.renderer}, ${gl.version}, ${backend}`);
  const [found, failed, pictures] = [[], [], []];
  for (const name of Object.keys(here.pictures).filter((each) => llvmpipe.pictures[each])) {
    const [a, b] = [here, llvmpipe].map((side) => side.pictures[name]);
    const error = a.error ?? b.error;
    if (error) {
      failed.push({ name, error });
      console.log(`${name} | ${error}`);
      continue;
    }
    const distant = await distance(folder, name);
    found.push({ name, ...distant });
    const { max, interiorMax, mean, flip, passes } = distant;
    const words = [name, `max ${max}, inside ${interiorMax}; mean ${mean.toFixed(3)}; FLIP ${flip.toFixed(4)}; gates passed: ${word(passes)}`];
    if (a.file) {
      const ways = Object.fromEntries(['file', 'kept'].map((way) => [way, { here: timesOf(a[way]), llvmpipe: timesOf(b[way]) }]));
      pictures.push({ name, ...ways, stages: a.kept.stages, max, mean, flip, gates: GATES.filter((_, i) => passes[i]) });
      for (const [way, sides] of Object.entries(ways))
        words.push(`${way} ${ms(sides.here.wall)} / ${ms(sides.llvmpipe.wall)} ms wall, ${ms(sides.here.cpu)} / ${ms(sides.llvmpipe.cpu)} ms CPU`);
    }
    console.log(words.join(' | '));
  }
  if (values.cases) tell({ cases: { ...summaryOf(found), failed, beyond: found.filter(({ passes }) => !passes.at(-1)).map(({ name }) => name) } });
  else tell({ machine: machine(), here: sideFacts(here), llvmpipe: sideFacts(llvmpipe), pictures });
}

if (values.draw) await drawSide(values.draw);
else if (values.first) await drawFirst();
else {
  const folder = values.pictures ?? mkdtempSync(path.join(os.tmpdir(), 'telar-bench-'));
  await compareSides(folder);
  if (!values.pictures) rmSync(folder, { recursive: true });
}
