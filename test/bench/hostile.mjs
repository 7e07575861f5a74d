// Hostile and damaged files through a pool of two and over HTTP, as many at once as workers: how soon they are refused, and that each ends as it must.
// node test/bench/hostile.mjs [ROUNDS]      each file ROUNDS (3) times. Ends with 1 where one ends otherwise or late, or a worker is lost
import http from 'node:http';
import { monitorEventLoopDelay } from 'node:perf_hooks';
import { createPool } from '../../js/pool/index.mjs';
import { listen } from '../../js/server/index.mjs';
import { askAll, hostileFiles, judgeHostile, timesOfHostile } from '../load/hostile.mjs';

const [rounds = '3'] = process.argv.slice(2);
const WORKERS = 2;
const DEADLINE_MS = 20_000;
const LATE_MS = 2000;
/** Milliseconds between two looks at the clock of the event loop. */
const LOOK_MS = 10;
const SHOT = { size: { width: 64, height: 64 } };
const say = (line) => process.stdout.write(`${line}\n`);
const told = (times) =>
  times ? `median ${times.median.toFixed(0)} ms, 99 of 100 within ${times.p99.toFixed(0)} ms, the latest ${times.most.toFixed(0)} ms` : 'none';

const pool = await createPool({ size: WORKERS, timeoutMs: DEADLINE_MS, recycleJobs: Number.MAX_SAFE_INTEGER });
const service = await listen({ port: 0, pool, deadlineMs: DEADLINE_MS });
const agent = new http.Agent({ keepAlive: true });

const byPool = (bytes) =>
  pool.render(bytes, SHOT).then(
    () => '',
    ({ code }) => code,
  );

/** By node:http: fetch() does not say why a connection was cut. */
const byHttp = (bytes) =>
  new Promise((resolve) => {
    const headers = { 'content-type': 'model/gltf-binary', 'content-length': bytes.length };
    const request = http.request(`${service.url}/v1/thumbnails?shot=${encodeURIComponent(JSON.stringify(SHOT))}`, { method: 'POST', agent, headers });
    request.on('error', ({ code }) => resolve(code));
    request.on('response', async (response) => {
      const body = Buffer.concat(await response.toArray());
      resolve(response.statusCode === 200 ? '' : JSON.parse(body).code);
    });
    request.end(bytes);
  });

const files = hostileFiles();
const asked = files.length * Number(rounds);
const pids = () => pool.workers.map(({ pid }) => pid);
await askAll(files, byPool, { atOnce: WORKERS, rounds: 1 });
for (const [name, ask] of Object.entries({ pool: byPool, HTTP: byHttp })) {
  const before = pids();
  const delay = monitorEventLoopDelay({ resolution: LOOK_MS });
  delay.enable();
  const answers = await askAll(files, ask, { atOnce: WORKERS, rounds: Number(rounds) });
  delay.disable();
  const lost = before.filter((pid) => !pids().includes(pid)).length;
  const { refused, drawn } = timesOfHostile(answers);
  say(`${name}: ${files.length} files, ${answers.filter(({ code }) => code).length} of ${asked} refused: ${told(refused)}`);
  say(`  drawn: ${told(drawn)}; event loop: 99 of 100 looks ${(delay.percentile(99) / 1e6 - LOOK_MS).toFixed(1)} ms late; ${lost} workers lost`);
  for (const { file, code, ms } of answers
    .filter(({ code }) => code)
    .sort((a, b) => b.ms - a.ms)
    .slice(0, 3))
    say(`  latest: ${file.name}, ${code}, ${ms.toFixed(0)} ms`);
  for (const fault of judgeHostile({ asked, answers, mostMs: DEADLINE_MS + LATE_MS, lost })) {
    say(`  wrong: ${fault}`);
    process.exitCode = 1;
  }
}
agent.destroy();
await service.drain();
await pool.close();
