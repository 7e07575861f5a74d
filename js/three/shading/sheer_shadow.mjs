import { revisionOf } from '../release.mjs';
import { PREFIX } from './material.mjs';

// Light gets through sheer cloth by its alpha (shaders/shadow/layer_threshold.glsl). three.js casts what is blended as if it were solid.

/** The first release whose shadow maps keep depth alone, as the text writes it. */
const DEPTH_ALONE = 182;

const ALPHA_TEST = '#include <alphatest_fragment>';

/** What a mesh casts its shadow with, where it is not three.js's own: for directional and spot lights, and for point lights. */
const CASTERS = { customDepthMaterial: 'MeshDepthMaterial', customDistanceMaterial: 'MeshDistanceMaterial' };

/** Materials by what they cast the shadow of. @type {WeakMap<import('three').Material, Record<string, import('three').Material>>} */
const made = new WeakMap();

/** Meshes that ask for them. */
const asking = new WeakSet();

const isSheer = (material) => material?.isFabricMaterial === true && material.transparent && !(material.alphaTest > 0);

/**
 * Has a mesh cast the shadow of sheer cloth while its material is a sheer FabricMaterial. What the client has it cast with stays.
 * @param {typeof import('three')} THREE
 * @param {import('three').Mesh} mesh
 * @param {string} text - Of the threshold.
 */
export function castSheerShadow(THREE, mesh, text) {
  if (asking.has(mesh) || revisionOf(THREE) < DEPTH_ALONE) return;
  asking.add(mesh);
  for (const key of Object.keys(CASTERS)) {
    let own = mesh[key];
    Object.defineProperty(mesh, key, {
      configurable: true,
      enumerable: true,
      get: () => own ?? (isSheer(mesh.material) ? casterOf(THREE, mesh.material, key, text) : undefined),
      set: (value) => {
        own = value;
      },
    });
  }
}

function casterOf(THREE, material, key, text) {
  if (!made.has(material)) made.set(material, {});
  const casters = made.get(material);
  if (!casters[key]) {
    casters[key] = sheerCaster(new THREE[CASTERS[key]](), material, text);
    // Its program goes with the material's, and comes again where that is drawn again.
    material.addEventListener('dispose', () => casters[key].dispose());
  }
  // three.js looks for another program where this changes: its map may have come, gone, or have other coordinates.
  casters[key].version = material.version;
  return casters[key];
}

/** three.js gives it the map and the sides of the material that it draws. */
function sheerCaster(caster, material, text) {
  const opacity = {
    get value() {
      return material.opacity;
    },
  };
  return Object.assign(caster, {
    onBeforeCompile(shader) {
      shader.uniforms[`${PREFIX}alphaFactor`] = opacity;
      const test = `if (${PREFIX}alphaFactor * diffuseColor.a <= ${PREFIX}layerThreshold()) discard;`;
      shader.fragmentShader = `uniform float ${PREFIX}alphaFactor;\n${text}\n${shader.fragmentShader.replace(ALPHA_TEST, test)}`;
    },
  });
}
