import { removeUnfinished } from '../api/atomic_file.mjs';
import { run } from './run.mjs';

// The first SIGINT or SIGTERM cancels the work, which removes what it has begun; then the signal is given its usual effect,
// so that the shell sees it. A second one does not wait, and the first not for ever: a driver or a file system may be stuck.
// A command that takes a signal as its ordinary end says so, and how long that may take.
const ending = { patienceMs: 1000, isWell: false };
const cancelled = new AbortController();
let received;

function onSignal(signal) {
  if (received) dieUnfinished();
  received = signal;
  cancelled.abort();
  setTimeout(dieUnfinished, ending.patienceMs).unref();
}

function dieUnfinished() {
  removeUnfinished();
  die(received);
}

function die(signal) {
  process.removeAllListeners(signal);
  process.kill(process.pid, signal);
}

for (const signal of ['SIGINT', 'SIGTERM']) process.on(signal, onSignal);

/**
 * The process of a command line: its streams, its signals, its exit code.
 * @param {Record<string, import('./program.mjs').Row>} commands that it knows
 * @param {import('../api/early.mjs').EarlyRenderer} [early] that opens already
 */
export async function main(commands, early) {
  const { stdin, stdout, stderr, env } = process;
  // A reader that has seen enough, as `head`, is no fault. What must arrive is written by writeAll(), which tells.
  for (const stream of [stdout, stderr]) {
    stream.on('error', (error) => {
      if (error.code !== 'EPIPE' && stream.listenerCount('error') === 1) throw error;
    });
  }
  // The API, and what lets a command load models beside the opening of the GL.
  const loadApi = async () => {
    const [api, { beginRenderer }] = await Promise.all([import('../index.mjs'), import('../api/renderer.mjs')]);
    return { ...api, beginRenderer: (options) => early?.take(options) ?? beginRenderer(options) };
  };
  const loadPool = () => import('../pool/index.mjs');
  const io = { stdin, stdout, stderr, env, signal: cancelled.signal, ending, loadApi, loadPool };
  process.exitCode = await run(process.argv.slice(2), io, commands);
  await early?.close();
  if (received && !ending.isWell) dieUnfinished();
}
