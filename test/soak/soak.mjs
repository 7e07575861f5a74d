import { createHash } from 'node:crypto';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';
import sharp from 'sharp';
import { createPool } from '../../js/pool/index.mjs';
import { MODELS } from '../fixtures/index.mjs';
import { glb, quad } from '../robust/glb.mjs';
import { makeCases } from '../robust/make_cases.mjs';

// Many renders through a pool whose workers are not replaced, a fifth of them of hostile files: whether memory, descriptors, threads and GL names stay flat, and
// whether each file ends each time as it did the first time. run.mjs is the command, ../js/pool/soak.test.mjs a short one.

const SHARED = fileURLToPath(new URL('../../../shared/hostile', import.meta.url));
const MIB = 2 ** 20;
const HOSTILE_PART = 0.2;
/** Jobs asked for at once, for each worker. */
const AT_ONCE = 2;
/** Milliseconds that a picture may take here; a hostile file that takes longer is X_TIMEOUT each time. */
const TIMEOUT_MS = 20_000;
const NEVER = 1e9;
/** Milliseconds in which a worker has told of its last job. */
const SETTLED_MS = 50;

/** Bytes that a worker may grow by in 1000 renders, once warm. */
const SLOPE = MIB;
/** Bytes by which a look at a worker may be off: what it keeps of the largest job so far, and its heap before a collection. */
const NOISE = 32 * MIB;

/** How many more there may be in the second half: a program for each kind of material that comes late. One that is lost in 100 renders is found in 10,000. */
const LATE = { threads: 0, descriptors: 0, glObjects: 8 };

const GOOD = ['cloth', 'ball', 'base-color-map', 'normal-map', 'vertex-colors', 'two-uv-sets', 'cloth-tangents', 'ball-metal'];
const SIDES = [24, 48, 96, 128];

/** Of a texture that fills what a worker keeps for its next jobs: textures, and memory of images. Pixels. */
const LARGE_SIDE = 4096;

/** A model whose one texture is a JPEG of so many pixels a side. */
export async function withTexture(side = LARGE_SIDE) {
  const image = await sharp({ create: { width: side, height: side, channels: 3, background: '#777' } })
    .jpeg()
    .toBuffer();
  const model = quad({ image });
  model.doc.images[0].mimeType = 'image/jpeg';
  return glb(model);
}

/** The same sequence each time (mulberry32): 0..1. */
export function random(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t ^= t + Math.imul(t ^ (t >>> 7), 61 | t);
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

function hostileFiles() {
  const own = makeCases().map(({ name, bytes }) => ({ name, bytes }));
  if (!existsSync(SHARED)) return own;
  const { cases } = JSON.parse(readFileSync(path.join(SHARED, 'manifest.json'), 'utf8'));
  const theirs = cases.filter(({ mode }) => mode === 'bytes').map(({ file }) => ({ name: file, bytes: readFileSync(path.join(SHARED, 'cases', file)) }));
  return [...own, ...theirs];
}

/** What a process holds now. */
async function holdings(pid) {
  const status = await readFile(`/proc/${pid}/status`, 'latin1');
  const number = (name) => Number(new RegExp(`^${name}:\\s*(\\d+)`, 'm').exec(status)[1]);
  return { pid, bytes: 1024 * number('VmRSS'), threads: number('Threads'), descriptors: readdirSync(`/proc/${pid}/fd`).length };
}

const outcomeOf = (promise) =>
  promise.then(
    ({ data }) => createHash('sha256').update(data).digest('hex'),
    ({ code }) => code,
  );

/**
 * @param {{renders: number, looks?: number, size?: number, say?: (line: string) => void}} how looks: at the processes, in between
 * @returns {Promise<{looks: {renders: number, processes: object[]}[], outcomes: Record<string, number>, changed: string[], lost: number, seconds: number}>}
 *   changed: files that did not end as before; lost: workers that ended
 */
export async function soak({ renders, looks = 20, size = 2, say = () => {} }) {
  const pool = await createPool({ size, cacheDirectory: null, recycleJobs: NEVER, recycleBytes: 1536 * MIB, memoryBytes: 3072 * MIB, timeoutMs: TIMEOUT_MS });
  const good = await Promise.all(GOOD.map(async (name) => ({ name, bytes: await MODELS[name]() })));
  const hostile = hostileFiles();
  const next = random(1);
  const pick = (list) => list[Math.floor(next() * list.length)];
  const seen = new Map();
  const outcomes = {};
  const changed = new Set();
  const found = [];
  const one = async () => {
    const { name, bytes } = next() < HOSTILE_PART ? pick(hostile) : pick(good);
    const side = pick(SIDES);
    const outcome = await outcomeOf(pool.render(bytes, { size: { width: side, height: side } }));
    const as = `${name} ${side}`;
    if ((seen.get(as) ?? outcome) !== outcome) changed.add(as);
    seen.set(as, outcome);
    const kind = /^[0-9a-f]{64}$/.test(outcome) ? 'picture' : outcome;
    outcomes[kind] = (outcomes[kind] ?? 0) + 1;
  };
  // What a kind of material makes once is there before the first look, in each worker, of hostile files that are drawn too, and what it keeps of the largest.
  const large = await withTexture();
  const drawInEach = async (models, ending = (picture) => picture) => {
    for (const bytes of models) await Promise.all(pool.workers.map(() => ending(pool.render(bytes, { size: { width: SIDES[0], height: SIDES[0] } }))));
  };
  const bytesOf = (files) => files.map(({ bytes }) => bytes);
  do {
    await drawInEach([large, ...bytesOf(good)]);
    // These may be refused.
    await drawInEach(bytesOf(hostile), outcomeOf);
  } while (pool.workers.some(({ jobs }) => jobs < 1 + good.length + hostile.length));
  const first = new Set(pool.workers.map(({ pid }) => pid));
  const look = async (done) => {
    // What a worker holds goes by its last jobs. After these it has given freed pages back (addon/freed_memory.h), and looks can be compared.
    await drawInEach([large, large]);
    globalThis.gc?.();
    await sleep(SETTLED_MS);
    const workers = pool.workers.map(async ({ pid, glObjects }) => ({ ...(await holdings(pid)), glObjects }));
    const processes = await Promise.all([holdings(process.pid), ...workers]);
    found.push({ renders: done, processes });
    say(
      `${done} renders: ${processes.map(({ bytes, threads, descriptors, glObjects }) => `${(bytes / MIB).toFixed(0)} MiB, ${threads} threads, ${descriptors} fds${glObjects === undefined ? '' : `, ${glObjects} GL names`}`).join('; ')}`,
    );
  };
  const start = performance.now();
  for (let done = 0; done < renders; ) {
    const until = Math.min(renders, done + Math.ceil(renders / looks));
    const client = async () => {
      while (done < until) {
        done += 1;
        await one();
      }
    };
    await Promise.all(Array.from({ length: AT_ONCE * size }, client));
    await look(done);
  }
  const lost = pool.workers.filter(({ pid }) => !first.has(pid)).length;
  await pool.close();
  return { looks: found, outcomes, changed: [...changed], lost, seconds: (performance.now() - start) / 1000 };
}

const median = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];

/** Bytes by which a process has grown in 1000 renders: the median of the slopes between all pairs of looks (Theil and Sen). */
export function growth(looks) {
  const slopes = looks.flatMap((a, i) => looks.slice(i + 1).map((b) => (1000 * (b.bytes - a.bytes)) / (b.renders - a.renders)));
  return slopes.length ? median(slopes) : 0;
}

/**
 * What is not flat after the first part of the looks, which warms up.
 * @param {Awaited<ReturnType<typeof soak>>} result
 * @param {number} [warmUp] part of the looks
 * @returns {{faults: string[], slopes: number[]}} slopes: of the parent and the workers, bytes in 1000 renders
 */
export function judgeSoak({ looks, changed, lost }, warmUp = 0.3) {
  const faults = changed.map((name) => `${name} did not end as it did before`);
  if (lost > 0) faults.push(`${lost} workers ended`);
  const warm = looks.slice(Math.floor(warmUp * looks.length));
  const slopes = warm[0].processes.map((_, i) => {
    const own = warm.map(({ renders, processes }) => ({ renders, ...processes[i] }));
    const which = i === 0 ? 'the parent' : `worker ${i}`;
    const slope = growth(own);
    const renders = own.at(-1).renders - own[0].renders;
    const grown = (slope * renders) / 1000;
    if (slope > SLOPE && grown > NOISE) faults.push(`${which} grew by ${(grown / MIB).toFixed(0)} MiB in ${renders} renders`);
    for (const [what, late] of Object.entries(LATE)) {
      const half = Math.ceil(own.length / 2);
      const [before, after] = [own.slice(0, half), own.slice(half)].map((part) => Math.min(...part.map((each) => each[what])));
      if (after > before + late) faults.push(`${which} has ${after} ${what} in place of ${before}`);
    }
    return slope;
  });
  return { faults, slopes };
}
