// That the gate has what it is meant to have: a case that is lost would be missed by nobody else.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { BROKEN_MODELS, ENVIRONMENTS, FABRIC_MODELS, MODELS } from '../fixtures/index.mjs';
import { CASES, GATE_CASES } from './cases.mjs';
import { KNOWN_CASES } from './known_differences.mjs';

const names = new Set(GATE_CASES.map(({ name }) => name));

/** Cases by what they are there for. */
const ROWS = {
  'roughness x metalness': ['sweep-lamps', 'sweep-sun', 'sweep-512'],
  'sheen roughness x colour': ['sheen-env', 'sheen-sun'],
  'clearcoat x roughness': ['clearcoat-env', 'clearcoat-sun', 'clearcoat-metal-env'],
  'anisotropy strength x rotation': ['anisotropy-env', 'anisotropy-sun', 'anisotropy-derivatives-env'],
  'ior x transmission': ['transmission-ior-lit', 'transmission-lit', 'transmission-ior-thin-lit'],
  'what transmission acts with': [
    'transmission-thickness-lit',
    'transmission-attenuation-lit',
    'transmission-dispersion-lit',
    'transmission-layers-lit',
    'transmission-order-lit',
  ],
  'area lights and blurred backgrounds': ['rect-sweep', 'rect-everything', 'rect-clearcoat', 'rect-sheen', 'rect-anisotropy', 'background-blur-0.3'],
  'shadows and what catches them': ['shadow-directional', 'shadow-spot', 'shadow-point', 'shadow-several', 'shadow-soft', 'shadow-everything', 'ground-tshirt'],
  'what a view frames': ['frame-node', 'frame-material', 'frame-fit-above-1', 'frame-turntable', 'frame-all', 'frame-shadow'],
  'coded textures and meshes': [
    'ktx2-uastc-sun',
    'ktx2-etc1s-sun',
    'ktx2-etc1s-alpha-sun',
    'meshopt-torus-sun',
    'draco-edgebreaker-sun',
    'draco-sequential-sun',
    'draco-quantized-sun',
  ],
  'what moves and what is drawn many times': [
    'skin-rest',
    'skin-0-0.5',
    'morph-rest',
    'morph-0-0.25',
    'morph-and-skin-0-0.6',
    'animated-nodes-1-0.45',
    'instances-rest',
    'instances-colors-rest',
    'instances-shadow',
    'skin-shadow',
  ],
  'features alone': [
    'clearcoat-env',
    'sheen-env',
    'specular-env',
    'ior-env',
    'anisotropy-env',
    'iridescence-env',
    'diffuse-roughness-env',
    'emissive-strength-env',
    'unlit-env',
    'normal-map-env',
    'occlusion-map-env',
    'emissive-map-env',
    'metallic-roughness-map-env',
    'base-color-map-env',
    'texture-transform-env',
    'vertex-colors-env',
    'variant-red',
  ],
  'pairs that interact': [
    'sheen-clearcoat-env',
    'anisotropy-clearcoat-env',
    'iridescence-clearcoat-env',
    'ior-clearcoat-env',
    'clearcoat-specular-env',
    'anisotropy-sheen-env',
    'iridescence-anisotropy-env',
    'iridescence-sheen-env',
    'iridescence-specular-env',
    'iridescence-ior-env',
    'sheen-specular-env',
    'ior-specular-env',
    'diffuse-roughness-sheen-env',
    'emissive-layers-env',
    'mask-layers-env',
    'clearcoat-blend-env',
    'physical-everything-env',
  ],
  'alpha modes': ['alpha-opaque-env', 'alpha-mask-env', 'alpha-mask-low-env', 'alpha-blend-env', 'alpha-blend-many-env', 'vertex-colors-alpha-env'],
  'mirrored UVs': ['mirrored-uvs-env', 'mirrored-uvs-tangents-env', 'mirrored-uvs-layers-env', 'mirrored-uvs-layers-tangents-env'],
  'negative scale': ['transforms-env', 'scaled-rings-env', 'scaled-rings-layers-env'],
  'textures with odd sides and of one texel': ['odd-images-env', 'odd-slots-env'],
  "cloth by telar's own text": [
    'fabric-sweep-sun',
    'fabric-sheen-env',
    'fabric-clearcoat-env',
    'fabric-physical-everything-lights',
    'fabric-shadow-everything',
    'fabric-tshirt-front',
    'cloth-brocade-studio',
  ],
  'shadings of before, and their terms': [
    'r115-sheen-sun',
    'r115-clearcoat-env',
    'disney-anisotropy-sun',
    'disney-physical-everything-env',
    'term-sheen-zeltner',
    'term-diffuse-eon',
  ],
  cloths: ['cloth-denim-studio', 'cloth-satin-sky', 'cloth-silk-behind', 'cloth-velvet-studio'],
  'our own garment': ['tshirt-front', 'tshirt-three-quarter', 'tshirt-back'],
};

for (const [row, wanted] of Object.entries(ROWS)) {
  test(`the gate has: ${row}`, () =>
    assert.deepEqual(
      wanted.filter((name) => !names.has(name)),
      [],
    ));
}

/** Every value of `key` (the const or enum of a property) under a part of the shot's JSON Schema. */
function valuesIn(part, key, found = []) {
  for (const [name, node] of Object.entries(part ?? {})) {
    if (name === key && node.const !== undefined) found.push(node.const);
    else if (name === key && node.enum) found.push(...node.enum);
    else if (typeof node === 'object') valuesIn(node, key, found);
  }
  return found;
}

test('every light and every tone mapping that a shot may name is in the gate', () => {
  const { properties } = JSON.parse(readFileSync(new URL('../../js/shot/schema.json', import.meta.url), 'utf8'));
  const [lights, toneMappings] = [valuesIn(properties.lights, 'type').filter((type) => type !== 'object'), valuesIn(properties, 'toneMapping')];
  assert.ok(lights.length >= 6 && toneMappings.length >= 7, `${lights} ${toneMappings}`);
  const drawn = new Set(GATE_CASES.flatMap(({ shot }) => [...shot.lights.map(({ type }) => type), shot.toneMapping]));
  // three.js has no disk.
  assert.deepEqual(
    [...lights, ...toneMappings].filter((value) => !drawn.has(value)),
    ['disk'],
  );
});

test('at least 150 cases, at 256 and 512, with names that are file names and unlike each other', () => {
  assert.ok(GATE_CASES.length >= 150, `${GATE_CASES.length}`);
  for (const size of [256, 512]) assert.ok(GATE_CASES.some(({ shot }) => shot.size.width === size && shot.size.height === size));
  assert.equal(new Set(CASES.map(({ name }) => name)).size, CASES.length);
  for (const { name } of CASES) assert.match(name, /^[a-z0-9][a-z0-9.-]*$/);
});

test('every model and environment that a case names is there, and every model of the fixtures is drawn', () => {
  const ours = (name) => name !== undefined && !/^(bundled|shared):|^studio$/.test(name);
  const [models, environments] = ['model', 'environment'].map((key) => [...new Set([...CASES, ...KNOWN_CASES].map((item) => item[key]).filter(ours))]);
  const known = { ...MODELS, ...FABRIC_MODELS, ...BROKEN_MODELS };
  assert.deepEqual(
    models.filter((name) => !known[name]),
    [],
  );
  assert.deepEqual(
    environments.filter((name) => !ENVIRONMENTS[name]),
    [],
  );
  // The page's own test draws the first one, test/js/api/tangents.test.mjs the second.
  assert.deepEqual(
    Object.keys(known)
      .filter((name) => !models.includes(name))
      .sort(),
    ['ball-grey-unlit', 'known-tangents-absent'],
  );
});
