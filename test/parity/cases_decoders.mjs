// Compressed textures and meshes: KTX2 with Basis Universal, meshopt, Draco.
import { DECODER_MODELS } from '../fixtures/scenes_decoders.mjs';
import { sharedCases } from './cases_files.mjs';
import { makeCase as make } from './make_case.mjs';
import { LIGHTS } from './shot.mjs';

const lights = [LIGHTS.ambient, LIGHTS.directional];

/**
 * Drawn with the texels that the files hold: what a browser transcodes them to depends on its GPU (known_differences.mjs). The
 * odd size is left out, since KTX2Loader pads such a texture for blocks and then has too few texels for it uncompressed.
 */
const models = Object.keys(DECODER_MODELS).filter((name) => name !== 'ktx2-odd-size');
const FAST = ['ktx2-etc1s-alpha', 'ktx2-levels', 'ktx2-raw-rgba16f', 'ktx2-raw-two-levels', 'ktx2-blocks-bc7-srgb', 'meshopt-torus'];
const exact = models.map((name) => ({ ...make(`${name}-sun`, name, null, { lights }, FAST.includes(name)), textures: 'uncompressed' }));

const MODELS = [
  ['box-meshopt', 'BoxMeshopt/BoxMeshopt.glb', 35, 25],
  ['box-meshopt-gltf', 'BoxMeshopt/BoxMeshopt.gltf', 35, 25],
  ['pirate', 'meshopt_pirate/pirate.glb', 20, 10],
];

/** @type {import('./cases.mjs').Case[]} */
export const CASES = [...exact, ...sharedCases(MODELS)];
