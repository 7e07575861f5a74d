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
  for (const mesh of meshes) await assignMaterial(parser, mesh, index);
}

function variantNames(parser) {
  return (parser.json.extensions?.[EXTENSION]?.variants ?? []).map((variant) => variant.name);
}

async function assignMaterial(parser, mesh, variantIndex) {
  const where = parser.associations.get(mesh);
  if (where?.meshes === undefined) return;
  const primitive = parser.json.meshes[where.meshes].primitives[where.primitives ?? 0];
  const mappings = primitive.extensions?.[EXTENSION]?.mappings ?? [];
  const mapping = mappings.find((entry) => entry.variants.includes(variantIndex));
  if (mapping) {
    if (!ownMaterial.has(mesh)) ownMaterial.set(mesh, mesh.material);
    mesh.material = await parser.getDependency('material', mapping.material);
    parser.assignFinalMaterial(mesh);
  } else if (ownMaterial.has(mesh)) {
    mesh.material = ownMaterial.get(mesh);
  }
}
