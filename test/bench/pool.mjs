// A pool beside a renderer in this process: what a thumbnail costs more, what two workers draw in a second, and how long a worker that was
// killed is missed.
// node test/bench/pool.mjs [COUNT [MODEL]]      COUNT thumbnails each (30); MODEL in place of the bundled T-shirt
import { readFileSync } from 'node:fs';
import { setTimeout as sleep } from 'node:timers/promises';
import { createRenderer } from '../../js/index.mjs';
import { createPool } from '../../js/pool/index.mjs';
import { cpuMs, residentBytes } from '../../js/pool/usage.mjs';
import { median } from '../median.mjs';

const [count = '30', file = new URL('../../js/assets/tshirt.glb', import.meta.url)] = process.argv.slice(2);
const COUNT = Number(count);
const WARM_UP = 3;
const KILLS = 5;
const SHOT = { size: { width: 512, height: 512 } };
const glb = readFileSync(file);
const say = (line) => process.stdout.write(`${line}\n`);
const mib = (bytes) => `${Math.round(bytes / 2 ** 20)} MiB`;

/** Median wall time and mean CPU of this process and of the given ones, one thumbnail after the other. */
async function oneByOne(to, pids = () => []) {
  for (let i = 0; i < WARM_UP; ++i) await to.render(glb, SHOT);
  const used = async () => (await Promise.all([process.pid, ...pids()].map(cpuMs))).reduce((sum, each) => sum + each);
  const before = await used();
  const times = [];
  for (let i = 0; i < COUNT; ++i) {
    const start = performance.now();
    await to.render(glb, SHOT);
    times.push(performance.now() - start);
  }
  return `${median(times).toFixed(0)} ms, ${(((await used()) - before) / COUNT).toFixed(0)} ms of CPU`;
}

async function perSecond(to, atOnce) {
  await Promise.all(Array.from({ length: 2 * atOnce }, () => to.render(glb, SHOT)));
  const start = performance.now();
  let left = COUNT;
  const draw = async () => {
    while (left-- > 0) await to.render(glb, SHOT);
  };
  await Promise.all(Array.from({ length: atOnce }, draw));
  return `${((1000 * COUNT) / (performance.now() - start)).toFixed(2)} thumbnails a second`;
}

const busyPid = async (pool) => {
  for (;;) {
    const found = pool.workers.find(({ state }) => state === 'busy');
    if (found) return found.pid;
    await sleep(1);
  }
};

/** From the end of a worker in the middle of a job to the next answer of a pool of one. */
async function recovery() {
  const pool = await createPool({ size: 1, quarantineMs: 0 });
  await pool.render(glb, SHOT);
  const times = [];
  for (let i = 0; i < KILLS; ++i) {
    const doomed = pool.render(glb, SHOT).catch(() => {});
    process.kill(await busyPid(pool), 'SIGKILL');
    const start = performance.now();
    const [, { info }] = await Promise.all([doomed, pool.render(glb, SHOT)]);
    times.push([performance.now() - start, info.milliseconds.total]);
  }
  await pool.close();
  const of = (pick) => median(times.map(pick)).toFixed(0);
  return `${of(([whole]) => whole)} ms, ${of(([, drawing]) => drawing)} ms of it the drawing`;
}

const renderer = await createRenderer();
say(`renderer, one by one:   ${await oneByOne(renderer)}`);
say(`renderer, four at once: ${await perSecond(renderer, 4)}`);
await renderer.close();
for (const size of [1, 2]) {
  const pool = await createPool({ size });
  say(`pool of ${size}, one by one:  ${await oneByOne(pool, () => pool.workers.map(({ pid }) => pid))}`);
  say(`pool of ${size}, four at once: ${await perSecond(pool, 4)}`);
  say(`  its workers have ${(await Promise.all(pool.workers.map(({ pid }) => residentBytes(pid)))).map(mib).join(', ')}`);
  await pool.close();
}
say(`a worker is killed:     ${await recovery()} until the next answer`);
