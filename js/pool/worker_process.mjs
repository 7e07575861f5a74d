import { spawn } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import v8 from 'node:v8';
import { fromNative, toTelarError } from '../error/index.mjs';
import { Channel, TooLarge } from './channel.mjs';
import { workerEnvironment } from './environment.mjs';
import { HeldModels } from './held_models.mjs';
import { RunningJob } from './running_job.mjs';
import { UsageWatch } from './usage.mjs';
import { GRACE_MS, notStarted, overCpu, overGroup, overMemory, overOutput } from './verdicts.mjs';

const CHILD = fileURLToPath(new URL('child.mjs', import.meta.url));
const PIPE = 3;
/** Of the plain part of an answer, beside the pictures: the lines of a flat are the longest. */
const HEADER_BYTES = 64 * 2 ** 20;
/** Milliseconds in which a worker is ready: one that is not does not start. */
const START_MS = 30_000;
/** What a worker may reserve before the kernel refuses: a last bound, for what happens between two looks. Stacks and heaps are mostly not resident. */
const reservable = (memoryBytes) => 2 * memoryBytes + 2 ** 30;

/** A worker ended in the middle of a job: by itself, or as `verdict` says; hadBegun: it had taken the job up. */
export class WorkerEnded extends Error {
  constructor(facts, { verdict, hadBegun }) {
    super('the worker ended');
    this.facts = facts;
    this.verdict = verdict;
    this.hadBegun = hadBegun;
  }
}

/** One child process, on the parent's side. */
export class WorkerProcess {
  /** @type {Promise<{backend: string, gl: object, isolation: object[]}>} rejects where it does not start */
  ready;
  /** @type {Promise<void>} */
  ended;
  held;
  jobs = 0;
  /** GL names that it held after its last job. */
  glObjects = 0;
  /** Whether it draws no more: an allocation of it failed, and its pictures may be wrong; or its GL context was lost. */
  isSpoiled = false;
  hasEnded = false;
  facts;
  #process;
  #group;
  #channel;
  #bound;
  #job;
  #watch;
  #verdict;
  #opened;
  #freed;
  #toForget = [];

  /** @param {{renderer: object, size: number, bound: object, modelBytes: number, cgroup?: import('./cgroup.mjs').Cgroup}} options of createPool, with every default */
  constructor({ renderer, size, bound, modelBytes, cgroup }) {
    this.#bound = bound;
    this.held = new HeldModels(modelBytes);
    this.ready = new Promise((resolve, reject) => {
      this.#opened = { resolve, reject };
    });
    // The caller who waits for it is told; others are not.
    this.ready.catch(() => {});
    // A group of its own: Ctrl-C in a terminal is for the parent, which then says when.
    const options = {
      stdio: ['ignore', 'ignore', 'inherit', 'pipe'],
      env: workerEnvironment(size, { cacheDirectory: renderer.cacheDirectory }),
      detached: true,
    };
    this.ended = new Promise((resolve) => this.#spawn(options, cgroup, (facts) => this.#end(facts, resolve)));
    // Node gives no pipes where there is no descriptor for them.
    const pipe = this.#process?.stdio?.[PIPE];
    if (!pipe) return;
    // What waits for jobs holds up no process: the pool does while it has some.
    this.#process.unref();
    pipe.unref();
    // A worker that is gone is told by the event of the process.
    pipe.on('error', () => {});
    this.#channel = new Channel(pipe, {
      encode: v8.serialize,
      decode: JSON.parse,
      take: (message, parts) => this.#take(message, parts),
      // One that writes what no worker writes has been taken over.
      refuse: (error) => this.kill(error instanceof TooLarge ? overOutput(bound.outputBytes, error.bytes) : undefined),
    });
    this.#channel.maxBytes = bound.outputBytes + HEADER_BYTES;
    const late = setTimeout(() => this.kill(), START_MS).unref();
    void Promise.race([this.ready, this.ended])
      .catch(() => {})
      .finally(() => clearTimeout(late));
    void this.#start({ renderer, bound, dataBytes: reservable(bound.memoryBytes) });
  }

  /** undefined of a process that could not be made. */
  get pid() {
    return this.#process?.pid;
  }

  get isBusy() {
    return this.#job !== undefined;
  }

  /**
   * Runs a job; one at a time.
   * @param {import('./request.mjs').Request} request
   * @param {AbortSignal} [signal] not aborted
   * @returns {{outcome: Promise<unknown>, free: Promise<WorkerEnded | undefined>}} free: the worker can take another one, or has ended in the middle of this
   *   one, also of one whose caller aborted
   */
  run(request, signal) {
    this.jobs += 1;
    this.forget(this.held.trim());
    const free = new Promise((resolve) => {
      this.#freed = resolve;
    });
    this.#watch = new UsageWatch(this.pid, this.#bound, ({ memory, cpu }) =>
      this.kill(memory === undefined ? overCpu(this.#bound.cpuMs, cpu) : overMemory(this.#bound.memoryBytes, memory)),
    );
    const worker = { send: (message, parts) => this.#channel.send(message, parts), kill: (verdict) => this.kill(verdict) };
    try {
      this.#job = new RunningJob(this.jobs, request, worker, this.held, signal);
    } catch (error) {
      this.#free();
      return { outcome: Promise.reject(toTelarError(error)), free };
    }
    return { outcome: this.#job.outcome, free };
  }

  /** Lets models go, after the job that runs. @param {number[]} ids */
  forget(ids) {
    // What a running job is told to use stays until it has: the two sides would not agree on what is held.
    if (this.#job) this.#toForget.push(...ids);
    else {
      for (const id of ids) this.held.forget(id);
      if (ids.length > 0) this.#channel?.send({ forget: ids });
    }
  }

  /** Ends it at once. @param {Error} [verdict] what the job's caller is told */
  kill(verdict) {
    this.#verdict ??= verdict;
    if (this.pid !== undefined) this.#process.kill('SIGKILL');
  }

  /** Ends it when it has nothing to do; one that does not end is killed. */
  close() {
    this.#channel?.end();
    const late = setTimeout(() => this.kill(), GRACE_MS).unref();
    return this.ended.finally(() => clearTimeout(late));
  }

  /** Without descriptors or memory Node tells of it later, or throws: either is a start that failed. */
  #spawn(options, cgroup, end) {
    try {
      this.#group = cgroup?.make(this.#bound.memoryBytes);
      this.#process = spawn(process.execPath, ['--no-warnings', CHILD], options);
    } catch (error) {
      return end({ failure: error.code ?? error.message });
    }
    this.#process.once('error', ({ code, message }) => end({ failure: code ?? message }));
    this.#process.once('close', (code, signal) => end({ code, signal }));
  }

  /** What a worker takes for its work counts in its group: it is there before it begins. */
  async #start(start) {
    try {
      await this.#group?.enter(this.pid);
    } catch ({ code }) {
      // One that has ended is told of by its own event.
      if (code === 'ESRCH') return;
      this.#opened.reject(notStarted({ failure: `${code} in its cgroup` }));
      return this.kill();
    }
    this.#channel.send({ start });
  }

  #take(message, parts) {
    if (message.ready) {
      this.facts = message.ready;
      this.#opened.resolve(message.ready);
    } else if (message.failed) this.#opened.reject(fromNative(message.failed));
    else if (message.glObjects !== undefined) this.glObjects = Number(message.glObjects);
    else {
      this.isSpoiled ||= message.isSpoiled === true;
      if (this.#job?.take(message, parts)) this.#free();
    }
  }

  #free(ended) {
    this.#watch.stop();
    this.#job = undefined;
    this.forget(this.#toForget.splice(0));
    this.#freed(ended);
  }

  #end(facts, resolve) {
    this.hasEnded = true;
    const over = this.#group?.end();
    const bytes = facts.signal === 'SIGKILL' ? over : undefined;
    // What ended a worker that had not taken its job up was not the job.
    if (bytes !== undefined && this.#job?.hasBegun) this.#verdict ??= overGroup(this.#bound.memoryBytes, bytes);
    this.#opened.reject(notStarted({ ...facts, bytes }));
    if (this.#job) {
      const ended = new WorkerEnded(facts, { verdict: this.#verdict, hadBegun: this.#job.hasBegun });
      this.#job.end(ended);
      this.#free(ended);
    }
    resolve();
  }
}
