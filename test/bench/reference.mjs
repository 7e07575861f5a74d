// The path tracer: paths a second on cloths, then on the T-shirt, 512 x 512 at 64 paths a pixel: milliseconds, rays and paths a second, and as a ratio to the
// raster's standard frame, and how noisy a sample is.
// node test/bench/reference.mjs [SAMPLES]      needs the release build
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { createRenderer } from '../../js/index.mjs';
import { median } from '../median.mjs';

const SIZE = 512;
const samples = Number(process.argv[2] ?? 64);
const asset = (name) => path.join(fileURLToPath(new URL('../../js/assets/', import.meta.url)), name);
const raw = { size: { width: SIZE, height: SIZE }, toneMapping: 'none', output: { format: 'raw', bitDepth: 32 } };

const renderer = await createRenderer({ cacheDirectory: null });
const model = await renderer.load(asset('tshirt.glb'));

/** Cloths with few and many layers, shells and large textures. */
const CLOTHS = [
  ['T-shirt', 'tshirt.glb', 'fabric'],
  ['T-shirt', 'tshirt.glb', 'three'],
  ['drape of leather', 'fabrics.glb', 'fabric'],
  ['towel', 'cloths/towel.glb', 'fabric'],
  ['denim', 'cloths/denim.glb', 'fabric'],
];
const SIDE = 128;
const ROUNDS = 3;

/** Million paths a second of CPU: what more paths take, so that reading the environment and building the hierarchy do not count. */
async function pathsPerSecond(cloth, shading) {
  const size = { width: SIDE, height: SIDE };
  const cpuMs = async (count) => {
    const before = process.cpuUsage();
    await renderer.render(cloth, { ...raw, size, shading, quality: { preset: 'reference', samples: count, threads: 1 } });
    const { user, system } = process.cpuUsage(before);
    return (user + system) / 1000;
  };
  await cpuMs(1);
  const rounds = [];
  for (let i = 0; i < ROUNDS; ++i) rounds.push((await cpuMs(samples)) - (await cpuMs(1)));
  return (SIDE * SIDE * (samples - 1)) / median(rounds) / 1000;
}

for (const [name, file, shading] of CLOTHS) {
  const cloth = await renderer.load(asset(file));
  const rate = await pathsPerSecond(cloth, shading);
  console.log(`${`${name}, shading ${shading}`.padEnd(33)} ${rate.toFixed(3)} million paths a second of CPU`);
}

async function timed(quality) {
  const before = process.cpuUsage();
  const { data, info } = await renderer.render(model, { ...raw, quality });
  const { user, system } = process.cpuUsage(before);
  const pixels = new Float32Array(data.buffer.slice(data.byteOffset, data.byteOffset + data.byteLength));
  return { pixels, info, cpuMs: (user + system) / 1000, ms: info.milliseconds.draw };
}

const FEW = 16;

/** Standard deviation of one sample's light, relative to the picture's mean where that is opaque; from two frames of FEW samples. */
function noiseOf(a, b) {
  let [squares, sum, count] = [0, 0, 0];
  for (let i = 1; i < a.length; i += 4) {
    if (a[i + 2] < 1 || b[i + 2] < 1) continue;
    squares += (a[i] - b[i]) ** 2;
    sum += a[i] + b[i];
    count += 1;
  }
  return (Math.sqrt((squares / count / 2) * FEW) * 2 * count) / sum;
}

await timed('standard');
const raster = await timed('standard');
console.log(`raster, standard     ${raster.cpuMs.toFixed(0).padStart(7)} ms of CPU`);
for (const transport of ['direct', 'occlusion', 'global']) {
  const drawn = await timed({ preset: 'reference', samples, transport });
  const [one, other] = [
    await timed({ preset: 'reference', samples: FEW, transport, seed: 2 }),
    await timed({ preset: 'reference', samples: FEW, transport, seed: 3 }),
  ];
  const { rays, threads } = drawn.info;
  console.log(
    `${transport.padEnd(20)} ${drawn.cpuMs.toFixed(0).padStart(7)} ms of CPU, ${drawn.ms.toFixed(0)} ms on ${threads} threads, ` +
      `${(rays / drawn.cpuMs / 1000).toFixed(2)} million rays and ${((SIZE * SIZE * samples) / drawn.cpuMs / 1000).toFixed(2)} million pixel samples a second of CPU, ` +
      `ratio to the raster ${(drawn.cpuMs / raster.cpuMs).toFixed(0)}, noise of a sample ${noiseOf(one.pixels, other.pixels).toFixed(2)} of the mean`,
  );
}
await renderer.close();
