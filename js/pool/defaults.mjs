import os from 'node:os';

const MIB = 2 ** 20;

/** What createPool takes where its caller says nothing. js/pool/index.d.ts and js/docs/pool.md tell them, and a test compares. */
export const DEFAULTS = Object.freeze({
  /** Of a worker: what one model may take (L_MEMORY_BYTES, 1536 MiB), and what Node and the GL driver take beside it. */
  memoryBytes: 2048 * MIB,
  cpuMs: null,
  /** A picture of 4096 x 4096 in floats is 256 MiB. */
  outputBytes: 1024 * MIB,
  quarantineMs: 24 * 3600 * 1000,
  recycleJobs: 500,
  recycleBytes: 800 * MIB,
  modelBytes: 512 * MIB,
  cgroup: null,
});

/** Part of the machine's memory that workers of the default number may take. */
const PART_OF_MEMORY = 0.75;

/** Memory of this machine, or of the container where that is less; `constrained` is 0 or absurd where there is no bound. */
export const usableBytes = (constrained = process.constrainedMemory(), total = os.totalmem()) => Math.min(total, constrained || Number.POSITIVE_INFINITY);

/** Workers: one for each core, as far as the memory goes. */
export function defaultSize(memoryBytes, { cores = os.availableParallelism(), totalBytes = usableBytes() } = {}) {
  return Math.max(1, Math.min(cores, Math.floor((PART_OF_MEMORY * totalBytes) / memoryBytes)));
}

/**
 * Threads of llvmpipe in each of so many workers: together as many as there are cores. 0 where that is one: the thread that draws rasterises too, and
 * hands nothing to another.
 */
export function threadsOfEach(size, cores = os.availableParallelism()) {
  const share = Math.floor(cores / size);
  return share > 1 ? share : 0;
}
