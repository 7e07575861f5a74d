// Hostile textures (KTX2, Basis Universal, zstd) and hostile compressed meshes (meshopt), one fault each.
import { etc1sKtx2 } from '../fixtures/etc1s.mjs';
import { blockKtx2 } from '../fixtures/gpu_blocks.mjs';
import { SUPERCOMPRESSION, ktx2File, rawKtx2 } from '../fixtures/ktx2.mjs';
import { rawFormatKtx2 } from '../fixtures/raw_formats.mjs';
import { compressViews } from '../fixtures/meshopt.mjs';
import { uastcBlocks, uastcKtx2 } from '../fixtures/uastc.mjs';
import { zstdBomb, zstdStored } from '../fixtures/zstd_frame.mjs';
import { addView, glb, png, quad } from './glb.mjs';

/** Soft colours, the same at each run. */
export function picture(width = 32, height = 16) {
  const pixels = new Uint8Array(width * height * 4);
  for (let i = 0; i < width * height; ++i) pixels.set([(i * 7) % 256, 255 - ((i >> 3) % 256), 128 + ((i * i) % 97), 255 - (i % 64)], i * 4);
  return { width, height, pixels };
}

/** The quad whose texture is a KTX2 image; `fallback`: with a PNG for readers that cannot have it. */
export function ktx2Quad(image, { fallback = false, required = true } = {}) {
  const model = quad({ image });
  model.doc.images[0].mimeType = 'image/ktx2';
  model.doc.textures[0] = { extensions: { KHR_texture_basisu: { source: 0 } } };
  if (fallback) {
    model.doc.images.push({ bufferView: addView(model, png()), mimeType: 'image/png' });
    model.doc.textures[0].source = 1;
  }
  model.doc.extensionsUsed = ['KHR_texture_basisu'];
  if (required) model.doc.extensionsRequired = ['KHR_texture_basisu'];
  return glb(model);
}

function basisuSource(source) {
  const model = quad();
  model.doc.textures[0].extensions = { KHR_texture_basisu: { source } };
  return glb(model);
}

function patched(file, offset, value, bytes = 4) {
  const out = Buffer.from(file);
  if (bytes === 8) out.writeBigUInt64LE(BigInt(value), offset);
  else out.writeUIntLE(value, offset, bytes);
  return out;
}

/** Offsets in a KTX2 file. */
const AT = { width: 20, height: 24, depth: 28, layers: 32, faces: 36, levels: 40, scheme: 44, dfd: 48, sgd: 64, level: 80 };
const globalOf = (file) => Number(file.readBigUInt64LE(AT.sgd));

const CORRUPT = 'E_IMAGE_CORRUPT';
const REFUSED = 'E_IMAGE_FORMAT';

function ktx2Faults() {
  const uastc = uastcKtx2(picture());
  const etc1s = etc1sKtx2(picture(), { alpha: true });
  const global = globalOf(etc1s);
  const zstd = (level, size) => ktx2File({ width: 8, height: 4, levels: [level], sizes: [size], supercompression: SUPERCOMPRESSION.zstd });
  const blocks = uastcBlocks(picture(8, 4));
  const noise = Buffer.from(Array.from({ length: 400 }, (_, i) => (i * 167 + 13) % 256));
  return [
    ['header-cut', uastc.subarray(0, 50), CORRUPT],
    ['level-index-cut', uastc.subarray(0, 100), CORRUPT],
    ['last-byte-cut', uastc.subarray(0, uastc.length - 1), CORRUPT],
    ['huge-4g', patched(patched(uastc, AT.width, 0xffffffff), AT.height, 0xffffffff), 'L_IMAGE_DIMENSION'],
    ['huge-area', ktx2File({ width: 8192, height: 8192, levels: [Buffer.alloc(16)], sizes: [16] }), CORRUPT],
    ['levels-2p31', patched(uastc, AT.levels, 0x80000000), CORRUPT],
    ['volume', patched(uastc, AT.depth, 4), REFUSED],
    ['array', patched(uastc, AT.layers, 100), REFUSED],
    ['cube', patched(uastc, AT.faces, 6), REFUSED],
    ['faces-7', patched(uastc, AT.faces, 7), CORRUPT],
    ['zlib', patched(uastc, AT.scheme, 3), REFUSED],
    ['bc2', ktx2File({ width: 4, height: 4, levels: [Buffer.alloc(16)], vkFormat: 135, model: 129 }), REFUSED],
    ['rgb8', ktx2File({ width: 4, height: 4, levels: [Buffer.alloc(48)], vkFormat: 23, model: 1 }), REFUSED],
    ['bc7-cut', ktx2File({ width: 8, height: 8, levels: [Buffer.alloc(63)], vkFormat: 145, model: 134 }), CORRUPT],
    ['bc7-huge', ktx2File({ width: 8192, height: 8192, levels: [Buffer.alloc(16)], sizes: [16], vkFormat: 145, model: 134 }), CORRUPT],
    ['bc1-odd', ktx2File({ width: 6, height: 4, levels: [Buffer.alloc(16)], vkFormat: 131, model: 128 }), REFUSED],
    ['floats-huge', ktx2File({ width: 8192, height: 8192, levels: [Buffer.alloc(16)], sizes: [16], vkFormat: 109, model: 1 }), CORRUPT],
    ['floats-of-nan', ktx2File({ width: 1, height: 1, levels: [Buffer.alloc(16, 255)], vkFormat: 109, model: 1 }), CORRUPT],
    ['dfd-past-end', patched(uastc, AT.dfd, 0xfffffff0), CORRUPT],
    ['level-offset-wraps', patched(uastc, AT.level, 0xfffffffffffffff0n, 8), CORRUPT],
    ['level-length-wraps', patched(uastc, AT.level + 8, 0xffffffffffffffffn, 8), CORRUPT],
    ['level-uncompressed-1tb', patched(uastc, AT.level + 16, 2 ** 40, 8), CORRUPT],
    ['raw-short', patched(rawKtx2(picture()), AT.width, 64), CORRUPT],
    ['uastc-reserved-mode', ktx2File({ width: 4, height: 4, levels: [Buffer.alloc(16, 69)] }), CORRUPT],
    ['zstd-bomb', zstd(zstdBomb(1 << 30, 32), 32), CORRUPT],
    ['zstd-bomb-that-says-so', zstd(zstdBomb(1 << 30), 2 ** 30), CORRUPT],
    ['zstd-short', zstd(zstdStored(blocks.subarray(0, 16)), 32), CORRUPT],
    ['zstd-cut', zstd(zstdStored(blocks).subarray(0, 20), 32), CORRUPT],
    ['zstd-noise', zstd(noise, 32), CORRUPT],
    ['etc1s-no-endpoints', patched(etc1s, global, 0, 2), CORRUPT],
    ['etc1s-65535-endpoints', patched(etc1s, global, 65535, 2), CORRUPT],
    ['etc1s-65535-selectors', patched(etc1s, global + 2, 65535, 2), CORRUPT],
    ['etc1s-endpoints-4g', patched(etc1s, global + 4, 0xffffffff), CORRUPT],
    ['etc1s-tables-empty', patched(etc1s, global + 12, 0), CORRUPT],
    ['etc1s-video', patched(etc1s, global + 20, 2), REFUSED],
    ['etc1s-slice-past-end', patched(etc1s, global + 24, 0xfffffff0), CORRUPT],
    ['etc1s-alpha-empty', patched(etc1s, global + 36, 0), CORRUPT],
    ['etc1s-global-past-end', patched(etc1s, AT.sgd, 0xffffffffffffff00n, 8), CORRUPT],
    ['etc1s-tables-noise', withNoise(etc1s, global), CORRUPT],
  ];
}

/** Everything behind the image descriptors: codebooks and Huffman tables. */
function withNoise(file, global) {
  const out = Buffer.from(file);
  const from = global + 20 + 20 * file.readUInt32LE(AT.levels);
  for (let i = from; i < from + 60; ++i) out[i] = (i * 89 + 41) % 256;
  return out;
}

/** The quad with its positions, texture coordinates and indices compressed. */
export function meshoptQuad(options) {
  const model = quad();
  for (const [view, target] of [
    [0, 12],
    [1, 8],
  ])
    model.doc.bufferViews[view].byteStride = target;
  return compressViews(
    model,
    [
      { view: 0, count: 4, stride: 12, mode: 'ATTRIBUTES' },
      { view: 1, count: 4, stride: 8, mode: 'ATTRIBUTES' },
      { view: 2, count: 6, stride: 2, mode: 'TRIANGLES' },
    ],
    options,
  );
}

const AT_VIEW_0 = '/bufferViews/0/extensions/EXT_meshopt_compression';

/** The compressed quad after `change(extension of view 0, model)`. */
function meshoptFault(change) {
  const model = meshoptQuad();
  change(model.doc.bufferViews[0].extensions.EXT_meshopt_compression, model);
  return glb(model);
}

/** With the first bytes of view 0's data replaced. */
const meshoptData = (...bytes) => meshoptFault(({ byteOffset }, { bin }) => Buffer.from(bytes).copy(bin, byteOffset));

// biome-ignore format: one row a line, read as a table
const meshoptFaults = () => [
  ['mode-unknown', meshoptFault((e) => { e.mode = 'POINTS'; }), '/mode'],
  ['filter-unknown', meshoptFault((e) => { e.filter = 'COLOR'; }), '/filter'],
  ['filter-on-wrong-stride', meshoptFault((e) => { e.filter = 'OCTAHEDRAL'; }), '/byteStride'],
  ['stride-3', meshoptFault((e) => { e.byteStride = 3; }), '/byteStride'],
  ['stride-1024', meshoptFault((e) => { e.byteStride = 1024; }), '/byteStride'],
  ['count-0', meshoptFault((e) => { e.count = 0; }), '/count'],
  ['count-2p31', meshoptFault((e) => { e.count = 2 ** 31; }), '/count'],
  ['count-unlike-view', meshoptFault((e) => { e.count = 5; }), '/count'],
  ['triangles-as-attributes', meshoptFault((e) => { e.mode = 'TRIANGLES'; }), '/byteStride'],
  ['source-past-end', meshoptFault((e) => { e.byteOffset = 1 << 20; }), ''],
  ['source-wraps', meshoptFault((e) => { e.byteOffset = 2 ** 53; e.byteLength = 2 ** 53; }), '/byteOffset'],
  ['source-at-2p32', meshoptFault((e) => { e.byteOffset += 2 ** 32; }), '/byteOffset'],
  ['source-before-start', meshoptFault((e) => { e.byteOffset = 2 ** 32 - 1; }), '/byteOffset'],
  ['length-2p32', meshoptFault((e) => { e.byteLength += 2 ** 32; }), '/byteLength'],
  ['source-cut', meshoptFault((e) => { e.byteLength -= 3; }), ''],
  ['source-of-1', meshoptFault((e) => { e.byteLength = 1; }), ''],
  ['bad-header', meshoptData(0x00), ''],
  ['version-1', meshoptData(0xa1), ''],
  ['header-of-indices', meshoptData(0xe1), ''],
  ['bomb', meshoptFault((e, { doc }) => {
    e.count = 2 ** 27;
    doc.bufferViews[0].byteLength = 2 ** 27 * 12;
    doc.buffers[1].byteLength = 2 ** 31;
  }), ''],
];

/** @returns {import('./make_cases.mjs').Case[]} */
// biome-ignore format: one row a line, read as a table
export const decoderCases = () => [
  { name: 'ktx2-uastc.glb', bytes: ktx2Quad(uastcKtx2(picture())), code: '' },
  { name: 'ktx2-etc1s.glb', bytes: ktx2Quad(etc1sKtx2(picture(), { alpha: true })), code: '' },
  { name: 'ktx2-bc7.glb', bytes: ktx2Quad(blockKtx2('bc7-srgb', picture())), code: '' },
  { name: 'ktx2-floats.glb', bytes: ktx2Quad(rawFormatKtx2('rg16f', picture())), code: '' },
  { name: 'ktx2-zstd.glb', bytes: ktx2Quad(ktx2File({ width: 8, height: 4, levels: [zstdStored(uastcBlocks(picture(8, 4)))], sizes: [32], supercompression: SUPERCOMPRESSION.zstd })), code: '' },
  { name: 'ktx2-optional-damaged.glb', bytes: ktx2Quad(uastcKtx2(picture()).subarray(0, 200), { fallback: true, required: false }), code: CORRUPT, pointer: '/images/0' },
  ...ktx2Faults().map(([name, image, code]) => ({ name: `ktx2-${name}.glb`, bytes: ktx2Quad(image), code, pointer: code.startsWith('L_') ? undefined : '/images/0' })),
  { name: 'basisu-source-missing.glb', bytes: basisuSource(7), code: 'E_REF', pointer: '/textures/0/extensions/KHR_texture_basisu/source' },
  { name: 'meshopt.glb', bytes: glb(meshoptQuad()), code: '' },
  { name: 'meshopt-without-fallback.glb', bytes: glb(meshoptQuad({ fallback: false })), code: '' },
  { name: 'meshopt-khr.glb', bytes: glb(meshoptQuad({ extension: 'KHR_meshopt_compression' })), code: '' },
  ...meshoptFaults().map(([name, bytes, pointer]) => ({ name: `meshopt-${name}.glb`, bytes, code: 'E_MESHOPT', pointer: `${AT_VIEW_0}${pointer}` })),
  { name: 'meshopt-buffer-missing.glb', bytes: meshoptFault((e) => { e.buffer = 9; }), code: 'E_REF', pointer: `${AT_VIEW_0}/buffer` },
  { name: 'meshopt-fallback-read.glb', bytes: meshoptFault((_, { doc }) => { delete doc.bufferViews[0].extensions; }), code: 'E_BUFFER', pointer: '/buffers/1' },
];
