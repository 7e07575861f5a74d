import { readFileSync, readdirSync } from 'node:fs';

/** What the processes below this one take: CPU time, memory. */

const TICKS_A_SECOND = 100;

/** Fields of /proc/PID/stat from the state on, or undefined where it has ended. */
function statOf(pid) {
  try {
    return readFileSync(`/proc/${pid}/stat`, 'utf8').split(') ').at(-1).split(' ');
  } catch {
    return undefined;
  }
}

/** Processes below this one. */
export function descendants() {
  const parents = new Map(
    readdirSync('/proc')
      .filter((name) => /^\d+$/.test(name))
      .map((pid) => [pid, statOf(pid)?.[1]]),
  );
  const isBelow = (pid) => pid !== undefined && (parents.get(pid) === String(process.pid) || (pid !== '1' && isBelow(parents.get(pid))));
  return [...parents.keys()].filter(isBelow);
}

/** Milliseconds of CPU of the processes below this one that live, and of those that have ended. */
export function cpuBelow() {
  const ticks = (fields, from) => Number(fields?.[from] ?? 0) + Number(fields?.[from + 1] ?? 0);
  return (
    ((descendants().reduce((sum, pid) => sum + ticks(statOf(pid), 11) + ticks(statOf(pid), 13), 0) + ticks(statOf(process.pid), 13)) * 1000) / TICKS_A_SECOND
  );
}

/** Mebibytes that processes have for themselves, with their shares of what is shared. */
export const pssOf = (pids) => pids.reduce((sum, pid) => sum + Number(/^Pss:\s+(\d+)/m.exec(readFileSync(`/proc/${pid}/smaps_rollup`, 'utf8'))[1]), 0) / 1024;

/** {cpu, wall} in milliseconds. `cpuNow`: of whom. */
export async function measured(cpuNow, job) {
  const [cpu, wall] = [cpuNow(), performance.now()];
  await job();
  return { cpu: cpuNow() - cpu, wall: performance.now() - wall };
}
