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

const one = async (count) => {
  const pool = await createPool({ size: 1 });
  say(`pool of 1, ${count} at once: ${await perSecond(pool, count)}`);
  await pool.close();
};

{
  const [renderer, pool] = [await createRenderer(), await createPool({ size: 1 })];
  const [inProcess, pooled] = await inTurns(renderer, pool);
  for (const [name, { wall, cpu, parent }] of Object.entries({ renderer: inProcess, 'pool of 1': pooled })) {
    say(`${name}, in turns: ${wall.toFixed(1)} ms, ${cpu.toFixed(1)} ms of CPU${name === 'renderer' ? '' : `, ${parent.toFixed(1)} ms of it in the parent`}`);
  }
  const more = 100 * (pooled.cpu / inProcess.cpu - 1);
  say(`  the pool takes ${(pooled.wall - inProcess.wall).toFixed(1)} ms and ${more.toFixed(1)} % of CPU more`);
  await pool.close();
  for (const count of [1, 4]) say(`renderer, ${count} at once: ${await perSecond(renderer, count)}`);
  await renderer.close();
}
for (const count of [1, 4]) await one(count);
process.env.LP_NUM_THREADS = '0';
say('on one core:');
await one(1);
delete process.env.LP_NUM_THREADS;
{
  const pool = await createPool({ size: 2 });
  say(`pool of 2, 4 at once: ${await perSecond(pool, 4)}`);
  say(`  its workers have ${(await Promise.all(pool.workers.map(({ pid }) => residentBytes(pid)))).map(mib).join(', ')}`);
  await pool.close();
}
say(`a worker is killed:     ${await recovery()} until the next answer`);
