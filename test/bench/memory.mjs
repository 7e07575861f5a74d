// Resident memory of a process that draws ten models in turn, decoded anew each time, and how long its event loop waits.
// node test/bench/memory.mjs [COUNT [FOLDER]]      COUNT pictures (300); FOLDER: ten of its .glb and .gltf files in place of fixtures
import { readdirSync } from 'node:fs';
import path from 'node:path';
import { monitorEventLoopDelay } from 'node:perf_hooks';
import { createRenderer } from '../../js/index.mjs';
import { MODELS } from '../fixtures/index.mjs';

const [count = '300', folder] = process.argv.slice(2);
const FIXTURES = [
  'ball',
  'cloth',
  'normal-map',
  'metallic-roughness-map',
  'physical-everything',
  'texture-transform',
  'vertex-colors',
  'two-uv-sets',
  'unlit',
  'samplers',
];
const RESOLUTION_MS = 5;

const residentMebibytes = () => Math.round(process.memoryUsage.rss() / 2 ** 20);
const peakMebibytes = () => Math.round(process.resourceUsage().maxRSS / 2 ** 10);

const models = folder
  ? readdirSync(folder, { recursive: true })
      .filter((file) => /\.gl(b|tf)$/.test(file))
      .sort()
      .slice(0, 10)
      .map((file) => path.join(folder, file))
  : await Promise.all(FIXTURES.map((name) => MODELS[name]()));
const renderer = await createRenderer();
const delay = monitorEventLoopDelay({ resolution: RESOLUTION_MS });
delay.enable();
const every = Math.ceil(Number(count) / 10);
for (let i = 0; i < Number(count); ++i) {
  await renderer.render(models[i % models.length], { size: { width: 512, height: 512 }, shading: i % 4 === 3 ? 'fabric' : 'three' });
  if ((i + 1) % every === 0) process.stdout.write(`${i + 1} pictures: ${residentMebibytes()} MiB, at most ${peakMebibytes()} MiB\n`);
}
delay.disable();
await renderer.close();
const p99 = delay.percentile(99) / 1e6 - RESOLUTION_MS;
process.stdout.write(`after close(): ${residentMebibytes()} MiB; the event loop waited ${p99.toFixed(1)} ms at most in 99 of 100 looks\n`);
