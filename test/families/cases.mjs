// Small pictures that between them show every part of three.js that a shot reaches: each light, the environment, each layer of a
// material, transmission, shadows, tone mappings, points and lines, textures, colours, transparency.
import { makeCase } from '../parity/make_case.mjs';
import { CASE_ENVIRONMENT, LIGHTS, shot } from '../parity/shot.mjs';

const { ambient, hemisphere, directional, point, spot } = LIGHTS;
const SIZE = 128;

const casting = (light) => ({
  ...light,
  castShadow: true,
  shadow: { mapSize: 256, radius: 1, intensity: 1, bias: -0.002, normalBias: 0.01, near: 0.1, far: 10, ...shadowExtent(light) },
});
const shadowExtent = ({ type }) => (type === 'directional' ? { left: -2, right: 2, bottom: -2, top: 2 } : type === 'spot' ? { focus: 1 } : {});
const SUN = casting({ ...directional, position: [1.5, 3, 2] });
const LAMP = casting({
  type: 'spot',
  color: [1, 0.9, 0.7],
  intensity: 30,
  position: [1.2, 2.2, 1.6],
  target: [0, -0.2, 0],
  range: 0,
  angle: 0.5,
  penumbra: 0.3,
});
const BULB = casting({ type: 'point', color: [1, 0.8, 0.6], intensity: 8, position: [-0.9, 1.2, 1.1], range: 0 });
const PANEL = { type: 'rect', color: [1, 0.97, 0.9], intensity: 8, position: [1.6, 1.5, 1.8], target: [0, 0, 0], width: 1.4, height: 0.9 };

/**
 * A case of test/parity, drawn small. Reinhard's curve is in every release and hides no difference of what is bright.
 * @param {string} name
 * @param {string} model - As makeCase.
 * @param {string | null} environment
 * @param {object} [shot] - As makeCase.
 * @param {import('./browser/client.mjs').Settings} [settings]
 */
const make = (name, model, environment, shot, settings) => ({
  ...makeCase(name, model, environment, { size: SIZE, toneMapping: 'reinhard', camera: 'front', ...shot }),
  settings,
});

const lights = [
  make('light-ambient', 'stage', null, { lights: [ambient] }),
  make('light-hemisphere', 'stage', null, { lights: [hemisphere] }),
  make('light-directional', 'sweep', null, { lights: [directional] }),
  make('light-point', 'stage', null, { lights: [LIGHTS['point-range']], camera: 'quarter' }),
  make('light-spot', 'stage', null, { lights: [spot], camera: 'quarter' }),
  make('light-rect', 'sweep', null, { lights: [PANEL] }),
  make('rect-clearcoat', 'clearcoat', null, { lights: [PANEL] }),
  make('rect-specular', 'specular', null, { lights: [PANEL] }),
  make('model-lights', 'model-lights', null, { camera: 'quarter' }),
];

const environments = [
  make('env-studio', 'sweep', 'studio'),
  make('env-lamps', 'sweep', 'lamps'),
  make('env-furnace', 'furnace-metal-0.5', 'one', { toneMapping: 'linear', exposure: 0.8 }),
  make('env-intensity', 'ball-metal', 'gradient', { environmentSettings: { intensity: 0.7 } }),
  make('env-turned', 'ball-metal', 'lamps', { environmentSettings: { rotation: 90 } }),
  make('background-env', 'ball-mirror', 'lamps', { background: 'environment' }),
  make('background-blur', 'ball-mirror', 'lamps', { background: { blur: 0.3 } }),
  make('background-color', 'alpha-blend-curved', 'gradient', { background: [0.18, 0.3, 0.05] }),
];

/** Each layer by direct light alone and by image-based light alone. */
const LAYERS = ['sheen', 'sheen-white-base', 'clearcoat', 'iridescence', 'iridescence-metal', 'anisotropy', 'specular', 'ior', 'diffuse-roughness'];
const layers = LAYERS.flatMap((model) => [make(`${model}-sun`, model, null, { lights: [directional] }), make(`${model}-env`, model, 'studio')]);

/** What irradiance without directions, of ambient and hemisphere lights, gives them. */
const diffuseLayers = ['sheen', 'iridescence', 'ior-0'].map((model) => make(`${model}-hemisphere`, model, null, { lights: [hemisphere, directional] }));

const transmissions = [
  make('transmission', 'transmission', 'lamps', { lights: [directional] }),
  make('transmission-volume', 'transmission-attenuation', 'gradient', { lights: [directional] }),
  make('transmission-dispersion', 'transmission-dispersion', 'gradient', { lights: [directional] }),
  make('transmission-two-sided', 'transmission-two-sided', 'gradient', { camera: 'quarter', lights: [directional] }),
  make('transmission-color', 'transmission-order', 'gradient', { background: [0.18, 0.3, 0.05] }),
  make('transmission-tone', 'transmission-order', 'lamps', { toneMapping: 'aces', background: 'environment' }),
];

const CUBE = { min: [-1, -1, -1], max: [1, 1, 1] };
const stage = (name, light, settings) => make(name, 'shadow-stage', null, { camera: 'quarter', lights: [ambient, light] }, settings);
const shadows = [
  stage('shadow-directional', SUN),
  stage('shadow-spot', LAMP),
  stage('shadow-point', BULB),
  stage('shadow-basic', SUN, { shadowType: 'BasicShadowMap' }),
  stage('shadow-pcf-soft', SUN, { shadowType: 'PCFSoftShadowMap' }),
  stage('shadow-vsm', SUN, { shadowType: 'VSMShadowMap' }),
  stage('shadow-point-basic', BULB, { shadowType: 'BasicShadowMap' }),
  {
    name: 'ground',
    model: 'boxes',
    environment: 'gradient',
    shot: shot({ environment: CASE_ENVIRONMENT, size: SIZE, toneMapping: 'reinhard', camera: 'quarter', lights: [SUN], ground: { opacity: 0.6 } }, CUBE),
  },
  make('shadow-mask', 'shadow-mask', null, { camera: 'quarter', lights: [ambient, SUN] }),
];

const tones = ['none', 'linear', 'cineon', 'aces', 'agx', 'neutral'].map((toneMapping) =>
  make(`tone-${toneMapping}`, 'sweep', null, { lights: [ambient, { ...directional, intensity: 8 }], toneMapping, exposure: 1.5 }),
);

const SUNLIT = [
  'base-color-map',
  'normal-map',
  'normal-map-tangents',
  'metallic-roughness-map',
  'emissive-map',
  'texture-transform',
  'two-uv-sets',
  'minification',
  'samplers',
  'vertex-colors',
  'vertex-colors-alpha',
  'flat-shading',
  'unlit',
  'default-material',
  'alpha-mask',
  'alpha-blend',
  'alpha-blend-curved',
  'alpha-blend-many',
  'topologies',
  'boxes',
  'transforms',
  'back-sides',
];
const materials = SUNLIT.map((model) =>
  make(model, model, null, { camera: /samplers|minification|back-sides|topologies/.test(model) ? 'front' : 'quarter', lights: [hemisphere, directional] }),
);

const others = [
  make('occlusion-map', 'occlusion-map', 'gradient', { camera: 'quarter' }),
  make('ortho', 'ball', 'studio', { camera: 'ortho-quarter', lights: [point] }),
  make('everything', 'physical-everything', 'studio', { camera: 'quarter', lights: [directional] }),
  make('cloth', 'sheen-cloth', 'studio', { camera: 'quarter', lights: [directional] }),
];

/** @type {(import('../parity/cases.mjs').Case & {settings?: import('./browser/client.mjs').Settings})[]} */
export const CASES = [...lights, ...environments, ...layers, ...diffuseLayers, ...transmissions, ...shadows, ...tones, ...materials, ...others];
