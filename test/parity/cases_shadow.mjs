// Shadows: each kind of light alone, what casts and receives, the ground over each background, other scales.
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { FABRIC_MODELS, MODELS } from '../fixtures/index.mjs';
import { boundsOf, readDocument } from './bounds.mjs';
import { ASSETS } from './places.mjs';
import { CAMERAS, CASE_ENVIRONMENT, LIGHTS, shot } from './shot.mjs';

/** Part of the subset that `npm test` draws. */
const FAST = ['shadow-directional', 'shadow-point-room', 'ground-tshirt'];

const { ambient, directional } = LIGHTS;
const casting = (light, shadow) => ({ ...light, castShadow: true, ...(shadow && { shadow }) });
const SUN = casting({ ...directional, position: [1.5, 3, 2] });
const SPOT = casting({ type: 'spot', color: [1, 0.9, 0.7], intensity: 30, position: [1.2, 2.2, 1.6], target: [0, -0.2, 0], angle: 0.5, penumbra: 0.3 });
const POINT = casting({ type: 'point', color: [1, 0.8, 0.6], intensity: 8, position: [-0.9, 1.2, 1.1] });

async function boundsOfModel(model) {
  const bytes = model.startsWith('bundled:')
    ? readFileSync(path.join(ASSETS, model.slice('bundled:'.length)))
    : await (MODELS[model] ?? FABRIC_MODELS[model])();
  return boundsOf(readDocument(Buffer.from(bytes)));
}

/** @returns {Promise<import('./cases.mjs').Case>} */
async function make(name, model, overrides, environment) {
  const settings = { environment: environment ? CASE_ENVIRONMENT : 'none', ...overrides };
  return { name, model, environment, shot: shot(settings, await boundsOfModel(model)), fast: FAST.includes(name) };
}

const FIT = { view: 'three-quarter' };
const stage = (name, lights, overrides) => make(name, 'shadow-stage', { lights: [ambient, ...lights].map((light) => ({ ...light })), ...overrides });
const shirt = (name, overrides) => make(name, 'bundled:tshirt.glb', { size: 512, ...overrides }, 'studio');

const lightCases = [
  stage('shadow-directional', [SUN]),
  stage('shadow-spot', [SPOT]),
  stage('shadow-point', [POINT]),
  stage('shadow-from-above', [casting({ ...directional, position: [0, 3, 0] })]),
  stage('shadow-several', [SUN, { ...LIGHTS.point, intensity: 2 }, SPOT, POINT, casting({ ...directional, color: [0.3, 0.5, 1], position: [-2, 2, 1] })], {
    exposure: 0.5,
  }),
  stage('shadow-spot-range', [casting({ ...SPOT, range: 6, penumbra: 0 }), casting({ ...POINT, range: 4 })]),
  stage('shadow-spot-wide', [casting({ ...SPOT, angle: Math.PI / 2, position: [0.2, 0.9, 0.3], target: [0, -0.7, 0] })]),
  stage('shadow-soft', [casting(SUN, { radius: 8, mapSize: 512 })]),
  stage('shadow-coarse', [casting(SUN, { mapSize: 64, intensity: 0.6, radius: 0 }), casting(POINT, { mapSize: 32, intensity: 0.8 })]),
  stage('shadow-given', [casting(SUN, { bias: -0.01, normalBias: 0, left: -0.6, right: 0.8, bottom: -0.9, top: 0.7, near: 1, far: 5.2 })]),
  stage('shadow-acne', [casting(SUN, { bias: 0, normalBias: 0 })]),
  stage('shadow-ortho', [SUN], { camera: 'ortho-quarter' }),
  stage('shadow-samples-1', [SPOT], { quality: { samples: 1 } }),
  stage('shadow-512', [SUN], { size: 512 }),
];

/** Cloth that is lit from behind: its shadow is not to fall on itself, whatever kind of light casts it. */
const DRAPE = { projection: 'perspective', fovY: 30, position: [0.3, 0.25, 0.7], target: [0, -0.02, 0], near: 0.3, far: 1.6 };
const FROM_BEHIND = { position: [-0.5, 0.6, -1], target: [0, 0, 0] };
/** Light gets through what is blended, and falls on its folds. */
const sheerCases = Object.entries({
  directional: { ...directional, position: [1, 2, 1.5] },
  spot: { type: 'spot', intensity: 8, angle: 0.5, penumbra: 0.3, position: [0.5, 0.9, 0.6] },
  point: { type: 'point', intensity: 4, position: [-0.5, 0.8, 0.6] },
}).map(([name, light]) =>
  make(`shadow-sheer-${name}`, 'bundled:fabrics.glb', {
    camera: { ...DRAPE, position: [0.4, 0.55, 0.85], target: [0, 0.2, 0], near: 0.4, far: 2 },
    shading: 'fabric',
    lights: [{ ...ambient }, casting(light)],
    materials: { '*': { preset: 'chiffon', color: [0.7, 0.4, 0.45] } },
  }),
);

const behindCases = Object.entries({
  directional: { ...directional, ...FROM_BEHIND },
  spot: { type: 'spot', intensity: 8, angle: 0.5, penumbra: 0.3, ...FROM_BEHIND },
  point: { type: 'point', intensity: 4, position: FROM_BEHIND.position },
}).map(([kind, light]) => make(`shadow-cloth-${kind}`, 'fabric-velvet', { shading: 'fabric', camera: DRAPE, lights: [ambient, casting(light)] }));

const modelCases = [
  make('shadow-mask-sun', 'shadow-mask', { lights: [ambient, SUN] }),
  make('shadow-mask-point', 'shadow-mask', { lights: [ambient, POINT] }),
  make('shadow-point-room', 'shadow-room', { camera: 'front', lights: [casting({ type: 'point', intensity: 1.5, position: [0.05, 0.02, 0.1] })] }),
  make('shadow-point-room-soft', 'shadow-room', {
    camera: 'front',
    size: 512,
    lights: [casting({ type: 'point', intensity: 1.5, position: [0, 0, 0] }, { radius: 6, mapSize: 256 })],
  }),
  make('shadow-boxes', 'boxes', { lights: [ambient, SUN] }),
  make('shadow-topologies', 'topologies', { camera: 'front', lights: [ambient, SUN], ground: {} }),
  make('shadow-everything', 'physical-everything', { lights: [ambient, SUN], exposure: 0.5 }),
  make('shadow-model-lights', 'model-lights', { lights: [SUN] }),
  shirt('shadow-tshirt', { camera: { view: 'front' }, lights: [casting({ ...directional, position: [2, 3, 3] })] }),
];

const groundCases = [
  shirt('ground-tshirt', { camera: { view: 'front' }, ground: {} }),
  shirt('ground-tshirt-above', { camera: { azimuth: 30, elevation: 25 }, ground: {}, background: 'white' }),
  shirt('ground-tshirt-sun', { camera: FIT, ground: { opacity: 0.6 }, background: [0.5, 0.6, 0.7], lights: [SUN] }),
  shirt('ground-tshirt-environment', { camera: { azimuth: -40, elevation: 20 }, ground: { opacity: 0.8 }, background: 'environment' }),
  make('ground-spot', 'boxes', { lights: [ambient, SPOT], ground: { opacity: 0.7 } }),
  make('ground-point', 'boxes', { lights: [ambient, POINT], ground: { opacity: 1 }, background: 'white' }),
  make('ground-several', 'boxes', { lights: [SUN, SPOT, POINT, { ...SUN, intensity: 0, position: [-2, 2, 1] }], ground: {}, exposure: 0.6 }),
  make('ground-low-sun', 'boxes', {
    lights: [ambient, casting({ ...directional, position: [3, 0.4, -1] })],
    camera: { azimuth: 20, elevation: 35, fit: 0.3 },
    ground: {},
  }),
  make('ground-blend', 'alpha-blend-curved', { lights: [ambient, SUN], ground: {}, camera: { azimuth: 30, elevation: 30 } }),
  make('ground-sheer', 'alpha-blend-sheer', { shading: 'fabric', lights: [ambient, SUN], ground: {}, camera: { azimuth: 30, elevation: 30 } }),
  make('ground-agx', 'boxes', { lights: [ambient, SUN], ground: {}, toneMapping: 'agx', background: [0.2, 0.3, 0.5] }),
  make('ground-ortho', 'boxes', { lights: [ambient, SUN], ground: {}, camera: 'ortho-quarter' }),
  make('ground-samples-1', 'boxes', { lights: [ambient, SUN], ground: {}, quality: { samples: 1 } }),
  make('ground-from-below', 'boxes', { lights: [ambient, SUN], ground: {}, camera: { azimuth: 30, elevation: -30 } }),
];

/** The camera and the light of a scene that is `scale` times as large. */
const sized = (v, scale) => v.map((c) => c * scale);
function scaledCase(name, model, scale) {
  const { position, target, near, far, ...lens } = CAMERAS.quarter;
  const camera = { ...lens, position: sized(position, scale), target: sized(target, scale) };
  const lights = [ambient, { ...SUN, position: sized(SUN.position, scale) }];
  return make(name, model, { camera, lights, ground: {} });
}
const scaleCases = [scaledCase('shadow-tiny', 'shadow-tiny', 1e-6), scaledCase('shadow-huge', 'shadow-huge', 1e6)];

/** @type {import('./cases.mjs').Case[]} */
export const CASES = await Promise.all([...lightCases, ...sheerCases, ...behindCases, ...modelCases, ...groundCases, ...scaleCases]);
