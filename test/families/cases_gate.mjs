// Pictures that only the gate of older releases draws, and not js/docs/families.md: no release that telar is held against differs in
// them, or what they show is rare.
import { makeCase } from '../parity/make_case.mjs';
import { LIGHTS } from '../parity/shot.mjs';

const { ambient, directional, hemisphere } = LIGHTS;
const SMALL = { size: 128, toneMapping: 'reinhard' };
const make = (name, model, lights, camera) => makeCase(name, model, null, { ...SMALL, camera, lights });

/** What a loader and the vertex stage make of a mesh. */
const MESHES = [
  'instances-colors',
  'instances-unlit-colors',
  'instances-tangents',
  'bump-map',
  'flat-normal-map-sides',
  'alpha-blend-bumpy-tangents',
  'morph',
  'morph-colors',
  'skin-tangents',
  'lines-map',
];

const SUN = {
  ...directional,
  castShadow: true,
  shadow: { mapSize: 256, radius: 1, intensity: 1, bias: -0.002, normalBias: 0.01, near: 0.1, far: 10, left: -2, right: 2, bottom: -2, top: 2 },
};

/** Its map ends within the room: walls beyond it throw their depth into the last texels before it. */
const NEAR_SIGHTED = {
  type: 'point',
  intensity: 1.5,
  position: [0.05, 0.02, 0.1],
  castShadow: true,
  shadow: { mapSize: 1024, radius: 2, intensity: 1, bias: -0.0005, normalBias: 0, near: 0.1, far: 1.2 },
};

/** @type {import('../parity/cases.mjs').Case[]} */
export const GATE_CASES = [
  make('alpha-blend-origins', 'alpha-blend-origins', [ambient, directional], 'front'),
  ...MESHES.map((model) => make(model, model, [hemisphere, directional], 'quarter')),
  ...['gradient', 'lamps'].map((map) =>
    makeCase(`transmission-aliased-${map}`, 'transmission-two-sided', map, { ...SMALL, camera: 'quarter', quality: { samples: 1 } }),
  ),
  // A matrix places the cloth, which no release takes apart.
  makeCase('dressed-turned', 'texture-transform', 'lamps', {
    ...SMALL,
    camera: 'quarter',
    materials: { '*': { preset: 'leather', scale: 4, rotation: 30, metresPerUv: [0.3, 0.1] } },
  }),
  make('shadow-half', 'shadow-stage', [ambient, { ...SUN, position: [1.5, 3, 2], shadow: { ...SUN.shadow, intensity: 0.5 } }], 'quarter'),
  // The ring has no normals, and lies under itself.
  make('shadow-no-normals', 'shadow-stage', [ambient, { ...SUN, position: [0, 3, 0] }], 'quarter'),
  make('shadow-beyond-far', 'shadow-room', [NEAR_SIGHTED], 'front'),
];
