import { Document, NodeIO } from '@gltf-transform/core';
import {
  EXTMeshoptCompression,
  KHRMaterialsClearcoat,
  KHRMaterialsSheen,
  KHRMaterialsVariants,
  KHRMeshQuantization,
  KHRTextureTransform,
} from '@gltf-transform/extensions';
import { MeshoptDecoder, MeshoptEncoder } from 'meshoptimizer';
import sharp from 'sharp';
import { bakeOcclusion } from '../cloth/occlusion.mjs';
import { particleNormals } from '../cloth/surface.mjs';
import { CLOTH, drapeCloth } from './drape_cloth.mjs';
import { reliefOf } from './reliefs.mjs';

/**
 * fabrics.glb: one drape, each fabric class a material variant of it, in glTF's own terms (core, sheen, clearcoat), so that
 * every shading reads the same numbers. They are typical of the class, not fitted to one cloth.
 */

/** Linear Rec.709 colours; roughnesses perceptual. The first is the default. */
export const FABRICS = {
  leather: { baseColor: [0.16, 0.062, 0.03], roughness: 0.48, clearcoat: { factor: 0.35, roughness: 0.3 } },
  wool: { baseColor: [0.085, 0.1, 0.13], roughness: 0.92, sheen: { color: [0.13, 0.14, 0.16], roughness: 0.65 } },
  towel: { baseColor: [0.78, 0.76, 0.7], roughness: 1, sheen: { color: [0.28, 0.28, 0.27], roughness: 0.85 } },
  velvet: { baseColor: [0.115, 0.006, 0.018], roughness: 0.8, sheen: { color: [0.62, 0.14, 0.2], roughness: 0.32 } },
};

async function addMaterial(document, [name, fabric], occlusion) {
  const material = document
    .createMaterial(name)
    .setDoubleSided(true)
    .setMetallicFactor(0)
    .setBaseColorFactor([...fabric.baseColor, 1])
    .setRoughnessFactor(fabric.roughness)
    .setOcclusionTexture(occlusion);
  const { image, tile } = await reliefOf(name);
  material.setNormalTexture(document.createTexture(`${name}_relief`).setImage(image).setMimeType('image/jpeg'));
  const repeats = CLOTH.edge / tile;
  const transform = document.createExtension(KHRTextureTransform).createTransform().setScale([repeats, repeats]);
  material.getNormalTextureInfo().setExtension('KHR_texture_transform', transform);
  if (fabric.sheen) {
    const sheen = document.createExtension(KHRMaterialsSheen).createSheen();
    material.setExtension('KHR_materials_sheen', sheen.setSheenColorFactor(fabric.sheen.color).setSheenRoughnessFactor(fabric.sheen.roughness));
  }
  if (fabric.clearcoat) {
    const coat = document.createExtension(KHRMaterialsClearcoat).createClearcoat();
    const { factor, roughness } = fabric.clearcoat;
    material.setExtension('KHR_materials_clearcoat', coat.setClearcoatFactor(factor).setClearcoatRoughnessFactor(roughness));
  }
  return material;
}

/** Openness of each point of the drape: a texel a point, as the cloth's grid is that of its texture coordinates. */
async function occlusionImage({ positions, normals, indices }) {
  const side = CLOTH.intervals + 1;
  const [open] = bakeOcclusion([{ positions, normals, indices: [...indices] }], { rays: 96, albedo: 0.4 });
  const texels = Buffer.alloc(side * side);
  // Rows of the cloth run upwards, those of an image downwards.
  open.forEach((value, i) => {
    texels[(side - 1 - Math.floor(i / side)) * side + (i % side)] = Math.round(Math.min(1, value) * 255);
  });
  return sharp(texels, { raw: { width: side, height: side, channels: 1 } })
    .toColourspace('b-w')
    .jpeg({ quality: 85 })
    .toBuffer();
}

/** 16-bit integers over `range`, as KHR_mesh_quantization stores them; the node's scale undoes the division. */
const quantized = (values, range) => Int16Array.from(values, (value) => Math.round((value / range) * 32767));

function addPrimitive(document, buffer, { positions, normals, uv, indices }, range) {
  const accessor = (type, array, normalized) => document.createAccessor().setType(type).setArray(array).setNormalized(normalized).setBuffer(buffer);
  // The outermost points lie half a texel inside the image of their occlusion.
  const side = CLOTH.intervals + 1;
  const texel = (value) => ((value / CLOTH.edge) * CLOTH.intervals + 0.5) / side;
  return document
    .createPrimitive()
    .setIndices(accessor('SCALAR', Uint16Array.from(indices), false))
    .setAttribute('POSITION', accessor('VEC3', quantized(positions, range), true))
    .setAttribute('NORMAL', accessor('VEC3', quantized(normals, 1), true))
    .setAttribute(
      'TEXCOORD_0',
      accessor(
        'VEC2',
        Uint16Array.from(uv, (value) => Math.round(texel(value) * 65535)),
        true,
      ),
    );
}

/** @returns {Promise<Uint8Array>} GLB */
export async function makeFabrics() {
  await Promise.all([MeshoptEncoder.ready, MeshoptDecoder.ready]);
  const cloth = drapeCloth();
  const drape = { ...cloth, normals: particleNormals(cloth.garment, cloth.positions) };
  const document = new Document();
  Object.assign(document.getRoot().getAsset(), {
    generator: 'telar',
    copyright: 'Copyright telar. Part of telar, under its licence; free to render, copy and show with it.',
  });
  document.createExtension(KHRMeshQuantization).setRequired(true);
  document.createExtension(KHRTextureTransform).setRequired(true);
  document.createExtension(EXTMeshoptCompression).setRequired(true).setEncoderOptions({ method: EXTMeshoptCompression.EncoderMethod.QUANTIZE });
  const occlusion = document
    .createTexture('drape_occlusion')
    .setImage(await occlusionImage(drape))
    .setMimeType('image/jpeg');
  const range = Math.max(...drape.positions.map(Math.abs));
  const primitive = addPrimitive(document, document.createBuffer(), drape, range);
  const variants = document.createExtension(KHRMaterialsVariants);
  const list = variants.createMappingList();
  for (const fabric of Object.entries(FABRICS)) {
    const material = await addMaterial(document, fabric, occlusion);
    if (!primitive.getMaterial()) primitive.setMaterial(material);
    list.addMapping(variants.createMapping().setMaterial(material).addVariant(variants.createVariant(fabric[0])));
  }
  primitive.setExtension('KHR_materials_variants', list);
  const node = document.createNode('drape').setMesh(document.createMesh('drape').addPrimitive(primitive)).setScale([range, range, range]);
  document.getRoot().setDefaultScene(document.createScene('fabrics').addChild(node));
  return new NodeIO()
    .registerExtensions([EXTMeshoptCompression, KHRMaterialsClearcoat, KHRMaterialsSheen, KHRMaterialsVariants, KHRMeshQuantization, KHRTextureTransform])
    .registerDependencies({ 'meshopt.encoder': MeshoptEncoder, 'meshopt.decoder': MeshoptDecoder })
    .writeBinary(document);
}
