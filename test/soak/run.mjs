// npm run soak [-- RENDERS [WORKERS]]: 30,000 renders through a pool of 2, a fifth of them of hostile files. Ends with 1 where something is not flat.
import { judgeSoak, soak } from './soak.mjs';

const [renders = '30000', size = '2'] = process.argv.slice(2);
const say = (line) => process.stdout.write(`${line}\n`);
const MIB = 2 ** 20;

const result = await soak({ renders: Number(renders), size: Number(size), say });
const { faults, slopes } = judgeSoak(result);
const { picture = 0, ...refused } = result.outcomes;
say(`${renders} renders in ${result.seconds.toFixed(0)} s: ${picture} pictures, ${Number(renders) - picture} errors of ${Object.keys(refused).length} codes`);
say(`growth in 1000 renders: ${slopes.map((slope) => `${(slope / MIB).toFixed(2)} MiB`).join(', ')} (parent, workers)`);
for (const fault of faults) say(`not flat: ${fault}`);
process.exitCode = faults.length > 0 ? 1 : 0;
