import { LAYERS, POLISHED, texturesOf, textureName, upper } from '../../material/table.mjs';
import { SLOTS } from '../../shot/shading_terms.mjs';
import { sunColors } from '../suns.mjs';
import { drawPartlyCovered } from './coverage.mjs';
import { shadingMaterialClass } from './material.mjs';
import { castSheerShadow } from './sheer_shadow.mjs';
import { featureDefines, termDefine } from './terms.mjs';
import { bakedTexture, reliefAxis } from './texture_bake.mjs';
import { drawFarToNear, isOrdered } from './triangle_order.mjs';

/** Map, as its uniform and varying are named: its texture in the extension, the define of it, and of what it is a part. */
const MAPS = Object.fromEntries(
  LAYERS.filter(({ shadings }) => shadings).flatMap((layer) =>
    texturesOf(layer).map((texture) => {
      const name = textureName(texture);
      return [name, { texture, extension: layer.extension, define: upper(name), of: upper(layer.name) }];
    }),
  ),
);

/**
 * Attributes of geometries, as GLTFLoader names those of the file. A geometry without one is open on that side: what WebGL reads
 * in place of a missing attribute is (0, 0, 0, 1).
 */
export const VISIBILITY_ATTRIBUTES = { front: '_telar_visibility', back: '_telar_visibility_back' };

/** Uniform of a normal map that was made anew, and the material's own map. */
const VARIANCE_MAPS = { normalVarianceMap: 'normalMap', clearcoatNormalVarianceMap: 'clearcoatNormalMap' };

/**
 * A class of materials that know what glTF says of cloth (js/docs/fabric.md is the table of it): FabricMaterial, and those of the principled shadings, which read a part
 * of it.
 * @param {typeof import('three')} THREE
 * @param {import('./material.mjs').ShadingText} text
 * @param {'fabric' | 'principled'} family
 * @param {Record<string, string>} textureShaders - Module js/dist/shading/texture.mjs.
 */
export function clothMaterialClass(THREE, text, family, textureShaders) {
  return class ClothMaterial extends shadingMaterialClass(THREE, text, family) {
    isFabricMaterial = family === 'fabric';

    /** @type {object | null} - As the glTF extension TELAR_materials_fabric, with THREE.Texture in place of references. */
    fabric = null;

    /** @type {object | null} - As KHR_materials_diffuse_transmission, likewise. */
    diffuseTransmission = null;

    /** Whether the geometries have tangents: a weave stands along them, also where no map of three.js needs them. */
    hasTangents = false;

    /** Which sides of the geometries have ambient visibility: attributes of the names in VISIBILITY_ATTRIBUTES. */
    visibleSides = { front: false, back: false };

    /** sunColors() of the scene that it is drawn in: what hides the environment from a surface hides its suns. */
    suns = [];

    /** Uniforms of the text, made once. */
    ownUniforms = {};

    /** Textures that were made of the material's own, by the name of their uniform. */
    madeMaps = { normalVarianceMap: null, clearcoatNormalVarianceMap: null, coverageMap: null, metalMap: null, yarnReliefMap: null };

    /** reliefAxis() of the normal map. */
    reliefAxis = new THREE.Vector2();

    /** textDefines() of the last draw. */
    compiledFor = '';

    coverageSamples = 1;

    coverageMask = 1;

    /** What the next draw shows, COVERAGE of coverage.mjs. */
    coverageDraw = 0;

    /** The same material for pixels that it covers in part (coverage.mjs). */
    coverageParts = [];

    /** @param {object} [parameters] - As of MeshPhysicalMaterial, and `fabric` and `diffuseTransmission`. */
    constructor(parameters) {
      super();
      if (parameters) this.setValues(parameters);
    }

    textDefines() {
      const parts = this.isFabricMaterial ? featuresOf(this) : principledFeatures(this);
      const features = Object.entries({ ...parts, ...mapFeatures(parts, mapsOf(this)) }).filter(([name]) => text.features.includes(name));
      return { ...super.textDefines(), ...Object.fromEntries(features), ...(needsTangents(this) && { OWN_TANGENTS: 1 }), SUNS: this.suns.length };
    }

    textUniforms() {
      const values = {
        ...factorsOf(THREE, this),
        ...textureValues(mapsOf(this)),
        ...this.madeMaps,
        sunColors: this.suns,
        reliefAxis: this.reliefAxis,
        coverageSamples: this.coverageSamples,
        coverageMask: this.coverageMask,
        coverageDraw: this.coverageDraw,
      };
      for (const [name, value] of Object.entries(values)) {
        if (!text.uniforms.includes(name)) continue;
        this.ownUniforms[name] ??= { value: null };
        this.ownUniforms[name].value = value;
      }
      return this.ownUniforms;
    }

    onBeforeCompile(shader) {
      // What three.js leaves out of the vertex stage where no map of its own needs it.
      setDefine(
        this.defines,
        'USE_UV1',
        Object.values(mapsOf(this)).some((map) => map.channel === 1),
      );
      setDefine(this.defines, 'USE_UV', Boolean(this.fabric?.weave));
      setDefine(this.defines, 'USE_TANGENT', needsTangents(this));
      super.onBeforeCompile(shader);
    }

    /** Before each draw: what has changed since reaches the program, maps that are new are made anew, and triangles put in order. */
    onBeforeRender(...draw) {
      const [renderer, scene, , , object] = draw;
      this.suns = sunColors(scene);
      this.compileAnew();
      if (!this.isFabricMaterial) return this.textUniforms();
      // applyShading() has done so before the first shadow is drawn.
      if (object?.isMesh) this.castShadowOf(object);
      this.forceSinglePass = isOrdered(this, object);
      if (this.forceSinglePass) drawFarToNear(THREE, draw);
      if (makeMaps(this, { THREE, textureShaders, renderer })) drawPartlyCovered(this, draw);
      else this.textUniforms();
    }

    /** Has a mesh cast the shadow of sheer cloth while this material, or another sheer one of this class, is on it. */
    castShadowOf(mesh) {
      castSheerShadow(THREE, mesh, text.layerThreshold);
    }

    /** Has three.js choose the program anew where another one is needed: clients change factors and the places of maps without `needsUpdate`. */
    compileAnew() {
      const compiledFor = JSON.stringify(this.textDefines());
      if (this.compiledFor !== compiledFor) Object.assign(this, { compiledFor, needsUpdate: true });
    }

    /** Which of a pixel's samples, in bits, the pixels cover that the next draw is for, and what it shows. */
    setCoverage(samples, mask, draw) {
      Object.assign(this, { coverageSamples: samples, coverageMask: mask, coverageDraw: draw });
      this.textUniforms();
    }

    copy(source) {
      super.copy(source);
      this.fabric = source.fabric ?? null;
      this.hasTangents = source.hasTangents ?? false;
      this.visibleSides = { front: false, back: false, ...source.visibleSides };
      this.diffuseTransmission = source.diffuseTransmission ?? null;
      return this;
    }
  };
}

/**
 * Makes the maps of a FabricMaterial's own ones that are new, or were made as another kind.
 * @returns {boolean} whether pixels are drawn that the material covers in part
 */
function makeMaps(material, { THREE, textureShaders, renderer }) {
  const { NORMAL_VARIANCE, NORMAL_FACETS, ALPHA_TO_COVERAGE, ALPHA_MEANS, NORMAL_HOLES, METAL_MEANS, METAL_YARNS, YARN_RELIEF } = featuresOf(material);
  const { madeMaps, map, normalMap } = material;
  const baked = (kind, texture, beside) => bakedTexture(THREE, textureShaders, renderer, kind, texture, beside);
  const yarns = material.fabric?.weave?.weaveTexture;
  const kind = NORMAL_FACETS ? 'facets' : 'relief';
  const cutoff = ALPHA_TO_COVERAGE ? textureCutoff(material) : 0;
  if (NORMAL_VARIANCE) {
    for (const [name, key] of Object.entries(VARIANCE_MAPS)) {
      const holes = NORMAL_HOLES && key === 'normalMap' ? { cutoff, beside: map } : {};
      madeMaps[name] = baked(key === 'normalMap' ? kind : 'relief', material[key], holes);
    }
  }
  if (NORMAL_VARIANCE && !NORMAL_FACETS) material.reliefAxis = reliefAxis(THREE, textureShaders, renderer, normalMap);
  if (YARN_RELIEF) madeMaps.yarnReliefMap = baked('yarns', normalMap, { beside: yarns });
  if (METAL_MEANS) madeMaps.metalMap = baked('metal', map, { beside: material.metalnessMap, ...(METAL_YARNS && { yarns }) });
  if (ALPHA_TO_COVERAGE || ALPHA_MEANS) madeMaps.coverageMap = baked('coverage', map, { cutoff });
  return Boolean(ALPHA_TO_COVERAGE);
}

/** three.js gives tangents to normal maps and to anisotropy by itself. */
const needsTangents = ({ hasTangents, fabric, normalMap, anisotropy }) => Boolean(hasTangents && fabric?.weave && !normalMap && !(anisotropy > 0));

function setDefine(defines, name, isWanted) {
  if (isWanted) defines[name] = '';
  else delete defines[name];
}

/** The alpha of its map from which on a material with holes is there. */
const textureCutoff = ({ alphaTest, opacity }) => (opacity > 0 ? alphaTest / opacity : 2);

/** @returns {Record<string, import('three').Texture>} Textures that are there, by the name of their uniform. */
function mapsOf({ fabric, diffuseTransmission }) {
  const parts = {
    TELAR_materials_fabric: fabric,
    KHR_materials_diffuse_transmission: diffuseTransmission?.diffuseTransmissionFactor > 0 && diffuseTransmission,
  };
  const textureOf = ({ texture: { key, within }, extension }) => (within ? parts[extension]?.[within] : parts[extension])?.[key];
  return Object.fromEntries(
    Object.entries(MAPS)
      .map(([name, map]) => [name, textureOf(map)])
      .filter(([, map]) => map),
  );
}

/** Without yarns there is the one highlight of the material. */
function hasYarns(fabric) {
  const { warp, weft } = fabric?.weave ?? { warp: { coverage: 0 }, weft: { coverage: 0 } };
  return (warp?.coverage ?? 0.5) + (weft?.coverage ?? 0.5) > 0;
}

/** Defines of 0 or 1, as renderer/pass sets them. */
function featuresOf(material) {
  const { fabric, diffuseTransmission, map, alphaTest, transparent, normalMap, clearcoatNormalMap, visibleSides } = material;
  const features = {
    DIFFUSE_TRANSMISSION: diffuseTransmission?.diffuseTransmissionFactor > 0,
    FLATNESS: fabric?.flatness > 0,
    WEAVE: hasYarns(fabric),
    BACK: Boolean(fabric?.back),
    NORMAL_VARIANCE: Boolean(normalMap ?? clearcoatNormalMap),
    ALPHA_TO_COVERAGE: Boolean(map) && alphaTest > 0,
    ALPHA_MEANS: mayHaveAlpha(map) && transparent && !(alphaTest > 0),
    AMBIENT_VISIBILITY: visibleSides.front,
    AMBIENT_VISIBILITY_BACK: visibleSides.front && visibleSides.back,
  };
  const hasHoles = features.ALPHA_TO_COVERAGE || features.ALPHA_MEANS;
  features.NORMAL_HOLES = hasHoles && Boolean(normalMap) && samePlace(map, normalMap);
  const { metalnessMap, metalness } = material;
  const weaveMap = fabric?.weave?.weaveTexture;
  features.YARN_RELIEF = Boolean(normalMap && weaveMap) && features.WEAVE && !features.NORMAL_HOLES && samePlace(normalMap, weaveMap);
  features.METAL_MEANS = Boolean(map && metalnessMap) && metalness > 0 && !hasHoles && samePlace(map, metalnessMap);
  features.METAL_YARNS = features.METAL_MEANS && features.WEAVE && Boolean(weaveMap) && samePlace(map, weaveMap);
  const NORMAL_FACETS = Boolean(normalMap) && isPolished(material) && !features.WEAVE && !features.NORMAL_HOLES;
  return featureDefines({ ...features, NORMAL_FACETS });
}

/** As draw_list.cpp has it; GLTFLoader tells the type of a file. */
const mayHaveAlpha = (map) => Boolean(map) && map.userData.mimeType !== 'image/jpeg';

/** As hasFacets() of renderer/pass/plan/draw_list.cpp has it. */
const isPolished = ({ roughness, metalness, anisotropy }) => roughness <= POLISHED.roughnessMax && metalness >= POLISHED.metalnessMin && !(anisotropy > 0);

/** Sizes of a texture after which its texels come again; 0 where the last ones go on. @returns {import('three').Vector2} along u and v */
function periodOf(THREE, texture) {
  const along = (wrap) => ({ [THREE.RepeatWrapping]: 1, [THREE.MirroredRepeatWrapping]: 2 })[wrap] ?? 0;
  return new THREE.Vector2(along(texture?.wrapS), along(texture?.wrapT));
}

/** Whether two textures lie on each other. */
function samePlace(...textures) {
  const [a, b] = textures.map((texture) => {
    if (texture.matrixAutoUpdate) texture.updateMatrix();
    return texture;
  });
  return a.channel === b.channel && a.matrix.equals(b.matrix);
}

/** The part that the principled shadings read, where their diffuse lobe has a place for it. */
function principledFeatures({ fabric, diffuseTransmission, shadingDefines: { [termDefine('diffuse')]: diffuse } }) {
  const isThin = SLOTS.diffuse[diffuse] === 'disney-2015-thin';
  return featureDefines({
    FLATNESS: fabric?.flatness > 0 && (isThin || SLOTS.diffuse[diffuse] === 'disney-2012'),
    DIFFUSE_TRANSMISSION: diffuseTransmission?.diffuseTransmissionFactor > 0 && isThin,
  });
}

/** Which maps of the parts that are there there are, and which of them have the second set of texture coordinates. */
function mapFeatures(parts, maps) {
  const features = {};
  for (const [name, { define, of }] of Object.entries(MAPS)) {
    const map = parts[of] ? maps[name] : undefined;
    features[`${define}_MAP`] = map !== undefined;
    features[`${define}_UV1`] = map?.channel === 1;
  }
  return featureDefines(features);
}

function textureValues(maps) {
  return Object.fromEntries(
    Object.entries(maps).flatMap(([name, map]) => {
      if (map.matrixAutoUpdate) map.updateMatrix();
      return [
        [`${name}Map`, map],
        [`${name}UvTransform`, map.matrix],
      ];
    }),
  );
}

const WHITE = [1, 1, 1];

/** Factors by the name of their uniform, with the extensions' defaults. */
function factorsOf(THREE, { fabric, diffuseTransmission, roughness, normalMap }) {
  const vector = (value = WHITE) => (value.isColor ? new THREE.Vector3(value.r, value.g, value.b) : new THREE.Vector3().fromArray(value));
  const { warp = {}, weft = {}, threadsPerUv = [0, 0] } = fabric?.weave ?? {};
  const pair = (key, fallback) => new THREE.Vector2(warp[key] ?? fallback, weft[key] ?? fallback);
  const coverage = pair('coverage', 0.5);
  coverage.divideScalar(Math.max(coverage.x + coverage.y, 1));
  return {
    diffuseTransmissionFactor: diffuseTransmission?.diffuseTransmissionFactor ?? 0,
    diffuseTransmissionColorFactor: vector(diffuseTransmission?.diffuseTransmissionColorFactor),
    flatness: fabric?.flatness ?? 0,
    normalMapPeriod: periodOf(THREE, normalMap),
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
