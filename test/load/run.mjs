// npm run load [-- SECONDS [TIMES]]: from nothing to 10 times the capacity in 300 s. Ends with 1 where an answer is missing or of another kind.
import { createPool } from '../../js/pool/index.mjs';
import { judgeRamp, ramp, timesOf } from './ramp.mjs';

const [seconds = '300', times = '10'] = process.argv.slice(2);
const DEADLINE_MS = 10_000;
const say = (line) => process.stdout.write(`${line}\n`);
const told = (answers) => {
  const found = timesOf(answers);
  if (!found) return 'none';
  const { median, p95, p99, most } = Object.fromEntries(Object.entries(found).map(([name, ms]) => [name, ms.toFixed(0)]));
  return `${answers.length}: median ${median} ms, 95 of 100 within ${p95} ms, 99 within ${p99} ms, the latest ${most} ms`;
};

const pool = await createPool();
const result = await ramp({ pool, seconds: Number(seconds), times: Number(times), deadlineMs: DEADLINE_MS });
await pool.close();
const { capacity, asked, answers, late } = result;
say(`capacity ${capacity.toFixed(1)} pictures a second; ${asked} requests in ${seconds} s, up to ${times} times as many`);
for (let from = 0; from < Number(times); from += Number(times) / 5) {
  const here = answers.filter(({ load }) => load >= from && load < from + Number(times) / 5);
  say(`load ${from} to ${from + Number(times) / 5}: drawn ${told(here.filter(({ status }) => status === 200))}`);
  say(`  refused ${told(here.filter(({ status }) => status === 429))}`);
}
say(`event loop of the service: 99 of 100 looks ${late.p99.toFixed(1)} ms late, the latest ${late.most.toFixed(0)} ms`);
const faults = judgeRamp(result);
for (const fault of faults) say(`wrong: ${fault}`);
process.exitCode = faults.length > 0 ? 1 : 0;
