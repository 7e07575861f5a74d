// What each preset of cloth takes: GPU bytes of its maps; the CPU time until they are there to draw, once a renderer, in shading "fabric" against "three" and against
// the same maps without a preset; and the CPU time until the bundled T-shirt that wears it is there to draw, once the renderer has the maps.
// Medians of rounds that take turns.
// node test/bench/cloths.mjs [PRESET]      needs the dev build (npm test makes it)
import { readFileSync } from 'node:fs';
import { createRenderer, inspect } from '../../js/index.mjs';
import { PRESETS } from '../../js/assets/make/cloths/index.mjs';
import { median } from '../median.mjs';

const only = process.argv[2] ?? '';
const ROUNDS = 21;
const MOST_BYTES = 4 * 2 ** 20;
const SIZE = { width: 64, height: 64 };
const asset = (name) => new URL(`../../js/assets/${name}`, import.meta.url);

const BYTES_A_TEXEL = { map: 4, relief: 8, yarns: 0.5, coverage: 4 }; // RGBA8 or SRGB8_ALPHA8; RGBA16F, of facets too; the same of a sixteenth of the texels; as the map
const MIP_LEVELS = 4 / 3;

/** @returns {{json: object, binary: Buffer}} of a GLB */
function chunksOf(glb) {
  const length = glb.readUInt32LE(12);
  return { json: JSON.parse(glb.subarray(20, 20 + length)), binary: glb.subarray(20 + length + 8) };
}

/** A GLB of other JSON. */
function glbOf({ json, binary }) {
  const text = Buffer.from(JSON.stringify(json));
  const padded = Buffer.concat([text, Buffer.alloc((4 - (text.length % 4)) % 4, ' ')]);
  const header = Buffer.alloc(20);
  header.write('glTF', 0, 'latin1');
  [2, 20 + padded.length + 8 + binary.length, padded.length].forEach((value, i) => header.writeUInt32LE(value, 4 + 4 * i));
  header.write('JSON', 16, 'latin1');
  const bin = Buffer.alloc(8);
  bin.writeUInt32LE(binary.length, 0);
  bin.write('BIN\0', 4, 'latin1');
  return Buffer.concat([header, padded, bin, binary]);
}

/** The same maps on a material of plain glTF. */
function withoutPreset(glb) {
  const { json, binary } = chunksOf(glb);
  const drop = (key) => key.startsWith('KHR_materials_') || key === 'TELAR_materials_fabric';
  for (const material of json.materials) material.extensions = Object.fromEntries(Object.entries(material.extensions ?? {}).filter(([key]) => !drop(key)));
  for (const list of ['extensionsUsed', 'extensionsRequired']) if (json[list]) json[list] = json[list].filter((key) => !drop(key));
  return glbOf({ json, binary });
}

/** GPU bytes: every map, what "fabric" makes of the normals, and of colours that are cut out. */
function bytesOf({ json, images }) {
  const [material] = json.materials;
  const texels = (info) => {
    const { width, height } = images[json.textures[info.index].source];
    return width * height;
  };
  const maps = images.reduce((sum, { width, height }) => sum + width * height * BYTES_A_TEXEL.map, 0);
  const relief = material.normalTexture ? texels(material.normalTexture) * BYTES_A_TEXEL.relief : 0;
  const weave = material.extensions?.TELAR_materials_fabric?.weave?.weaveTexture;
  const yarns = weave && material.normalTexture ? texels(material.normalTexture) * BYTES_A_TEXEL.yarns : 0;
  const holed = material.alphaMode !== undefined && material.alphaMode !== 'OPAQUE' && material.pbrMetallicRoughness?.baseColorTexture;
  return { maps: maps * MIP_LEVELS, made: (relief + yarns + (holed ? texels(holed) * BYTES_A_TEXEL.coverage : 0)) * MIP_LEVELS };
}

const renderer = await createRenderer({ cacheDirectory: null, timeoutMs: null });

async function cpuMs(work) {
  const before = process.cpuUsage();
  const result = await work();
  const { user, system } = process.cpuUsage(before);
  return { result, ms: (user + system) / 1000 };
}

/** Loading with a first frame, and a second frame. */
async function timesTo(source, shot) {
  const { result: model, ms: first } = await cpuMs(async () => {
    const loaded = await renderer.load(source);
    await renderer.render(loaded, shot);
    return loaded;
  });
  const { ms: again } = await cpuMs(() => renderer.render(model, shot));
  model.close?.();
  return { first, again };
}

const raw = { size: SIZE, output: { format: 'raw' } };
const shirt = readFileSync(asset('tshirt.glb'));
const mebibytes = (bytes) => (bytes / 2 ** 20).toFixed(2);

/**
 * What loading and a first frame take above a second frame: what is uploaded and made. Of several ways, in turns.
 * @param {[Uint8Array, object][]} cases - Model and shot.
 */
async function timesOf(cases) {
  const times = cases.map(() => []);
  for (let round = -1; round < ROUNDS; ++round) {
    for (const [i, [source, shot]] of cases.entries()) {
      const each = await timesTo(source, shot);
      if (round >= 0) times[i].push(each); // programs are compiled in the round before the first
    }
  }
  return times.map((rounds) => median(rounds.map(({ first }) => first)) - median(rounds.map(({ again }) => again)));
}

const inThree = { ...raw, shading: 'three' };
const inFabric = { ...raw, shading: 'fabric' };
const [shirtInThree, shirtInFabric] = await timesOf([
  [shirt, inThree],
  [shirt, inFabric],
]);
console.log(
  '| preset | maps, MiB | made of them, MiB | once: three, ms | fabric without preset | fabric | T-shirt: three, ms | fabric | added |\n|---|---|---|---|---|---|---|---|---|',
);
let worst = 0;
for (const name of Object.keys(PRESETS).filter((each) => each.includes(only))) {
  const square = readFileSync(asset(`cloths/${name}.glb`));
  const { images } = await inspect(square);
  const { maps, made } = bytesOf({ ...chunksOf(square), images });
  worst = Math.max(worst, maps + made);
  const once = await timesOf([
    [square, inThree],
    [withoutPreset(square), inFabric],
    [square, inFabric],
  ]);
  const materials = { '*': { preset: name } };
  const worn = await timesOf([
    [shirt, { ...inThree, materials }],
    [shirt, { ...inFabric, materials }],
  ]);
  const added = `${(100 * (worn[1] / worn[0] - 1)).toFixed(0)} %`;
  console.log(`| ${[name, mebibytes(maps), mebibytes(made), ...[...once, ...worn].map((ms) => ms.toFixed(1)), added].join(' | ')} |`);
}
await renderer.close();
console.log(`\nthe T-shirt in its own cloth: three ${shirtInThree.toFixed(0)} ms, fabric ${shirtInFabric.toFixed(0)} ms`);
console.log(`most GPU bytes of a cloth: ${mebibytes(worst)} MiB of ${mebibytes(MOST_BYTES)}`);
process.exitCode = worst <= MOST_BYTES ? 0 : 1;
