import { readFile } from 'node:fs/promises';

/** Milliseconds between two looks at a worker. */
const INTERVAL = 50;
/** Of /proc/PID/stat: a tick is 10 ms on every Linux, as user space sees it. */
const MS_PER_TICK = 10;
/** Fields of /proc/PID/stat after the name: time in user mode and in the kernel. */
const [USER, SYSTEM] = [11, 12];

/** Resident memory in bytes; 0 of a process that is gone. */
export async function residentBytes(pid) {
  const status = await readFile(`/proc/${pid}/status`, 'latin1').catch(() => '');
  return 1024 * Number(/^VmRSS:\s*(\d+)/m.exec(status)?.[1] ?? 0);
}

/** Milliseconds of CPU, of all threads. */
export async function cpuMs(pid) {
  const stat = await readFile(`/proc/${pid}/stat`, 'latin1').catch(() => '');
  const fields = stat.slice(stat.lastIndexOf(')') + 2).split(' ');
  return MS_PER_TICK * (Number(fields[USER] ?? 0) + Number(fields[SYSTEM] ?? 0));
}

/** Looks at a worker while it has a job, and says once what is over its bound. */
export class UsageWatch {
  #pid;
  #bound;
  #tell;
  #timer;
  #busy = false;
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
    this.#timer = setInterval(() => void this.#look(), INTERVAL).unref();
  }

  stop() {
    clearInterval(this.#timer);
    this.#timer = undefined;
  }

  async #look() {
    if (this.#busy) return;
    this.#busy = true;
    const memory = await residentBytes(this.#pid);
    const cpu = this.#cpuBefore ? (await cpuMs(this.#pid)) - (await this.#cpuBefore) : 0;
    this.#busy = false;
    if (!this.#timer) return;
    if (memory > this.#bound.memoryBytes) this.#end({ memory });
    else if (this.#bound.cpuMs !== null && cpu > this.#bound.cpuMs) this.#end({ cpu });
  }

  #end(over) {
    this.stop();
    this.#tell(over);
  }
}
