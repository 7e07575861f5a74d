// Transmission, volume and dispersion: what is seen through a surface, in every way that a shot can ask for.
import { TRANSMISSION_MODELS } from '../fixtures/scenes_transmission.mjs';
import { sharedCases } from './cases_files.mjs';
import { makeCase } from './make_case.mjs';
import { CASE_ENVIRONMENT, LIGHTS, shot } from './shot.mjs';

const { ambient, directional, hemisphere, point, spot } = LIGHTS;
const FAST = ['transmission', 'transmission-attenuation', 'transmission-order', 'transmission-two-sided-alone'];

/** Under lights and an environment that is not seen itself; some of it on a colour. */
const featureCases = Object.keys(TRANSMISSION_MODELS).map((model) =>
  makeCase(`${model}-lit`, model, 'lamps', { camera: 'front', lights: [ambient, directional], exposure: 0.7 }, FAST.includes(model)),
);

const BACKGROUNDS = ['transmission-alone', 'transmission-two-sided-alone'];
const backgroundCases = BACKGROUNDS.flatMap((model) => [
  makeCase(`${model}-color`, model, 'lamps', { camera: 'front', background: [0.18, 0.3, 0.05] }),
  makeCase(`${model}-environment`, model, 'lamps', { camera: 'quarter', background: 'environment' }, model === 'transmission-alone'),
  makeCase(`${model}-environment-aces`, model, 'gradient', {
    camera: 'tilted',
    background: 'environment',
    environmentSettings: { intensity: 0.8, rotation: -70 },
    toneMapping: 'aces',
    exposure: 0.6,
  }),
]);

const lights = [ambient, hemisphere, directional, point, spot];
const otherCases = [
  makeCase('transmission-lights', 'transmission', null, { camera: 'front', lights, exposure: 0.5 }),
  makeCase('transmission-quarter', 'transmission-ior', 'lamps', { lights: [directional] }),
  makeCase('transmission-ortho', 'transmission-thickness', 'lamps', { camera: 'ortho', lights: [directional] }),
  makeCase('transmission-ortho-quarter', 'transmission-dispersion', 'lamps', { camera: 'ortho-quarter', lights: [point] }),
  makeCase('transmission-samples-1', 'transmission-order', 'lamps', { camera: 'front', lights: [directional], quality: { samples: 1 } }),
  makeCase('transmission-wide', 'transmission', 'lamps', { camera: 'front', lights: [directional], size: { width: 321, height: 143 } }),
  makeCase('transmission-tall', 'transmission', 'lamps', { camera: 'front', lights: [directional], size: { width: 101, height: 256 } }),
  makeCase('transmission-512', 'transmission-ior', 'studio', { camera: 'front', size: 512, lights: [directional] }),
  makeCase('transmission-two-sided-512', 'transmission-two-sided', 'studio', { size: 512, lights: [directional], background: [0.5, 0.5, 0.5] }),
  makeCase('transmission-order-quarter', 'transmission-order', 'gradient', { exposure: 0.6, lights: [directional], background: 'environment' }),
  makeCase('transmission-dispersion-linear', 'transmission-dispersion-rough', 'lamps', { toneMapping: 'linear', exposure: 0.5, camera: 'front' }),
];

/** Shadows on and of glass, and the ground, which is see-through itself. */
const casting = [directional, spot].map((light) => ({ ...light, castShadow: true }));
const CUBE = { min: [-1, -1, -1], max: [1, 1, 1] };
const shadowed = (name, model, overrides) => {
  const settings = { environment: CASE_ENVIRONMENT, lights: casting, exposure: 0.6, ...overrides };
  return { name, model, environment: 'lamps', shot: shot(settings, CUBE), fast: false };
};
const shadowCases = [
  shadowed('transmission-shadows', 'transmission-order', { camera: 'front' }),
  shadowed('transmission-ground', 'transmission-two-sided', { ground: { opacity: 0.6 }, background: { blur: 0.3 } }),
];

const MODELS = [
  ['transmission-roughness', 'TransmissionRoughnessTest/TransmissionRoughnessTest.glb', 0, 0],
  ['attenuation', 'AttenuationTest/AttenuationTest.glb', 0, 0],
  ['dispersion', 'dispersion-test/dispersion-test.glb', 20, 10],
];

/** What another case shows as well. */
const EXTENDED = [
  'transmission-second-uv-lit',
  'transmission-normal-tangents-lit',
  'transmission-two-sided-flat-lit',
  'transmission-blend-lit',
  'transmission-mirrored-lit',
  'transmission-two-sided-alone-color',
  'transmission-alone-environment-aces',
  'transmission-quarter',
  'transmission-ortho-quarter',
  'transmission-tall',
  'transmission-dispersion-linear',
  'transmission-lights',
  'transmission-two-sided-512',
];

/** @type {import('./cases.mjs').Case[]} */
export const CASES = [...featureCases, ...backgroundCases, ...otherCases, ...shadowCases, ...sharedCases(MODELS)].map((item) => ({
  ...item,
  extended: EXTENDED.includes(item.name),
}));
