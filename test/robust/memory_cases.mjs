// Small models that would take much memory or time: refused from what their headers and counts say, before anything is
// allocated or decoded.
import { PNG_MAGIC, addView, floats, glb, pngChunk, pngHeader, quad, u32 } from './glb.mjs';

const FLOAT = 5126;
const UINT = 5125;
const PRIMITIVE = '/meshes/0/primitives/0';

/** An accessor without bytes: zeros, but for one element, so that there is something to draw. */
function zeros(model, count, type, componentType = FLOAT) {
  const width = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 }[type];
  const index = addView(model, u32(1));
  const value = addView(model, componentType === FLOAT ? floats(...Array(width).fill(1)) : u32(1));
  const sparse = { count: 1, indices: { bufferView: index, componentType: UINT }, values: { bufferView: value } };
  return model.doc.accessors.push({ componentType, count, type, sparse }) - 1;
}

/** 9.99 million vertices with every attribute, out of a kilobyte. */
function allAttributes() {
  const model = quad();
  const types = { POSITION: 'VEC3', NORMAL: 'VEC3', TANGENT: 'VEC4', TEXCOORD_0: 'VEC2', TEXCOORD_1: 'VEC2', COLOR_0: 'VEC3' };
  const attributes = Object.fromEntries(Object.entries(types).map(([name, type]) => [name, zeros(model, 9_990_000, type)]));
  model.doc.meshes[0].primitives[0] = { attributes, indices: zeros(model, 59_990_001, 'SCALAR', UINT), material: 0 };
  return glb(model);
}

/** A mesh of so many points, drawn by five nodes. */
function points(count) {
  const model = quad();
  model.doc.nodes = Array(5).fill({ mesh: 0 });
  model.doc.scenes[0].nodes = [0, 1, 2, 3, 4];
  model.doc.meshes[0].primitives[0] = { attributes: { POSITION: zeros(model, count, 'VEC3') }, mode: 0 };
  return glb(model);
}

/** Images of 8192 x 8192 whose texels are not there: decoding one of them would be E_IMAGE_CORRUPT. */
function largeImages() {
  const image = Buffer.concat([PNG_MAGIC, pngHeader(8192, 8192), pngChunk('IDAT', Buffer.alloc(8)), pngChunk('IEND', Buffer.alloc(0))]);
  const model = quad({ image });
  for (let i = 1; i < 3; ++i) model.doc.images.push({ bufferView: addView(model, Buffer.concat([image, Buffer.alloc(i)])), mimeType: 'image/png' });
  model.doc.textures = [{ source: 0 }, { source: 1 }, { source: 2 }];
  const both = (index) => ({ pbrMetallicRoughness: { baseColorTexture: { index }, metallicRoughnessTexture: { index } } });
  model.doc.materials = [both(0), both(1), both(2)];
  const [primitive] = model.doc.meshes[0].primitives;
  model.doc.meshes[0].primitives = [0, 1, 2].map((material) => ({ ...primitive, material }));
  return glb(model);
}

/** As many variants as primitives: a table of both would have 9 million places. */
function variants() {
  const model = quad();
  const [primitive] = model.doc.meshes[0].primitives;
  const mapped = { ...primitive, extensions: { KHR_materials_variants: { mappings: [{ material: 0, variants: [2999] }] } } };
  model.doc.meshes[0].primitives = Array(3000).fill(mapped);
  model.doc.extensions = { KHR_materials_variants: { variants: Array.from({ length: 3000 }, (_, i) => ({ name: `${i}` })) } };
  model.doc.extensionsUsed = ['KHR_materials_variants'];
  return glb(model);
}

/** Extensions that are required and extensions that are used, none of them in both lists. */
function extensions() {
  const model = quad();
  model.doc.extensionsUsed = Array.from({ length: 30_000 }, (_, i) => `KHR_materials_${i}`);
  model.doc.extensionsRequired = [...Array(30_000).fill('KHR_materials_ior'), 'TELAR_unknown'];
  return glb(model);
}

export const memoryCases = () => [
  { name: 'vertices-all-attributes.glb', bytes: allAttributes(), code: 'L_MEMORY_BYTES', pointer: PRIMITIVE },
  { name: 'points-of-five-nodes.glb', bytes: points(9_900_000), code: 'L_TRIANGLES', pointer: PRIMITIVE },
  { name: 'images-read-both-ways.glb', bytes: largeImages(), code: 'L_MEMORY_BYTES', pointer: '/images/1' },
  { name: 'variants-and-primitives.glb', bytes: variants(), code: '' },
  { name: 'extensions-30k-and-30k.glb', bytes: extensions(), code: 'E_EXT_REQUIRED', pointer: '/extensionsRequired/30000' },
];
