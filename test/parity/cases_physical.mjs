// The layers of KHR_materials_*: every feature alone, and the pairs that act on each other.
import { PHYSICAL_MODELS } from '../fixtures/scenes_physical.mjs';
import { sharedCases } from './cases_files.mjs';
import { CASE_ENVIRONMENT, LIGHTS, shot } from './shot.mjs';

const { ambient, directional, hemisphere, point, spot } = LIGHTS;

/** Models of one ring, seen from the upper right; all others are grids of balls, seen from the front. */
const RINGS = /normal|maps?$|map-tangents|second-uv|flat|blend|cloth|everything/;

/** Part of the subset that `npm test` draws. */
const FAST = ['clearcoat-two-normals-env', 'sheen-env', 'anisotropy-map-tangents-env', 'physical-everything-env'];

/** @returns {import('./cases.mjs').Case} */
function make(name, model, environment, overrides = {}) {
  const settings = { environment: environment ? CASE_ENVIRONMENT : 'none', camera: RINGS.test(model) ? 'quarter' : 'front', ...overrides };
  return { name, model, environment: environment ?? undefined, shot: shot(settings), fast: FAST.includes(name) };
}

/** Each model by direct light alone and by image-based light alone. */
const featureCases = Object.keys(PHYSICAL_MODELS).flatMap((model) => [
  make(`${model}-sun`, model, null, { lights: [ambient, directional] }),
  make(`${model}-env`, model, 'lamps'),
]);

/** What a layer adds or takes in a world of radiance 1, where a gain of energy is not cut off. */
const furnaceCases = ['clearcoat-metal', 'sheen-white-base', 'anisotropy', 'iridescence-metal', 'diffuse-roughness'].map((model) =>
  make(`${model}-furnace`, model, 'one', { toneMapping: 'linear', exposure: 0.8 }),
);

const lights = [ambient, hemisphere, directional, point, spot];
const otherCases = [
  make('physical-everything-lights', 'physical-everything', 'gradient', { lights, exposure: 0.4 }),
  make('physical-everything-ortho', 'physical-everything', 'lamps', { lights: [point], camera: 'ortho-quarter' }),
  make('physical-everything-rotated', 'physical-everything-tangents', 'lamps', { environment: { map: CASE_ENVIRONMENT, intensity: 0.7, rotation: 130 } }),
  make('clearcoat-512', 'clearcoat-two-normals-tangents', 'studio', { size: 512, lights: [point] }),
  make('sheen-cloth-512', 'sheen-cloth', 'studio', { size: 512, lights: [directional] }),
  make('anisotropy-512', 'anisotropy', 'studio', { size: 512, lights: [point] }),
  make('iridescence-512', 'iridescence', 'studio', { size: 512, lights: [directional] }),
];

const MODELS = [
  ['clearcoat-test', 'ClearCoatTest/ClearCoatTest.glb', 0, 0],
  ['specular-test', 'SpecularTest/SpecularTest.glb', 0, 0],
  ['anisotropy-strength', 'AnisotropyStrengthTest/AnisotropyStrengthTest.glb', 0, 0],
  ['anisotropy-rotation', 'AnisotropyRotationTest/AnisotropyRotationTest.glb', 0, 0],
  ['sheen-cloth', 'SheenCloth_playcanvas/SheenCloth.glb', 30, 20],
  ['golf-ball', 'GolfBall/GolfBall.glb', 20, 10],
];

/** @type {import('./cases.mjs').Case[]} */
export const CASES = [...featureCases, ...furnaceCases, ...otherCases, ...sharedCases(MODELS)];
