import { Document, NodeIO } from '@gltf-transform/core';
import { KHRMaterialsVariants, KHRTextureTransform } from '@gltf-transform/extensions';

/** Dyes as linear-sRGB factors on the undyed yarn of the base colour maps. The first is the default. */
const COLOURWAYS = [
  { name: 'natural', factor: [0.96, 0.93, 0.872] },
  { name: 'terracotta', factor: [0.37, 0.132, 0.078] },
  { name: 'indigo', factor: [0.032, 0.044, 0.082] },
];

function addTexture(document, name, image) {
  return document.createTexture(name).setImage(image).setMimeType('image/jpeg');
}

const ROUGHNESS_WITHOUT_MAP = 0.75;

// Coordinates are metres on the flat pattern, v down from the lower edge of a repeat.
function tile(transforms, info, [width, height]) {
  info.setExtension('KHR_texture_transform', transforms.createTransform().setScale([1 / width, 1 / height]));
}

function addMaterial(document, { name, factor, textures, extent, drape, transforms }) {
  const material = document
    .createMaterial(name)
    .setBaseColorFactor([...factor, 1])
    .setMetallicFactor(0)
    .setOcclusionTexture(drape);
  material.getOcclusionTextureInfo().setTexCoord(1);
  material.setBaseColorTexture(textures.base);
  tile(transforms, material.getBaseColorTextureInfo(), extent);
  if (!textures.surface) return material.setRoughnessFactor(ROUGHNESS_WITHOUT_MAP);
  material.setNormalTexture(textures.normal).setMetallicRoughnessTexture(textures.surface);
  tile(transforms, material.getNormalTextureInfo(), extent);
  tile(transforms, material.getMetallicRoughnessTextureInfo(), extent);
  return material;
}

// One material per textile and dye; a textile that is not dyed has the same one in all colourways.
function addMaterials(document, { textiles, occlusion }) {
  const transforms = document.createExtension(KHRTextureTransform).setRequired(true);
  const drape = addTexture(document, 'drape_occlusion', occlusion);
  const materials = {};
  for (const [textile, { extent, dyed, ...maps }] of Object.entries(textiles)) {
    const textures = Object.fromEntries(Object.entries(maps).map(([kind, image]) => [kind, addTexture(document, `${textile}_${kind}`, image)]));
    const shared = dyed ? null : addMaterial(document, { name: textile, factor: [1, 1, 1], textures, extent, drape, transforms });
    materials[textile] = COLOURWAYS.map(
      ({ name, factor }) => shared ?? addMaterial(document, { name: `${textile}_${name}`, factor, textures, extent, drape, transforms }),
    );
  }
  return materials;
}

function addPrimitive(document, buffer, piece, atlasUv) {
  const accessor = (type, array) => document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
  const indices = piece.positions.length / 3 > 65535 ? Uint32Array.from(piece.indices) : Uint16Array.from(piece.indices);
  return document
    .createPrimitive()
    .setIndices(accessor('SCALAR', indices))
    .setAttribute('POSITION', accessor('VEC3', Float32Array.from(piece.positions)))
    .setAttribute('NORMAL', accessor('VEC3', Float32Array.from(piece.normals)))
    .setAttribute('TANGENT', accessor('VEC4', Float32Array.from(piece.tangents)))
    .setAttribute('TEXCOORD_0', accessor('VEC2', Float32Array.from(piece.uv)))
    .setAttribute('TEXCOORD_1', accessor('VEC2', Float32Array.from(atlasUv)));
}

// Pieces of one part share a primitive per textile: fewer draw calls, the same picture.
function joinPieces(pieces, atlasUv) {
  const joined = new Map();
  pieces.forEach((piece, i) => {
    const key = `${piece.part}:${piece.textile}`;
    const target = joined.get(key) ?? { part: piece.part, textile: piece.textile, positions: [], normals: [], tangents: [], uv: [], atlas: [], indices: [] };
    const base = target.positions.length / 3;
    for (const index of piece.indices) target.indices.push(index + base);
    for (const attribute of ['positions', 'normals', 'tangents', 'uv']) for (const value of piece[attribute]) target[attribute].push(value);
    for (const value of atlasUv[i]) target.atlas.push(value);
    joined.set(key, target);
  });
  return [...joined.values()];
}

/**
 * @param {object} garment
 * @param {object[]} garment.pieces - From `cutPieces`.
 * @param {Float64Array[]} garment.atlasUv - Per piece.
 * @param {Buffer} garment.occlusion - JPEG of the occlusion atlas.
 * @param {Object<string, {base, normal, surface, extent, dyed}>} garment.textiles - From `makeTextiles`.
 * @returns {Promise<Uint8Array>} GLB.
 */
export async function writeGarment({ pieces, atlasUv, occlusion, textiles }) {
  const document = new Document();
  Object.assign(document.getRoot().getAsset(), {
    generator: 'telar',
    copyright: 'Copyright telar. Part of telar, under its licence; free to render, copy and show with it.',
  });
  const buffer = document.createBuffer();
  const materials = addMaterials(document, { textiles, occlusion });
  const variants = document.createExtension(KHRMaterialsVariants);
  const colourways = COLOURWAYS.map(({ name }) => variants.createVariant(name));
  const root = document.createNode('tshirt');
  document.getRoot().setDefaultScene(document.createScene('tshirt').addChild(root));
  for (const piece of joinPieces(pieces, atlasUv)) {
    const primitive = addPrimitive(document, buffer, piece, piece.atlas);
    const choices = materials[piece.textile];
    const list = variants.createMappingList();
    colourways.forEach((variant, i) => list.addMapping(variants.createMapping().setMaterial(choices[i]).addVariant(variant)));
    primitive.setMaterial(choices[0]).setExtension('KHR_materials_variants', list);
    root.addChild(document.createNode(piece.part).setMesh(document.createMesh(piece.part).addPrimitive(primitive)));
  }
  return new NodeIO().registerExtensions([KHRMaterialsVariants, KHRTextureTransform]).writeBinary(document);
}
