// A picture as an older release of three.js draws it against the same as today's: CPU time of telar alone, drawn again, and of a picture
// in an environment that it sees for the first time, programs kept. In turns, medians. Also which programs today's pictures have paid for.
// npm run bench -- families      node test/bench/families.mjs [RUNS]
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { createRenderer } from '../../js/index.mjs';
import { families } from '../../js/shot/three_terms.mjs';
import { hdr } from '../fixtures/environment.mjs';
import { MODELS } from '../fixtures/index.mjs';
import { median } from '../median.mjs';

const RUNS = Number(process.argv[2] ?? 9);
const ASSETS = fileURLToPath(new URL('../../js/assets/', import.meta.url));
const SHOT = { size: { width: 512, height: 512 }, output: { format: 'raw' }, toneMapping: 'aces' };
const REVISIONS = families()
  .map(({ to }) => to)
  .filter((revision) => revision === 160 || revision === 166 || revision >= 180)
  .slice(0, -1);

const cpuMs = () => Object.values(process.cpuUsage()).reduce((sum, us) => sum + us, 0) / 1000;

/** An environment that no picture has had: 512 x 256 texels of its own brightness. */
const freshEnvironment = (turn) => hdr(512, ([x, y, z]) => [1 + 0.4 * y + turn * 1e-3, 0.6 + 0.2 * y + 0.1 * z, 0.6 + 0.15 * x]);

// No environment of a run before is found again.
const renderer = await createRenderer({ cacheDirectory: null });
const models = {
  'T-shirt': await renderer.load(path.join(ASSETS, 'tshirt.glb')),
  everything: await renderer.load(await MODELS['physical-everything']()),
};
let turn = 0;

async function cpuOf(model, shading, environment) {
  const start = cpuMs();
  await renderer.render(model, { ...SHOT, shading, ...(environment && { environment }) });
  return cpuMs() - start;
}

for (const [name, model] of Object.entries(models)) {
  for (const revision of REVISIONS) {
    const shading = { base: 'three', revision };
    const ratios = { again: [], 'new environment': [] };
    for (let run = -1; run < RUNS; ++run) {
      const times = {};
      for (const side of run % 2 === 0 ? ['three', shading] : [shading, 'three']) {
        const key = side === 'three' ? 'today' : 'older';
        const fresh = await cpuOf(model, side, freshEnvironment(++turn));
        await cpuOf(model, side);
        times[key] = { again: await cpuOf(model, side), 'new environment': fresh };
      }
      // The first turn compiles programs.
      if (run >= 0) for (const key of Object.keys(ratios)) ratios[key].push(times.older[key] / times.today[key]);
    }
    const told = Object.entries(ratios).map(([key, list]) => `${key} ${median(list).toFixed(2)}`);
    console.log(`${name.padEnd(12)} three@${revision} against three: ${told.join(', ')}`);
  }
}
await renderer.close();
