// Core glTF materials, lights, environments, cameras, tone mapping.
import { TONE_MAPPINGS } from '../../js/shot/table/tone_mappings.mjs';
import { makeCase as make } from './make_case.mjs';
import { CAMERAS, LIGHTS } from './shot.mjs';

const { ambient, hemisphere, directional, point, spot } = LIGHTS;
const SUN = [directional];

/** Each kind of light by itself on the same stage. */
const lightCases = Object.entries(LIGHTS).map(([name, light]) =>
  make(`light-${name}`, 'stage', null, { lights: [light] }, ['point-range', 'spot', 'hemisphere'].includes(name)),
);

/** Each tone mapping over radiances from 0 to far above 1. */
const toneCases = Object.keys(TONE_MAPPINGS).map((toneMapping) =>
  make(`tone-${toneMapping}`, 'sweep', 'lamps', { toneMapping, exposure: 1.5, camera: 'front' }, toneMapping === 'agx'),
);

/** Models whose features show under light and environment alike. */
const FEATURES = [
  'base-color-map',
  'normal-map',
  'normal-map-tangents',
  'normal-map-scale',
  'normal-map-fine',
  'metallic-roughness-map',
  'occlusion-map',
  'occlusion-strength',
  'emissive-map',
  'cloth',
  'cloth-tangents',
  'texture-transform',
  'two-uv-sets',
  'no-uvs',
  'vertex-colors',
  'vertex-colors-alpha',
  'flat-shading',
  'flat-shading-unindexed',
  'flat-normal-map',
  'flat-normal-map-sides',
  'unlit',
  'default-material',
  'odd-images',
  'alpha-mask',
  'alpha-mask-low',
  'alpha-blend',
  'alpha-blend-one-sided',
  'alpha-blend-curved',
  'alpha-blend-many',
  'alpha-blend-bumpy',
  'alpha-blend-bumpy-tangents',
  'alpha-opaque',
  'transforms',
  'boxes',
  'ball',
  'ball-mirror',
  'ball-metal',
  'ball-black',
];
const FAST_FEATURES = ['cloth', 'cloth-tangents', 'texture-transform', 'alpha-blend', 'alpha-mask', 'transforms', 'flat-normal-map'];
const featureCases = FEATURES.flatMap((model) => [
  make(`${model}-sun`, model, null, { lights: [ambient, directional] }),
  make(`${model}-env`, model, 'lamps', {}, FAST_FEATURES.includes(model)),
]);

const FACING = ['samplers', 'minification', 'back-sides', 'topologies', 'lines-map', 'lines-holes', 'points-map', 'points-blended', 'strips-overlapping'];
const facingCases = FACING.map((model) => make(model, model, null, { camera: 'front', lights: [hemisphere, ...SUN] }));

/** Radiance 1 shows as 0.8, so that a gain of energy is not cut off. */
const FURNACE = { toneMapping: 'linear', camera: 'front', exposure: 0.8 };
const furnaceCases = [0, 0.045, 0.1, 0.25, 0.5, 0.75, 1]
  .flatMap((roughness) => [
    make(`furnace-${roughness}`, `furnace-${roughness}`, 'one', FURNACE, roughness === 0.25),
    make(`furnace-metal-${roughness}`, `furnace-metal-${roughness}`, 'one', FURNACE),
  ])
  .map((item, i) => ({ ...item, extended: i > 1 && i < 12 && !item.fast }));

const environmentCases = [
  make('sweep-gradient', 'sweep', 'gradient', { camera: 'front' }, true),
  make('sweep-lamps', 'sweep', 'lamps', { camera: 'front' }),
  make('sweep-gradient-odd', 'sweep', 'gradient-odd', { camera: 'front' }),
  make('sweep-lamps-2k', 'sweep', 'lamps-2k', { camera: 'front' }),
  make('sweep-hot-texels', 'sweep', 'hot-texels', { camera: 'front' }),
  make('sweep-studio', 'sweep', 'studio', { camera: 'front' }, true),
  make('sweep-sun', 'sweep', null, { camera: 'front', lights: SUN }),
  make('sweep-512', 'sweep', 'lamps', { camera: 'front', size: 512, lights: SUN }),
  make('environment-rotated', 'ball-metal', 'lamps', { environmentSettings: { intensity: 0.7, rotation: 130 } }, true),
  make('environment-and-lights', 'stage', 'gradient', { exposure: 0.4, lights: [ambient, hemisphere, directional, point, spot] }),
  make('background-environment', 'ball-mirror', 'lamps', { background: 'environment' }),
  make('background-environment-rotated', 'sweep', 'gradient', {
    background: 'environment',
    environmentSettings: { intensity: 0.8, rotation: -70 },
    camera: 'tilted',
  }),
  make('background-environment-ortho', 'transforms', 'gradient', { background: 'environment', camera: 'ortho-quarter' }),
  make('background-color', 'alpha-blend-curved', 'lamps', { background: [0.18, 0.3, 0.05] }),
  make('ghost-all', 'transforms', 'lamps', { ghost: [{ node: '*', opacity: 0.4 }] }),
  make('ghost-opaque', 'alpha-opaque', 'lamps', { ghost: [{ material: 0, opacity: 0.5 }] }),
  make('ghost-material', 'alpha-blend', 'lamps', { ghost: [{ material: 0, opacity: 0.5 }] }),
  make('background-color-aces', 'stage', null, { background: [0.18, 0.18, 0.18], toneMapping: 'aces', lights: SUN }),
];

const cameraCases = ['front', 'ortho', 'ortho-quarter', 'tilted'].map((camera) =>
  make(`camera-${camera}`, 'cloth', 'lamps', { camera, lights: [point] }, camera === 'ortho-quarter'),
);

/** The camera of a scene that is `scale` times as large and moved by `offset` (in scene sizes). */
function scaledCamera(scale, offset = [0, 0, 0]) {
  const base = CAMERAS.quarter;
  const move = (v) => v.map((c, i) => (c + offset[i]) * scale);
  return { ...base, position: move(base.position), target: move(base.target), near: base.near * scale, far: base.far * scale };
}

const scaleCases = [
  make('scale-tiny', 'scale-tiny', 'lamps', { camera: scaledCamera(1e-6), lights: SUN }),
  make('scale-huge', 'scale-huge', 'lamps', { camera: scaledCamera(1e6), lights: SUN }),
  make('scale-node-tiny', 'scale-node-tiny', 'lamps', { camera: scaledCamera(1e-6), lights: SUN }),
  make('offset-huge', 'offset-huge', 'lamps', { camera: scaledCamera(1, [1e6, -2e6, 5e5]), lights: SUN }),
];

const modelLightCases = [
  make('model-lights', 'model-lights', null, {}, true),
  make('model-lights-off', 'model-lights', null, { modelLights: false, lights: [ambient] }),
  make('model-lights-and-shot', 'model-lights', 'gradient', { exposure: 0.4, lights: SUN }),
  make('model-lights-shared', 'model-lights-shared', null),
  make('model-directional', 'model-directional', null),
  make('model-point', 'model-point', null),
  make('model-spot', 'model-spot', null),
];

/** Several lights of each kind at once, and a light behind an object seen without perspective (half vector of length 0). */
const manyLights = [...Object.values(LIGHTS), { ...directional, color: [0.3, 0.4, 1], position: [-3, 1, 0] }, { ...hemisphere, intensity: 0.3 }];
const lightSetCases = [
  make('lights-many', 'stage', null, { lights: manyLights, exposure: 0.4 }),
  make('lights-many-512', 'sweep', 'gradient', { lights: manyLights, exposure: 0.3, camera: 'tilted', size: 512 }),
  make('light-behind-ortho', 'boxes', null, { lights: [ambient, { ...directional, position: [0, 0, -3] }], camera: 'ortho' }),
  make('light-none', 'stage', null),
];

const otherCases = [
  make('alpha-blend-origins', 'alpha-blend-origins', null, { camera: 'front', lights: [ambient, ...SUN] }),
  make('alpha-blend-shared', 'alpha-blend-shared', 'gradient', { camera: 'front' }),
  make('alpha-blend-many-front', 'alpha-blend-many', 'gradient', { camera: 'front' }),
  make('two-scenes-dyed', 'two-scenes', 'lamps', { camera: 'front', materials: { '*': { color: '#3a6ea5' } } }),
  make('variant-none', 'variants', 'lamps', { camera: 'front' }),
  make('variant-red', 'variants', 'lamps', { camera: 'front', variant: 'red' }),
  make('variant-blue', 'variants', 'lamps', { camera: 'front', variant: 'blue' }, true),
  make('exposure', 'sweep', 'lamps', { camera: 'front', exposure: 0.35 }),
  make('wide', 'cloth', 'lamps', { size: { width: 321, height: 143 }, lights: SUN }),
  make('tall', 'cloth', 'lamps', { size: { width: 101, height: 256 }, lights: SUN }),
  make('samples-1', 'cloth', 'lamps', { quality: { samples: 1 }, lights: SUN }),
  make('cloth-512', 'cloth', 'studio', { size: 512 }),
  make('normal-map-512', 'normal-map', 'lamps', { size: 512, lights: [point] }),
  make('alpha-mask-512', 'alpha-mask', 'lamps', { size: 512, lights: SUN }),
  make('transforms-512', 'transforms', 'lamps', { size: 512, lights: SUN }),
];

/** @type {import('./cases.mjs').Case[]} */
export const CASES = [
  ...featureCases,
  ...facingCases,
  ...lightCases,
  ...toneCases,
  ...environmentCases,
  ...furnaceCases,
  ...cameraCases,
  ...scaleCases,
  ...modelLightCases,
  ...lightSetCases,
  ...otherCases,
];
