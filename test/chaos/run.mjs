import { spawnSync } from 'node:child_process';
import { parseArgs } from 'node:util';
import { chaos, judgeChaos } from './chaos.mjs';
import { fullDisk } from './full_disk.mjs';

// npm run chaos [-- JOBS [--planted | --full-disk]]: 2,000 jobs while a process ends each 2 s, one for ten jobs. Ends with 1 where a job is lost, doubled or not
// whole. --planted: with a worker that says too early that a job is done, which must be found. --full-disk: 200 jobs through SQLite, on a disk that is full for
// 1.5 s of each 3.5 s; as root, as the disk is mounted, where no other process sees it.

const EVERY_MS = 2000;
const OPTIONS = { planted: { type: 'boolean' }, 'full-disk': { type: 'boolean' }, mounts: { type: 'boolean' } };
const { values, positionals } = parseArgs({ options: OPTIONS, allowPositionals: true });
const [count = values['full-disk'] ? '200' : '2000', ...rest] = positionals;
if (!/^[1-9]\d{0,5}$/.test(count) || rest.length > 0) throw new Error('expected npm run chaos [-- JOBS [--planted | --full-disk]]');
const say = (line) => process.stdout.write(`${line}\n`);
const jobs = Number(count);

function tell(facts, lines) {
  const { seconds, done, lost, wrong, doubled, stuck, asked, again, slow, cut, longest } = facts;
  say(
    `${jobs} jobs in ${seconds.toFixed(0)} s: ${done} done, ${lost} lost, ${doubled} doubled, ${wrong} not whole, ${stuck} stuck; the longest took ${longest.toFixed(1)} s`,
  );
  for (const line of lines) say(line);
  say(`requests for jobs: ${asked}, ${again} of them again; ${slow} slow, ${cut} cut`);
  const faults = judgeChaos(facts);
  for (const fault of faults) say(`fault: ${fault}`);
  return faults;
}

async function ends() {
  const planted = values.planted ? new URL('plant_early_word.mjs', import.meta.url).href : undefined;
  const facts = await chaos({ jobs, kills: Math.max(5, Math.ceil(jobs / 10)), everyMs: EVERY_MS, planted, say });
  const kills = Object.entries(facts.kills).map(([what, times]) => `${what} ${times}`);
  const faults = tell(facts, [`ended: ${kills.join(', ')}`]);
  if (values.planted) say(faults.length > 0 ? 'the planted fault is found' : 'the planted fault is not found');
  return faults.length > 0 === Boolean(values.planted) ? 0 : 1;
}

async function full() {
  const facts = await fullDisk({ jobs, say });
  return tell(facts, [`the disk was full ${facts.fills} times; ${facts.starts} processes ended`]).length > 0 ? 1 : 0;
}

/** The same command where what it mounts is seen by nobody else, and goes with it. */
const inside = () => spawnSync('unshare', ['--mount', process.execPath, ...process.argv.slice(1), '--mounts'], { stdio: 'inherit' }).status;

process.exitCode = !values['full-disk'] ? await ends() : values.mounts ? await full() : (inside() ?? 1);
