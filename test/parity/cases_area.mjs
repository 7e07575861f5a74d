// Rect area lights, and the environment blurred behind the model.
import { CASE_ENVIRONMENT, LIGHTS, shot } from './shot.mjs';

const { ambient, hemisphere, directional, point } = LIGHTS;

/** Colours linear, nit, metres. */
const RECTS = {
  key: { type: 'rect', color: [1, 0.97, 0.9], intensity: 8, position: [1.6, 1.5, 1.8], target: [0, 0, 0], width: 1.4, height: 0.9 },
  fill: { type: 'rect', color: [0.6, 0.75, 1], intensity: 4, position: [-2, 0.3, 1.2], target: [0, 0, 0], width: 0.6, height: 2.4 },
  rim: { type: 'rect', color: [1, 0.6, 0.4], intensity: 12, position: [0.4, 1, -1.8], target: [0, 0, 0], width: 1, height: 1 },
  // Straight above: its up vector lies along its axis.
  top: { type: 'rect', color: [1, 1, 1], intensity: 6, position: [0, 1.8, 0], target: [0, 0, 0], width: 2, height: 1 },
  strip: { type: 'rect', color: [1, 1, 1], intensity: 60, position: [0.9, 0.4, 1.9], target: [0, 0, 0], width: 0.03, height: 2.5 },
  huge: { type: 'rect', color: [1, 1, 1], intensity: 0.8, position: [0, 0, 3], target: [0, 0, 0], width: 300, height: 300 },
};
const { key, fill, rim, top, strip, huge } = RECTS;

const FAST = ['rect-sweep', 'rect-everything', 'background-blur-0.3'];

/** Shown by others as well. */
const EXTENDED = [
  'rect-fill',
  'rect-sweep-512',
  'rect-clearcoat-metal',
  'rect-specular-metal',
  'rect-ior',
  'rect-iridescence-clearcoat',
  'rect-anisotropy-clearcoat',
  'rect-normal-map-tangents',
  'rect-flat-normal-map',
  'rect-metallic-roughness-map',
  'rect-clearcoat-two-normals',
  'rect-alpha-mask',
  'rect-transforms',
  'rect-occlusion-map',
  'rect-far',
  'rect-ortho-front',
  'rect-aces',
  'background-blur-0.1',
  'background-blur-0.5',
  'background-blur-aces',
];

/** @returns {import('./cases.mjs').Case} */
const make = (name, model, environment, overrides = {}) => ({
  name,
  model,
  environment: environment ?? undefined,
  shot: shot({ environment: environment ? CASE_ENVIRONMENT : 'none', camera: 'front', ...overrides }),
  fast: FAST.includes(name),
  extended: EXTENDED.includes(name),
});

/** Each light by itself on the same stage: some of its surfaces face away, stand behind it or cut its plane. */
const lightCases = Object.entries(RECTS).map(([name, light]) => make(`rect-${name}`, 'stage', null, { lights: [light], camera: 'quarter' }));

const materialCases = [
  make('rect-sweep', 'sweep', null, { lights: [key] }),
  make('rect-sweep-strip', 'sweep', null, { lights: [strip] }),
  make('rect-sweep-512', 'sweep', null, { lights: [key, fill], size: 512 }),
  ...[
    'clearcoat',
    'clearcoat-metal',
    'sheen',
    'sheen-clearcoat',
    'specular',
    'specular-metal',
    'ior',
    'iridescence',
    'iridescence-clearcoat',
    'anisotropy',
    'anisotropy-clearcoat',
    'diffuse-roughness',
  ].map((model) => make(`rect-${model}`, model, null, { lights: [key] })),
  ...[
    'normal-map',
    'normal-map-tangents',
    'flat-shading',
    'flat-normal-map',
    'cloth',
    'metallic-roughness-map',
    'clearcoat-two-normals',
    'clearcoat-two-normals-tangents',
    'sheen-cloth',
    'specular-maps',
    'alpha-blend-bumpy',
    'alpha-mask',
    'transforms',
    'occlusion-map',
  ].map((model) => make(`rect-${model}`, model, null, { lights: [key, { ...rim, intensity: 4 }], camera: 'quarter' })),
  make('rect-transmission', 'transmission', 'lamps', { lights: [key], background: { blur: 0.3 } }),
  make('rect-everything', 'physical-everything', 'lamps', { lights: [key, point], camera: 'quarter' }),
];

/** What a light does not reach: the side it turns its back to, points in its plane, and what it shines on from below the horizon. */
const placeCases = [
  make('rect-behind', 'boxes', null, { lights: [ambient, { ...key, position: [0, 0, -2.5], target: [0, 0, -5] }] }),
  make('rect-through', 'ball', null, { lights: [ambient, { ...key, position: [0, 0, 0.2], target: [0, 0, 3], width: 0.8, height: 0.8 }], camera: 'quarter' }),
  make('rect-inside', 'boxes', null, { lights: [{ ...key, position: [0, 0, 0], target: [1, 0.4, 0.6], width: 3, height: 3 }], camera: 'quarter' }),
  make('rect-horizon', 'sweep', null, { lights: [{ ...key, position: [2.4, 0, 0.15], target: [0, 0, 0.15], width: 1, height: 3, intensity: 20 }] }),
  make('rect-grazing', 'stage', null, { lights: [{ ...key, position: [2.2, -0.6, 0.2], target: [0, -0.6, 0], intensity: 20 }], camera: 'quarter' }),
  make('rect-far', 'sweep', null, { lights: [{ ...key, position: [200, 150, 250], width: 60, height: 60, intensity: 40 }] }),
  make('rect-close', 'stage', null, { lights: [{ ...key, position: [0.3, -0.2, 0.9], target: [0, -1, 0], width: 0.3, height: 0.3 }], camera: 'quarter' }),
];

const otherCases = [
  make('rect-many', 'stage', null, { lights: [...Object.values(RECTS), hemisphere, directional, point], exposure: 0.4, camera: 'quarter' }),
  make('rect-ortho', 'physical-everything', 'lamps', { lights: [key], camera: 'ortho-quarter' }),
  make('rect-ortho-front', 'sweep', null, { lights: [key, fill], camera: 'ortho' }),
  make('rect-tilted', 'cloth', null, { lights: [key, fill], camera: 'tilted' }),
  make('rect-aces', 'sweep', null, { lights: [top, huge], toneMapping: 'aces' }),
];

/** Turned and dimmed, where a wrong rotation, level or factor shows. */
const blurred = (name, blur, overrides) =>
  make(`background-blur-${name}`, 'ball-mirror', 'lamps', {
    environment: { map: CASE_ENVIRONMENT, intensity: 0.8, rotation: 70 },
    background: { blur },
    camera: 'quarter',
    ...overrides,
  });
const blurCases = [
  ...[0.02, 0.1, 0.3, 0.5, 0.8, 1].map((blur) => blurred(String(blur), blur)),
  blurred('wide', 0.25, { size: { width: 320, height: 160 }, camera: 'tilted' }),
  blurred('ortho', 0.4, { camera: 'ortho-quarter' }),
  blurred('aces', 0.4, { toneMapping: 'aces', exposure: 1.7 }),
  { ...blurred('2k', 0.2), environment: 'lamps-2k' },
  { ...blurred('studio-512', 0.3, { size: 512, lights: [key] }), environment: 'studio', model: 'cloth' },
  // No lit material: the background alone needs the prefiltered cube.
  { ...blurred('unlit', 0.6), model: 'unlit' },
];

/** @type {import('./cases.mjs').Case[]} */
export const CASES = [...lightCases, ...materialCases, ...placeCases, ...otherCases, ...blurCases];
