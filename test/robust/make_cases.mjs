// Malformed and hostile models of our own, each with one fault and the error that it must end with. Deterministic.
// `node test/robust/make_cases.mjs FOLDER` writes them; tests take them from makeCases().
import { mkdirSync, symlinkSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { PNG_MAGIC, addView, chunk, container, floats, glb, gltf, padded, png, pngChunk, pngHeader, quad, u32, ushorts } from './glb.mjs';
import { decoderCases } from './decoder_cases.mjs';
import { fabricCases } from './fabric_cases.mjs';
import { memoryCases } from './memory_cases.mjs';
import { motionCases } from './motion_cases.mjs';
import { deflateSync } from './png_parts.mjs';

/**
 * @typedef {object} Case
 * @property {string} name file name
 * @property {Buffer} bytes
 * @property {string} code expected error code; '' = the model is good
 * @property {string} [pointer] expected JSON pointer
 * @property {number} [offset] expected byte offset
 * @property {string} [warning] expected warning code of a good model
 * @property {boolean} [byPath] loaded by its path, not as bytes
 */

/** The quad after `change(model)`, as a GLB. */
function changed(change) {
  const model = quad();
  change(model);
  return glb(model);
}

/** The quad whose texture is these bytes. */
const textured = (image) => glb(quad({ image }));

/** The quad with `from` replaced by `to` in its JSON text. */
function replaced(from, to) {
  const model = quad();
  return glb(model, JSON.stringify(model.doc).replace(from, to));
}

const patched = (bytes, at, ...values) => {
  const out = Buffer.from(bytes);
  u32(...values).copy(out, at);
  return out;
};

// biome-ignore format: one row a line, read as a table
const containerCases = (good) => [
  { name: 'empty.glb', bytes: Buffer.alloc(0), code: 'E_EMPTY', offset: 0 },
  { name: 'cut-in-magic.glb', bytes: good.subarray(0, 3), code: 'E_GLB_HEADER', offset: 3 },
  { name: 'cut-in-header.glb', bytes: good.subarray(0, 11), code: 'E_GLB_HEADER', offset: 11 },
  { name: 'cut-after-header.glb', bytes: good.subarray(0, 12), code: 'E_GLB_CHUNK', offset: 12 },
  { name: 'cut-in-json.glb', bytes: good.subarray(0, 200), code: 'E_GLB_CHUNK', offset: 12 },
  { name: 'cut-last-byte.glb', bytes: good.subarray(0, good.length - 1), code: 'E_GLB_CHUNK' },
  { name: 'trailing-bytes.glb', bytes: Buffer.concat([good, Buffer.alloc(8)]), code: 'E_GLB_LENGTH', offset: 8 },
  { name: 'version-1.glb', bytes: patched(good, 4, 1), code: 'E_GLB_VERSION', offset: 4 },
  { name: 'length-too-small.glb', bytes: patched(good, 8, 16), code: 'E_GLB_LENGTH', offset: 8 },
  { name: 'json-length-wraps.glb', bytes: patched(good, 12, 0xfffffff0), code: 'E_GLB_CHUNK', offset: 12 },
  { name: 'json-chunk-odd.glb', bytes: patched(good, 12, good.readUInt32LE(12) - 1), code: 'E_GLB_CHUNK', offset: 12 },
  { name: 'two-json-chunks.glb', bytes: container(chunk('JSON', padded(Buffer.from('{}'), 0x20)), chunk('JSON', Buffer.from('{}  '))), code: 'E_GLB_CHUNK', offset: 24 },
  { name: 'archive.glb', bytes: Buffer.from('PK\x03\x04\x14\0\0\0../../x', 'latin1'), code: 'E_NOT_GLTF', offset: 0 },
  { name: 'picture.glb', bytes: png(), code: 'E_NOT_GLTF', offset: 0 },
  { name: 'unknown-chunk.glb', bytes: patched(Buffer.concat([good, chunk('XTRA', Buffer.alloc(4))]), 8, good.length + 12), code: '', warning: 'W_GLB_CHUNK' },
];

// biome-ignore format: one row a line, read as a table
const jsonCases = () => [
  { name: 'page.gltf', bytes: Buffer.from('<!doctype html>'), code: 'E_JSON', offset: 0 },
  { name: 'array.gltf', bytes: Buffer.from('[]'), code: 'E_JSON', offset: 0 },
  { name: 'trailing-comma.gltf', bytes: Buffer.from('{"asset":{"version":"2.0"},}'), code: 'E_JSON', offset: 27 },
  { name: 'broken-utf8.gltf', bytes: Buffer.from('{"asset":"\xc3("}', 'latin1'), code: 'E_JSON' },
  { name: 'nul-inside.glb', bytes: replaced('"scene"', '\0"scene"'), code: 'E_JSON' },
  { name: 'deep-arrays.gltf', bytes: Buffer.from(`{"extras":${'['.repeat(500_000)}`), code: 'L_JSON_DEPTH' },
  { name: 'many-values.gltf', bytes: Buffer.from(`{"extras":[0${',0'.repeat(600_000)}]}`), code: 'L_JSON_VALUES' },
  { name: 'number-1e400.glb', bytes: replaced('"mesh":0', '"mesh":1e400'), code: 'E_SCHEMA', pointer: '/nodes/0/mesh' },
  { name: 'long-number.glb', bytes: replaced('"mesh":0', `"mesh":0.${'0'.repeat(1_000_000)}`), code: '' },
  { name: 'no-asset.glb', bytes: changed((m) => { delete m.doc.asset; }), code: 'E_SCHEMA', pointer: '/asset' },
  { name: 'gltf-1.glb', bytes: changed((m) => { m.doc.asset.version = '1.1'; }), code: 'E_VERSION', pointer: '/asset/version' },
  { name: 'nodes-null.glb', bytes: changed((m) => { m.doc.nodes = null; }), code: 'E_SCHEMA', pointer: '/nodes' },
  { name: 'mesh-negative.glb', bytes: changed((m) => { m.doc.nodes[0].mesh = -1; }), code: 'E_SCHEMA', pointer: '/nodes/0/mesh' },
  { name: 'mesh-2p32.glb', bytes: changed((m) => { m.doc.nodes[0].mesh = 2 ** 32; }), code: 'E_REF', pointer: '/nodes/0/mesh' },
  { name: 'material-missing.glb', bytes: changed((m) => { m.doc.meshes[0].primitives[0].material = 7; }), code: 'E_REF', pointer: '/meshes/0/primitives/0/material' },
  { name: 'odd-keys.glb', bytes: replaced('"scene":0', '"__proto__":{"a":1},"constructor":{},"scene":0'), code: '' },
  { name: 'pointer-injection.glb', bytes: changed((m) => { m.doc.meshes[0].primitives[0].attributes['a/b~\u001b[31m'] = 99; }), code: 'E_REF', pointer: '/meshes/0/primitives/0/attributes/a~1b~0?[31m' },
  { name: 'extension-required.glb', bytes: changed((m) => { m.doc.extensionsRequired = ['ACME_glitter']; }), code: 'E_EXT_REQUIRED', pointer: '/extensionsRequired/0' },
  { name: 'extension-ignored.glb', bytes: changed((m) => { m.doc.extensionsUsed = ['ACME_glitter']; }), code: '', warning: 'W_EXT_IGNORED' },
];

// biome-ignore format: one row a line, read as a table
const bufferCases = () => [
  { name: 'buffer-longer-than-bin.glb', bytes: changed((m) => { m.doc.buffers[0].byteLength += 64; }), code: 'E_BUFFER', pointer: '/buffers/0/byteLength' },
  { name: 'buffer-1-tb.glb', bytes: changed((m) => { m.doc.buffers[0].byteLength = 2 ** 40; }), code: 'E_BUFFER', pointer: '/buffers/0/byteLength' },
  { name: 'buffer-shorter-than-views.glb', bytes: changed((m) => { m.doc.buffers[0].byteLength = 40; }), code: 'E_BUFFERVIEW', pointer: '/bufferViews/0' },
  { name: 'view-past-end.glb', bytes: changed((m) => { m.doc.bufferViews[3].byteLength += 64; }), code: 'E_BUFFERVIEW', pointer: '/bufferViews/3' },
  { name: 'view-offset-wraps.glb', bytes: replaced('"byteOffset":48', '"byteOffset":18446744073709551600'), code: 'E_BUFFERVIEW', pointer: '/bufferViews/1/byteOffset' },
  { name: 'stride-8.glb', bytes: changed((m) => { m.doc.bufferViews[0].byteStride = 8; }), code: 'E_STRIDE', pointer: '/bufferViews/0/byteStride' },
  { name: 'stride-of-indices.glb', bytes: changed((m) => { m.doc.bufferViews[2].byteStride = 4; }), code: 'E_STRIDE', pointer: '/bufferViews/2/byteStride' },
  { name: 'accessor-count.glb', bytes: changed((m) => { m.doc.accessors[0].count = 5; }), code: 'E_ACCESSOR', pointer: '/accessors/0' },
  { name: 'accessor-count-2p53.glb', bytes: changed((m) => { m.doc.accessors[0].count = 2 ** 53; }), code: 'E_ACCESSOR', pointer: '/accessors/0' },
  { name: 'accessor-misaligned.glb', bytes: changed((m) => { m.doc.accessors[1].byteOffset = 1; }), code: 'E_ACCESSOR', pointer: '/accessors/1/byteOffset' },
  { name: 'accessor-int.glb', bytes: changed((m) => { m.doc.accessors[0].componentType = 5124; }), code: 'E_ACCESSOR', pointer: '/accessors/0/componentType' },
  { name: 'uv-is-vec3.glb', bytes: changed((m) => { m.doc.meshes[0].primitives[0].attributes.TEXCOORD_0 = 0; }), code: 'E_ACCESSOR', pointer: '/meshes/0/primitives/0/attributes/TEXCOORD_0' },
  { name: 'zeros-2e9.glb', bytes: changed((m) => { m.doc.accessors[0] = { componentType: 5126, count: 2e9, type: 'VEC3' }; }), code: 'L_VERTICES', pointer: '/meshes/0/primitives/0' },
  { name: 'sparse-index.glb', bytes: changed((m) => sparse(m, [1, 4])), code: 'E_SPARSE', pointer: '/accessors/0/sparse/indices' },
  { name: 'sparse-order.glb', bytes: changed((m) => sparse(m, [2, 1])), code: 'E_SPARSE', pointer: '/accessors/0/sparse/indices' },
  { name: 'sparse-count.glb', bytes: changed((m) => { sparse(m, [1, 2]); m.doc.accessors[0].sparse.count = 4; }), code: 'E_SPARSE', pointer: '/accessors/0/sparse/indices' },
  { name: 'index-out-of-range.glb', bytes: changed((m) => { m.doc.accessors[2].bufferView = addView(m, ushorts(0, 1, 2, 0, 2, 4)); }), code: 'E_INDEX', pointer: '/accessors/2' },
  { name: 'index-restart.glb', bytes: changed((m) => { m.doc.accessors[2].bufferView = addView(m, ushorts(0, 1, 2, 0, 2, 0xffff)); }), code: 'E_INDEX', pointer: '/accessors/2' },
  { name: 'all-nan.glb', bytes: changed((m) => { m.doc.accessors[0].bufferView = addView(m, floats(...Array(12).fill(NaN))); }), code: 'E_NO_GEOMETRY' },
  { name: 'one-nan.glb', bytes: changed((m) => { m.doc.accessors[0].bufferView = addView(m, floats(0, 0, 0, 1, 0, 0, 1, 1, 0, NaN, 1, 0)); }), code: '', warning: 'W_NONFINITE' },
];

function sparse(model, indices) {
  model.doc.accessors[0].sparse = {
    count: 2,
    indices: { bufferView: addView(model, ushorts(...indices)), componentType: 5123 },
    values: { bufferView: addView(model, floats(0, 0, 1, 0, 0, 2)) },
  };
}

/** `levels` nodes, each with both nodes of the next level as children: 2^levels paths. */
function dag(levels) {
  const nodes = [];
  for (let i = 0; i < levels; ++i) nodes.push({ children: [2 * i + 2, 2 * i + 3] }, { children: [2 * i + 2, 2 * i + 3] });
  return [...nodes, { mesh: 0 }, { mesh: 0 }];
}

// biome-ignore format: one row a line, read as a table
const graphCases = () => [
  { name: 'own-child.glb', bytes: changed((m) => { m.doc.nodes[0].children = [0]; }), code: 'E_GRAPH', pointer: '/nodes/0' },
  { name: 'cycle-of-3.glb', bytes: changed((m) => { m.doc.nodes.push({ children: [2] }, { children: [3] }, { children: [1] }); }), code: 'E_GRAPH', pointer: '/nodes/1' },
  { name: 'two-parents.glb', bytes: changed((m) => { m.doc.nodes = [{ children: [2] }, { children: [2] }, { mesh: 0 }]; }), code: 'E_GRAPH', pointer: '/nodes/1/children/0' },
  { name: 'dag-2p60.glb', bytes: changed((m) => { m.doc.nodes = dag(60); }), code: 'E_GRAPH' },
  { name: 'chain-30k.glb', bytes: changed((m) => { m.doc.nodes = Array.from({ length: 30_000 }, (_, i) => ({ mesh: 0, children: [i + 1] })); delete m.doc.nodes.at(-1).children; }), code: 'L_NODE_DEPTH' },
  { name: 'nodes-70k.glb', bytes: changed((m) => { m.doc.nodes.push(...Array.from({ length: 70_000 }, () => ({}))); }), code: 'L_NODES', pointer: '/nodes' },
  { name: 'draws-20k.glb', bytes: changed((m) => { m.doc.meshes[0].primitives = Array(20_000).fill({ attributes: { POSITION: 0 } }); }), code: 'L_DRAW_CALLS' },
  { name: 'no-nodes.glb', bytes: changed((m) => { m.doc.scenes[0].nodes = []; }), code: 'E_NO_GEOMETRY' },
  { name: 'scale-zero.glb', bytes: changed((m) => { m.doc.nodes[0].scale = [0, 0, 0]; }), code: 'E_NO_GEOMETRY' },
  { name: 'matrix-15.glb', bytes: changed((m) => { m.doc.nodes[0].matrix = Array(15).fill(1); }), code: 'E_SCHEMA', pointer: '/nodes/0/matrix' },
  { name: 'quaternion-zero.glb', bytes: changed((m) => { m.doc.nodes[0].rotation = [0, 0, 0, 0]; }), code: 'E_SCHEMA', pointer: '/nodes/0/rotation' },
];

const damagedPng = () => {
  const bytes = png(16, 16);
  bytes[bytes.length - 30] ^= 0xff;
  return bytes;
};

// biome-ignore format: one row a line, read as a table
const imageCases = () => [
  { name: 'png-cut.glb', bytes: textured(png(16, 16).subarray(0, 60)), code: 'E_IMAGE_CORRUPT', pointer: '/images/0' },
  { name: 'png-damaged.glb', bytes: textured(damagedPng()), code: 'E_IMAGE_CORRUPT', pointer: '/images/0' },
  { name: 'png-magic-only.glb', bytes: textured(PNG_MAGIC), code: 'E_IMAGE_CORRUPT', pointer: '/images/0' },
  { name: 'png-bomb.glb', bytes: textured(Buffer.concat([PNG_MAGIC, pngHeader(40_000, 40_000, 1, 0), pngChunk('IDAT', deflateSync(Buffer.alloc(1_000_000)))])), code: 'L_IMAGE_DIMENSION', pointer: '/images/0' },
  { name: 'jpeg-start-only.glb', bytes: textured(Buffer.of(0xff, 0xd8, 0xff, 0xe0)), code: 'E_IMAGE_CORRUPT', pointer: '/images/0' },
  { name: 'webp-cut.glb', bytes: textured(Buffer.from('RIFF\x20\0\0\0WEBPVP8L', 'latin1')), code: 'E_IMAGE_CORRUPT', pointer: '/images/0' },
  { name: 'bmp.glb', bytes: textured(Buffer.from('BM\x3a\0\0\0\0\0\0\0', 'latin1')), code: 'E_IMAGE_FORMAT', pointer: '/images/0' },
  { name: 'svg.glb', bytes: textured(Buffer.from('<svg xmlns="http://www.w3.org/2000/svg"/>')), code: 'E_IMAGE_FORMAT', pointer: '/images/0' },
  { name: 'image-without-source.glb', bytes: changed((m) => { m.doc.images[0] = {}; }), code: 'E_SCHEMA', pointer: '/images/0' },
  { name: 'image-unused-damaged.glb', bytes: changed((m) => { m.doc.images.push({ bufferView: addView(m, Buffer.from('nonsense')), mimeType: 'image/png' }); }), code: '', warning: 'W_IMAGE' },
  { name: 'draco-garbage.glb', bytes: changed((m) => draco(m, Buffer.from('DRACO\x02\x02\x01\x01\0\0\xff\xff\xff\xff', 'latin1'))), code: 'E_DRACO', pointer: '/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression' },
  { name: 'draco-4g-faces.glb', bytes: changed((m) => draco(m, Buffer.from('DRACO\x02\x02\x01\0\0\0\xff\xff\xff\xff\x0f\x03', 'latin1'))), code: 'E_DRACO', pointer: '/meshes/0/primitives/0/extensions/KHR_draco_mesh_compression' },
];

/** The quad whose material has this extension. */
const layered = (extension, value) =>
  changed((m) => {
    m.doc.materials[0].extensions = { [extension]: value };
  });

/** The quad with a second, damaged image in a texture that only this layer reads. */
const damagedLayer = (extension, value) =>
  changed((m) => {
    m.doc.images.push({ bufferView: addView(m, damagedPng()), mimeType: 'image/png' });
    m.doc.textures.push({ source: 1 });
    m.doc.materials[0].extensions = { [extension]: value };
  });

const LAYERS = '/materials/0/extensions';
const HUGE = 1e300;

// biome-ignore format: one row a line, read as a table
const layerFaults = () => [
  ['ior-text', 'ior', { ior: '1.5' }, 'E_SCHEMA', '/ior'],
  ['ior-null', 'ior', null, 'E_SCHEMA', ''],
  ['clearcoat-array', 'clearcoat', [], 'E_SCHEMA', ''],
  ['clearcoat-texture-number', 'clearcoat', { clearcoatTexture: 0 }, 'E_SCHEMA', '/clearcoatTexture'],
  ['clearcoat-normal-scale-text', 'clearcoat', { clearcoatNormalTexture: { index: 0, scale: '1' } }, 'E_SCHEMA', '/clearcoatNormalTexture/scale'],
  ['sheen-color-of-2', 'sheen', { sheenColorFactor: [1, 1] }, 'E_SCHEMA', '/sheenColorFactor'],
  ['sheen-color-of-4', 'sheen', { sheenColorFactor: [1, 1, 1, 1] }, 'E_SCHEMA', '/sheenColorFactor'],
  ['sheen-texture-no-index', 'sheen', { sheenColorTexture: {} }, 'E_SCHEMA', '/sheenColorTexture/index'],
  ['specular-color-null', 'specular', { specularColorFactor: [1, null, 1] }, 'E_SCHEMA', '/specularColorFactor/1'],
  ['specular-texture-missing', 'specular', { specularTexture: { index: 1 } }, 'E_REF', '/specularTexture/index'],
  ['anisotropy-texture-2p32', 'anisotropy', { anisotropyTexture: { index: 2 ** 32 } }, 'E_REF', '/anisotropyTexture/index'],
  ['anisotropy-rotation-object', 'anisotropy', { anisotropyRotation: {} }, 'E_SCHEMA', '/anisotropyRotation'],
  ['iridescence-texture-negative', 'iridescence', { iridescenceTexture: { index: -1 } }, 'E_SCHEMA', '/iridescenceTexture/index'],
  ['iridescence-transform', 'iridescence', { iridescenceThicknessTexture: { index: 0, extensions: { KHR_texture_transform: { scale: [1] } } } }, 'E_SCHEMA', '/iridescenceThicknessTexture/extensions/KHR_texture_transform/scale'],
  ['transmission-text', 'transmission', { transmissionFactor: '1' }, 'E_SCHEMA', '/transmissionFactor'],
  ['transmission-texture-missing', 'transmission', { transmissionTexture: { index: 1 } }, 'E_REF', '/transmissionTexture/index'],
  ['volume-array', 'volume', [], 'E_SCHEMA', ''],
  ['volume-color-of-2', 'volume', { attenuationColor: [1, 1] }, 'E_SCHEMA', '/attenuationColor'],
  ['volume-distance-null', 'volume', { attenuationDistance: null }, 'E_SCHEMA', '/attenuationDistance'],
  ['volume-texture-2p32', 'volume', { thicknessTexture: { index: 2 ** 32 } }, 'E_REF', '/thicknessTexture/index'],
  ['dispersion-object', 'dispersion', { dispersion: {} }, 'E_SCHEMA', '/dispersion'],
  ['diffuse-roughness-bool', 'diffuse_roughness', { diffuseRoughnessFactor: true }, 'E_SCHEMA', '/diffuseRoughnessFactor'],
];

// biome-ignore format: one row a line, read as a table
const hugeLayers = () => [
  ['ior', { ior: HUGE }],
  ['specular', { specularFactor: HUGE, specularColorFactor: [HUGE, -HUGE, 1] }],
  ['clearcoat', { clearcoatFactor: HUGE, clearcoatRoughnessFactor: -HUGE, clearcoatNormalTexture: { index: 0, scale: HUGE } }],
  ['sheen', { sheenColorFactor: [HUGE, HUGE, HUGE], sheenRoughnessFactor: HUGE }],
  ['anisotropy', { anisotropyStrength: HUGE, anisotropyRotation: HUGE }],
  ['iridescence', { iridescenceFactor: HUGE, iridescenceIor: -HUGE, iridescenceThicknessMinimum: HUGE, iridescenceThicknessMaximum: -HUGE }],
  ['diffuse_roughness', { diffuseRoughnessFactor: HUGE }],
  ['transmission', { transmissionFactor: HUGE }],
  ['volume', { thicknessFactor: HUGE, attenuationDistance: -HUGE, attenuationColor: [HUGE, -HUGE, 0] }],
  ['dispersion', { dispersion: HUGE }],
];

/** Everything beyond its range at once, drawn. */
const hugeGlass = () =>
  changed((m) => {
    m.doc.materials[0].extensions = {
      KHR_materials_ior: { ior: HUGE },
      KHR_materials_transmission: { transmissionFactor: HUGE },
      KHR_materials_volume: { thicknessFactor: HUGE, attenuationDistance: 1e-300, attenuationColor: [0, HUGE, -HUGE] },
      KHR_materials_dispersion: { dispersion: HUGE },
    };
  });

const COAT = { clearcoatTexture: { index: 1 } };
// biome-ignore format: one row a line, read as a table
const materialCases = () => [
  ...layerFaults().map(([name, extension, value, code, pointer]) => ({
    name: `${name}.glb`, bytes: layered(`KHR_materials_${extension}`, value), code, pointer: `${LAYERS}/KHR_materials_${extension}${pointer}`,
  })),
  ...hugeLayers().map(([extension, value]) => ({
    name: `huge-${extension}.glb`, bytes: layered(`KHR_materials_${extension}`, value), code: '', warning: 'W_RANGE',
  })),
  { name: 'huge-glass.glb', bytes: hugeGlass(), code: '', warning: 'W_RANGE' },
  { name: 'transmission-image-damaged.glb', bytes: damagedLayer('KHR_materials_transmission', { transmissionFactor: 1, transmissionTexture: { index: 1 } }), code: 'E_IMAGE_CORRUPT', pointer: '/images/1' },
  { name: 'volume-off-image-damaged.glb', bytes: damagedLayer('KHR_materials_volume', { thicknessFactor: 1, thicknessTexture: { index: 1 } }), code: '' },
  { name: 'ior-nan.glb', bytes: replaced('"pbrMetallicRoughness"', '"extensions":{"KHR_materials_ior":{"ior":NaN}},"pbrMetallicRoughness"'), code: 'E_JSON' },
  { name: 'sheen-1e400.glb', bytes: replaced('"pbrMetallicRoughness"', '"extensions":{"KHR_materials_sheen":{"sheenRoughnessFactor":1e400}},"pbrMetallicRoughness"'), code: 'E_SCHEMA', pointer: `${LAYERS}/KHR_materials_sheen/sheenRoughnessFactor` },
  { name: 'sheen-texcoord-2p31.glb', bytes: layered('KHR_materials_sheen', { sheenColorTexture: { index: 0, texCoord: 2 ** 31 } }), code: '', warning: 'W_TEXCOORD' },
  { name: 'clearcoat-image-damaged.glb', bytes: damagedLayer('KHR_materials_clearcoat', { clearcoatFactor: 1, ...COAT }), code: 'E_IMAGE_CORRUPT', pointer: '/images/1' },
  { name: 'clearcoat-off-image-damaged.glb', bytes: damagedLayer('KHR_materials_clearcoat', COAT), code: '' },
];

function draco(model, data) {
  model.doc.meshes[0].primitives[0].extensions = {
    KHR_draco_mesh_compression: { bufferView: addView(model, data), attributes: { POSITION: 0 } },
  };
}

const URIS = {
  parent: ['../secret.bin', 'E_URI_DENIED'],
  'parent-encoded': ['%2e%2e/secret.bin', 'E_URI_DENIED'],
  'parent-twice-encoded': ['%252e%252e%252fsecret.bin', 'E_URI_DENIED'],
  absolute: ['/etc/passwd', 'E_URI_DENIED'],
  'file-scheme': ['file:///etc/passwd', 'E_URI_DENIED'],
  http: ['http://127.0.0.1:9/x.bin', 'E_URI_DENIED'],
  backslash: ['..\\secret.bin', 'E_URI_DENIED'],
  nul: ['quad.bin%00.png', 'E_URI_DENIED'],
  link: ['link.bin', 'E_URI_DENIED'],
  'link-folder': ['up/secret.bin', 'E_URI_DENIED'],
  missing: ['none.bin', 'E_URI_MISSING'],
  folder: ['side', 'E_URI_MISSING'],
  empty: ['', 'E_URI_MISSING'],
  'data-no-comma': ['data:application/octet-stream;base64', 'E_URI_DATA'],
  'data-not-base64': ['data:application/octet-stream;base64,@@@@', 'E_URI_DATA'],
  beside: ['side/quad%20data.bin', ''],
};

// biome-ignore format: one row a line, read as a table
const uriCases = () => [
  ...Object.entries(URIS).map(([name, [uri, code]]) => ({
    name: `uri-${name}.gltf`, bytes: gltf(quad(), uri), code, pointer: code && '/buffers/0/uri', byPath: true,
  })),
  { name: 'uri-in-bytes.gltf', bytes: gltf(quad(), 'side/quad%20data.bin'), code: 'E_URI_DENIED', pointer: '/buffers/0/uri' },
];

/** @returns {Case[]} */
// biome-ignore format: one row a line, read as a table
export const makeCases = () => {
  const good = glb(quad());
  return [
    { name: 'good.glb', bytes: good, code: '' },
    { name: 'good.gltf', bytes: gltf(quad()), code: '' },
    ...containerCases(good), ...jsonCases(), ...bufferCases(), ...graphCases(), ...imageCases(), ...materialCases(), ...memoryCases(), ...motionCases(), ...fabricCases(changed), ...uriCases(), ...decoderCases(),
  ];
};

/** Writes the cases, and the files and links that some of them name, to FOLDER/cases; FOLDER/secret.bin is the bait. */
export function writeCases(folder, cases = makeCases()) {
  const at = join(folder, 'cases');
  mkdirSync(join(at, 'side'), { recursive: true });
  writeFileSync(join(folder, 'secret.bin'), quad().bin);
  writeFileSync(join(at, 'side', 'quad data.bin'), quad().bin);
  symlinkSync('../secret.bin', join(at, 'link.bin'));
  symlinkSync('..', join(at, 'up'));
  for (const { name, bytes } of cases) writeFileSync(join(at, name), bytes);
  return at;
}

if (process.argv[1] && resolve(process.argv[1]) === fileURLToPath(import.meta.url)) {
  const folder = process.argv[2] ?? join(dirname(fileURLToPath(import.meta.url)), '../../out/hostile');
  const cases = makeCases();
  console.log(`${cases.length} cases in ${writeCases(folder, cases)}`);
}
