// A worker of the pool: a process of its own that draws what its parent sends. It never writes a picture, and ends with the pipe.
import net from 'node:net';
import os from 'node:os';
import v8 from 'node:v8';
import { isolationSteps, loadNative } from '../api/native.mjs';
import { createRenderer } from '../api/renderer.mjs';
import { toTelarError } from '../error/index.mjs';
import { Channel } from './channel.mjs';
import { ChildJobs } from './child_jobs.mjs';
import { lowerSession } from './session_priority.mjs';

/** What the pool speaks through: one end of a socket pair. */
const PIPE = 3;

/** What a worker leaves to its parent: who draws with all cores would let who answers wait. Threads that are made later have it too. */
const NICER = 5;
const { PRIORITY_LOW } = os.constants.priority;
os.setPriority(Math.min(PRIORITY_LOW, os.getPriority() + NICER));
lowerSession(NICER, process.ppid);

// A service that ends sends these to all of its processes; the parent says when.
for (const signal of ['SIGINT', 'SIGTERM', 'SIGHUP']) process.on(signal, () => {});

/** What a socket of the kernel holds at most, more or less. */
const READ_BYTES = 2 ** 18;

// One piece of memory for all that comes: a new one for each piece that is read would keep the garbage collector busy.
const pipe = new net.Socket({
  fd: PIPE,
  onread: { buffer: Buffer.allocUnsafeSlow(READ_BYTES), callback: (bytes, buffer) => channel.read(buffer.subarray(0, bytes)) },
});
for (const event of ['end', 'close', 'error']) pipe.on(event, () => process.exit(0));

// Whoever took this process over may write anything: so the parent is sent JSON, which makes nothing but plain data.
const channel = new Channel(pipe, {
  encode: (message) => Buffer.from(JSON.stringify(message)),
  decode: v8.deserialize,
  take: (message, parts) => void take(message, parts),
  refuse: () => process.exit(1),
  isFed: true,
});

let jobs;

async function take(message, parts) {
  if (message.start) return start(message.start);
  // Before the file is looked at: what ends this worker from now on may be the file's doing.
  if (message.job) channel.send({ begun: message.job.id });
  jobs.take(message, parts);
}

/** Opens the renderer, and gives up what drawing does not need: after it, since a driver may start programs when it is opened. */
async function start({ renderer: options, bound, dataBytes }) {
  try {
    const renderer = await createRenderer(options);
    const native = loadNative();
    const report = native.isolate(dataBytes);
    // What failed while the driver tried what this machine has is no news: the renderer is open.
    const before = native.failedAllocations();
    const isolation = isolationSteps(report, before === null ? 'libtelar_worker.so is not preloaded' : null);
    const isSpoiled = () => native.failedAllocations() !== before;
    jobs = new ChildJobs(renderer, { ...bound, limits: options.limits }, { answer: (answer, parts) => channel.send(answer, parts), isSpoiled });
    channel.send({ ready: { backend: renderer.backend, gl: renderer.gl, isolation } });
  } catch (error) {
    channel.send({ failed: toTelarError(error).toJSON() });
    channel.end();
  }
}
