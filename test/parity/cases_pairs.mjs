// What acts on each other across layers, textures and geometry.
import { PAIR_MODELS } from '../fixtures/scenes_pairs.mjs';
import { makeCase } from './make_case.mjs';
import { LIGHTS } from './shot.mjs';

const { ambient, directional, point } = LIGHTS;

/** Grids of balls are seen from the front, everything else from the upper right. */
const GRIDS = /^(iridescence|sheen|clearcoat|emissive)-/;
const cameraOf = (model) => (GRIDS.test(model) ? 'front' : 'quarter');

/** Part of the subset that `npm test` draws. */
const FAST = ['emissive-strength', 'mirrored-uvs-layers', 'scaled-rings'];

/** @type {import('./cases.mjs').Case[]} */
export const CASES = [
  ...Object.keys(PAIR_MODELS).flatMap((model) => [
    makeCase(`${model}-sun`, model, null, { lights: [ambient, directional], camera: cameraOf(model) }),
    makeCase(`${model}-env`, model, 'lamps', { camera: cameraOf(model) }, FAST.includes(model)),
  ]),
  makeCase('mirrored-uvs-512', 'mirrored-uvs', 'studio', { size: 512, lights: [point] }),
  makeCase('scaled-rings-layers-512', 'scaled-rings-layers', 'studio', { size: 512, lights: [point] }),
  makeCase('emissive-strength-aces', 'emissive-strength', 'gradient', { camera: 'front', toneMapping: 'aces', exposure: 0.5 }),
];
