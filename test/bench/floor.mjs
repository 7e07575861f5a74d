// How far a picture is from the least that it could cost: its images decoded by their libraries, and its pixels shaded once, as two triangles of
// the same material with the same number of pixels. What a picture takes above that is vertices, small and hidden triangles, mip levels, uploads.
// npm run bench -- floor      node test/bench/floor.mjs [MODEL...] [--runs N]
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { WebIO } from '@gltf-transform/core';
import { KHRONOS_EXTENSIONS } from '@gltf-transform/extensions';
import sharp from 'sharp';
import { createRenderer } from '../../js/index.mjs';
import { median } from '../median.mjs';
import { chair, helmet, shirt } from './peer_models.mjs';

const { values, positionals } = parseArgs({ options: { runs: { type: 'string', default: '7' } }, allowPositionals: true });
const TSHIRT = fileURLToPath(new URL('../../js/assets/tshirt.glb', import.meta.url));
const SHOT = { size: { width: 512, height: 512 } };
const io = new WebIO().registerExtensions(KHRONOS_EXTENSIONS);
const renderer = await createRenderer();

/** Stages of a picture, of `info.milliseconds`. */
const STAGES = ['load', 'upload', 'vertices', 'visibility', 'draw', 'read', 'encode'];

/** CPU milliseconds of a job, and of pictures the wall milliseconds of each stage: medians; once before that is not counted. */
async function costOf(job) {
  const times = [];
  const stages = Object.fromEntries(STAGES.map((name) => [name, []]));
  for (let i = 0; i <= Number(values.runs); i++) {
    const start = process.cpuUsage();
    const { info } = await job();
    const { user, system } = process.cpuUsage(start);
    if (i === 0) continue;
    times.push((user + system) / 1000);
    for (const name of STAGES) stages[name].push(info?.milliseconds[name] ?? 0);
  }
  return { cpu: median(times), stages: Object.fromEntries(STAGES.map((name) => [name, median(stages[name])])) };
}

/** Pixels that show something. */
async function covered(model) {
  const { data } = await renderer.render(model, { ...SHOT, output: { format: 'raw' } });
  return data.filter((value, i) => i % 4 === 3 && value > 0).length;
}

/** The material with the most triangles on a square of two, in place of all meshes. @returns {Promise<Uint8Array>} GLB */
async function asSquare(bytes) {
  const document = await io.readBinary(bytes);
  const root = document.getRoot();
  const weight = new Map();
  for (const mesh of root.listMeshes())
    for (const primitive of mesh.listPrimitives())
      weight.set(primitive.getMaterial(), (weight.get(primitive.getMaterial()) ?? 0) + (primitive.getIndices()?.getCount() ?? 0));
  const material = [...weight].sort(([, a], [, b]) => b - a)[0][0];
  const buffer = root.listBuffers()[0];
  const accessor = (type, array) => document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
  const uvs = accessor('VEC2', new Float32Array([0, 0, 0, 1, 1, 0, 1, 1]));
  const primitive = document
    .createPrimitive()
    .setAttribute('POSITION', accessor('VEC3', new Float32Array([-1, 1, 0, -1, -1, 0, 1, 1, 0, 1, -1, 0])))
    .setAttribute('NORMAL', accessor('VEC3', new Float32Array([0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1])))
    .setAttribute('TEXCOORD_0', uvs)
    .setAttribute('TEXCOORD_1', uvs)
    .setIndices(accessor('SCALAR', new Uint16Array([0, 1, 2, 2, 1, 3])))
    .setMaterial(material);
  for (const scene of root.listScenes()) {
    for (const child of scene.listChildren()) scene.removeChild(child);
    scene.addChild(document.createNode().setMesh(document.createMesh().addPrimitive(primitive)));
  }
  return io.writeBinary(document);
}

const imagesOf = async (bytes) =>
  (await io.readBinary(bytes))
    .getRoot()
    .listTextures()
    .map((texture) => Buffer.from(texture.getImage()));

const models = positionals.length
  ? positionals.map((file) => [file, new Uint8Array(readFileSync(file))])
  : [
      ['T-shirt', new Uint8Array(readFileSync(TSHIRT))],
      ['shirt', await shirt()],
      ['chair', await chair()],
      ['ball', await helmet()],
    ];
const row = (...cells) => console.log(`| ${cells.map((cell) => (typeof cell === 'number' ? cell.toFixed(cell < 10 ? 1 : 0) : cell)).join(' | ')} |`);
const stageRows = [];
row('model', 'a picture from its file, CPU ms', 'decoding', 'pixels as two triangles, PNG', 'above the floor');
row(...Array(5).fill('---'));
for (const [name, bytes] of models) {
  const square = await renderer.load(await asSquare(bytes));
  const share = (await covered(bytes)) / (await covered(square));
  const whole = await costOf(() => renderer.render(bytes, SHOT));
  const images = await imagesOf(bytes);
  const decoding = await costOf(() => Promise.all(images.map((image) => sharp(image).ensureAlpha().raw().toBuffer())));
  const pixels = await costOf(() => renderer.render(square, SHOT));
  renderer.release(square);
  row(name, whole.cpu, decoding.cpu, pixels.cpu * share, whole.cpu / (decoding.cpu + pixels.cpu * share));
  const least = { ...Object.fromEntries(STAGES.map((stage) => [stage, pixels.stages[stage] * share])), load: decoding.cpu };
  stageRows.push([name, ...STAGES.map((stage) => `${whole.stages[stage].toFixed(1)}, ${least[stage].toFixed(1)}`)]);
}
console.log('\nStage by stage: wall ms of the picture, and of the least (of loading: CPU ms of the libraries)\n');
row('model', ...STAGES);
row(...Array(STAGES.length + 1).fill('---'));
for (const cells of stageRows) row(...cells);
await renderer.close();
