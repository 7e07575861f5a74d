// node test/families/prefilter.mjs REVISION[,REVISION...] [ENVIRONMENT...] [--swap SLOT=TERM]
// Compares the atlas that a release of three.js before 0.187 prefilters an environment to with telar's, level by level.
import { parseArgs } from 'node:util';
import { loadInputs } from '../parity/inputs.mjs';
import { atlasOfTelar, distances, openRelease } from './atlas.mjs';
import { parseSwaps } from './gate.mjs';

const { values, positionals } = parseArgs({ allowPositionals: true, options: { swap: { type: 'string', multiple: true } } });
const [revisions, ...named] = positionals;
const environments = named.length > 0 ? named : ['studio', 'lamps', 'gradient', 'one'];
for (const revision of revisions.split(',').map(Number)) {
  const release = await openRelease(revision);
  try {
    for (const name of environments) {
      const { environment } = await loadInputs({ name: 'atlas', model: 'ball', environment: name });
      const rows = distances(await release.atlas(environment), await atlasOfTelar(environment, revision, parseSwaps(values.swap)));
      for (const { level, equal, relative, shown } of rows) {
        const figures = `${(100 * equal).toFixed(2)} % equal, relative ${relative.toExponential(2)}, shown ${shown.toFixed(3)}`;
        console.log(`${revision} ${name} level ${level}: ${figures}`);
      }
    }
  } finally {
    await release.browser.close();
  }
}
