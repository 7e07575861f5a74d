import { closeSync, openSync, readSync } from 'node:fs';

/** Milliseconds between two looks at a worker. */
const INTERVAL = 50;
/** Of /proc/PID/stat: a tick is 10 ms on every Linux, as user space sees it. */
const MS_PER_TICK = 10;
/** Fields of /proc/PID/stat after the name: time in user mode and in the kernel. */
const [USER, SYSTEM] = [11, 12];

/** More than these files have. */
const scratch = Buffer.allocUnsafeSlow(8192);

/** A file of /proc/PID, empty where the process is gone. It is no disk's: reading it takes microseconds, and another thread would take longer. */
function procText(pid, name) {
  let file;
  try {
    file = openSync(`/proc/${pid}/${name}`);
    return scratch.latin1Slice(0, readSync(file, scratch));
  } catch {
    return '';
  } finally {
    if (file !== undefined) closeSync(file);
  }
}

/** Resident memory in bytes; 0 of a process that is gone. */
export const residentBytes = (pid) => 1024 * Number(/^VmRSS:\s*(\d+)/m.exec(procText(pid, 'status'))?.[1] ?? 0);

/** Milliseconds of CPU, of all threads. */
export function cpuMs(pid) {
  const stat = procText(pid, 'stat');
  const fields = stat.slice(stat.lastIndexOf(')') + 2).split(' ');
  return MS_PER_TICK * (Number(fields[USER] ?? 0) + Number(fields[SYSTEM] ?? 0));
}

/** Looks at a worker while it has a job, and says once what is over its bound. */
export class UsageWatch {
  #pid;
  #bound;
  #tell;
  #timer;
  #cpuBefore;

  /**
   * @param {number} pid
   * @param {{memoryBytes: number, cpuMs: number | null}} bound
   * @param {(over: {memory?: number, cpu?: number}) => void} tell
   */
  constructor(pid, bound, tell) {
    this.#pid = pid;
    this.#bound = bound;
    this.#tell = tell;
    this.#cpuBefore = bound.cpuMs === null ? undefined : cpuMs(pid);
    this.#timer = setInterval(() => this.#look(), INTERVAL).unref();
  }

  stop() {
    clearInterval(this.#timer);
    this.#timer = undefined;
  }

  #look() {
    const memory = residentBytes(this.#pid);
    const cpu = this.#cpuBefore === undefined ? 0 : cpuMs(this.#pid) - this.#cpuBefore;
    if (memory > this.#bound.memoryBytes) this.#end({ memory });
    else if (this.#bound.cpuMs !== null && cpu > this.#bound.cpuMs) this.#end({ cpu });
  }

  #end(over) {
    this.stop();
    this.#tell(over);
  }
}
