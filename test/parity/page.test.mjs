// The browser side against facts that are known without it, so that a fault there is not taken for the client's look.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { ENVIRONMENTS, MODELS } from '../fixtures/index.mjs';
import { Browser } from './browser/chromium.mjs';
import { CASE_ENVIRONMENT, shot } from './shot.mjs';

const SIZE = 64;
let browser;
before(async () => (browser = await Browser.start()));
after(() => browser?.close());

const centre = ({ image, width, height }) => Array.from(image.subarray(((height / 2) * width + width / 2) * 4).subarray(0, 4));

/** 8-bit greys of each curve for linear 0.18, 1 and 4, from the published formulas (brightness by exposure). */
const GREYS = {
  neutral: [105, 240, 253],
  aces: [127, 226, 250],
  agx: [128, 202, 239],
  reinhard: [109, 188, 231],
  linear: [118, 255, 255],
};

for (const [toneMapping, expected] of Object.entries(GREYS)) {
  test(`tone mapping ${toneMapping} gives the greys of its formula`, async () => {
    const model = await MODELS['ball-grey-unlit']();
    const greys = [];
    for (const radiance of [0.18, 1, 4]) {
      const drawn = await browser.draw({ model, shot: shot({ size: SIZE, toneMapping, exposure: radiance / 0.18 }) });
      greys.push(centre(drawn)[0]);
    }
    assert.deepEqual(greys, expected);
  });
}

test('the drawing buffer has 4 samples, premultiplied edges and transparent corners', async () => {
  const { image, facts } = await browser.draw({ model: await MODELS['ball-grey-unlit'](), shot: shot({ size: SIZE, toneMapping: 'none' }) });
  assert.equal(facts.samples, 4);
  assert.equal(facts.three, '187');
  assert.deepEqual(Array.from(image.subarray(0, 4)), [0, 0, 0, 0]);
  const alphas = new Set(image.filter((_, i) => i % 4 === 3));
  assert.deepEqual(
    [...alphas].sort((a, b) => a - b),
    [0, 64, 128, 191, 255],
  );
  for (let i = 0; i < image.length; i += 4) assert.ok(Math.abs(image[i] - (118 * image[i + 3]) / 255) <= 1);
});

test('a solid background is converted to sRGB and not tone mapped', async () => {
  const drawn = await browser.draw({ model: await MODELS.ball(), shot: shot({ size: SIZE, toneMapping: 'aces', background: [0.18, 0.18, 0.18] }) });
  assert.deepEqual(Array.from(drawn.image.subarray(0, 4)), [118, 118, 118, 255]);
  assert.deepEqual(Array.from(drawn.mask.subarray(0, 4)), [0, 0, 0, 0]);
});

test('a white dielectric and a white metal in a white furnace show radiance 1', async () => {
  const environment = ENVIRONMENTS.one();
  for (const model of ['furnace-0.5', 'furnace-metal-0.5']) {
    const input = { environment, model: await MODELS[model](), shot: shot({ size: SIZE, environment: CASE_ENVIRONMENT }) };
    const { linear } = await browser.terms({ ...input, terms: ['linear'] });
    const radiance = linear[((SIZE / 2) * SIZE + SIZE / 2) * 4];
    assert.ok(Math.abs(radiance - 1) < 0.005, `${model}: ${radiance}`);
  }
});

test('a black sphere reflects a directional light by the DFG-compensated GGX lobe alone', async () => {
  const lights = [{ type: 'directional', color: [1, 1, 1], intensity: Math.PI, position: [0, 0, 1], target: [0, 0, 0] }];
  const input = { model: await MODELS['ball-black'](), shot: shot({ size: SIZE, camera: 'ortho', lights }) };
  const terms = ['directDiffuse', 'directSpecular', 'perceptualRoughness', 'dfg'];
  const { directDiffuse, directSpecular, perceptualRoughness, dfg } = await browser.terms({ ...input, terms });
  const at = ((SIZE / 2) * SIZE + SIZE / 2) * 4;
  assert.equal(directDiffuse[at], 0);
  // N.V, N.L, N.H and V.H are 1 within 1e-3 at the centre: D = 1 / (pi alpha^2), V = 1/4, F = F0.
  const alpha = perceptualRoughness[at] ** 2;
  const expected = (0.04 * (1 + 0.04 * (1 / (dfg[at] + dfg[at + 1]) - 1))) / (4 * alpha * alpha);
  assert.ok(Math.abs(directSpecular[at] / expected - 1) < 0.02, `${directSpecular[at]} against ${expected}`);
});
