import { TEXTS } from '../../dist/shading/index.mjs';
import { wornCloth } from '../cloths.mjs';
import { clothMaterialClass, VISIBILITY_ATTRIBUTES } from './cloth_material.mjs';
import { clothOf, extensionsOf, finishBack } from './fabric_layers.mjs';
import { shadingMaterialClass } from './material.mjs';
import { readNumbers } from './number_maps.mjs';
import { definesOfTerms } from './terms.mjs';

/** Classes by family, for each three.js module. */
const classes = new WeakMap();

/**
 * Class of the materials of one family of shadings.
 * @param {typeof import('three')} THREE
 * @param {string} family - three, principled, fabric; `three` is stock three.js by telar's own text, for tests.
 * @returns {Promise<new (parameters?: object) => import('three').MeshPhysicalMaterial>}
 */
export async function loadShading(THREE, family) {
  const text = await TEXTS[family]();
  if (!classes.has(THREE)) classes.set(THREE, {});
  const own = classes.get(THREE);
  own[family] ??= family === 'three' ? shadingMaterialClass(THREE, text, family) : clothMaterialClass(THREE, text, family, await TEXTS.texture());
  return own[family];
}

/**
 * How materials of a resolved shot's shading are made.
 * @param {typeof import('three')} THREE
 * @param {string | object} shading
 * @returns {Promise<{key: string, create: () => import('three').Material, update: (material: import('three').Material,
 *   original: import('three').Material, place: {model: object, mesh: import('three').Mesh, transmits: boolean}) => Promise<void>}>}
 */
export async function openShading(THREE, shading) {
  const hasTerms = typeof shading !== 'string';
  const Material = await loadShading(THREE, hasTerms ? 'principled' : shading);
  return {
    key: JSON.stringify(shading),
    create: () => new Material(),
    update: async (material, original, { model: { parser }, mesh, drawn, transmits }) => {
      const worn = wornCloth(original);
      const file = worn?.parser ?? parser;
      // Presets are of the shading "fabric" alone.
      const cloth = await clothOf(file, mesh, worn?.material ?? original, shading === 'fabric' ? TEXTS.presets : null);
      material.copy(cloth.material);
      worn?.finish(material);
      material.shadingDefines = hasTerms ? definesOfTerms(shading) : {};
      // GLTFLoader gives geometries with tangents materials of their own.
      if (shading === 'three') return;
      const extensions = await extensionsOf(file, cloth.definition, THREE, worn?.placed);
      finishBack(extensions.fabric, material);
      if (worn && extensions.diffuseTransmission) extensions.diffuseTransmission = worn.through(extensions.diffuseTransmission);
      // What is blended is not seen through glass.
      if (shading === 'fabric' && material.map && material.alphaTest > 0 && !transmits) {
        Object.assign(material, { transparent: true, depthWrite: false });
      }
      Object.assign(material, { hasTangents: mesh.geometry.attributes.tangent !== undefined, visibleSides: sidesOf(drawn) }, extensions);
      readNumbers(THREE, material);
      if (shading === 'fabric') for (const each of drawn) material.castShadowOf(each);
    },
  };
}

/** Which sides of any of the meshes know what they see. */
const sidesOf = (meshes) =>
  Object.fromEntries(
    Object.entries(VISIBILITY_ATTRIBUTES).map(([side, name]) => [side, meshes.some(({ geometry }) => geometry.attributes[name] !== undefined)]),
  );
