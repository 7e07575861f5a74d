import { readFileSync } from 'node:fs';
import { setTimeout as sleep } from 'node:timers/promises';
import { Redis } from 'ioredis';
import { createPool } from '../../js/pool/index.mjs';
import { MODELS } from '../fixtures/index.mjs';
import { freePort, startRedis } from '../js/queue/support.mjs';
import { random } from '../soak/soak.mjs';
import { clientOf } from './client.mjs';
import { supervise } from './supervise.mjs';

// A Redis server, three workers and the API, any of which ends at any moment, and clients that are slow or gone: whether each job has one whole result.
// run.mjs is the command; ../js/queue/chaos.test.mjs plants faults in what it judges.

/** Shots of the jobs: the right bytes of each are drawn beforehand. */
export const SHOTS = Array.from({ length: 8 }, (_, i) => ({ size: { width: 48, height: 48 }, exposure: 0.5 + 0.25 * i }));
/** Jobs asked for at once: more wait for theirs. */
const CLIENTS = 32;
/** Milliseconds after the last end of a process in which all jobs are over. */
export const STUCK_MS = 90_000;
const LEASE_MS = 3000;
/** Milliseconds between two looks at what was completed. */
const LOOK_MS = 250;

/** A model like no other: a chunk that readers skip (glTF 2.0, 4.4.3.1). One file for all would be put aside by a pool whose children are killed. */
export function oneOf(glb, number) {
  const chunk = Buffer.alloc(16);
  chunk.writeUInt32LE(8, 0);
  chunk.write('TEST', 4, 'latin1');
  chunk.writeUInt32LE(number, 8);
  const file = Buffer.concat([glb, chunk]);
  file.writeUInt32LE(file.length, 8);
  return file;
}

/** How often each job was told to be completed, through the ends of the server. */
function countCompletions(url) {
  const client = new Redis(url, { maxRetriesPerRequest: null });
  client.on('error', () => {});
  const times = new Map();
  let last = '0';
  const read = async () => {
    const found = await client.xrange('telar:jobs:events', last === '0' ? '-' : `(${last}`, '+');
    for (const [id, fields] of found) {
      last = id;
      const facts = Object.fromEntries(fields.flatMap((name, i) => (i % 2 === 0 ? [[name, fields[i + 1]]] : [])));
      if (facts.event === 'completed') times.set(facts.jobId, (times.get(facts.jobId) ?? 0) + 1);
    }
  };
  // One after the other: while the server is away, they wait for it.
  let isOver = false;
  const reading = (async () => {
    while (!isOver) {
      await read().catch(() => {});
      await sleep(LOOK_MS);
    }
  })();
  return {
    async end() {
      isOver = true;
      await reading;
      await read();
      client.disconnect();
      return times;
    },
    stop: () => {
      isOver = true;
      client.disconnect();
    },
  };
}

const childrenOf = (pid) => {
  try {
    return readFileSync(`/proc/${pid}/task/${pid}/children`, 'utf8').trim().split(' ').filter(Boolean).map(Number);
  } catch {
    return [];
  }
};

/** Ends one of them at random: Redis, the API, a worker, or the process that draws for one. */
async function endOne({ redis, processes, next, kills }) {
  const count = (what) => {
    kills[what] = (kills[what] ?? 0) + 1;
  };
  const at = Math.floor(next() * (processes.length + 2));
  if (at === processes.length) {
    count('redis SIGKILL');
    await redis.kill();
    await sleep(200 * next());
    return redis.start();
  }
  const one = processes[at] ?? processes[1 + Math.floor(next() * (processes.length - 1))];
  const [drawing] = at > processes.length ? childrenOf(one.pid) : [];
  const signal = drawing === undefined && next() < 0.25 ? 'SIGTERM' : 'SIGKILL';
  count(`${drawing === undefined ? one.name : 'drawing'} ${signal}`);
  try {
    process.kill(drawing ?? one.pid, signal);
  } catch {
    // It ended by itself, or is about to begin again.
  }
}

/**
 * @param {{jobs: number, kills: number, everyMs: number, seed?: number, planted?: string, say?: (line: string) => void}} how planted: a module that
 *   workers load first
 */
export async function chaos({ jobs, kills: wanted, everyMs, seed = 1, planted, say = () => {} }) {
  const glb = Buffer.from(await MODELS.cloth());
  const pool = await createPool({ size: 1, cacheDirectory: null });
  const right = [];
  for (const shot of SHOTS) right.push((await pool.render(glb, shot)).data);
  await pool.close();

  const redis = await startRedis(['--appendfsync', 'always']);
  const url = `http://127.0.0.1:${await freePort()}`;
  const env = { REDIS_URL: redis.url };
  const serve = [
    'serve',
    '--port',
    new URL(url).port,
    '--workers',
    '1',
    '--no-draw-jobs',
    '--log-level',
    'silent',
    '--jobs',
    String(jobs),
    '--lease-ms',
    '3000',
  ];
  const work = ['worker', '--workers', '1', '--lease-ms', String(LEASE_MS)];
  const processes = [supervise('api', serve, { env }), ...[1, 2, 3].map(() => supervise('worker', work, { env, planted }))];
  const completions = countCompletions(redis.url);
  const next = random(seed);
  const kills = {};
  const start = performance.now();
  const client = clientOf(url, { next, deadline: () => start + wanted * everyMs + STUCK_MS });
  try {
    let asked = 0;
    const clients = Array.from({ length: Math.min(CLIENTS, jobs) }, async () => {
      for (let i = asked++; i < jobs; i = asked++) {
        await sleep(Math.max(0, start + (i / jobs) * wanted * everyMs - performance.now()));
        await client.job({ model: oneOf(glb, i), shot: SHOTS[i % SHOTS.length], right: right[i % SHOTS.length] });
      }
    });
    const killing = (async () => {
      for (let i = 0; i < wanted; ++i) {
        await sleep(everyMs);
        await endOne({ redis, processes, next, kills });
        if (i % 10 === 9) say(`${i + 1} ends, ${client.facts.done} of ${jobs} jobs done`);
      }
    })();
    await Promise.all([...clients, killing]);
    const times = await completions.end();
    const doubled = [...times.values()].filter((count) => count > 1).length;
    return { jobs, seconds: (performance.now() - start) / 1000, kills, ...client.facts, completed: times.size, doubled };
  } finally {
    await Promise.all(processes.map((one) => one.end()));
    completions.stop();
    await redis.stop();
  }
}

/** @returns {string[]} what must not be */
export function judgeChaos({ jobs, done, lost, wrong, doubled, failed, stuck, completed }) {
  const told = [
    [lost, 'accepted jobs were lost'],
    [wrong, 'results were not the right bytes'],
    [doubled, 'jobs were completed twice'],
    [stuck, `jobs were not over ${STUCK_MS / 1000} s after the last end`],
    ...Object.entries(failed).map(([code, count]) => [count, `jobs failed with ${code}`]),
    [jobs - done, 'jobs have no result'],
    [Math.max(0, done - completed), 'results are of jobs that were never completed'],
  ];
  return told.filter(([count]) => count > 0).map(([count, what]) => `${count} ${what}`);
}
