import { assignMaterial } from './assign_material.mjs';

const EXTENSION = 'KHR_materials_variants';

/** Material that the file gives to a mesh outside of any variant, remembered before the first change. */
const ownMaterial = new WeakMap();

/**
 * Shows one KHR_materials_variants variant of a loaded model; meshes that it does not map keep the file's own material.
 *
 * @param {{scene: import('three').Object3D, parser: object}} model - What GLTFLoader gave.
 * @param {string} name - Name of the variant, or '' for the file's own materials.
 * @throws {Error} When the model has no variant of that name.
 */
export async function applyVariant(model, name) {
  const { parser } = model;
  const index = name === '' ? -1 : variantNames(parser).indexOf(name);
  if (name !== '' && index < 0) {
    throw new Error(`shot.variant: the model has ${variantNames(parser).join(', ') || 'no variants'}, not ${name}`);
  }
  const meshes = [];
  model.scene.traverse((object) => {
    if (object.isMesh || object.isLine || object.isPoints) meshes.push(object);
  });
  for (const mesh of meshes) await showVariant(parser, mesh, index);
}

/**
 * Index of the material that the file gives to a mesh in a variant; undefined for glTF's default one, and where the file is not known.
 * @param {object} parser - Of GLTFLoader.
 * @param {import('three').Object3D} mesh
 * @param {string} variant - Name; '' for the file's own materials, as a variant that the file lacks.
 */
export function materialIndexOf(parser, mesh, variant) {
  const primitive = primitiveOf(parser, mesh);
  const mappings = primitive?.extensions?.[EXTENSION]?.mappings ?? [];
  const index = variant === '' ? -1 : variantNames(parser).indexOf(variant);
  return mappings.find(({ variants }) => variants.includes(index))?.material ?? primitive?.material;
}

function variantNames(parser) {
  return (parser.json.extensions?.[EXTENSION]?.variants ?? []).map((variant) => variant.name);
}

/** The primitive of the file that a mesh shows; an instanced one is known by its node alone. */
export function primitiveOf({ associations, json }, mesh) {
  const { meshes, primitives = 0 } = associations.get(mesh) ?? {};
  if (meshes !== undefined) return json.meshes[meshes].primitives[primitives];
  if (!mesh.isInstancedMesh) return undefined;
  const own = associations.get(mesh)?.nodes;
  const node = own ?? associations.get(mesh.parent)?.nodes;
  const index = own === undefined ? mesh.parent.children.filter((child) => child.isInstancedMesh).indexOf(mesh) : 0;
  return json.meshes[json.nodes[node]?.mesh]?.primitives[index];
}

async function showVariant(parser, mesh, variantIndex) {
  const primitive = primitiveOf(parser, mesh);
  if (!primitive) return;
  const mappings = primitive.extensions?.[EXTENSION]?.mappings ?? [];
  const mapping = mappings.find((entry) => entry.variants.includes(variantIndex));
  if (mapping) {
    if (!ownMaterial.has(mesh)) ownMaterial.set(mesh, mesh.material);
    assignMaterial(parser, mesh, await parser.getDependency('material', mapping.material));
  } else if (ownMaterial.has(mesh)) {
    mesh.material = ownMaterial.get(mesh);
  }
}
