// Every other shading than stock three.js's: the browser runs telar's text (js/three/shading), the server the same text.
import { resolveShot } from '../../js/shot/index.mjs';
import { SLOTS } from '../../js/shot/shading_terms.mjs';
import { FABRIC_MODELS, LAYERED_FABRICS } from '../fixtures/index.mjs';
import { CLOTH_MAP_MODELS } from '../fixtures/scenes_cloth_maps.mjs';
import { VISIBILITY_MODELS } from '../fixtures/scenes_visibility.mjs';
import { CASES as AREA } from './cases_area.mjs';
import { CASES as CORE } from './cases_core.mjs';
import { CASES as FILES } from './cases_files.mjs';
import { CASES as MOTION } from './cases_motion.mjs';
import { CASES as PAIRS } from './cases_pairs.mjs';
import { CASES as PHYSICAL } from './cases_physical.mjs';
import { CASES as SHADOW } from './cases_shadow.mjs';
import { CASES as TRANSMISSION } from './cases_transmission.mjs';
import { makeCase } from './make_case.mjs';
import { CAMERAS, LIGHTS } from './shot.mjs';

const STOCK = [...CORE, ...PHYSICAL, ...PAIRS, ...AREA, ...SHADOW, ...TRANSMISSION, ...MOTION, ...FILES];

/** Cases of stock three.js that each shading draws as well: what it may treat in its own way, once each. */
const ALIKE = [
  'sweep-sun',
  'sweep-lamps',
  'sweep-gradient',
  'light-hemisphere',
  'light-spot',
  'lights-many',
  'furnace-0.25',
  'furnace-metal-0.5',
  'sheen-sun',
  'sheen-env',
  'sheen-maps-env',
  'sheen-metal-env',
  'sheen-clearcoat-env',
  'clearcoat-sun',
  'clearcoat-env',
  'clearcoat-two-normals-tangents-env',
  'clearcoat-two-normals-polished-env',
  'anisotropy-sun',
  'anisotropy-env',
  'anisotropy-map-tangents-env',
  'anisotropy-derivatives-sun',
  'anisotropy-sheen-env',
  'specular-maps-env',
  'ior-specular-sun',
  'iridescence-metal-env',
  'diffuse-roughness-sun',
  'diffuse-roughness-env',
  'normal-map-sun',
  'normal-map-env',
  'metallic-roughness-map-env',
  'occlusion-map-env',
  'cloth-env',
  'cloth-tangents-env',
  'mirrored-uvs-layers-env',
  'transforms-env',
  'alpha-mask-env',
  'alpha-blend-env',
  'emissive-strength-env',
  'vertex-colors-env',
  'camera-ortho-quarter',
  'light-behind-ortho',
  'rect-everything',
  'shadow-everything',
  'shadow-point',
  'transmission-layers-lit',
  'instances-colors-rest',
  'morph-and-skin-0-0.6',
  'variant-red',
  'physical-everything-lights',
  'physical-everything-env',
  'tshirt-front',
];

/** Part of the subset that `npm test` draws, of every shading. */
const FAST = ['sheen-env', 'physical-everything-lights'];

const CAMERA = { camera: CAMERAS.front, environment: 'none' };

/** The stock case of that name under another shading. */
function shaded(label, shading, name) {
  const item = STOCK.find((candidate) => candidate.name === name);
  if (!item) throw new Error(`cases_shading.mjs: no stock case is named ${name}`);
  const resolved = resolveShot({ ...CAMERA, shading }).shading;
  return {
    ...item,
    name: label.startsWith('term-') ? label : `${label}-${name}`,
    shot: { ...item.shot, shading: resolved },
    fast: FAST.includes(name),
    extended: false,
  };
}

/** Each term that neither base has, and each of one base in the other, under lights and an environment at once. */
const termCases = Object.entries(SLOTS).flatMap(([slot, [ofR115, ...others]]) => [
  ...others.map((term) => termCase('three-r115', slot, term)),
  termCase('disney-2012', slot, ofR115),
]);

function termCase(base, slot, term) {
  const label = `term-${slot}-${term}${base === 'disney-2012' ? '-in-disney' : ''}`;
  return { ...shaded(label, { base, [slot]: term }, 'physical-everything-lights'), fast: false };
}

/** Sees the draped cloths of test/fixtures/scenes_fabric.mjs, 40 cm wide. */
const DRAPE = { projection: 'perspective', fovY: 30, position: [0.3, 0.25, 0.7], target: [0, -0.02, 0], near: 0.3, far: 1.6 };
const BEHIND = { type: 'directional', color: [1, 0.95, 0.9], intensity: 3, position: [-0.5, 0.6, -1], target: [0, 0, 0] };

/** Cloths in a studio, under the sun, and with the light behind them: the classes whose layers are another set. */
const clothCases = LAYERED_FABRICS.flatMap((model) => {
  const name = model.replace(/^fabric-/, 'cloth-');
  return [
    makeCase(`${name}-studio`, model, 'soft-studio', { camera: DRAPE, shading: 'fabric' }, name === 'cloth-denim'),
    makeCase(`${name}-sky`, model, 'overcast-sky', { camera: DRAPE, shading: 'fabric', lights: [LIGHTS.directional] }),
    makeCase(`${name}-behind`, model, null, { camera: DRAPE, shading: 'fabric', lights: [BEHIND, LIGHTS.hemisphere] }),
  ];
});

/** The others differ from one of those in their maps, which each of them shows once. */
const otherClassCases = Object.keys(FABRIC_MODELS)
  .filter((model) => !LAYERED_FABRICS.includes(model))
  .map((model) => makeCase(model.replace(/^fabric-/, 'cloth-'), model, 'soft-studio', { camera: DRAPE, shading: 'fabric' }));

/** A preset's sheen is dyed anew with its cloth. */
const RECOLORED = { camera: DRAPE, shading: 'fabric', lights: [BEHIND], materials: { '*': { color: [0.3, 0.3, 0.01] } } };

/** Sees the backs of the draped cloths. */
const FROM_BEHIND = { ...DRAPE, position: [0.3, 0.25, -0.7] };

/** From far, where a pixel holds many threads and holes, and without multisampling. */
const AFAR = { ...DRAPE, position: DRAPE.position.map((c) => 3 * c), near: 1.5, far: 3.5 };
const afarCases = [
  ...['denim', 'satin', 'towel', 'lace', 'tulle'].map((name) =>
    makeCase(`cloth-${name}-far`, `fabric-${name}`, 'soft-studio', { camera: AFAR, shading: 'fabric', lights: [LIGHTS.directional] }, name === 'lace'),
  ),
  makeCase('cloth-sheer-far', 'alpha-blend-sheer', 'lamps', { shading: 'fabric', camera: 'tilted' }),
  // Metal that lies in one set of yarns, from near and from where means of its maps alone are seen.
  makeCase('cloth-brocade-studio', 'brocade', 'soft-studio', { camera: DRAPE, shading: 'fabric' }, true),
  makeCase('cloth-brocade-far', 'brocade', 'soft-studio', { camera: AFAR, shading: 'fabric', lights: [LIGHTS.directional] }),
  makeCase('cloth-brocade-behind', 'brocade', null, { camera: DRAPE, shading: 'fabric', lights: [BEHIND, LIGHTS.hemisphere] }),
  makeCase('cloth-layers-samples-1', 'cloth-layers', null, { shading: 'fabric', quality: { samples: 1 } }),
  ...['satin', 'lace'].map((name) =>
    makeCase(`cloth-${name}-samples-1`, `fabric-${name}`, 'soft-studio', { camera: DRAPE, shading: 'fabric', quality: { samples: 1 } }),
  ),
];

/** Suns that three.js has no room for: its own shading leaves them out, every other one has them as lights. */
const SUNLIT = { environmentSettings: { intensity: 0.002, rotation: 70 }, camera: CAMERAS.quarter };
const sunCases = [
  ...['three', 'fabric', 'three-r115', 'disney-2012'].map((shading) =>
    makeCase(`bright-suns-${shading}`, 'sheen', 'bright-suns', { ...SUNLIT, shading }, shading === 'fabric'),
  ),
  makeCase('bright-suns-occlusion-disney-2012', 'occlusion-map', 'bright-suns', { ...SUNLIT, shading: 'disney-2012' }),
];

/** A small light that halves hold: of cloth it is a light too, and stands in the background all the same. */
const smallSunCases = [
  ['sharp', 'environment'],
  ['blurred', { blur: 0.3 }],
].map(([name, background]) =>
  makeCase(
    `fabric-sunny-sky-${name}`,
    'fabric-velvet',
    'sunny-sky',
    { environmentSettings: { rotation: 40 }, camera: DRAPE, shading: 'fabric', background },
    name === 'sharp',
  ),
);

/** What hides the environment from a surface hides its small lights: baked occlusion, what vertices say, and of a polished relief too. */
const hiddenSunCases = [
  ['occlusion', 'occlusion-map', {}],
  ['occlusion-sheen', 'sheen-cloth', {}],
  ['visibility', 'visibility', { camera: DRAPE }],
  ['visibility-thin', 'visibility-thin', { camera: DRAPE, lights: [BEHIND] }],
  ['occlusion-sequins', 'occlusion-map', { materials: { '*': { preset: 'sequin-thread', color: [0.6, 0.3, 0.1], scale: 6 } } }],
].map(([name, model, rest]) =>
  makeCase(`fabric-sunny-sky-${name}`, model, 'sunny-sky', { environmentSettings: { rotation: 40 }, shading: 'fabric', ...rest }, name === 'visibility'),
);

/** Every map and factor of cloth, both sides of it seen. */
const clothMapCases = Object.keys(CLOTH_MAP_MODELS).flatMap((model) => [
  makeCase(`${model}-sun`, model, null, { shading: 'fabric', lights: [LIGHTS.ambient, LIGHTS.directional, LIGHTS.point] }),
  makeCase(`${model}-env`, model, 'lamps', { shading: 'fabric', camera: 'tilted' }, model === 'cloth-maps-second-uv'),
  makeCase(`${model}-disney`, model, 'lamps', { shading: { base: 'disney-2012', diffuse: 'disney-2015-thin' }, lights: [BEHIND] }),
]);

/** What vertices say of their surroundings, under an environment and under lamps from everywhere. */
const visibilityCases = Object.keys(VISIBILITY_MODELS).flatMap((model) => [
  makeCase(`${model}-env`, model, 'soft-studio', { camera: DRAPE, shading: 'fabric' }, model === 'visibility'),
  makeCase(`${model}-dome`, model, null, { camera: DRAPE, shading: 'fabric', lights: [LIGHTS.ambient, LIGHTS.hemisphere, BEHIND] }),
]);

/** @type {import('./cases.mjs').Case[]} */
export const CASES = [
  ...ALIKE.map((name) => shaded('r115', 'three-r115', name)),
  ...ALIKE.map((name) => shaded('disney', 'disney-2012', name)),
  ...ALIKE.map((name) => shaded('fabric', 'fabric', name)),
  ...termCases,
  ...clothCases,
  ...afarCases,
  ...otherClassCases,
  makeCase('cloth-velvet-recolored', 'fabric-velvet', 'soft-studio', RECOLORED),
  makeCase('cloth-leather-recolored-back', 'fabric-leather', 'soft-studio', { ...RECOLORED, camera: FROM_BEHIND }),
  ...clothMapCases,
  ...visibilityCases,
  ...sunCases,
  ...smallSunCases,
  ...hiddenSunCases,
  ...['some', 'none'].map((kind) => makeCase(`tangents-${kind}-fabric`, `known-tangents-${kind}`, 'lamps', { shading: 'fabric' })),
  makeCase('tangents-some-disney', 'known-tangents-some', 'lamps', { shading: 'disney-2012' }),
  ...['fabric', 'disney-2012'].map((shading) => makeCase(`shared-texture-${shading}`, 'known-shared-texture', 'lamps', { shading })),
];
