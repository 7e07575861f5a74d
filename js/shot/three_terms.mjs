/**
 * What the releases of three.js draw, as a table of terms: each slot has the terms that stood in it, and a release is one choice for
 * every slot. The one source of the names: the schema, the C++ enums (renderer/include/telar/three_terms.inc) and the defines of the
 * shaders (shaders/shading/three_terms.glsl) are written from it by js/build/docs/generate.mjs. Releases go by their number N of
 * 0.N. What each term computes and how it was found stands in js/docs/families.md.
 */

/** The release that "three" alone means, and the newest of the table. */
export const REVISION = 187;

/** The oldest release of the table. */
export const REVISION_MIN = 150;

/** slot: {term: first release that draws so}, newest first: the first term is that of "three" alone. */
export const THREE_SLOTS = Object.freeze({
  // Light of the environment.
  prefilter: { cube: 187, 'ggx-chain-interpolated': 186, 'ggx-chain': 182, 'ggx-chain-floor': 181, 'blur-from-end': 164, blur: 150 },
  backgroundCube: { full: 161, half: 150 },
  environmentRotation: { direction: 162, columns: 150 },
  reflectionDirection: { 'roughness-4': 181, 'roughness-2': 150 },
  // The split sum, and what bounces more than once.
  dfg: { 'table-16': 182, 'table-32': 181, karis: 150 },
  environmentMetal: { 'two-interfaces': 182, 'one-interface': 150 },
  directMultiscatter: { turquin: 186, 'added-lobe': 182, 'added-lobe-squared': 181, none: 150 },
  directDiffuse: { 'under-fresnel': 186, lambert: 150 },
  ambientDiffuse: { 'under-interface': 186, lambert: 150 },
  // Layers.
  sheenAlbedo: { exponential: 182, 'two-ranges': 150 },
  sheenEnergy: { albedo: 182, constant: 150 },
  ambientSheen: { albedo: 186, none: 150 },
  filmMetal: { 'two-films': 182, 'one-film': 150 },
  filmEnvironment: { 'schlick-f0': 186, reflectance: 150 },
  anisotropicVisibility: { floored: 184, unbounded: 182, saturated: 150 },
  anisotropyDirection: { vector: 159, 'turned-back': 153, none: 150 },
  roughnessMin: { 0.045: 187, 0.0525: 150 },
  diffuseRoughness: { eon: 187, none: 150 },
  bump: { drawn: 159, none: 150 },
  layerOcclusion: { occluded: 158, none: 150 },
  ior0: { infinite: 184, zero: 150 },
  // Lights and shadows.
  rectF90: { 'of-material': 183, one: 150 },
  rectCoat: { 'own-lobe': 183, none: 150 },
  shadowFilter: { 'depth-disk': 182, 'packed-grid': 150 },
  shadowPacking: { 'to-one': 167, 'below-one': 150 },
  shadowIntensity: { part: 166, whole: 150 },
  shadowNormalOffset: { 'own-place': 184, 'no-place': 150 },
  pointShadow: { 'own-face': 187, 'range-lit': 163, 'range-compared': 150 },
  // Glass.
  dispersion: { 'three-rays': 164, none: 150 },
  glassBackground: { linear: 165, 'half-white': 153, 'as-canvas': 150 },
  glassBackSides: { drawn: 151, none: 150 },
  glassBuffer: { canvas: 153, 'square-1024': 150 },
  glassSamples: { four: 184, 'of-canvas': 182, 'four-always': 154, 'of-antialias': 150 },
  glassAlpha: { transmittance: 153, 'added-tenth': 150 },
  // Textures and output.
  samplerPrecision: { highp: 161, lowp: 150 },
  textureTransform: { trs: 186, tsr: 150 },
  textureCoordinates: { 'each-map': 151, 'first-map': 150 },
  neutralToneMapping: { peak: 163, white: 150 },
  sorting: { 'bounding-sphere': 166, 'bounding-sphere-divided': 152, origin: 150 },
  // What the loader and the vertex stage make of a mesh.
  instanceColor: { drawn: 158, none: 150 },
  instanceTangents: { turned: 159, 'of-mesh': 150 },
  flippedTangents: { kept: 185, turned: 150 },
  flatFrames: { turned: 185, kept: 151, 'turned-before': 150 },
  morphColors: { drawn: 187, 'no-program': 183, 'drawn-before': 150 },
  lineMap: { drawn: 151, none: 150 },
});

/** Releases whose first patches draw otherwise; their number means the patch that is named. */
export const PATCHES = Object.freeze({ 156: '0.156.1', 181: '0.181.2' });

const termAt = (terms, revision) => Object.keys(terms).find((name) => terms[name] <= revision);

/** The release of the table that stands for one outside of it. */
export const nearestRevision = (revision) => Math.min(Math.max(revision, REVISION_MIN), REVISION);

/**
 * Every slot of a release.
 * @param {number} revision - N of 0.N; beyond the table, the nearest in it.
 * @returns {Record<keyof typeof THREE_SLOTS, string>}
 */
export function termsOfRevision(revision) {
  const known = nearestRevision(revision);
  return Object.fromEntries(Object.entries(THREE_SLOTS).map(([slot, terms]) => [slot, termAt(terms, known)]));
}

/** First releases of the families, oldest first: no term changes between one and the next. */
const BORDERS = [...new Set(Object.values(THREE_SLOTS).flatMap((terms) => Object.values(terms)))].sort((a, b) => a - b);

/**
 * The releases that draw as this one does.
 * @param {number} revision - Beyond the table, the nearest in it.
 * @returns {{from: number, to: number}} Both inclusive.
 */
export function familyOf(revision) {
  const known = nearestRevision(revision);
  const next = BORDERS.find((border) => border > known);
  return { from: BORDERS.findLast((border) => border <= known), to: next === undefined ? REVISION : next - 1 };
}

/** Whether a shading is stock three.js, of whatever release. @param {string | object | null} shading - Resolved or not. */
export const isRelease = (shading) => shading === 'three' || shading?.base === 'three';

/** N of the release 0.N that such a shading is of. */
export const releaseOf = (shading) => shading.revision ?? REVISION;

/** "three.js 0.165 to 0.180" */
export const familyName = ({ from, to }) => (from === to ? `three.js 0.${from}` : `three.js 0.${from} to 0.${to}`);

/**
 * Why a picture may not be what a client of this release shows.
 * @param {number} revision
 * @returns {string | undefined} What is drawn in its place; undefined where the table has the release.
 */
export function revisionRemark(revision) {
  const known = nearestRevision(revision);
  if (known !== revision) return `three.js 0.${revision} is not known, which are 0.${REVISION_MIN} to 0.${REVISION}: drawn as the nearest, 0.${known}`;
  if (PATCHES[revision]) return `three.js 0.${revision} is drawn as ${PATCHES[revision]} and later: the patches before it show other pictures`;
  return undefined;
}

/** @returns {{from: number, to: number}[]} Oldest first. */
export const families = () => BORDERS.map((from) => familyOf(from));

/**
 * Every slot written out; "three" alone where nothing differs from it.
 * @param {{base: 'three', revision?: number}} shading - A release, with the slots that differ from it.
 * @returns {'three' | {base: 'three', revision: number} & Record<keyof typeof THREE_SLOTS, string>}
 */
export function resolveThree({ base, revision = REVISION, ...swapped }) {
  const terms = { ...termsOfRevision(revision), ...Object.fromEntries(Object.entries(swapped).filter(([, term]) => term !== undefined)) };
  const isToday = revision === REVISION && Object.entries(THREE_SLOTS).every(([slot, names]) => terms[slot] === Object.keys(names)[0]);
  return isToday ? base : { base, revision, ...terms };
}
