// How CPU time and memory of a picture grow with its pixels, triangles, texels, textures and lights, one at a time; each point in a process of
// its own. A straight line through the points says what is fixed and what each one more costs; R2 how straight it is.
// npm run bench -- scale      node test/bench/scale.mjs [AXIS...] [--runs N] [--json FILE]   --json: what was measured, for npm run scale
import { spawnSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { createRenderer } from '../../js/index.mjs';
import { plane } from '../fixtures/geometry.mjs';
import { GlbBuilder } from '../fixtures/glb.mjs';
import { median } from '../median.mjs';
import { photograph } from './peer_models.mjs';

const SELF = fileURLToPath(import.meta.url);
const TSHIRT = fileURLToPath(new URL('../../js/assets/tshirt.glb', import.meta.url));

/** A square that fills the frame. @param {object} [textures] */
async function sheet(textures) {
  const glb = new GlbBuilder();
  glb.add(plane(1, 1), glb.material({ roughness: 0.8, textures }), { name: 'sheet' });
  return glb.bytes();
}

/** The same by hand: what builds the fixtures takes no million vertices. */
function fineSheet(cells) {
  const side = cells + 1;
  const [positions, normals, indices] = [new Float32Array(side * side * 3), new Float32Array(side * side * 3), new Uint32Array(cells * cells * 6)];
  for (let i = 0; i < side * side; i++) {
    positions.set([(i % side) / cells - 0.5, 0.5 - Math.floor(i / side) / cells, 0], 3 * i);
    normals[3 * i + 2] = 1;
  }
  for (let i = 0; i < cells * cells; i++) {
    const a = Math.floor(i / cells) * side + (i % cells);
    indices.set([a, a + side, a + 1, a + 1, a + side, a + side + 1], 6 * i);
  }
  const parts = [positions, normals, indices];
  const bufferViews = parts.map(({ byteLength }, i) => ({
    buffer: 0,
    byteOffset: parts.slice(0, i).reduce((sum, part) => sum + part.byteLength, 0),
    byteLength,
  }));
  const vertices = { componentType: 5126, count: side * side, type: 'VEC3' };
  const json = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, NORMAL: 1 }, indices: 2, material: 0 }] }],
    materials: [{ pbrMetallicRoughness: { metallicFactor: 0, roughnessFactor: 0.8 } }],
    accessors: [
      { ...vertices, bufferView: 0, min: [-0.5, -0.5, 0], max: [0.5, 0.5, 0] },
      { ...vertices, bufferView: 1 },
      { bufferView: 2, componentType: 5125, count: indices.length, type: 'SCALAR' },
    ],
    bufferViews,
    buffers: [{ byteLength: parts.reduce((sum, part) => sum + part.byteLength, 0) }],
  };
  const text = Buffer.from(JSON.stringify(json));
  const padded = Buffer.concat([text, Buffer.alloc(-text.length & 3, ' ')]);
  const binary = Buffer.concat(parts.map((part) => Buffer.from(part.buffer)));
  const words = (...list) => Buffer.from(Uint32Array.from(list).buffer);
  const chunks = [words(padded.length, 0x4e4f534a), padded, words(binary.length, 0x004e4942), binary];
  return Buffer.concat([words(0x46546c67, 2, 28 + padded.length + binary.length), ...chunks]);
}

/** `count` sheets in a square, each with a texture of its own. */
async function patchwork(count) {
  const glb = new GlbBuilder();
  const side = Math.ceil(Math.sqrt(count));
  for (let i = 0; i < count; i++) {
    const material = glb.material({ roughness: 0.8, textures: { baseColor: { image: await photograph(512, i + 1) } } });
    glb.add(plane(1 / side, 1 / side), material, { name: `patch ${i}`, translation: [(i % side) / side, Math.floor(i / side) / side, 0] });
  }
  return glb.bytes();
}

const lamps = (count) => Array.from({ length: count }, (_, i) => ({ type: 'point', intensity: 1 / count, position: [Math.cos(i), Math.sin(i), 1 + (i % 3)] }));

/** What grows: `values`, in `unit`; `of(value)`: the model and the shot. */
const AXES = {
  pixels: {
    unit: 'megapixel of the T-shirt',
    values: [256, 512, 1024, 2048, 4096],
    count: (side) => side ** 2 / 1e6,
    of: (side) => ({ model: TSHIRT, shot: { size: { width: side, height: side } } }),
  },
  triangles: {
    unit: 'million triangles smaller than a pixel',
    values: [200, 500, 900, 1250, 1582],
    count: (cells) => (2 * cells ** 2) / 1e6,
    of: (cells) => ({ model: fineSheet(cells), shot: { size: { width: 128, height: 128 } } }),
  },
  texels: {
    unit: 'megatexel of one JPEG',
    values: [512, 1024, 2048, 4096, 8192],
    count: (side) => side ** 2 / 1e6,
    of: async (side) => ({ model: await sheet({ baseColor: { image: await photograph(side, 5) } }), shot: {} }),
  },
  textures: {
    unit: 'JPEG of 512 x 512, on a mesh of its own',
    values: [1, 8, 16, 32, 64],
    count: (count) => count,
    of: async (count) => ({ model: await patchwork(count), shot: {} }),
  },
  lights: {
    unit: 'point light on a sheet that fills the frame',
    values: [1, 8, 16, 32, 64],
    count: (count) => count,
    of: async (count) => ({ model: await sheet(), shot: { lights: lamps(count) } }),
  },
};

/** One point: {cpu: milliseconds from file to PNG, the median, mib: the largest resident size less that of the model's bytes before}. */
async function point(axis, value, runs) {
  const { model, shot } = await AXES[axis].of(value);
  const bytes = model === TSHIRT ? new Uint8Array(readFileSync(TSHIRT)) : model;
  globalThis.gc();
  const before = process.memoryUsage.rss();
  const renderer = await createRenderer({ limits: { L_FILE_BYTES: 2 ** 30, L_MEMORY_BYTES: 2 ** 33 } });
  const times = [];
  let peak = 0;
  const watch = setInterval(() => {
    peak = Math.max(peak, process.memoryUsage.rss());
  }, 5);
  for (let i = 0; i <= runs; i++) {
    const start = process.cpuUsage();
    await renderer.render(bytes, shot);
    const { user, system } = process.cpuUsage(start);
    // The first one compiles.
    if (i > 0) times.push((user + system) / 1000);
  }
  clearInterval(watch);
  await renderer.close();
  return { cpu: median(times), mib: (peak - before) / 2 ** 20 };
}

/** Least squares: y = fixed + each * x. */
function line(points) {
  const mean = (list) => list.reduce((sum, value) => sum + value, 0) / list.length;
  const [x0, y0] = [mean(points.map(([x]) => x)), mean(points.map(([, y]) => y))];
  const each = mean(points.map(([x, y]) => (x - x0) * (y - y0))) / mean(points.map(([x]) => (x - x0) ** 2));
  const fixed = y0 - each * x0;
  const r2 = 1 - mean(points.map(([x, y]) => (y - fixed - each * x) ** 2)) / mean(points.map(([, y]) => (y - y0) ** 2));
  return { fixed, each, r2 };
}

const OPTIONS = { runs: { type: 'string', default: '3' }, point: { type: 'string' }, json: { type: 'string' } };
const { values, positionals } = parseArgs({ options: OPTIONS, allowPositionals: true });
if (values.point) {
  const [axis, value] = values.point.split('=');
  console.log(JSON.stringify(await point(axis, Number(value), Number(values.runs))));
} else {
  const told = [];
  console.log('| one more | CPU ms | MiB | R2 of time, of memory | fixed CPU ms, MiB | points: CPU ms |\n|---|---|---|---|---|---|');
  for (const axis of positionals.length ? positionals : Object.keys(AXES)) {
    const points = AXES[axis].values.map((value) => {
      const { stdout, stderr, status } = spawnSync(process.execPath, ['--expose-gc', SELF, '--point', `${axis}=${value}`, '--runs', values.runs], {
        encoding: 'utf8',
      });
      if (status !== 0) throw new Error(`${axis} ${value}: ${stderr}`);
      return { count: AXES[axis].count(value), ...JSON.parse(stdout) };
    });
    const [cpu, mib] = ['cpu', 'mib'].map((key) => line(points.map((each) => [each.count, each[key]])));
    told.push({ axis, unit: AXES[axis].unit, cpu, mib, points });
    const cells = [
      AXES[axis].unit,
      cpu.each.toFixed(2),
      mib.each.toFixed(2),
      `${cpu.r2.toFixed(4)}, ${mib.r2.toFixed(4)}`,
      `${cpu.fixed.toFixed(0)}, ${mib.fixed.toFixed(0)}`,
      points.map(({ count, cpu: ms }) => `${Number(count.toPrecision(3))}: ${ms.toFixed(0)}`).join(', '),
    ];
    console.log(`| ${cells.join(' | ')} |`);
  }
  if (values.json) writeFileSync(values.json, JSON.stringify(told));
}
