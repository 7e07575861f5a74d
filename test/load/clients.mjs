import http from 'node:http';
import { setTimeout as sleep } from 'node:timers/promises';

// The clients of ramp.mjs.

/** Milliseconds between two looks at how many requests are due. */
const TICK_MS = 5;
/** Milliseconds that a client keeps an idle connection: as load balancers do, and less than the service does. */
const KEEP_ALIVE_MS = 60_000;
const agent = new http.Agent({ keepAlive: true, maxSockets: 4096, timeout: KEEP_ALIVE_MS });

/** @returns {Promise<{status: number | string, code: string, ms: number}>} status: of HTTP, or the code of what cut the connection */
function ask({ url, model, shot }) {
  const start = performance.now();
  return new Promise((resolve) => {
    const end = (status, code = '') => resolve({ status, code, ms: performance.now() - start });
    const headers = { 'content-type': 'model/gltf-binary', 'content-length': model.length };
    const request = http.request(`${url}/v1/thumbnails?shot=${encodeURIComponent(JSON.stringify(shot))}`, { method: 'POST', agent, headers });
    request.on('error', ({ code }) => end(code));
    request.on('response', async (response) => {
      const body = Buffer.concat(await response.toArray());
      end(response.statusCode, response.statusCode === 200 ? '' : JSON.parse(body).code);
    });
    request.end(model);
  });
}

/** How many times as long a machine with other work gets for its first picture: without one there is no capacity, and nothing to ramp up. */
const PATIENCE = 60;

/** Pictures a second where each client asks again as soon as it has an answer. */
async function measure(of, { clients, ms }) {
  await ask(of);
  const start = performance.now();
  const elapsed = () => performance.now() - start;
  let count = 0;
  const client = async () => {
    while (elapsed() < (count === 0 ? PATIENCE * ms : ms)) if ((await ask(of)).status === 200) count += 1;
  };
  await Promise.all(Array.from({ length: clients }, client));
  return { capacity: (1000 * count) / elapsed() };
}

/** Asks ever faster, up to `times` the capacity. */
async function ramp(of, { capacity, times, ms }) {
  const answering = [];
  const start = performance.now();
  for (let elapsed = 0; elapsed < ms; elapsed = performance.now() - start) {
    // The rate grows with time, so what is due grows with its square.
    const due = (capacity * times * elapsed * elapsed) / (2000 * ms);
    const load = (times * elapsed) / ms;
    while (answering.length < due) answering.push(ask(of).then((answer) => ({ ...answer, load })));
    await sleep(TICK_MS);
  }
  return { asked: answering.length, answers: await Promise.all(answering) };
}

process.on('message', async ({ measure: measured, ramp: ramped, ...of }) => process.send(await (measured ? measure(of, measured) : ramp(of, ramped))));
