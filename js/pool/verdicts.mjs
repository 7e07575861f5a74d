import { TelarError } from '../error/index.mjs';

/** Errors of jobs whose worker was ended, or had to be. */

/** Milliseconds that a worker gets to end a job by itself, after its time or after it was cancelled. */
export const GRACE_MS = 2000;

const MIB = 2 ** 20;
const inMib = (bytes) => `${Math.ceil(bytes / MIB)} MiB`;

export const overTime = (ms) =>
  new TelarError('X_TIMEOUT', `the work took longer than the ${ms} ms that timeoutMs allows and did not stop by itself; its worker was ended`);

export const overCpu = (max, actual) =>
  new TelarError('X_TIMEOUT', `the job took ${actual} ms of CPU, and cpuMs of the pool is ${max}; reduce the model, the size or the quality`, {
    limit: { name: 'cpuMs', max, actual },
  });

const tooMuchMemory = (facts, max, actual) =>
  new TelarError('X_MEMORY', `${facts} is ${inMib(max)}; reduce the model or the size, or allow more`, { limit: { name: 'memoryBytes', max, actual } });

export const overMemory = (max, actual) => tooMuchMemory(`the worker took ${inMib(actual)} of memory, and memoryBytes of the pool`, max, actual);

/** Over the bound of its cgroup, which counts more than what is resident: the kernel's own memory for it, too. */
export const overGroup = (max, actual) =>
  tooMuchMemory(`the kernel ended the worker at ${inMib(actual)} of memory, and memoryBytes of the pool, the bound of its cgroup,`, max, actual);

/** An allocation of the worker failed, whoever asked for it. */
export const untrusted = () =>
  new TelarError('X_MEMORY', 'there was not enough memory for an allocation of the worker, and the GL driver may have drawn without it; try again');

export const overOutput = (max, actual) =>
  new TelarError('L_OUTPUT_BYTES', `the pictures of the job have ${inMib(actual)}, and outputBytes of the pool is ${inMib(max)}`, {
    limit: { name: 'outputBytes', max, actual },
  });

export const crashed = ({ signal, code }, input) =>
  new TelarError('X_CRASH', `the worker that drew this ended by ${signal ?? `itself, with exit code ${code}`}; no other job is affected`, {
    ...(signal && { signal }),
    ...(input && { input }),
  });

/** A worker ended before it was ready; failure: its process could not be made; bytes: what it had where its cgroup allows no more. */
export const notStarted = ({ signal, code, failure, bytes }) =>
  new TelarError(
    'X_WORKERS',
    failure
      ? `the process of a worker of the pool cannot be made (${failure})`
      : `a worker of the pool ended before it was ready, by ${signal ?? `itself, with ${code}`}${bytes === undefined ? '' : ` of the kernel at ${inMib(bytes)}, the bound of its cgroup`}`,
  );

export const noWorkers = (cause) =>
  new TelarError('X_WORKERS', `the workers of the pool do not start (${cause?.message ?? 'they end at once'}); it tries again by itself`, { cause });
