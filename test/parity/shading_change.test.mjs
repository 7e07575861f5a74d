// A client that goes from one shading to another and back, as the page of `telar view` does.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { ENVIRONMENTS, MODELS } from '../fixtures/index.mjs';
import { Browser } from './browser/chromium.mjs';
import { CASE_ENVIRONMENT, LIGHTS, shot } from './shot.mjs';

let browser;
before(async () => (browser = await Browser.start()));
after(() => browser?.close());

const SIZE = 64;
const base = { size: SIZE, environment: CASE_ENVIRONMENT, lights: [LIGHTS.directional] };
const apart = (a, b) => a.filter((value, i) => Math.abs(value - b[i]) > 1).length;

test('from stock three.js to cloth and back, the stock picture is the same to the byte, and nothing piles up', async () => {
  const shadings = ['three', 'fabric', 'three', 'fabric', 'three', 'fabric'];
  const { images, held } = await browser.sequence({
    model: await MODELS['physical-everything'](),
    environment: ENVIRONMENTS.lamps(),
    shots: shadings.map((shading) => shot({ ...base, shading })),
  });
  assert.ok(apart(images[0], images[1]) > 100, 'cloth looks otherwise');
  assert.deepEqual(images[2], images[0]);
  assert.deepEqual(images[4], images[0]);
  assert.deepEqual(images[5], images[3]);
  assert.deepEqual(images[3], images[1]);
  assert.deepEqual(held[5], held[1]);
});

test('variants change under a shading, and a shading under variants', async () => {
  const states = [
    ['three', ''],
    ['fabric', 'red'],
    ['fabric', ''],
    ['three', 'red'],
    ['three', ''],
    ['fabric', 'red'],
  ];
  const { images } = await browser.sequence({
    model: await MODELS.variants(),
    environment: ENVIRONMENTS.lamps(),
    shots: states.map(([shading, variant]) => shot({ ...base, shading, variant, camera: 'front' })),
  });
  const [plain, redCloth, cloth, red, plainAgain, redClothAgain] = images;
  assert.deepEqual(plainAgain, plain);
  assert.deepEqual(redClothAgain, redCloth);
  for (const [a, b] of [
    [plain, red],
    [cloth, redCloth],
    [plain, cloth],
    [red, redCloth],
  ])
    assert.ok(apart(a, b) > 4, `${apart(a, b)}`); // sides that are the same are 1 apart at most
});
