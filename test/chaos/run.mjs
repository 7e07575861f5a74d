import { chaos, judgeChaos } from './chaos.mjs';

// npm run chaos [-- JOBS [--planted]]: 2,000 jobs while a process ends each 2 s, one for ten jobs. Ends with 1 where a job is lost, doubled or not whole.
// --planted: with a worker that says too early that a job is done, which must be found.

const EVERY_MS = 2000;
const [count = '2000', ...rest] = process.argv.slice(2).filter((word) => word !== '--planted');
const isPlanted = process.argv.includes('--planted');
if (!/^[1-9]\d{0,5}$/.test(count) || rest.length > 0) throw new Error('expected npm run chaos [-- JOBS [--planted]]');
const say = (line) => process.stdout.write(`${line}\n`);

const jobs = Number(count);
const planted = isPlanted ? new URL('plant_early_word.mjs', import.meta.url).href : undefined;
const facts = await chaos({ jobs, kills: Math.max(5, Math.ceil(jobs / 10)), everyMs: EVERY_MS, planted, say });
const faults = judgeChaos(facts);
const { seconds, kills, done, lost, wrong, doubled, stuck, asked, again, slow, cut, longest } = facts;
say(
  `${jobs} jobs in ${seconds.toFixed(0)} s: ${done} done, ${lost} lost, ${doubled} doubled, ${wrong} not whole, ${stuck} stuck; the longest took ${longest.toFixed(1)} s`,
);
say(
  `ended: ${Object.entries(kills)
    .map(([what, times]) => `${what} ${times}`)
    .join(', ')}`,
);
say(`requests for jobs: ${asked}, ${again} of them again; ${slow} slow, ${cut} cut`);
for (const fault of faults) say(`fault: ${fault}`);
if (isPlanted) say(faults.length > 0 ? 'the planted fault is found' : 'the planted fault is not found');
process.exitCode = faults.length > 0 === isPlanted ? 0 : 1;
