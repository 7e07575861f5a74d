import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { createPool } from '../../js/pool/index.mjs';
import { MODELS } from '../fixtures/index.mjs';

// Faults of the machine that faults.c makes; faults.test.mjs has what must come of them, run.mjs more allocations.

/** A folder with the library, both gone at the end of the process. */
export function buildLibrary() {
  const folder = mkdtempSync(path.join(tmpdir(), 'telar-faults-'));
  process.once('exit', () => rmSync(folder, { recursive: true, force: true }));
  const library = path.join(folder, 'faults.so');
  execFileSync('gcc', ['-shared', '-fPIC', '-O1', '-o', library, fileURLToPath(new URL('faults.c', import.meta.url)), '-ldl']);
  return { folder, library };
}

const SHOT = { size: { width: 48, height: 48 } };

/** What a job may end with where there is no memory for one allocation of its worker. */
export const OF_MEMORY = ['X_MEMORY', 'X_GL_MEMORY', 'X_CRASH', 'X_TIMEOUT'];

const settled = (promise) =>
  promise.then(
    ({ data }) => ({ data }),
    ({ code, message }) => ({ code, message }),
  );

/** What is wrong with an outcome, and with that of the next job; one whose worker ended may be asked for again. @returns {string[]} */
export function faultsOf({ data, code, message }, again, good) {
  return [
    ...(data && !data.equals(good) ? ['another picture'] : []),
    ...(code && !OF_MEMORY.includes(code) ? [`${code}: ${message}`] : []),
    ...(again.data?.equals(good) ? [] : [`afterwards ${again.code ?? 'another picture'}`]),
  ];
}

/**
 * Lets the nth allocation of a worker fail while it has a job, for each n, and then draws again.
 * @param {{folder: string, library: string}} built
 * @param {number[]} points
 * @returns {Promise<{n: number, outcome: string, faults: string[], isHit: boolean}[]>} isHit: the job made so many allocations
 */
export async function failAllocations({ folder, library }, points) {
  const counter = path.join(folder, 'countdown');
  const arm = (n) => writeFileSync(counter, Buffer.from(BigInt64Array.of(BigInt(n)).buffer), { flag: 'r+' });
  writeFileSync(counter, Buffer.alloc(8));
  Object.assign(process.env, { LD_PRELOAD: library, TELAR_FAULT_ALLOCATIONS: counter });
  const pool = await createPool({ size: 1, cacheDirectory: null, timeoutMs: 60_000, quarantineMs: 0 });
  const glb = await MODELS.cloth();
  const found = [];
  try {
    const good = (await pool.render(glb, SHOT)).data;
    for (const n of points) {
      arm(n);
      const told = await settled(pool.render(glb, SHOT));
      const isHit = readFileSync(counter).readBigInt64LE() <= 0n;
      arm(0);
      let again = await settled(pool.render(glb, SHOT));
      // One that failed after the answer is told with the next job, or ends it.
      if (OF_MEMORY.includes(again.code)) again = await settled(pool.render(glb, SHOT));
      found.push({ n, outcome: told.code ?? 'picture', faults: faultsOf(told, again, good), isHit });
    }
  } finally {
    delete process.env.LD_PRELOAD;
    delete process.env.TELAR_FAULT_ALLOCATIONS;
    await pool.close();
  }
  return found;
}
