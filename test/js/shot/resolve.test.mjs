import assert from 'node:assert/strict';
import { test } from 'node:test';
import { resolveShot } from '../../../js/shot/index.mjs';
import { resolvedShotSchema } from '../../../js/shot/resolved_schema.mjs';

const box = { min: [-1, 0, -0.2], max: [1, 2, 0.2] };
const facts = {
  bounds: box,
  variants: ['white', 'navy'],
  animations: [
    { name: 'walk', duration: 2 },
    { name: 'sit', duration: 1 },
  ],
  cameras: [
    { name: 'shop', node: 1, projection: 'perspective', fovY: 40, near: 0.1, far: 0, position: [0, 1, 4], target: [0, 1, 3], up: [0, 1, 0] },
    { name: 'plan', node: 2, projection: 'orthographic', height: 2, near: 0.01, far: 10, position: [0, 5, 0], target: [0, 4, 0], up: [0, 0, -1] },
  ],
};

const SHOTS = [
  {},
  { size: { width: 800, height: 600 } },
  { size: { width: 1 }, camera: { view: 'three-quarter', fit: 1 } },
  { camera: { azimuth: 12.5, elevation: -7, fovY: 21 } },
  { camera: { view: 'top', projection: 'orthographic' } },
  { camera: { position: [1, 2, 3], target: [0, 1, 0] } },
  { camera: { position: [0, 0, 3], target: [0, 1, 0], height: 2, near: 1, far: 5 } },
  { camera: { gltf: 0 } },
  { camera: { gltf: 'plan' } },
  { environment: 'none' },
  { environment: { map: 'maps/loft.hdr', intensity: 0.5, rotation: -90 } },
  { environment: new Uint8Array([1, 2, 3]) },
  { lights: ['ambient', 'hemisphere', 'directional', 'point', 'spot', 'rect', 'disk'].map((type) => ({ type })) },
  { lights: [{ type: 'spot', color: 'tomato', intensity: 3, position: [1, 2, 3], target: [0, 1, 0], range: 9, angle: 0.3, penumbra: 1 }] },
  { lights: [{ type: 'hemisphere', color: [1, 2, 3], groundColor: '#123' }], modelLights: false },
  { lights: ['directional', 'point', 'spot'].map((type) => ({ type, position: [1, 3, 2], castShadow: true })) },
  { lights: [{ type: 'point', range: 9, castShadow: true, shadow: { radius: 5, mapSize: 256 } }], ground: { opacity: 0.7 } },
  { ground: {} },
  { ground: { position: [0, -1, 0], size: [2, 3] } },
  { background: '#eee', shading: 'three', toneMapping: 'agx', exposure: 0.5 },
  { shading: 'three-r115' },
  { shading: 'fabric' },
  { shading: { base: 'disney-2012', sheen: 'zeltner' } },
  { background: 'environment', variant: 'navy', layers: ['beauty'] },
  { background: { blur: 0.25 } },
  { background: { type: 'environment' } },
  { pose: null },
  { pose: { animation: 1 } },
  { pose: { animation: 'walk', time: -0.5 } },
  { quality: 'draft' },
  { quality: { samples: 1 } },
  { quality: { preset: 'standard' } },
  { quality: 'medium' },
  { quality: 'high' },
  { quality: { samples: 64, environmentSamples: 32 } },
  { quality: { samples: 256, noise: 2.5 } },
  { quality: 'reference' },
  { quality: { preset: 'reference', samples: 16, seed: 7, transport: 'direct', threads: 2 } },
  { quality: { preset: 'reference', transport: 'occlusion' } },
  { lens: { aperture: 8 } },
  { lens: { aperture: 2.8, shutter: 1 / 125, iso: 100, focusDistance: 'target' } },
  { output: { format: 'jpeg', quality: 80, ppi: 300, icc: true } },
  { output: { format: 'exr', bitDepth: 32 } },
];

function deepFreeze(value) {
  if (typeof value === 'object' && value !== null && !ArrayBuffer.isView(value)) Object.values(Object.freeze(value)).forEach(deepFreeze);
  return value;
}

test('a resolved shot has every key, resolves to itself and survives JSON', () => {
  for (const shot of SHOTS) {
    const resolved = resolveShot(shot, facts);
    const message = JSON.stringify(shot);
    assert.equal(resolvedShotSchema.safeParse(resolved).error, undefined, message);
    assert.deepEqual(resolveShot(resolved, facts), resolved, message);
    assert.deepEqual(resolveShot(resolved), resolved, `${message} without facts`);
    if (!(shot.environment instanceof Uint8Array)) assert.deepEqual(JSON.parse(JSON.stringify(resolved)), resolved, message);
  }
});

test('arguments stay as they were, and results share nothing', () => {
  for (const shot of SHOTS) {
    const resolved = resolveShot(deepFreeze(shot), deepFreeze(facts));
    const again = resolveShot(shot, facts);
    assert.deepEqual(again, resolved);
    // Spoil the first result in every place: a later one must not notice.
    const spoil = (value) =>
      Object.keys(value).forEach((key) => {
        if (typeof value[key] === 'object' && value[key] !== null && !ArrayBuffer.isView(value[key])) spoil(value[key]);
        else value[key] = 'spoilt';
      });
    spoil(resolved);
    assert.deepEqual(resolveShot(shot, facts), again, JSON.stringify(shot));
  }
});

/** What an object has under the keys of another, at any depth. */
const partOf = (value, keys) =>
  typeof keys !== 'object' || keys === null || Array.isArray(keys)
    ? value
    : Object.fromEntries(Object.entries(keys).map(([key, inner]) => [key, partOf(value[key], inner)]));

test('all defaults are written out', () => {
  const { camera, ...rest } = resolveShot({}, box);
  const expected = {
    size: { width: 512, height: 512 },
    lens: null,
    environment: { map: 'studio', intensity: 1, rotation: 0 },
    lights: [],
    modelLights: true,
    background: 'transparent',
    ground: 'none',
    shading: 'three',
    toneMapping: 'neutral',
    exposure: 1,
    quality: { preset: 'standard', samples: 4, resolve: 'encoded', noise: 0, environmentSamples: 0 },
    variant: '',
    pose: null,
    layers: ['beauty'],
    output: { format: 'png', quality: 90, bitDepth: 8, ppi: 0, icc: false },
  };
  assert.deepEqual(partOf(rest, expected), expected);
  assert.deepEqual(Object.keys(camera), ['projection', 'position', 'target', 'up', 'fovY', 'near', 'far']);
  assert.equal(camera.fovY, 30);
  assert.deepEqual(resolveShot(undefined, box), resolveShot({}, box));
});

test("the path tracer's settings are written out, and the lens focuses on the target", () => {
  const reference = { preset: 'reference', samples: 256, noise: 0, seed: 1, transport: 'global', bounces: 8, threads: 0 };
  assert.deepEqual(resolveShot({ quality: 'reference' }, box).quality, reference);
  assert.deepEqual(resolveShot({ quality: { preset: 'reference', transport: 'direct', samples: 4 } }, box).quality, {
    ...reference,
    samples: 4,
    transport: 'direct',
    bounces: 0,
  });
  const camera = { position: [0, 0, 5], target: [0, 3, 1], near: 0.1, far: 10 };
  assert.deepEqual(resolveShot({ camera, lens: { aperture: 8, focusDistance: 'target' } }).lens, { aperture: 8, shutter: null, iso: null, focusDistance: 5 });
});

test("defaults of lights are three.js's", () => {
  const types = ['ambient', 'hemisphere', 'directional', 'point', 'spot', 'rect'];
  assert.deepEqual(resolveShot({ lights: types.map((type) => ({ type })) }, box).lights, [
    { type: 'ambient', color: [1, 1, 1], intensity: 1 },
    { type: 'hemisphere', color: [1, 1, 1], intensity: 1, groundColor: [1, 1, 1] },
    { type: 'directional', color: [1, 1, 1], intensity: 1, position: [0, 1, 0], target: [0, 0, 0], castShadow: false },
    { type: 'point', color: [1, 1, 1], intensity: 1, position: [0, 0, 0], range: 0, castShadow: false },
    { type: 'spot', color: [1, 1, 1], intensity: 1, position: [0, 1, 0], target: [0, 0, 0], range: 0, angle: Math.PI / 3, penumbra: 0, castShadow: false },
    { type: 'rect', color: [1, 1, 1], intensity: 1, position: [0, 1, 0], target: [0, 0, 0], width: 10, height: 10 },
  ]);
});

test('a background with no blur is the environment as it is', () => {
  assert.equal(resolveShot({ background: { blur: 0 } }, box).background, 'environment');
  assert.deepEqual(resolveShot({ background: { blur: 0.3 } }, box).background, { type: 'environment', blur: 0.3 });
});

test('a jpeg without a background is white: it has no transparency', () => {
  assert.deepEqual(resolveShot({ output: { format: 'jpeg' } }, box).background, [1, 1, 1]);
});

test('bit depth follows the format', () => {
  const depths = ['png', 'jpeg', 'webp', 'tiff', 'exr', 'raw'].map((format) => resolveShot({ output: { format } }, box).output.bitDepth);
  assert.deepEqual(depths, [8, 8, 8, 8, 16, 8]);
});

test('a camera of the model becomes explicit; an infinite far plane is fitted', () => {
  const shop = resolveShot({ camera: { gltf: 'shop' } }, facts).camera;
  assert.deepEqual(
    { ...shop, far: 0 },
    {
      projection: 'perspective',
      position: [0, 1, 4],
      target: [0, 1, 3],
      up: [0, 1, 0],
      fovY: 40,
      near: 0.1,
      far: 0,
    },
  );
  assert.ok(shop.far > 4.2 && shop.far < 4.3);
  assert.deepEqual(resolveShot({ camera: { gltf: 1 } }, facts).camera, {
    projection: 'orthographic',
    position: [0, 5, 0],
    target: [0, 4, 0],
    up: [0, 0, -1],
    height: 2,
    near: 0.01,
    far: 10,
  });
});

test('height alone means orthographic', () => {
  const { projection, fovY } = resolveShot({ camera: { position: [0, 0, 3], target: [0, 0, 0], height: 2 } }, box).camera;
  assert.deepEqual([projection, fovY], ['orthographic', undefined]);
});

test('facts may be a THREE.Box3', async () => {
  const { Box3, Vector3 } = await import('three');
  assert.deepEqual(resolveShot({}, new Box3(new Vector3(...box.min), new Vector3(...box.max))), resolveShot({}, box));
  assert.throws(() => resolveShot({}, new Box3()), { code: 'E_NO_GEOMETRY' });
});
