import { writeFileSync } from 'node:fs';
import { mean } from '../../js/compare/statistics.mjs';
import { row } from '../../js/build/docs/tables.mjs';
import { PRESETS } from '../../js/shot/table/quality.mjs';
import { createRenderer } from '../../js/index.mjs';
import { ENVIRONMENTS, FABRIC_MODELS, LAYERED_FABRICS } from '../fixtures/index.mjs';
import { measureHeldOut } from './held_out.mjs';
import { errorsOf } from './measure.mjs';

// npm run accuracy [-- PATHS [CLOTH...]]: qualities of the raster against the path tracer on cloth, in a window of a thumbnail;
// writes js/docs/accuracy.md where all cloths are measured. CLOTH "held-out": those that nothing was tuned on, or of them those that are named after it, into the terminal; their table is in
// js/docs/fabric_accuracy.md.

const [paths = '2048', only = '', ...others] = process.argv.slice(2);
const SKIES = ['soft-studio', 'sunny-sky', 'overcast-sky'];
// By its name the tracer itself would draw `high` here: js/docs/reference.md.
const QUALITIES = { draft: 'draft', standard: 'standard', medium: 'medium', '64 samples': { samples: 64, environmentSamples: 256 }, high: PRESETS.high };
const names = Object.keys(QUALITIES);
const MOST = { flip: 0.02, deltaE: 2 };

// Threads are as wide as in a picture of 512 px; the window has a fold's edge against nothing, lit and shaded cloth.
const THUMBNAIL = 512;
const SIZE = 64;
const camera = { position: [0, -0.03, 0.95], target: [0.08, 0.03, 0.06], fovY: (30 * SIZE) / THUMBNAIL };

if (only === 'held-out') {
  process.exit(await measureHeldOut({ paths: Number(paths), skies: SKIES, size: SIZE, camera, cloths: others }));
}

/** Cloths of one surface: lace lies over a card. */
const cloths = LAYERED_FABRICS.filter((name) => name !== 'fabric-lace' && name.includes(only));

const renderer = await createRenderer({ cacheDirectory: null });
const rows = [];
for (const name of cloths) {
  const model = await FABRIC_MODELS[name]();
  for (const sky of SKIES) {
    const shot = { size: { width: SIZE, height: SIZE }, camera, environment: ENVIRONMENTS[sky](), shading: 'fabric' };
    const errors = await errorsOf(renderer, model, shot, Object.values(QUALITIES), Number(paths));
    rows.push({ name, sky, errors, high: errors[names.indexOf('high')] });
    process.stderr.write(`${name} ${sky} ${JSON.stringify(rows.at(-1).high)}\n`);
  }
}
await renderer.close();

const within = ({ high }) => high.flip <= MOST.flip && high.deltaE <= MOST.deltaE;
const meanOf = (index, key, digits) => mean(rows.map(({ errors }) => errors[index][key])).toFixed(digits);
const overall = names.map((name, i) => row([name, meanOf(i, 'flip', 4), meanOf(i, 'deltaE', 2), meanOf(i, 'cpuMs', 0)]));
const single = rows.map((each) =>
  row([
    each.name,
    each.sky,
    ...each.errors.flatMap(({ flip, deltaE }) => [flip.toFixed(4), deltaE.toFixed(2)]),
    each.high.cpuMs.toFixed(0),
    within(each) ? 'yes' : 'no',
  ]),
);
const text = `# The raster against the path tracer

Written by \`npm run accuracy -- ${paths}\`: ${rows.length} windows of ${SIZE} x ${SIZE} pixels out of pictures of ${THUMBNAIL} on Mesa llvmpipe, shading \`fabric\`,
the environment without occlusion. "64 samples" has environmentSamples ${QUALITIES['64 samples'].environmentSamples}. \`high\` is that of the raster.
The reference has ${paths} paths a pixel, whose own noise is part of every
figure. FLIP is the mean, CIEDE2000 the 95th percentile, both over the pixels of the cloth. Targets of \`high\`: FLIP ${MOST.flip} and CIEDE2000 ${MOST.deltaE}
or less; ${rows.filter(within).length} of ${rows.length} are there.

| quality | FLIP, mean of all | CIEDE2000, mean of all | CPU ms a window |
|---|---|---|---|
${overall.join('\n')}

| cloth | sky | ${names.map((name) => `${name} FLIP | CIEDE2000`).join(' | ')} | high CPU ms | within |
|---|---|${'---|---|'.repeat(names.length)}---|---|
${single.join('\n')}
`;
if (only) process.stdout.write(text);
else writeFileSync(new URL('../../js/docs/accuracy.md', import.meta.url), text);
process.exitCode = rows.every(within) ? 0 : 1;
