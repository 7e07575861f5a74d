import { accessSync, constants, existsSync, mkdtempSync, readdirSync, readFileSync, rmdirSync, writeFileSync } from 'node:fs';
import { writeFile } from 'node:fs/promises';
import path from 'node:path';
import { isAlive } from '../api/is_alive.mjs';
import { TelarError } from '../error/index.mjs';
import { shown } from '../shot/complain.mjs';

/** Files of a group, by the version of cgroups. Swap is given none: a worker that swaps would be late, not ended. */
const V2 = {
  max: 'memory.max',
  swap: { file: 'memory.swap.max', of: () => 0 },
  kills: 'memory.events',
  /** From Linux 5.19 on. */
  peak: 'memory.peak',
};
const V1 = {
  max: 'memory.limit_in_bytes',
  /** Of memory and swap together. */
  swap: { file: 'memory.memsw.limit_in_bytes', of: (bytes) => bytes },
  kills: 'memory.oom_control',
  peak: 'memory.max_usage_in_bytes',
};

/** Bytes below its bound at which the kernel may end a process: it counts them in batches, and takes a large page whole. */
const SLACK = 16 * 2 ** 20;

/** Groups are named by the process that made them, and when that started: in containers the next service has the same number. */
const STARTED = Math.round(performance.timeOrigin);
const PREFIX = `telar-${process.pid}-${STARTED}-`;
const OWNER = /^telar-(\d+)-(\d+)-/;

function isLeft(name) {
  const [, owner, started] = OWNER.exec(name) ?? [];
  if (Number(owner) === process.pid) return Number(started) !== STARTED;
  return owner !== undefined && !isAlive(Number(owner));
}

/** A cgroup that was delegated to this process: workers get groups of their own below it, bounded by the kernel. */
export class Cgroup {
  #path;
  #files;

  /**
   * @param {string} folder of cgroup v2, without processes of its own, or of the memory controller of v1
   * @throws {TelarError} E_OPTION where groups with a bound of memory cannot be made in it
   */
  constructor(folder) {
    this.#path = folder;
    this.#files = existsSync(path.join(folder, 'cgroup.controllers')) ? V2 : V1;
    try {
      if (this.#files === V2) this.#delegateMemory();
      rmdirSync(this.make(Number.MAX_SAFE_INTEGER).path);
      this.#removeLeft();
    } catch ({ code }) {
      throw new TelarError(
        'E_OPTION',
        `options.cgroup: expected a cgroup with the memory controller in which this process may make others, of v2 without processes of its own, got ${shown(folder)} (${code})`,
      );
    }
  }

  /** @param {number} bytes of memory that a process may take in it @returns {WorkerGroup} */
  make(bytes) {
    const own = mkdtempSync(path.join(this.#path, PREFIX));
    try {
      const write = (file, value) => writeFileSync(path.join(own, file), String(value), { flag: 'r+' });
      write(this.#files.max, bytes);
      const { file, of } = this.#files.swap;
      // A kernel that does not count swap has no such file.
      if (existsSync(path.join(own, file))) write(file, of(bytes));
    } catch (error) {
      remove(own);
      throw error;
    }
    return new WorkerGroup(own, this.#files);
  }

  #delegateMemory() {
    // Whoever moves a process writes to the group above both, too.
    accessSync(path.join(this.#path, 'cgroup.procs'), constants.W_OK);
    const control = path.join(this.#path, 'cgroup.subtree_control');
    if (!/\bmemory\b/.test(readFileSync(control, 'latin1'))) writeFileSync(control, '+memory', { flag: 'r+' });
  }

  /** Groups of processes that ended before they could remove them. One that is in use is not removed by the kernel. */
  #removeLeft() {
    for (const name of readdirSync(this.#path)) if (isLeft(name)) remove(path.join(this.#path, name));
  }
}

/** The group of one worker. */
export class WorkerGroup {
  /** @type {string} */
  path;
  #files;

  constructor(own, files) {
    [this.path, this.#files] = [own, files];
  }

  /** Puts a process into it. The kernel takes some 20 ms for that, so another thread waits. @param {number} pid */
  enter(pid) {
    return writeFile(path.join(this.path, 'cgroup.procs'), String(pid), { flag: 'r+' });
  }

  /**
   * Removes it, when its process has ended.
   * @returns {number | undefined} bytes that the process had, where the kernel ended it for this group's bound; a bound of a group above or of the
   *   machine is another's
   */
  end() {
    const kills = Number(/^oom_kill (\d+)/m.exec(this.#read(this.#files.kills))?.[1] ?? 0);
    const bound = Number(this.#read(this.#files.max));
    const peak = Number(this.#read(this.#files.peak)) || bound;
    remove(this.path);
    return kills > 0 && peak >= bound - SLACK ? peak : undefined;
  }

  #read(file) {
    try {
      return readFileSync(path.join(this.path, file), 'latin1');
    } catch {
      return '';
    }
  }
}

/** One that is still in use stays until another process makes a pool in its parent. */
function remove(group) {
  try {
    rmdirSync(group);
  } catch {
    // Nobody lacks it.
  }
}
