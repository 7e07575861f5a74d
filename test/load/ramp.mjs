import { fork } from 'node:child_process';
import { once } from 'node:events';
import { monitorEventLoopDelay } from 'node:perf_hooks';
import { fileURLToPath } from 'node:url';
import { MODELS } from '../fixtures/index.mjs';
import { listen } from '../../js/server/index.mjs';

// More requests than a service can draw: those that it takes are answered within their deadline, the others are refused at once. The clients are in a
// process of their own, and ask at their rate whatever comes back. run.mjs is the command, ../js/server/load.test.mjs a short one.

const CLIENTS = fileURLToPath(new URL('clients.mjs', import.meta.url));
const SHOT = { size: { width: 128, height: 128 } };
/** Milliseconds between two looks at the clock of the event loop. */
const LOOK_MS = 10;

/**
 * @param {{pool: object, seconds: number, times: number, deadlineMs: number}} how times: the capacity, at the end of the ramp
 * @returns {Promise<{capacity: number, asked: number, answers: {status: number | string, code: string, ms: number, load: number}[], idle: object, late: {p99: number, most: number}}>}
 *   capacity: pictures a second, one client for each worker; load: rate over capacity when it was asked; idle: what the service says afterwards;
 *   late: milliseconds that the event loop of the service was late during the ramp
 */
export async function ramp({ pool, seconds, times, deadlineMs }) {
  const service = await listen({ port: 0, pool, deadlineMs });
  const model = Buffer.from(await MODELS.cloth());
  const clients = fork(CLIENTS, [], { serialization: 'advanced' });
  const ask = async (message) => {
    clients.send({ url: service.url, model, shot: SHOT, ...message });
    const [answer] = await once(clients, 'message');
    return answer;
  };
  try {
    const { length } = pool.workers;
    const { capacity } = await ask({ measure: { clients: length, ms: Math.max(1000, 100 * seconds) } });
    const delay = monitorEventLoopDelay({ resolution: LOOK_MS });
    delay.enable();
    // Before the clients tell all answers at once.
    setTimeout(() => delay.disable(), 1000 * seconds);
    const { asked, answers } = await ask({ ramp: { capacity, times, ms: 1000 * seconds } });
    const late = { p99: delay.percentile(99) / 1e6 - LOOK_MS, most: delay.max / 1e6 - LOOK_MS };
    const idle = await (await fetch(new URL('/readyz', service.url))).json();
    return { capacity, asked, answers, idle, late };
  } finally {
    clients.kill();
    await service.drain();
  }
}

const part = (sorted, share) => sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];

/** @returns {{median: number, p95: number, p99: number, most: number} | undefined} milliseconds */
export function timesOf(answers) {
  const sorted = answers.map(({ ms }) => ms).sort((a, b) => a - b);
  return sorted.length ? { median: part(sorted, 0.5), p95: part(sorted, 0.95), p99: part(sorted, 0.99), most: sorted.at(-1) } : undefined;
}

/**
 * What is wrong with the answers: each request has one, of two kinds, and afterwards the service is idle.
 * @param {Awaited<ReturnType<typeof ramp>>} result
 * @returns {string[]}
 */
export function judgeRamp({ asked, answers, idle }) {
  const faults = [];
  const others = answers.filter(({ status, code }) => status !== 200 && !(status === 429 && code === 'X_BUSY'));
  if (answers.length !== asked) faults.push(`${asked - answers.length} of ${asked} requests have no answer`);
  if (others.length > 0) faults.push(`${others.length} answers of another kind, as ${others[0].status} ${others[0].code}`);
  for (const status of [200, 429]) if (!answers.some((answer) => answer.status === status)) faults.push(`no answer is ${status}`);
  if (idle.status !== 'ready' || idle.running + idle.waiting > 0) faults.push(`afterwards the service says ${JSON.stringify(idle)}`);
  return faults;
}
