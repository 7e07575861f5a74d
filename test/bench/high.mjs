// Quality "high" by the path tracer and by the raster: CPU seconds of each, the one that draws it in bold, and FLIP of the one to the
// other. What renderer/frame/traced_instead.cpp goes by; the table of js/docs/reference.md.
// node test/bench/high.mjs      needs the release build
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { compareImages } from '../../js/compare/index.mjs';
import { createRenderer } from '../../js/index.mjs';
import { SETTINGS } from '../../js/predict/settings.mjs';

const asset = (name) => path.join(fileURLToPath(new URL('../../js/assets/', import.meta.url)), name);
const RASTER = SETTINGS['high by the raster'];
/** As tracedInstead() sets it, by whether the raster's passes are denoised: all of "high" are. */
const TRACER = { preset: 'reference', transport: 'direct', samples: RASTER.samples, noise: RASTER.noise / 2 };

/** Opaque models of few and of many triangles, nets that are cut out, and what blends. */
const MODELS = [
  { name: 'drape, leather', file: 'fabrics.glb', shot: { shading: 'fabric', variant: 'leather' }, sizes: [16, 32, 64, 160] },
  { name: 'T-shirt', file: 'tshirt.glb', shot: { shading: 'fabric' }, sizes: [16, 32, 64, 128] },
  { name: 'T-shirt', file: 'tshirt.glb', shot: { shading: 'three' }, sizes: [16, 64] },
  { name: 'denim', file: 'cloths/denim.glb', shot: { shading: 'fabric' }, sizes: [16, 64] },
  { name: 'lace', file: 'cloths/lace.glb', shot: { shading: 'fabric' }, sizes: [32, 64, 128] },
  { name: 'tulle', file: 'cloths/tulle.glb', shot: { shading: 'fabric' }, sizes: [32, 64] },
];

const renderer = await createRenderer({ cacheDirectory: null });

async function drawn(model, shot) {
  const before = process.cpuUsage();
  const { data, info } = await renderer.render(model, { ...shot, output: { format: 'raw' } });
  const { user, system } = process.cpuUsage(before);
  return { data, info, seconds: (user + system) / 1e6 };
}

/** The second of two: programs are compiled with the first. */
async function warm(model, shot) {
  await drawn(model, shot);
  return drawn(model, shot);
}

const seconds = (value, draws) => (draws ? `**${value.toPrecision(2)}**` : value.toPrecision(2));

console.log('| | shading | size, px | triangles | tracer | raster | FLIP |\n|---|---|---|---|---|---|---|');
for (const { name, file, shot, sizes } of MODELS) {
  const model = await renderer.load(asset(file));
  for (const side of sizes) {
    const size = { width: side, height: side };
    const tracer = await warm(model, { ...shot, size, quality: TRACER });
    const raster = await warm(model, { ...shot, size, quality: RASTER });
    const { info } = await drawn(model, { ...shot, size, quality: 'high' });
    const isTraced = info.backend === tracer.info.backend;
    const { flip } = compareImages({ ...size, data: tracer.data }, { ...size, data: raster.data }).object;
    const triangles = raster.info.triangles.toLocaleString('en');
    const cells = [seconds(tracer.seconds, isTraced), seconds(raster.seconds, !isTraced), flip.mean.toFixed(3)];
    console.log(`| ${[name, shot.shading, side, triangles, ...cells].join(' | ')} |`);
  }
  await renderer.release(model);
}
await renderer.close();
