import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { createRenderer } from '../../../js/index.mjs';
import { resolveShot } from '../../../js/shot/index.mjs';
import { MODELS } from '../../fixtures/index.mjs';
import './support/real.mjs';

const SIZE = 256;
const sun = (...position) => [{ type: 'directional', position, castShadow: true }];

let renderer, models;
before(async () => {
  renderer = await createRenderer({ cacheDirectory: null });
  const sources = { tshirt: readFileSync(new URL('../../../js/assets/tshirt.glb', import.meta.url)), ball: await MODELS.ball(), boxes: await MODELS.boxes() };
  models = Object.fromEntries(await Promise.all(Object.entries(sources).map(async ([name, bytes]) => [name, await renderer.load(bytes)])));
});
after(() => renderer.close());

/** Shots whose shadow was cut at the frame's edge before framing knew of it; all but the first four with a light of the shot. */
const SHOTS = {
  'contact shadow': { ground: {} },
  'contact shadow from three-quarter': { camera: { view: 'three-quarter' }, ground: {} },
  'contact shadow without perspective': { camera: { view: 'three-quarter', projection: 'orthographic' }, ground: { opacity: 1 } },
  'contact shadow, wide': { size: { width: 320, height: 128 }, camera: { azimuth: -40, elevation: 30 }, ground: {} },
  'sun from behind': { camera: { view: 'three-quarter' }, ground: { opacity: 1 }, lights: sun(-1.5, 2, -2) },
  'low sun': { camera: { azimuth: 20, elevation: 20 }, ground: { opacity: 1 }, lights: sun(3, 1.2, -1) },
  'sun from behind without perspective': { camera: { view: 'three-quarter', projection: 'orthographic' }, ground: { opacity: 1 }, lights: sun(-1.5, 2, -2) },
  'soft sun': { camera: { view: 'three-quarter' }, ground: { opacity: 1 }, lights: [{ ...sun(1.5, 3, 2)[0], shadow: { radius: 20, mapSize: 128 } }] },
  spot: { camera: { view: 'three-quarter' }, ground: { opacity: 1 }, lights: [{ type: 'spot', position: [-1.2, 3.2, -1.6], angle: 0.6, castShadow: true }] },
  point: {
    camera: { view: 'three-quarter' },
    ground: { opacity: 1 },
    lights: [{ type: 'point', position: [-0.9, 3.2, -1.1], castShadow: true, shadow: { mapSize: 128, radius: 6 } }],
  },
  'two suns': { camera: { azimuth: -30, elevation: 35 }, ground: { opacity: 0.8 }, lights: [...sun(2, 2, 0), ...sun(-2, 2, -1)] },
  turntable: { camera: { azimuth: 250, elevation: 25, fitTo: 'turntable' }, ground: {}, lights: sun(1.5, 2, -1) },
  'all directions': { camera: { azimuth: 250, elevation: 25, fitTo: 'all' }, ground: {}, lights: sun(1.5, 2, -1) },
};

const whole = (shot) => ({
  size: { width: SIZE, height: SIZE },
  environment: 'none',
  ...shot,
  lights: [{ type: 'ambient' }, ...(shot.lights ?? [])],
  output: { format: 'raw' },
});

/** Pixels of the frame's border that show anything. */
async function borderPixels(model, shot) {
  const {
    data,
    info: { width, height },
  } = await renderer.render(model, whole(shot));
  const isShown = (x, y) => data[4 * (y * width + x) + 3] > 0;
  let count = 0;
  for (let x = 0; x < width; x++) count += isShown(x, 0) + isShown(x, height - 1);
  for (let y = 0; y < height; y++) count += isShown(0, y) + isShown(width - 1, y);
  return count;
}

for (const [name, shot] of Object.entries(SHOTS)) {
  test(`the frame holds the whole shadow: ${name}`, async () => {
    for (const [of, model] of Object.entries(models)) {
      assert.equal(await borderPixels(model, shot), 0, of);
    }
    // What would be cut otherwise, and so what this test can see.
    if (shot.camera?.fitTo) return;
    const alone = await Promise.all(Object.values(models).map((model) => borderPixels(model, { ...shot, camera: { ...shot.camera, frame: 'model' } })));
    assert.ok(
      alone.some((pixels) => pixels > 0),
      `framed alone ${alone} pixels of the borders show something`,
    );
  });
}

test('the camera stays where it was where the shadow is in the frame already', () => {
  const facts = models.tshirt.facts;
  const cameras = (shot) => ['scene', 'model'].map((frame) => resolveShot({ ...shot, camera: { ...shot.camera, frame } }, facts).camera);
  for (const shot of [
    { ground: {}, camera: { view: 'three-quarter', fit: 0.5 } },
    { ground: { opacity: 0 } },
    // From beneath there is no ground to be seen, nor edge-on without perspective.
    { ground: {}, camera: { view: 'bottom' } },
    { ground: {}, camera: { azimuth: 30, elevation: -60 } },
    { ground: {}, camera: { projection: 'orthographic', elevation: 0 } },
    // A shadow that runs out of the frame, as on a photograph: longer than three times the model.
    { ground: {}, camera: { view: 'three-quarter' }, lights: sun(3, 0.3, -3) },
    // A light beside the model, whose shadow has no end.
    { ground: {}, lights: [{ type: 'point', position: [1, 0.3, 0], castShadow: true }] },
  ]) {
    const [scene, model] = cameras(shot);
    assert.deepEqual(scene, model, JSON.stringify(shot));
  }
  assert.notDeepEqual(...cameras({ ground: {}, camera: { view: 'three-quarter' } }));
});

test('of a ground that the caller sizes, only what lies on it counts', () => {
  const { facts } = models.tshirt;
  const shot = (size) => ({ camera: { view: 'three-quarter' }, ground: { size, position: [0, 0, 0] }, lights: sun(-1.5, 2, -2) });
  const distance = (size) => Math.hypot(...resolveShot(shot(size), facts).camera.position);
  assert.ok(distance([0.5, 0.5]) < distance([1, 1]) && distance([1, 1]) < distance([9, 9]));
  assert.equal(distance([9, 9]), distance([19, 19]));
});

test('the model keeps as much of the frame as the shadow leaves it', async () => {
  // The shadow's end and the model's top touch what each may take: nothing is given away.
  const shot = whole({ camera: { azimuth: 0, elevation: 40 }, ground: { opacity: 1 }, lights: sun(0, 2, -2) });
  const { data } = await renderer.render(models.tshirt, shot);
  const rows = Array.from({ length: SIZE }, (_, y) => data.subarray(4 * SIZE * y, 4 * SIZE * (y + 1)).some((value, i) => i % 4 === 3 && value > 0));
  assert.ok(Math.abs(rows.indexOf(true) - 0.05 * SIZE) <= 2, `first row ${rows.indexOf(true)}`);
  assert.ok(rows.lastIndexOf(true) > 0.96 * SIZE && rows.lastIndexOf(true) < 0.99 * SIZE, `last row ${rows.lastIndexOf(true)}`);
});
