import { capital, LAYERS, texturesOf, textureName, upper } from '../../material/table.mjs';

// The names that three.js has for what shaders/ uses. Those of layers are from js/material/table.mjs.

/** Features that three.js decides by itself, or that it never has. */
const FIXED = {
  UNLIT: 0,
  ORTHOGRAPHIC: 0,
  AMBIENT: 1,
  TRANSMISSION: 0,
  FULL_DETAIL: 0,
  OWN_PLACES: 0,
  ENVIRONMENT_SAMPLES: 0,
  DISK_LIGHTS: 0,
  ALL_TERMS: 0,
  SAMPLE_MASK: 0,
  FLAT_SHADOWS: 0,
  CUBE_SHADOWS: 0,
};

/** Of cloth, beside its layers. */
const CLOTH = [
  'NORMAL_VARIANCE',
  'NORMAL_FACETS',
  'ALPHA_TO_COVERAGE',
  'ALPHA_MEANS',
  'NORMAL_HOLES',
  'METAL_MEANS',
  'METAL_YARNS',
  'YARN_RELIEF',
  'AMBIENT_VISIBILITY',
  'AMBIENT_VISIBILITY_BACK',
];

/** Feature of surface.frag: the condition under which three.js has it, as its preprocessor knows it. */
const CORE = {
  FLAT_SHADED: 'defined(FLAT_SHADED)',
  DOUBLE_SIDED: 'defined(DOUBLE_SIDED)',
  FLIP_SIDED: 'defined(FLIP_SIDED)',
  INSTANCING: 'defined(USE_INSTANCING)',
  TANGENT: 'defined(USE_TANGENT)',
  TANGENT_FRAME_UV0: 'defined(USE_ANISOTROPY) || defined(USE_UV)',
  NORMAL_MAP: 'defined(USE_NORMALMAP_TANGENTSPACE)',
  OCCLUSION_MAP: 'defined(USE_AOMAP)',
  ENVIRONMENT: 'defined(USE_ENVMAP) && defined(ENVMAP_TYPE_PMREM)',
};

/** Counts: three.js writes numbers in place of its own names. */
export const COUNTS = {
  HEMISPHERE_LIGHTS: 'NUM_HEMI_LIGHTS',
  RECT_LIGHTS: 'NUM_RECT_AREA_LIGHTS',
  POINT_LIGHTS: 'NUM_POINT_LIGHTS',
  SPOT_LIGHTS: 'NUM_SPOT_LIGHTS',
  DIRECTIONAL_LIGHTS: 'NUM_DIR_LIGHTS',
};

const ofThree = LAYERS.filter(({ three }) => three);

/** Define of three.js for a map: "sheenColor" as USE_SHEEN_COLORMAP. */
const mapDefine = (name) => `USE_${upper(name)}MAP`;

/** @type {Record<string, string>} */
export const FEATURES = {
  ...CORE,
  ...Object.fromEntries(
    ofThree.flatMap((layer) => [
      [upper(layer.name), `defined(${layer.three})`],
      ...texturesOf(layer).map((texture) => [`${upper(textureName(texture))}_MAP`, `defined(${mapDefine(texture.three)})`]),
    ]),
  ),
};

/** Layers that three.js has no name for and a family of shadings reads. */
export const ownLayers = (family) => LAYERS.filter(({ shadings }) => shadings?.includes(family));

/** Features of which a family knows the value. */
export function fixedFeatures(family) {
  const absent = LAYERS.filter(({ shadings }) => shadings && !shadings.includes(family)).flatMap((layer) => [
    upper(layer.name),
    ...texturesOf(layer).map((texture) => `${upper(textureName(texture))}_MAP`),
  ]);
  const cloth = family === 'fabric' ? [] : CLOTH;
  const suns = family === 'three' ? ['SUNS'] : [];
  return { ...FIXED, ...Object.fromEntries([...absent, ...cloth, ...suns].map((name) => [name, 0])) };
}

/** Map and texture coordinates: of three.js where it has a name for them. */
const lookupOf = (texture, three) =>
  three ? { map: `${three}Map`, uv: `v${capital(three)}MapUv` } : { map: `${textureName(texture)}Map`, uv: `v${capital(textureName(texture))}Uv` };

/** How withLayerInputs() reads factors and texels. */
export const INPUT_NAMES = {
  factor: ({ three, key, name }) => three ?? name ?? key,
  texel: (texture, row) => {
    const { map, uv } = lookupOf(texture, row.three);
    return `texture(${map}, ${uv})`;
  },
  lookup: (texture) => lookupOf(texture, texture.three),
};
