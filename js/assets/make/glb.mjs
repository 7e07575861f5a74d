import { Document, NodeIO } from '@gltf-transform/core';
import { KHRMaterialsVariants, KHRTextureTransform } from '@gltf-transform/extensions';
import { TILE } from './textile/knit.mjs';

/** Dyes as linear-sRGB factors on the undyed yarn of the base colour maps. The first is the default. */
export const COLOURWAYS = [
  { name: 'natural', factor: [0.86, 0.825, 0.765] },
  { name: 'terracotta', factor: [0.42, 0.135, 0.07] },
  { name: 'indigo', factor: [0.034, 0.05, 0.105] },
];

function addTexture(document, name, image) {
  return document.createTexture(name).setImage(image).setMimeType('image/jpeg');
}

function addMaterials(document, { textiles, occlusion }) {
  const transforms = document.createExtension(KHRTextureTransform).setRequired(true);
  const drape = addTexture(document, 'drape_occlusion', occlusion);
  // Coordinates are metres on the flat pattern; the tile is TILE metres wide.
  const repeat = () => transforms.createTransform().setScale([1 / TILE, 1 / TILE]);
  const tiled = (info) => info.setExtension('KHR_texture_transform', repeat());
  const materials = {};
  for (const [textile, maps] of Object.entries(textiles)) {
    const textures = Object.fromEntries(Object.entries(maps).map(([kind, image]) => [kind, addTexture(document, `${textile}_${kind}`, image)]));
    for (const { name, factor } of COLOURWAYS) {
      const material = document.createMaterial(`${textile}_${name}`)
        .setBaseColorFactor([...factor, 1]).setBaseColorTexture(textures.base).setNormalTexture(textures.normal)
        .setMetallicRoughnessTexture(textures.surface).setMetallicFactor(0).setRoughnessFactor(1)
        .setOcclusionTexture(drape);
      tiled(material.getBaseColorTextureInfo());
      tiled(material.getNormalTextureInfo());
      tiled(material.getMetallicRoughnessTextureInfo());
      material.getOcclusionTextureInfo().setTexCoord(1);
      materials[`${textile}_${name}`] = material;
    }
  }
  return materials;
}

function addPrimitive(document, buffer, piece, atlasUv) {
  const accessor = (type, array) => document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
  const indices = piece.positions.length / 3 > 65535 ? Uint32Array.from(piece.indices) : Uint16Array.from(piece.indices);
  return document.createPrimitive()
    .setIndices(accessor('SCALAR', indices))
    .setAttribute('POSITION', accessor('VEC3', Float32Array.from(piece.positions)))
    .setAttribute('NORMAL', accessor('VEC3', Float32Array.from(piece.normals)))
    .setAttribute('TEXCOORD_0', accessor('VEC2', Float32Array.from(piece.uv)))
    .setAttribute('TEXCOORD_1', accessor('VEC2', Float32Array.from(atlasUv)));
}

// Pieces of one part share a primitive per textile: fewer draw calls, the same picture.
function joinPieces(pieces, atlasUv) {
  const joined = new Map();
  pieces.forEach((piece, i) => {
    const key = `${piece.part}:${piece.textile}`;
    const target = joined.get(key) ?? { part: piece.part, textile: piece.textile, positions: [], normals: [], uv: [], atlas: [], indices: [] };
    const base = target.positions.length / 3;
    for (const index of piece.indices) target.indices.push(index + base);
    for (const attribute of ['positions', 'normals', 'uv']) for (const value of piece[attribute]) target[attribute].push(value);
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
 * @param {Object<string, {base, normal, surface}>} garment.textiles - JPEG maps.
 * @returns {Promise<Uint8Array>} GLB.
 */
export async function writeGarment({ pieces, atlasUv, occlusion, textiles }) {
  const document = new Document();
  Object.assign(document.getRoot().getAsset(), { generator: 'telar', copyright: 'Copyright telar. Part of telar, under its licence; free to render, copy and show with it.' });
  const buffer = document.createBuffer();
  const materials = addMaterials(document, { textiles, occlusion });
  const variants = document.createExtension(KHRMaterialsVariants);
  const colourways = COLOURWAYS.map(({ name }) => ({ name, variant: variants.createVariant(name) }));
  const root = document.createNode('tshirt');
  document.getRoot().setDefaultScene(document.createScene('tshirt').addChild(root));
  for (const piece of joinPieces(pieces, atlasUv)) {
    const primitive = addPrimitive(document, buffer, piece, piece.atlas);
    const list = variants.createMappingList();
    for (const { name, variant } of colourways) {
      list.addMapping(variants.createMapping().setMaterial(materials[`${piece.textile}_${name}`]).addVariant(variant));
    }
    primitive.setMaterial(materials[`${piece.textile}_${COLOURWAYS[0].name}`]).setExtension('KHR_materials_variants', list);
    root.addChild(document.createNode(piece.part).setMesh(document.createMesh(piece.part).addPrimitive(primitive)));
  }
  return new NodeIO().registerExtensions([KHRMaterialsVariants, KHRTextureTransform]).writeBinary(document);
}
