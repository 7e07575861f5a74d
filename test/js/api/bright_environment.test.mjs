// Environments with texels that half floats, and so three.js, do not hold.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { createRenderer } from '../../../js/index.mjs';
import { ENVIRONMENTS, MODELS } from '../../fixtures/index.mjs';
import { hdr } from '../../fixtures/environment.mjs';
import { occlusionMap } from '../../fixtures/scenes_material.mjs';
import './support/real.mjs';

const OWN = ['fabric', 'three-r115', 'disney-2012'];

/** One texel in the dark, ahead of the model on its left. */
const sunOf = (radiance) => hdr(128, (_, u, v) => (Math.floor(u * 128) === 85 && Math.floor(v * 64) === 20 ? [radiance, radiance, radiance] : [0, 0, 0]));

const shotOf = (map, overrides) => ({
  size: { width: 64, height: 64 },
  environment: { map, intensity: 1e-3 },
  output: { format: 'raw', bitDepth: 32 },
  ...overrides,
});

/** What it says of the map's range. */
const rangeWarnings = ({ info }) => info.warnings.filter(({ code }) => code === 'W_ENVIRONMENT_RANGE');

/** Mean radiance of a frame. */
function light({ data }) {
  const floats = new Float32Array(data.buffer, data.byteOffset, data.length / 4);
  return floats.reduce((sum, value, i) => sum + (i % 4 === 3 ? 0 : value), 0) / floats.length;
}

let renderer, ball;
before(async () => {
  renderer = await createRenderer({ cacheDirectory: null });
  ball = await MODELS.ball();
});
after(() => renderer.close());

for (const shading of OWN) {
  test(`shading ${shading}: quality standard has the light of a sun of 1e6 that high has`, async () => {
    const draw = async (quality) => renderer.render(ball, shotOf(sunOf(1e6), { shading, quality }));
    const [standard, high] = [await draw('standard'), await draw({ samples: 16, environmentSamples: 512 })];
    const ratio = light(standard) / light(high);
    assert.ok(Math.abs(ratio - 1) < 0.05, `${ratio} of the light of quality high`);
    assert.deepEqual(rangeWarnings(standard), []);
  });
}

for (const shading of OWN) {
  test(`shading ${shading}: baked occlusion hides a sun as it hides the rest of the map, as much in standard as in high`, async () => {
    const glb = await occlusionMap();
    const draw = async (model, quality) => light(await renderer.render(model, shotOf(sunOf(1e6), { shading, quality })));
    // The bar is that of the suns themselves, above.
    const standard = await draw(glb, 'standard');
    const ratio = standard / (await draw(glb, { samples: 16, environmentSamples: 512 }));
    assert.ok(Math.abs(ratio - 1) < 0.05, `${ratio} of the light of quality high`);
    const hidden = standard / (await draw(await occlusionMap({ occlusionStrength: 0 }), 'standard'));
    assert.ok(hidden < 0.9, `${hidden} of the light without occlusion`);
  });
}

test('the sun stands where the map has it, turned with it', async () => {
  const side = async (rotation) => {
    const { data } = await renderer.render(ball, shotOf(sunOf(1e6), { shading: 'fabric', environment: { map: sunOf(1e6), intensity: 1e-3, rotation } }));
    const floats = new Float32Array(data.buffer, data.byteOffset, data.length / 4);
    return [0, 1].map((half) => light({ data: Float32Array.from(floats.filter((_, i) => Number(Math.floor(i / 4) % 64 >= 32) === half)) }));
  };
  const [left, right] = await side(0);
  const [turnedLeft, turnedRight] = await side(180);
  assert.ok(left !== right && Math.max(left, right) > Math.max(turnedLeft, turnedRight), 'the sun is in front of the ball, and behind it when it is turned');
});

test('shading three is as three.js: it says what it lacks, and its light is that of a sun of 65504', async () => {
  const held = 65279; // the brightest colour that RGBE and halves both hold
  const cut = await renderer.render(ball, shotOf(sunOf(1e6)));
  const least = await renderer.render(ball, shotOf(sunOf(held)));
  assert.ok(Math.abs(light(cut) / light(least) - 65504 / held) < 1e-3);
  assert.deepEqual(rangeWarnings(least), []);
  assert.equal(rangeWarnings(cut).length, 1);
  assert.match(rangeWarnings(cut)[0].message, /: 93\.\d % of the map's light is lost/);
});

test('nothing is said where nothing is lost: every quality that samples the map, and an unlit use of it', async () => {
  const sampled = await renderer.render(ball, shotOf(sunOf(1e6), { quality: { samples: 4, environmentSamples: 16 } }));
  assert.deepEqual(rangeWarnings(sampled), []);
  const behind = await renderer.render(ball, shotOf(sunOf(1e6), { environment: { map: sunOf(1e6), intensity: 0 }, background: 'environment' }));
  assert.deepEqual(rangeWarnings(behind), []);
  const within = await renderer.render(ball, shotOf(ENVIRONMENTS.lamps()));
  assert.deepEqual(rangeWarnings(within), []);
});

test('a cube from the disk cache has its suns too', async () => {
  const cacheDirectory = mkdtempSync(path.join(tmpdir(), 'telar-suns-'));
  try {
    const frames = [];
    for (const source of ['prefiltered', 'disk']) {
      const own = await createRenderer({ cacheDirectory });
      frames.push(await own.render(ball, shotOf(sunOf(1e6), { shading: 'fabric' })));
      await own.close();
      assert.equal(frames.at(-1).info.environmentSource, source);
    }
    assert.deepEqual(frames[1].data, frames[0].data);
  } finally {
    rmSync(cacheDirectory, { recursive: true });
  }
});

test('suns count to no limit of lights', async () => {
  const own = await createRenderer({ cacheDirectory: null, limits: { L_LIGHTS: 1 } });
  const lights = [{ type: 'ambient' }];
  await own.render(ball, shotOf(sunOf(1e6), { shading: 'fabric', lights }));
  await assert.rejects(own.render(ball, shotOf(sunOf(1e6), { shading: 'fabric', lights: [...lights, ...lights] })), { code: 'L_LIGHTS' });
  await own.close();
});
