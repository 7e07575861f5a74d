import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { setTimeout as sleep } from 'node:timers/promises';
import { createPool } from '../../js/pool/index.mjs';
import { MODELS } from '../fixtures/index.mjs';
import { freePort } from '../js/queue/support.mjs';
import { random } from '../soak/soak.mjs';
import { oneOf, SHOTS, STUCK_MS } from './chaos.mjs';
import { clientOf } from './client.mjs';
import { supervise } from './supervise.mjs';

// The API and workers on a queue in SQLite, all of it on a disk that is full again and again: whether each accepted job has its whole result.

const DISK_BYTES = 24 * 2 ** 20;
const CLIENTS = 8;
const WORKERS = 2;
/** Milliseconds for which the disk is full, and for which it is not. */
const [FULL_MS, FREE_MS] = [1500, 2000];
/** A disk that is full for almost half of the time fails three tries of some jobs. */
const TRIES = ['--attempts', '6', '--backoff-ms', '300'];
/** What fills it is written in pieces: the last one that fits is small. */
const PIECES = [2 ** 20, 4096, 1];

/** A disk of its own, as root: a tmpfs. */
export function smallDisk(bytes = DISK_BYTES) {
  const folder = mkdtempSync(path.join(tmpdir(), 'telar-disk-'));
  execFileSync('mount', ['-t', 'tmpfs', '-o', `size=${bytes}`, 'telar-chaos', folder]);
  const filler = path.join(folder, 'filler');
  return {
    folder,
    /** Until not a byte more fits. */
    fill() {
      for (const piece of PIECES) {
        try {
          for (;;) writeFileSync(filler, Buffer.alloc(piece), { flag: 'a' });
        } catch (error) {
          if (error.code !== 'ENOSPC') throw error;
        }
      }
    },
    free: () => rmSync(filler, { force: true }),
    remove() {
      execFileSync('umount', ['-l', folder]);
      rmSync(folder, { recursive: true });
    },
  };
}

/** @param {{jobs: number, seed?: number, say?: (line: string) => void}} how @returns {Promise<object>} as chaos() does; fills: how often the disk was full */
export async function fullDisk({ jobs, seed = 1, say = () => {} }) {
  const glb = Buffer.from(await MODELS.cloth());
  const pool = await createPool({ size: 1, cacheDirectory: null });
  const right = [];
  for (const shot of SHOTS) right.push((await pool.render(glb, shot)).data);
  await pool.close();

  const disk = smallDisk();
  mkdirSync(path.join(disk.folder, 'queue'));
  const url = `http://127.0.0.1:${await freePort()}`;
  const queue = ['--sqlite', path.join(disk.folder, 'queue/jobs.db'), '--lease-ms', '3000', '--workers', '1', ...TRIES];
  const serve = ['serve', '--port', new URL(url).port, '--no-draw-jobs', '--log-level', 'silent', '--jobs', String(jobs), ...queue];
  const processes = [supervise('api', serve, { env: {} }), ...Array.from({ length: WORKERS }, () => supervise('worker', ['worker', ...queue], { env: {} }))];
  let end = performance.now() + STUCK_MS;
  const client = clientOf(url, { next: random(seed), deadline: () => end });
  let [asked, fills, isOver] = [0, 0, false];
  const start = performance.now();
  try {
    const clients = Promise.all(
      Array.from({ length: Math.min(CLIENTS, jobs) }, async () => {
        for (let i = asked++; i < jobs; i = asked++) await client.job({ model: oneOf(glb, i), shot: SHOTS[i % SHOTS.length], right: right[i % SHOTS.length] });
      }),
    );
    clients
      .catch(() => {})
      .finally(() => {
        isOver = true;
      });
    while (!isOver) {
      await sleep(FREE_MS);
      disk.fill();
      fills += 1;
      await sleep(FULL_MS);
      disk.free();
      end = performance.now() + STUCK_MS;
      if (fills % 10 === 0) say(`${fills} times full, ${client.facts.done} of ${jobs} jobs done`);
    }
    await clients;
    // Of a job in SQLite one end is kept: what came twice is a second result, whose bytes would be there beside the first.
    const doubled = Math.max(0, readdirSync(path.join(disk.folder, 'queue/jobs.db-bytes')).filter((name) => !name.startsWith('.')).length - client.facts.done);
    const starts = processes.reduce((sum, one) => sum + one.starts, 0) - processes.length;
    return { jobs, seconds: (performance.now() - start) / 1000, fills, starts, ...client.facts, completed: client.facts.done, doubled };
  } finally {
    await Promise.all(processes.map((one) => one.end()));
    disk.remove();
  }
}
