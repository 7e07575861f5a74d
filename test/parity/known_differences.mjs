// Where three.js 0.187 is wrong and telar is not the same on purpose. Kept apart from the cases of the gate, which these
// would not pass; known_differences.test.mjs shows each fault in the real browser and telar's picture beside it.
import { makeCase } from './make_case.mjs';
import { LIGHTS } from './shot.mjs';

const SIZE = 64;
const SMALL = { size: SIZE, camera: 'front' };
/** Looks straight at the square of known-facing, which fills the frame. */
const FACING = { projection: 'orthographic', height: 2, near: 1, far: 8, position: [0, 0, 4], target: [0, 0, 0] };
/** Metres of the centre of a pixel column or row. */
const pixelCentre = (i) => ((i + 0.5) / SIZE) * 2 - 1;

/** The pixel of known-light-on-surface whose centre the light lies on, from the top left. */
export const LIT_PIXEL = [40, 24];

const sun = { lights: [LIGHTS.directional] };
const day = { lights: [LIGHTS.ambient, LIGHTS.directional] };
const rect = { type: 'rect', color: [1, 1, 1], intensity: 8, position: [0.5, 0.5, 1.5], target: [0, 0, 0], width: 1, height: 1 };
const onSurface = { type: 'point', intensity: 1, position: [pixelCentre(LIT_PIXEL[0]), -pixelCentre(LIT_PIXEL[1]), 0] };

/** @type {import('./cases.mjs').Case[]} */
export const KNOWN_CASES = [
  makeCase('known-anisotropy-no-uvs-sun', 'known-anisotropy-no-uvs', null, { ...SMALL, ...sun }),
  makeCase('known-anisotropy-no-uvs-env', 'known-anisotropy-no-uvs', 'lamps', SMALL),
  makeCase('known-sheen-roughness-zero', 'known-sheen-roughness-zero', null, { ...SMALL, ...sun }),
  makeCase('known-light-on-surface', 'known-facing-rough', null, { ...SMALL, camera: FACING, lights: [LIGHTS.directional, onSurface] }),
  makeCase('known-shared-texture', 'known-shared-texture', 'lamps', SMALL),
  makeCase('known-shared-texture-apart', 'known-shared-texture-apart', 'lamps', SMALL),
  makeCase('known-flattened', 'known-flattened', null, { ...SMALL, ...sun }),
  makeCase('known-rect-head-on', 'known-facing', null, { ...SMALL, camera: FACING, lights: [rect] }),
  // The same a hundredth of a degree aside, where three.js is right.
  makeCase('known-rect-aside', 'known-facing', null, { ...SMALL, camera: { ...FACING, position: [7e-4, 0, 4] }, lights: [rect] }),
  ...['all', 'some', 'none'].map((kind) => makeCase(`known-tangents-${kind}`, `known-tangents-${kind}`, null, { ...SMALL, size: 128, ...day })),
  makeCase('known-ktx2-etc1s', 'ktx2-etc1s', null, day),
  makeCase('known-ktx2-uastc', 'ktx2-uastc', null, day),
  makeCase('known-ktx2-odd-size', 'ktx2-odd-size', null, day),
];

/**
 * One fault of three.js.
 * @typedef {object} KnownDifference
 * @property {string} name - What it takes.
 * @property {string} three - What three.js 0.187 does.
 * @property {string} telar - What telar does in its place.
 * @property {string} source - Where in three.js's sources the fault is.
 * @property {string[]} cases - Names in KNOWN_CASES that show it.
 */

const PHYSICAL = 'ShaderChunk/lights_physical_pars_fragment.glsl.js';

/** @type {KnownDifference[]} */
export const KNOWN_DIFFERENCES = [
  {
    name: 'Anisotropy on a mesh without texture coordinates (or with collapsed ones)',
    three: 'The tangent frame is 0: highlights cover the whole surface or are not numbers, and the environment shows as one constant colour.',
    telar: 'Stretches the highlight along some direction that is square with the normal.',
    source: 'ShaderChunk/normalmap_pars_fragment.glsl.js, getTangentFrame: scale = 0 where det is 0',
    cases: ['known-anisotropy-no-uvs-sun', 'known-anisotropy-no-uvs-env'],
  },
  {
    name: 'Tangents of no length',
    three: 'A vertex with one makes its triangles not a number: they have no direct light.',
    telar: 'Puts the normal map of these triangles into the frame of its texture coordinates, as that of a mesh without tangents.',
    source: 'ShaderChunk/defaultnormal_vertex.glsl.js: normalize of 0',
    cases: ['known-tangents-some', 'known-tangents-none', 'known-tangents-all'],
  },
  {
    name: 'A sheen roughness map with a texel of 0',
    three: 'Sheen roughness is held above 0 before the map is multiplied in, so that 1 / 0 enters the lobe: direct light there is not a number.',
    telar: 'Holds it above 0 after the map too.',
    source: `ShaderChunk/lights_physical_fragment.glsl.js, sheenRoughness; ${PHYSICAL}, D_Charlie`,
    cases: ['known-sheen-roughness-zero'],
  },
  {
    name: 'A point or spot light exactly on the shaded point',
    three: 'The direction to the light is normalize(0). Most drivers hide it; rough diffuse and anisotropic materials are not numbers there: a black pixel.',
    telar: 'Such a light gives that point nothing, as it gives nothing to the points around it on the surface.',
    source: 'ShaderChunk/lights_pars_begin.glsl.js, getPointLightInfo',
    cases: ['known-light-on-surface'],
  },
  {
    name: 'A node that one axis of its scale flattens to 0',
    three: 'The matrix of its normals has no inverse and becomes 0: no normal is a number, and the surface is black.',
    telar: 'Turns normals by the cofactors of the matrix, which need no inverse.',
    source: 'math/Matrix3.js, getNormalMatrix and invert',
    cases: ['known-flattened'],
  },
  {
    name: 'A rect light on a surface seen head-on (an orthographic camera that faces a plane)',
    three: 'The frame of the tables is normalize(v - n (n.v)) = normalize(0): the light is lost altogether.',
    telar: 'Takes any frame about the normal: seen head-on the lobe is round.',
    source: `${PHYSICAL}, LTC_Evaluate`,
    cases: ['known-rect-head-on', 'known-rect-aside'],
  },
  {
    name: 'An image that is a colour in one place and numbers in another (roughness, normals, occlusion)',
    three: 'The loader has one texture for all uses of an image with the same sampler, and decodes sRGB in all of them where one is a colour.',
    telar: 'Decodes colours alone, as glTF says. So do its own shadings in the browser, which read a second texture.',
    source: 'examples/jsm/loaders/GLTFLoader.js, assignTexture and loadTextureImage',
    cases: ['known-shared-texture', 'known-shared-texture-apart'],
  },
  {
    name: 'Textures in Basis Universal (KTX2 with ETC1S or UASTC)',
    three:
      'KTX2Loader transcodes them to a format of the GPU: on Mesa to BC7, up to 26/255 from the texels of the file for ETC1S, 4/255 for UASTC (mean 0.1 to 0.5). Other GPUs get other texels.',
    telar: 'Draws the texels of the file. Kept from GPU formats, three.js draws the same: the ktx2-* cases of the gate.',
    source: 'examples/jsm/loaders/KTX2Loader.js, FORMAT_OPTIONS',
    cases: ['known-ktx2-etc1s', 'known-ktx2-uastc', 'known-ktx2-odd-size'],
  },
];
