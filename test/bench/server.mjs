// The service under full load: how long the event loop of its process waits, what a thumbnail over HTTP costs more than in its pool, and how soon what
// is too much is refused. Clients are in a process of their own.
// node test/bench/server.mjs [SECONDS [CLIENTS]]      load of CLIENTS (16) for SECONDS (20)
import { fork } from 'node:child_process';
import { once } from 'node:events';
import { readFileSync } from 'node:fs';
import { monitorEventLoopDelay } from 'node:perf_hooks';
import { fileURLToPath } from 'node:url';
import { createPool } from '../../js/pool/index.mjs';
import { listen } from '../../js/server/index.mjs';
import { median } from '../median.mjs';

const [seconds = '20', clients = '16', url] = process.argv.slice(2);
const MS = 1000 * Number(seconds);
/** Milliseconds between two looks at the clock of the event loop. */
const LOOK_MS = 10;
const WARM_UP = 3;
const ALONE = 20;
const SHOT = { size: { width: 512, height: 512 } };
const glb = readFileSync(new URL('../../js/assets/tshirt.glb', import.meta.url));
const say = (line) => process.stdout.write(`${line}\n`);

async function ask(to) {
  const start = performance.now();
  const headers = { 'content-type': 'model/gltf-binary' };
  const response = await fetch(`${to}/v1/thumbnails?shot=${encodeURIComponent(JSON.stringify(SHOT))}`, { method: 'POST', body: glb, headers });
  await response.arrayBuffer();
  return { status: response.status, ms: performance.now() - start };
}

/** What clients do: each asks again as soon as it has an answer. */
async function load(to, ms) {
  const end = performance.now() + ms;
  const answers = [];
  const client = async () => {
    while (performance.now() < end) answers.push(await ask(to));
  };
  await Promise.all(Array.from({ length: Number(clients) }, client));
  return answers;
}

const part = (sorted, share) => sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
function times(answers) {
  const sorted = answers.map(({ ms }) => ms).sort((a, b) => a - b);
  return sorted.length ? `median ${part(sorted, 0.5).toFixed(0)} ms, 99 of 100 within ${part(sorted, 0.99).toFixed(0)} ms` : 'none';
}

async function oneByOne(work) {
  for (let i = 0; i < WARM_UP; ++i) await work();
  const all = [];
  for (let i = 0; i < ALONE; ++i) {
    const start = performance.now();
    await work();
    all.push(performance.now() - start);
  }
  return median(all).toFixed(0);
}

async function serve() {
  const pool = await createPool();
  const service = await listen({ port: 0, pool });
  say(`one by one: in the pool ${await oneByOne(() => pool.render(glb, SHOT))} ms, over HTTP ${await oneByOne(() => ask(service.url))} ms`);
  const delay = monitorEventLoopDelay({ resolution: LOOK_MS });
  const child = fork(fileURLToPath(import.meta.url), [seconds, clients, service.url]);
  const before = process.cpuUsage();
  delay.enable();
  const [answers] = await once(child, 'message');
  delay.disable();
  const { user, system } = process.cpuUsage(before);
  child.kill();
  const of = (status) => answers.filter((answer) => answer.status === status);
  say(`${clients} clients for ${seconds} s: ${of(200).length} pictures (${times(of(200))}), ${of(429).length} refused (${times(of(429))})`);
  const others = answers.length - of(200).length - of(429).length;
  if (others) say(`  ${others} answers of another status`);
  // The timer itself is woken each LOOK_MS; what is beyond that the loop was busy.
  say(`event loop: 99 of 100 looks ${(delay.percentile(99) / 1e6 - LOOK_MS).toFixed(1)} ms late, the latest ${(delay.max / 1e6 - LOOK_MS).toFixed(0)} ms`);
  say(
    `CPU of the process of the service: ${((100 * (user + system)) / 1000 / MS).toFixed(0)} % of a core, ${((user + system) / 1000 / answers.length).toFixed(1)} ms an answer`,
  );
  await service.drain();
  await pool.close();
}

if (url) process.send(await load(url, MS));
else await serve();
