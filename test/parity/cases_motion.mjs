// Skins, morph targets, animations at several times, instances.
import { existsSync } from 'node:fs';
import path from 'node:path';
import { MOTION_MODELS } from '../fixtures/scenes_motion.mjs';
import { SHARED_MODELS } from './places.mjs';
import { CASE_ENVIRONMENT, LIGHTS, shot } from './shot.mjs';

const { ambient, directional } = LIGHTS;

/** What every fixture keeps to; shadows are fitted to it. */
const BOX = { min: [-1, -1, -1], max: [1, 1, 1] };

/** Part of the subset that `npm test` draws. */
const FAST = ['skin-rest', 'skin-0-0.3', 'morph-colors-alpha-rest', 'instances-tangents-rest', 'animated-nodes-0-0.75'];

/** @returns {import('./cases.mjs').Case} */
function make(model, pose, overrides = {}) {
  const name = `${model}-${pose ? `${pose.animation}-${pose.time}` : 'rest'}`;
  const settings = { environment: CASE_ENVIRONMENT, lights: [ambient, directional], exposure: 0.6, pose, ...overrides };
  return { name, model, environment: 'lamps', shot: shot(settings, BOX), fast: FAST.includes(name) };
}

const restCases = Object.keys(MOTION_MODELS).map((model) => make(model, null));

/** Before the start, at it, between keyframes, on one, at the end and after it. */
const POSES = [
  ['skin', 0, [-1, 0, 0.3, 0.5, 0.85, 1, 9]],
  ['skin', 1, [0.1, 0.5, 0.8]],
  ['skin-tangents', 0, [0.4]],
  ['morph', 0, [0.25, 0.75]],
  ['morph', 1, [0.4, 1]],
  ['morph', 2, [0.6]],
  ['morph-node-weights', 0, [0.1]],
  ['morph-primitives', 0, [0.5]],
  ['morph-and-skin', 0, [0.6]],
  ['animated-nodes', 0, [0, 0.2, 0.75, 1]],
  ['animated-nodes', 1, [0, 0.45]],
];
const poseCases = POSES.flatMap(([model, animation, times]) => times.map((time) => make(model, { animation, time })));

/** What is deformed or drawn many times casts its shadow and receives others'. */
const shadowed = { lights: [ambient, { ...directional, castShadow: true }], exposure: 0.9 };
const shadowCases = [
  ['instances', null],
  ['instances-tangents', null],
  ['skin', { animation: 0, time: 0.85 }],
  ['morph-primitives', { animation: 0, time: 0.5 }],
].map(([model, pose]) => ({ ...make(model, pose, shadowed), name: `${model}-shadow` }));

/** [name, path, bounds, azimuth, elevation, animation or null, times]: bounds that hold every pose. */
const SHARED = [
  [
    'morph-cube',
    'AnimatedMorphCube/glTF/AnimatedMorphCube.gltf',
    [
      [-1.5, -1.5, -1.5],
      [1.5, 1.5, 1.5],
    ],
    35,
    25,
    0,
    [0, 1, 2.5],
  ],
  [
    'cesium-man',
    'CesiumMan/glTF_Binary/CesiumMan.glb',
    [
      [-0.6, 0, -0.6],
      [0.6, 1.55, 0.6],
    ],
    30,
    10,
    0,
    [0, 0.4, 1.1, 1.75],
  ],
  [
    'interpolation',
    'InterpolationTest/glTF/InterpolationTest.gltf',
    [
      [-6, -3.5, -2],
      [6, 9, 2],
    ],
    15,
    10,
    0,
    [0.7],
  ],
  [
    'interpolation',
    'InterpolationTest/glTF/InterpolationTest.gltf',
    [
      [-6, -3.5, -2],
      [6, 9, 2],
    ],
    15,
    10,
    2,
    [1.1],
  ],
  [
    'interpolation',
    'InterpolationTest/glTF/InterpolationTest.gltf',
    [
      [-6, -3.5, -2],
      [6, 9, 2],
    ],
    15,
    10,
    4,
    [0.9],
  ],
  [
    'interpolation',
    'InterpolationTest/glTF/InterpolationTest.gltf',
    [
      [-6, -3.5, -2],
      [6, 9, 2],
    ],
    15,
    10,
    5,
    [0.9],
  ],
  [
    'interpolation',
    'InterpolationTest/glTF/InterpolationTest.gltf',
    [
      [-6, -3.5, -2],
      [6, 9, 2],
    ],
    15,
    10,
    7,
    [1.3],
  ],
  [
    'morph-primitives',
    'MorphPrimitivesTest/glTF/MorphPrimitivesTest.gltf',
    [
      [-1, -1, -1],
      [1, 1, 1],
    ],
    20,
    30,
    null,
    [0],
  ],
  [
    'instancing',
    'simple-instancing/simple-instancing.glb',
    [
      [-1, -1, -1],
      [11, 11, 11],
    ],
    35,
    25,
    null,
    [0],
  ],
];

function sharedCases([name, file, [min, max], azimuth, elevation, animation, times]) {
  if (!existsSync(path.join(SHARED_MODELS, file))) return [];
  return times.map((time) => {
    const pose = animation === null ? null : { animation, time };
    const settings = { size: 512, camera: { azimuth, elevation }, environment: CASE_ENVIRONMENT, lights: [directional], pose };
    return {
      name: `shared-${name}-${pose ? `${animation}-${time}` : 'rest'}`,
      model: `shared:${file}`,
      environment: 'shared:env/brown_photostudio_02_1k.hdr',
      shot: shot(settings, { min, max }),
      fast: false,
    };
  });
}

/** @type {import('./cases.mjs').Case[]} */
export const CASES = [...restCases, ...poseCases, ...shadowCases, ...SHARED.flatMap(sharedCases)];
