// A pool beside a renderer in this process: what a thumbnail costs more, and what two workers draw in a second.
// node test/bench/pool.mjs [COUNT [MODEL]]      COUNT thumbnails each (30); MODEL in place of the bundled T-shirt
import { readFileSync } from 'node:fs';
import { createRenderer } from '../../js/index.mjs';
import { createPool } from '../../js/pool/index.mjs';
import { cpuMs, residentBytes } from '../../js/pool/usage.mjs';
import { median } from '../median.mjs';

const [count = '30', file = new URL('../../js/assets/tshirt.glb', import.meta.url)] = process.argv.slice(2);
const COUNT = Number(count);
const WARM_UP = 3;
/** Of rates: what else runs on the machine meets all. */
const ROUNDS = 6;
const SHOT = { size: { width: 512, height: 512 } };
const glb = readFileSync(file);
const say = (line) => process.stdout.write(`${line}\n`);
const mib = (bytes) => `${Math.round(bytes / 2 ** 20)} MiB`;

/** One thumbnail after the other, in the renderer and in the pool in turns: what else runs on the machine meets both. Told: median wall time, mean CPU. */
async function inTurns(renderer, pool) {
  const [{ pid }] = pool.workers;
  const own = () => {
    const { user, system } = process.cpuUsage();
    return (user + system) / 1000;
  };
  const turns = [renderer, pool].map((to) => ({ to, times: [], all: 0, here: 0 }));
  for (let i = -WARM_UP; i < COUNT; ++i) {
    for (const turn of i % 2 ? turns : turns.toReversed()) {
      const [start, here, there] = [performance.now(), own(), cpuMs(pid)];
      await turn.to.render(glb, SHOT);
      if (i < 0) continue;
      turn.times.push(performance.now() - start);
      turn.here += own() - here;
      turn.all += own() - here + cpuMs(pid) - there;
    }
  }
  return turns.map(({ times, all, here }) => ({ wall: median(times), cpu: all / COUNT, parent: here / COUNT }));
}

/** So many at once, until `count` are drawn. @returns {Promise<number>} thumbnails a second */
async function perSecond({ to, atOnce }, count) {
  const start = performance.now();
  let left = count;
  const draw = async () => {
    while (left-- > 0) await to.render(glb, SHOT);
  };
  await Promise.all(Array.from({ length: atOnce }, draw));
  return (1000 * count) / (performance.now() - start);
}

/** A pool of one whose worker rasterises on the core that draws. */
async function onOneCore() {
  process.env.LP_NUM_THREADS = '0';
  try {
    return await createPool({ size: 1 });
  } finally {
    delete process.env.LP_NUM_THREADS;
  }
}

/** Rates of all, in rounds: one after the other in each round, in turned order each second round. */
async function rates(contestants) {
  const all = contestants.map((one) => ({ ...one, rates: [] }));
  for (const one of all) await perSecond(one, 2 * one.atOnce);
  for (let round = 0; round < ROUNDS; ++round)
    for (const one of round % 2 ? all : all.toReversed()) one.rates.push(await perSecond(one, Math.max(8, Math.round(COUNT / ROUNDS))));
  return all;
}

{
  const [renderer, pool] = [await createRenderer(), await createPool({ size: 1 })];
  const [inProcess, pooled] = await inTurns(renderer, pool);
  for (const [name, { wall, cpu, parent }] of Object.entries({ renderer: inProcess, 'pool of 1': pooled })) {
    say(`${name}, in turns: ${wall.toFixed(1)} ms, ${cpu.toFixed(1)} ms of CPU${name === 'renderer' ? '' : `, ${parent.toFixed(1)} ms of it in the parent`}`);
  }
  const more = 100 * (pooled.cpu / inProcess.cpu - 1);
  say(`  the pool takes ${(pooled.wall - inProcess.wall).toFixed(1)} ms and ${more.toFixed(1)} % of CPU more`);
  const [one, two, four] = [await onOneCore(), await createPool({ size: 2 }), await createPool({ size: 4 })];
  const all = await rates([
    { name: 'renderer, one after the other', to: renderer, atOnce: 1 },
    { name: 'renderer, four at once', to: renderer, atOnce: 4 },
    { name: 'pool of 1, four at once', to: pool, atOnce: 4 },
    { name: 'pool of 1 on one core', to: one, atOnce: 1 },
    { name: 'pool of 4, eight at once', to: four, atOnce: 8 },
    { name: 'pool of 2, four at once', to: two, atOnce: 4 },
  ]);
  const ofTwo = all.at(-1).rates;
  say(`thumbnails a second, medians of ${ROUNDS} rounds; how many times as many the pool of 2 drew in the same round:`);
  for (const { name, rates: own } of all) say(`  ${name}: ${median(own).toFixed(1)}, ${median(own.map((rate, i) => ofTwo[i] / rate)).toFixed(2)}`);
  say(`  workers of the pool of 2 have ${(await Promise.all(two.workers.map(({ pid }) => residentBytes(pid)))).map(mib).join(', ')}`);
  for (const opened of [renderer, pool, one, two, four]) await opened.close();
}
