import { isRelease } from '../shot/three_terms.mjs';

/** Material of a mesh in the model as loaded (or of its variant), by what stands in its place. */
const originals = new WeakMap();

/** Materials that stand for an original, by a shading's key. */
const replacements = new WeakMap();

const originalOf = (material) => originals.get(material) ?? material;

/**
 * Puts the model's own materials back.
 * @param {import('three').Object3D} root
 */
export function restoreMaterials(root) {
  root.traverse((object) => {
    if (object.material) object.material = mapped(object.material, originalOf);
  });
}

/**
 * Draws every lit material of a model with a shading of telar's. The originals stay as they are; one that several meshes share
 * has one replacement, which is kept for the next time. Called again, it takes over what was changed in the originals since.
 * @param {{scene: import('three').Object3D, parser?: object}} model - What GLTFLoader gave, or any scene graph: without a
 *   parser, what only the file says of its cloth is not known.
 * @param {string | object} shading - Of a resolved shot: "fabric", a principled shading with every slot, or "three" or a release of it for
 *   the model's own materials.
 * @param {{THREE: typeof import('three'), ownText?: boolean}} options - `ownText`: shades "three" by telar's text of it.
 */
export async function applyShading(model, shading, { THREE, ownText = false }) {
  if (isRelease(shading) && !ownText) {
    restoreMaterials(model.scene);
    return;
  }
  const meshes = [];
  model.scene.traverse((object) => {
    if (object.isMesh && [object.material].flat().some((material) => material && isStock(originalOf(material)))) meshes.push(object);
  });
  if (meshes.length === 0) return;
  const { openShading } = await import('./shading/index.mjs');
  const maker = await openShading(THREE, shading);
  const made = new Map();
  const drawn = meshesByMaterial(meshes);
  const transmits = meshes.some(({ material }) => [material].flat().some((each) => originalOf(each).transmission > 0));
  for (const mesh of meshes) {
    for (const material of [mesh.material].flat()) {
      const original = originalOf(material);
      if (isStock(original) && !made.has(original))
        made.set(original, await refreshed(original, maker, { model, mesh, drawn: drawn.get(original), transmits }));
    }
    mesh.material = mapped(mesh.material, (material) => made.get(originalOf(material)) ?? material);
  }
}

/** The meshes that show each material. */
function meshesByMaterial(meshes) {
  const found = new Map();
  for (const mesh of meshes) {
    for (const original of new Set([mesh.material].flat().map(originalOf))) {
      if (!found.has(original)) found.set(original, []);
      found.get(original).push(mesh);
    }
  }
  return found;
}

/** Lit by three.js's own text: a FabricMaterial that a client has put there itself stays. */
const isStock = (material) => material.isMeshStandardMaterial === true && !material.isTelarShadingMaterial;

const mapped = (material, change) => (Array.isArray(material) ? material.map(change) : change(material));

/** The replacement of an original in the state that the original has now. */
async function refreshed(original, { key, create, update }, place) {
  if (!replacements.has(original)) {
    replacements.set(original, new Map());
    original.addEventListener('dispose', () => disposeReplacements(original));
  }
  const known = replacements.get(original);
  if (!known.has(key)) known.set(key, create());
  const material = known.get(key);
  originals.set(material, original);
  await update(material, original, place);
  material.needsUpdate = true;
  return material;
}

/** An original that goes takes along what stood for it. */
function disposeReplacements(original) {
  for (const material of replacements.get(original).values()) material.dispose();
  replacements.get(original).clear();
}

/**
 * The class of materials that are shaded as cloth, for scenes of a client's own making.
 * @param {typeof import('three')} THREE - The client's own three.js module, 0.187.
 * @returns {Promise<new (parameters?: object) => import('three').MeshPhysicalMaterial>} Takes the parameters of a
 *   MeshPhysicalMaterial, and `fabric` and `diffuseTransmission`: the glTF extensions TELAR_materials_fabric and
 *   KHR_materials_diffuse_transmission as objects, with THREE.Texture in place of references to textures.
 */
export async function loadFabricMaterial(THREE) {
  return (await import('./shading/index.mjs')).loadShading(THREE, 'fabric');
}
