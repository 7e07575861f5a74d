import { BASES, SLOTS } from '../../js/shot/shading_terms.mjs';
import { CLOTHS } from '../../js/shot/table/cloths.mjs';
import { LOOKS } from '../../js/shot/table/looks.mjs';
import { COLOURWAYS } from '../fixtures/random_file.mjs';
import { Choices, OTHER_UNIT, randomScene } from '../fixtures/random_scene.mjs';
import { boundsOf, readDocument } from './bounds.mjs';
import { CAMERAS, CASE_ENVIRONMENT, shot } from './shot.mjs';

// Random scenes in random light: `run.mjs --random COUNT`. What one of them finds becomes a case of its own.

const ENVIRONMENTS = ['studio', 'lamps', 'gradient', 'sunny-sky', 'overcast-sky', 'soft-studio'];
const TONE_MAPPINGS = ['none', 'linear', 'reinhard', 'cineon', 'aces', 'agx', 'neutral'];
const SIZES = [128, 192, 256, { width: 200, height: 130 }, { width: 83, height: 211 }];
const MOST_LIGHTS = 4;

/** Somewhere in front of the model, so many metres off. */
function placeOf(c, distance) {
  const towards = [c.between(-1, 1), c.between(-0.3, 1), c.between(0.1, 1)];
  return towards.map((x) => (x / Math.hypot(...towards)) * distance);
}

const sidesOf = (c) => ({ left: -c.between(0.4, 1), right: c.between(0.4, 1), bottom: -c.between(0.4, 1), top: c.between(0.4, 1) });

/** Where a shadow's map begins and ends, by the light's type: some of the model lies beyond it. */
const BORDERS = {
  directional: (c) => ({ near: c.between(1, 2.5), far: c.between(2.8, 4), ...sidesOf(c) }),
  point: (c) => ({ near: c.between(0.3, 1.2) }),
  spot: (c) => ({ near: c.between(0.3, 2), focus: c.between(0.3, 1) }),
};

const shadowOf = (c, type) => ({
  castShadow: true,
  shadow: {
    mapSize: c.of([256, 512, 1024]),
    radius: c.between(0, 4),
    intensity: c.between(0.3, 1),
    ...(c.is(0.2) && { normalBias: c.between(0.02, 0.06) }),
    ...(c.is(0.3) && BORDERS[type](c)),
  },
});

/** Whether cameras and lights that stand somewhere see nothing of it. */
const isOtherUnit = ({ nodes }) => nodes.some(({ name }) => name === OTHER_UNIT);

const LIGHTS = {
  ambient: (c) => ({ intensity: c.random() }),
  hemisphere: (c) => ({ groundColor: c.color(0.2), intensity: c.between(0, 1.5) }),
  directional: (c) => ({ intensity: c.between(0.3, 4), position: placeOf(c, 3) }),
  point: (c) => ({ intensity: c.between(1, 10), position: placeOf(c, c.between(1.2, 2.5)), range: c.of([0, c.between(1, 6)]) }),
  spot: (c) => ({
    intensity: c.between(5, 30),
    position: placeOf(c, c.between(2, 3)),
    target: [c.between(-0.2, 0.2), 0, 0],
    range: c.of([0, 6]),
    angle: c.between(0.1, 0.9),
    penumbra: c.factor(),
  }),
  rect: (c) => ({ intensity: c.between(1, 8), position: placeOf(c, 2), target: [0.05, 0.02, 0.1], width: c.between(0.2, 2), height: c.between(0.2, 2) }),
};
const CASTING = ['directional', 'point', 'spot'];

const DISTANT = ['ambient', 'hemisphere', 'directional'];

function lightOf(c, model) {
  const type = c.of(isOtherUnit(model) ? DISTANT : Object.keys(LIGHTS));
  const light = { type, color: c.color(0.2), ...LIGHTS[type](c) };
  return CASTING.includes(type) && c.is(0.25) ? { ...light, ...shadowOf(c, type) } : light;
}

/** Looks at the first body from so near that planes of the view cut others, or they lie behind it. */
function closeCamera(c, { nodes }) {
  const target = nodes.find(({ mesh }) => mesh === 0).translation;
  const position = placeOf(c, c.between(0.7, 2)).map((x, i) => target[i] + x);
  return { projection: 'perspective', position, target, fovY: c.between(15, 110), near: c.between(0.05, 0.4), far: c.between(1.5, 6) };
}

function cameraOf(c, model) {
  const isElsewhere = isOtherUnit(model);
  if (!isElsewhere && c.is(0.2)) return closeCamera(c, model);
  if (!isElsewhere && c.is(0.5)) return CAMERAS[c.of(Object.keys(CAMERAS))];
  return { azimuth: c.between(-180, 180), elevation: c.between(-60, 80), projection: c.of(['perspective', 'orthographic']), fit: c.between(0.4, 1.5) };
}

/** Orthographic cameras see the environment's cube alone; beside that three.js leaves the colour of the picture before. */
const backgroundOf = (c, { projection }) => (projection === 'orthographic' ? 'transparent' : c.of(['environment', { type: 'environment', blur: c.random() }]));

/** Points and lines have no holes of a cloth. */
const WHOLE_CLOTHS = CLOTHS.filter((name) => !['tulle', 'lace', 'athletic-mesh', 'chiffon', 'organza'].includes(name));
const hasLines = ({ meshes }) => meshes.some(({ primitives }) => primitives.some(({ mode = 4 }) => mode < 4));

const materialsOf = (c, model) => ({
  [c.of(['*', '0'])]: {
    preset: c.is(0.8) ? c.of(hasLines(model) ? WHOLE_CLOTHS : CLOTHS) : null,
    color: c.is(0.8) ? c.color(0, 0.8) : null,
    scale: c.between(1, 30),
    rotation: c.of([0, c.between(-180, 180)]),
    metresPerUv: c.is(0.3) ? [c.between(0.1, 0.5), c.between(0.1, 0.5)] : null,
  },
});

/** What a look has: a shot by one leaves it out. */
const OF_LOOKS = ['lights', 'background', 'exposure', 'toneMapping', 'ground', 'metering', 'lens'];

const meteringOf = (c) => ({ percentile: c.between(0.3, 1), level: c.between(0.3, 1), least: 0.1, most: c.between(1, 4) });

/** @param {string} name - As `--shading` has it: "terms" is any of the principled shadings' terms. */
function shadingOf(c, name) {
  if (name !== 'terms') return name;
  const changed = Object.entries(SLOTS).filter(() => c.is(0.4));
  return { base: c.of(BASES), ...Object.fromEntries(changed.map(([slot, terms]) => [slot, c.of(terms)])) };
}

const targetsOf = ({ meshes }) => meshes.flatMap(({ primitives }) => primitives.flatMap(({ targets = [] }) => targets));
const extensionsOf = ({ materials = [] }) => materials.map(({ extensions = {} }) => extensions);

/** What decides whether older releases of three.js show a model: test/families/gate.mjs. */
const TRAITS = {
  morph: (model) => targetsOf(model).length > 0,
  'morph-colors': (model) => targetsOf(model).some(({ COLOR_0 }) => COLOR_0 !== undefined),
  'ior-0': (model) => extensionsOf(model).some(({ KHR_materials_ior: layer }) => layer?.ior === 0),
  anisotropy: (model) => extensionsOf(model).some(({ KHR_materials_anisotropy: layer }) => layer),
};

/**
 * @param {number} seed - Integer.
 * @param {string} [shading] - Of the shot, or "terms": any terms of the principled shadings.
 * @returns {Promise<import('./cases.mjs').Case>}
 */
export async function randomCase(seed, shading = 'three') {
  // Other numbers than those of the model of this seed.
  const c = new Choices(~seed);
  const isCloth = shading !== 'three';
  const model = readDocument(Buffer.from(await randomScene(seed, isCloth)));
  const lights = Array.from({ length: Math.floor(c.between(0, MOST_LIGHTS)) }, () => lightOf(c, model));
  const environment = lights.length === 0 || c.is(0.7) ? c.of(ENVIRONMENTS) : undefined;
  const camera = cameraOf(c, model);
  const settings = {
    shading: shadingOf(c, shading),
    lights,
    camera,
    size: c.of(SIZES),
    toneMapping: c.of(TONE_MAPPINGS),
    exposure: c.between(0.4, 1.5),
    environment: environment ? { map: CASE_ENVIRONMENT, intensity: c.between(0.3, 1.5), rotation: c.is(0.5) ? c.between(-180, 180) : 0 } : 'none',
    background: c.of(['transparent', c.color(), ...(environment ? [backgroundOf(c, camera)] : [])]),
    ground: c.is(0.15) ? { opacity: c.random() } : 'none',
    ghost: c.is(0.1) ? [{ material: 0, opacity: c.random() }] : [],
    quality: { samples: c.of([1, 4]) },
    materials: model.materials && c.is(0.2) ? materialsOf(c, model) : {},
    metering: c.is(0.15) ? meteringOf(c) : undefined,
    lens: c.is(0.1) ? { aperture: 1, shutter: 0.25, iso: 400 } : undefined,
  };
  if (model.extensions?.KHR_materials_variants) settings.variant = c.of(COLOURWAYS);
  if (model.animations) settings.pose = { animation: 0, time: c.between(-0.1, 1.2) };
  if (environment && c.is(0.1)) {
    for (const key of OF_LOOKS) delete settings[key];
    Object.assign(settings, { look: c.of(Object.keys(LOOKS)), camera: {} });
  }
  const name = `random-${shading}-${seed}`;
  const ofModel = {
    name,
    model: `random${isCloth ? '-cloth' : ''}:${seed}`,
    textures: 'uncompressed',
    traits: Object.keys(TRAITS).filter((trait) => TRAITS[trait](model)),
  };
  return { ...ofModel, environment, shot: shot(settings, boundsOf(model)) };
}

/**
 * The cases of so many seeds, one after the other.
 * @param {string} count
 * @param {string} first - Seed of the first one.
 * @param {string} shading
 * @returns {Promise<import('./cases.mjs').Case[]>}
 * @throws {Error} Where a number is none.
 */
export function randomCases(count, first, shading) {
  if (![count, first].every((number) => /^\d+$/.test(number))) throw new Error(`--random ${count} --seed ${first}: expected whole numbers`);
  return Promise.all(Array.from({ length: Number(count) }, (_, i) => randomCase(Number(first) + i, shading)));
}
