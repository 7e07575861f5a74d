/**
 * What a picture has to have for any term of a slot of three.js to show: one of these in info.features. A slot that is not here may
 * show in every picture. Counts of lights stand before their names there.
 */
const NEEDED = {
  reflectionDirection: ['environment'],
  environmentMetal: ['environment'],
  directMultiscatter: ['point-light', 'spot-light', 'directional-light'],
  directDiffuse: ['point-light', 'spot-light', 'directional-light'],
  ambientDiffuse: ['ambient-light', 'hemisphere-light'],
  sheenAlbedo: ['sheen'],
  sheenEnergy: ['sheen'],
  ambientSheen: ['sheen'],
  filmMetal: ['iridescence'],
  filmEnvironment: ['iridescence'],
  anisotropicVisibility: ['anisotropy'],
  anisotropyDirection: ['anisotropy'],
  diffuseRoughness: ['diffuse-roughness'],
  layerOcclusion: ['occlusion-map'],
  rectF90: ['rect-light'],
  rectCoat: ['rect-light'],
  dispersion: ['dispersion'],
  glassAlpha: ['transmission'],
  neutralToneMapping: ['tone-mapping-neutral'],
};

/** "2 rect-lights" as "rect-light". */
const plain = (feature) => feature.replace(/^\d+ (.*?)s?$/, '$1');

/**
 * @param {string} slot - Of the principled shadings or of three.js.
 * @param {string[]} features - Of the pictures by either shading; a path traced one tells none.
 * @returns {boolean} Whether a swap in it can change the picture.
 */
export function mayShow(slot, features) {
  const needed = NEEDED[slot];
  return needed === undefined || features.length === 0 || features.some((feature) => needed.includes(plain(feature)));
}
