/**
 * A term of another release in each slot, and the case that catches it: what telar draws as 0.180 with this one term in place of its
 * own is over the bar of the gate.
 * @type {Record<keyof typeof import('../../js/shot/three_terms.mjs').THREE_SLOTS, [term: string, item: string]>}
 */
// biome-ignore format: one slot a line
export const PLANTED = {
  prefilter: ['blur', 'env-lamps'],
  backgroundCube: ['half', 'transmission-tone'],
  reflectionDirection: ['roughness-4', 'env-lamps'],
  dfg: ['table-32', 'light-directional'],
  environmentMetal: ['two-interfaces', 'env-studio'],
  directMultiscatter: ['turquin', 'light-directional'],
  directDiffuse: ['under-fresnel', 'base-color-map'],
  ambientDiffuse: ['under-interface', 'light-hemisphere'],
  sheenAlbedo: ['exponential', 'sheen-sun'],
  sheenEnergy: ['albedo', 'sheen-sun'],
  ambientSheen: ['albedo', 'sheen-hemisphere'],
  filmMetal: ['two-films', 'everything'],
  filmEnvironment: ['schlick-f0', 'iridescence-env'],
  anisotropicVisibility: ['floored', 'anisotropy-sun'],
  anisotropyDirection: ['turned-back', 'anisotropy-sun'],
  roughnessMin: ['0.045', 'light-directional'],
  diffuseRoughness: ['eon', 'diffuse-roughness-sun'],
  bump: ['none', 'bump-map'],
  layerOcclusion: ['none', 'everything'],
  ior0: ['infinite', 'ior-0-hemisphere'],
  rectF90: ['of-material', 'rect-specular'],
  rectCoat: ['own-lobe', 'rect-clearcoat'],
  shadowFilter: ['depth-disk', 'shadow-directional'],
  shadowPacking: ['below-one', 'shadow-beyond-far'],
  shadowIntensity: ['whole', 'shadow-half'],
  shadowNormalOffset: ['own-place', 'shadow-no-normals'],
  pointShadow: ['range-compared', 'shadow-point'],
  dispersion: ['none', 'transmission-dispersion'],
  glassBackground: ['half-white', 'transmission-color'],
  glassBackSides: ['none', 'transmission-two-sided'],
  glassBuffer: ['square-1024', 'transmission'],
  glassSamples: ['of-canvas', 'transmission-aliased-gradient'],
  glassAlpha: ['added-tenth', 'transmission'],
  samplerPrecision: ['lowp', 'shadow-spot'],
  textureTransform: ['trs', 'texture-transform'],
  textureCoordinates: ['first-map', 'two-uv-sets'],
  neutralToneMapping: ['white', 'tone-neutral'],
  environmentRotation: ['columns', 'env-turned'],
  sorting: ['origin', 'alpha-blend-origins'],
  instanceColor: ['none', 'instances-colors'],
  instanceTangents: ['of-mesh', 'instances-tangents'],
  flippedTangents: ['kept', 'alpha-blend-bumpy-tangents'],
  flatFrames: ['turned', 'flat-normal-map-sides'],
  morphColors: ['no-program', 'morph-colors'],
  lineMap: ['none', 'lines-map'],
};

/** The release that they are planted in: of a family without a term of its own that is today's in every other slot. */
export const PLANTED_REVISION = 180;
