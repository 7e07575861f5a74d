// npm run faults [-- POINTS]: lets 500 single allocations of a worker fail, one in each job, from the first to the last that a job makes. Ends with 1 where
// a picture is wrong, an error has no type, or the next job fails.
import { buildLibrary, failAllocations } from './support.mjs';

const [points = '500'] = process.argv.slice(2);
const say = (line) => process.stdout.write(`${line}\n`);

const built = buildLibrary();
/** More than a job makes. */
const MOST = 2 ** 24;
let most = 1;
while (most < MOST && (await failAllocations(built, [most]))[0].isHit) most *= 2;
say(`a job of the worker makes fewer than ${most} allocations`);
const step = Math.max(1, Math.floor(most / Number(points)));
const results = await failAllocations(
  built,
  Array.from({ length: Math.min(Number(points), most) }, (_, i) => 1 + i * step),
);
const counts = {};
for (const { outcome } of results) counts[outcome] = (counts[outcome] ?? 0) + 1;
const outcomes = Object.entries(counts).map(([outcome, count]) => `${count} ${outcome}`);
say(`${results.filter(({ isHit }) => isHit).length} failed allocations: ${outcomes.join(', ')}`);
const wrong = results.filter(({ faults }) => faults.length > 0);
for (const { n, faults } of wrong) say(`allocation ${n}: ${faults.join('; ')}`);
process.exitCode = wrong.length > 0 ? 1 : 0;
