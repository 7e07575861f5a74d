import { shadingMaterialClass } from './material.mjs';
import { bakedTexture } from './texture_bake.mjs';

/**
 * What cloth has beyond a MeshPhysicalMaterial: js/docs/fabric.md is the table of it.
 * @typedef {object} Cloth
 * @property {object | null} fabric - As the glTF extension TELAR_materials_fabric, with THREE.Texture in place of references.
 * @property {object | null} diffuseTransmission - As KHR_materials_diffuse_transmission, likewise.
 */

/** Map: [name of its uniform and varying, define]. */
const MAPS = {
  diffuseTransmission: 'DIFFUSE_TRANSMISSION',
  diffuseTransmissionColor: 'DIFFUSE_TRANSMISSION_COLOR',
  weave: 'WEAVE',
  backColor: 'BACK_COLOR',
};

/** Uniform of a normal map that was made anew, and the material's own map. */
const VARIANCE_MAPS = { normalVarianceMap: 'normalMap', clearcoatNormalVarianceMap: 'clearcoatNormalMap' };

/**
 * The class FabricMaterial: a MeshPhysicalMaterial that is shaded as cloth.
 * @param {typeof import('three')} THREE
 * @param {import('./material.mjs').ShadingText} text
 * @param {Record<string, string>} textureShaders - Module js/dist/shading/texture.mjs.
 */
export function fabricMaterialClass(THREE, text, textureShaders) {
  return class FabricMaterial extends shadingMaterialClass(THREE, text, 'fabric') {
    isFabricMaterial = true;

    /** @type {object | null} - As the glTF extension TELAR_materials_fabric, with THREE.Texture in place of references. */
    fabric = null;

    /** @type {object | null} - As KHR_materials_diffuse_transmission, likewise. */
    diffuseTransmission = null;

    #uniforms = {};

    /** @param {object} [parameters] - As of MeshPhysicalMaterial, and `fabric` and `diffuseTransmission`. */
    constructor(parameters) {
      super();
      if (parameters) this.setValues(parameters);
    }

    textDefines() {
      const maps = mapsOf(this);
      const defines = { ...super.textDefines(), ...featuresOf(this, maps) };
      return Object.fromEntries(Object.entries(defines).filter(([name]) => text.features.includes(name)));
    }

    textUniforms() {
      const values = { ...factorsOf(THREE, this), ...textureValues(mapsOf(this)), ...Object.fromEntries(Object.keys(VARIANCE_MAPS).map((name) => [name, this.#uniforms[name]?.value ?? null])) };
      for (const [name, value] of Object.entries(values)) {
        if (!text.uniforms.includes(name)) continue;
        this.#uniforms[name] ??= { value: null };
        this.#uniforms[name].value = value;
      }
      return this.#uniforms;
    }

    onBeforeCompile(shader) {
      // Declares the attribute of the second set of texture coordinates, which three.js leaves out where no map of its own has it.
      if (Object.values(mapsOf(this)).some((map) => map.channel === 1)) this.defines.USE_UV1 = '';
      super.onBeforeCompile(shader);
    }

    /** Before each draw: what has changed since reaches the program, and maps that are new are made anew. */
    onBeforeRender(renderer) {
      const uniforms = this.textUniforms();
      for (const [name, key] of Object.entries(VARIANCE_MAPS)) {
        if (this[key] && uniforms[name]) uniforms[name].value = bakedTexture(THREE, textureShaders, renderer, 'slope', this[key]);
      }
    }

    copy(source) {
      super.copy(source);
      this.fabric = source.fabric ?? null;
      this.diffuseTransmission = source.diffuseTransmission ?? null;
      return this;
    }
  };
}

/** @returns {Record<string, import('three').Texture>} Textures that are there, by the name of their uniform. */
function mapsOf({ fabric, diffuseTransmission }) {
  const isThin = diffuseTransmission?.diffuseTransmissionFactor > 0;
  const maps = {
    diffuseTransmission: isThin && diffuseTransmission.diffuseTransmissionTexture,
    diffuseTransmissionColor: isThin && diffuseTransmission.diffuseTransmissionColorTexture,
    weave: fabric?.weave?.weaveTexture,
    backColor: fabric?.back?.baseColorTexture,
  };
  return Object.fromEntries(Object.entries(maps).filter(([, map]) => map));
}

/** Defines of 0 or 1, as renderer/pass sets them. */
function featuresOf({ fabric, diffuseTransmission }, maps) {
  const features = {
    DIFFUSE_TRANSMISSION: diffuseTransmission?.diffuseTransmissionFactor > 0,
    FLATNESS: fabric?.flatness > 0,
    WEAVE: Boolean(fabric?.weave),
    BACK: Boolean(fabric?.back),
    NORMAL_VARIANCE: false,
  };
  for (const [name, define] of Object.entries(MAPS)) {
    features[`${define}_MAP`] = name in maps;
    features[`${define}_UV1`] = maps[name]?.channel === 1;
  }
  return Object.fromEntries(Object.entries(features).map(([name, value]) => [name, Number(value)]));
}

function textureValues(maps) {
  return Object.fromEntries(Object.entries(maps).flatMap(([name, map]) => {
    if (map.matrixAutoUpdate) map.updateMatrix();
    return [[`${name}Map`, map], [`${name}UvTransform`, map.matrix]];
  }));
}

const WHITE = [1, 1, 1];

/** Factors by the name of their uniform, with the extensions' defaults. */
function factorsOf(THREE, { fabric, diffuseTransmission, roughness }) {
  const vector = (value = WHITE) => (value.isColor ? new THREE.Vector3(value.r, value.g, value.b) : new THREE.Vector3().fromArray(value));
  const { warp = {}, weft = {}, threadsPerUv = [0, 0] } = fabric?.weave ?? {};
  const pair = (key, fallback) => new THREE.Vector2(warp[key] ?? fallback, weft[key] ?? fallback);
  const coverage = pair('coverage', 0.5);
  coverage.divideScalar(Math.max(coverage.x + coverage.y, 1));
  return {
    diffuseTransmissionFactor: diffuseTransmission?.diffuseTransmissionFactor ?? 0,
    diffuseTransmissionColorFactor: vector(diffuseTransmission?.diffuseTransmissionColorFactor),
    flatness: fabric?.flatness ?? 0,
    yarnCoverage: coverage,
    yarnRoughness: pair('roughnessFactor', 0.5),
    yarnAnisotropy: pair('anisotropyStrength', 0),
    warpSpecularColor: vector(warp.specularColorFactor),
    weftSpecularColor: vector(weft.specularColorFactor),
    threadsPerUv: new THREE.Vector2().fromArray(threadsPerUv),
    backColorFactor: vector(fabric?.back?.baseColorFactor),
    backRoughness: fabric?.back?.roughnessFactor ?? roughness,
  };
}
