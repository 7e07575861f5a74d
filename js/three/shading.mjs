/** Material of a mesh in the model as loaded (or of its variant), by what stands in its place. */
const originals = new WeakMap();

/** Materials that stand for an original, by a shading's key. */
const replacements = new WeakMap();

/**
 * Puts the model's own materials back.
 * @param {import('three').Object3D} root
 */
export function restoreMaterials(root) {
  eachMaterial(root, (material) => originals.get(material) ?? material);
}

/**
 * Draws every lit material of a model with a shading of telar's. The original stays as it is and is put back by
 * `restoreMaterials`; one that several meshes share has one replacement.
 * @param {import('three').Object3D} root
 * @param {string | object} shading - Of a resolved shot; not "three".
 * @param {typeof import('three')} THREE
 */
export async function replaceMaterials(root, shading, THREE) {
  const { familyOf, definesOf, loadShading } = await import('./shading/index.mjs');
  const Material = await loadShading(THREE, familyOf(shading));
  const key = JSON.stringify(shading);
  const made = new Map();
  const replacementOf = (original) => {
    if (!made.has(original)) made.set(original, refreshed(original, key, Material, definesOf(shading)));
    return made.get(original);
  };
  eachMaterial(root, (material) => (material.isMeshStandardMaterial ? replacementOf(originals.get(material) ?? material) : material));
}

/** The replacement of an original in the state that the original has now. */
function refreshed(original, key, Material, defines) {
  if (!replacements.has(original)) {
    replacements.set(original, new Map());
    original.addEventListener('dispose', () => disposeReplacements(original));
  }
  const known = replacements.get(original);
  if (!known.has(key)) known.set(key, new Material());
  const material = known.get(key).copy(original);
  material.shadingDefines = defines;
  material.needsUpdate = true;
  originals.set(material, original);
  return material;
}

/** An original that goes takes along what stood for it. */
function disposeReplacements(original) {
  for (const material of replacements.get(original).values()) material.dispose();
  replacements.get(original).clear();
}

function eachMaterial(root, change) {
  root.traverse((object) => {
    if (!object.material) return;
    object.material = Array.isArray(object.material) ? object.material.map(change) : change(object.material);
  });
}
