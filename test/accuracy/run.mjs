import { writeFileSync } from 'node:fs';
import { createRenderer } from '../../js/index.mjs';
import { ENVIRONMENTS, FABRIC_MODELS } from '../fixtures/index.mjs';
import { errorsOf } from './measure.mjs';

// npm run accuracy [-- SIZE PATHS]: qualities of the raster against the path tracer on cloth; writes js/docs/accuracy.md.

const [size = 96, paths = 256] = process.argv.slice(2).map(Number);
const SKIES = ['soft-studio', 'sunny-sky', 'overcast-sky'];
const SHADINGS = ['fabric'];
const QUALITIES = ['draft', 'standard', 'high', { samples: 64, environmentSamples: 1024 }];
const nameOf = (quality) => (typeof quality === 'string' ? quality : '64 samples');
const HIGH = QUALITIES.indexOf('high');
const MOST = { flip: 0.02, deltaE: 2 };

/** Cloths of one surface: lace lies over a card. */
const cloths = Object.keys(FABRIC_MODELS).filter((name) => name !== 'fabric-lace').slice(0, 12);

const renderer = await createRenderer({ cacheDirectory: null });
const rows = [];
for (const name of cloths) {
  const model = await FABRIC_MODELS[name]();
  for (const sky of SKIES) {
    for (const shading of SHADINGS) {
      const shot = { size: { width: size, height: size }, environment: ENVIRONMENTS[sky](), shading };
      const errors = await errorsOf(renderer, model, shot, QUALITIES, paths);
      rows.push({ name, sky, shading, errors });
      process.stderr.write(`${name} ${sky} ${shading} ${JSON.stringify(errors.at(-1))}\n`);
    }
  }
}
await renderer.close();

const within = ({ errors }) => errors[HIGH].flip <= MOST.flip && errors[HIGH].deltaE <= MOST.deltaE;
const cells = ({ flip, deltaE }) => `${flip.toFixed(4)} | ${deltaE.toFixed(2)}`;
const mean = (list) => list.reduce((sum, x) => sum + x, 0) / list.length;
const text = `# The raster against the path tracer

Written by \`npm run accuracy -- ${size} ${paths}\`: ${rows.length} pictures of ${size} x ${size} pixels on Mesa llvmpipe, the same shading, environment without
occlusion, "64 samples" with environmentSamples 1024; the reference has ${paths} paths a pixel, whose noise is part of every figure. FLIP is the mean, CIEDE2000 the 95th percentile,
both over the pixels of the cloth. Wanted of \`high\`: FLIP ${MOST.flip} and CIEDE2000 ${MOST.deltaE} or less; ${rows.filter(within).length} of ${rows.length} are there.

| quality | FLIP, mean of all | CIEDE2000, mean of all | CPU ms a picture |
|---|---|---|---|
${QUALITIES.map((quality, i) => `| ${nameOf(quality)} | ${mean(rows.map(({ errors }) => errors[i].flip)).toFixed(4)} | ${
  mean(rows.map(({ errors }) => errors[i].deltaE)).toFixed(2)} | ${mean(rows.map(({ errors }) => errors[i].cpuMs)).toFixed(0)} |`).join('\n')}

| cloth | sky | shading | ${QUALITIES.map((quality) => `${nameOf(quality)} FLIP | CIEDE2000`).join(' | ')} | within |
|---|---|---|${'---|---|'.repeat(QUALITIES.length)}---|
${rows.map((row) => `| ${row.name} | ${row.sky} | ${row.shading} | ${row.errors.map(cells).join(' | ')} | ${within(row) ? 'yes' : 'no'} |`).join('\n')}
`;
writeFileSync(new URL('../../js/docs/accuracy.md', import.meta.url), text);
process.exitCode = rows.every(within) ? 0 : 1;
