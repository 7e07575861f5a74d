// Workers of a pool that are killed: how long the next answer of their slot takes, and what the jobs of the others notice.
// node test/bench/deaths.mjs [SECONDS [MODEL]]      two clients for SECONDS (20) with and without a kill a second; MODEL in place of the bundled T-shirt
import { readFileSync } from 'node:fs';
import { setTimeout as sleep } from 'node:timers/promises';
import { createPool } from '../../js/pool/index.mjs';
import { timesOf } from '../load/ramp.mjs';
import { median } from '../median.mjs';
import { until } from '../until.mjs';

const [seconds = '20', file = new URL('../../js/assets/tshirt.glb', import.meta.url)] = process.argv.slice(2);
const KILLS = 9;
/** With and without kills in turns: what else runs on the machine meets both. */
const TURNS = 4;
/** Milliseconds between two kills. */
const EVERY_MS = 1000;
const SHOT = { size: { width: 512, height: 512 } };
const glb = readFileSync(file);
const say = (line) => process.stdout.write(`${line}\n`);

/** A worker that has a job, once there is one; undefined from `end` on. */
async function busyPid(pool, end = Number.POSITIVE_INFINITY) {
  while (performance.now() < end) {
    const found = pool.workers.find(({ state }) => state === 'busy');
    if (found) return found.pid;
    await sleep(1);
  }
}

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
  const [whole, drawing] = [0, 1].map((i) => times.map((time) => time[i]));
  say(
    `a worker is killed: ${median(whole).toFixed(0)} ms until the next answer, ${median(drawing).toFixed(0)} ms of it the drawing; the latest ${Math.max(...whole).toFixed(0)} ms`,
  );
}

/**
 * Two clients, each one job after the other. One whose worker was killed asks again as soon as both workers are there: what the other notices is the start
 * beside it, and no wait for its turn.
 * @returns {Promise<{ms: number}[]>} of the jobs that no kill met
 */
async function drawn(pool, ms, isKilled) {
  const answers = [];
  const end = performance.now() + ms;
  const client = async () => {
    while (performance.now() < end) {
      const start = performance.now();
      const { code } = await pool.render(glb, SHOT).catch((error) => error);
      if (code === undefined) answers.push({ ms: performance.now() - start });
      else if (code !== 'X_CRASH') throw new Error(`a job ended with ${code}`);
      else await until(() => pool.workers.length === 2 && pool.workers.every(({ state }) => state !== 'starting'));
    }
  };
  const kill = async () => {
    for (;;) {
      await sleep(EVERY_MS);
      const pid = await busyPid(pool, end);
      if (!pid) return;
      process.kill(pid, 'SIGKILL');
    }
  };
  await Promise.all([client(), client(), isKilled && kill()]);
  return answers;
}

await recovery();
const pool = await createPool({ size: 2, quarantineMs: 0 });
await drawn(pool, 2000, false);
const turns = [false, true].map((isKilled) => ({ isKilled, answers: [] }));
for (let turn = 0; turn < TURNS; ++turn)
  for (const { isKilled, answers } of turns) answers.push(...(await drawn(pool, (1000 * Number(seconds)) / TURNS, isKilled)));
await pool.close();
for (const { isKilled, answers } of turns) {
  const { median: middle, p95, p99, most } = timesOf(answers);
  say(
    `two clients, ${isKilled ? 'a kill a second' : 'no kill'}: ${answers.length} pictures, median ${middle.toFixed(0)} ms, 95 of 100 within ${p95.toFixed(0)} ms, 99 within ${p99.toFixed(0)} ms, the latest ${most.toFixed(0)} ms`,
  );
}
