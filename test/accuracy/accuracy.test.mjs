import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createRenderer } from '../../js/index.mjs';
import { POLISHED } from '../../js/material/table.mjs';
import { PRESETS } from '../../js/shot/table/quality.mjs';
import { ENVIRONMENTS, FABRIC_MODELS, MODELS } from '../fixtures/index.mjs';
import { editedGlb } from '../fixtures/edited_glb.mjs';
import { errorsOf } from './measure.mjs';

// Two smooth surfaces of npm run accuracy, held to where they are: at so few paths the reference's noise is part of the
// figures. js/docs/accuracy.md has the cloths, and how many of them reach the bar.
const SIZE = { width: 48, height: 48 };
const PATHS = 128;
const FLIP_MEAN = 0.03;
const DELTA_E_P95 = 2;

/** Of quality medium on satin in a studio, where it is at 0.036 with 768 paths; quality standard is at 0.101. */
const MEDIUM_FLIP = 0.07;

/** Where sequins in the sun are on either side of the roughness up to which facets are told from edges, and how near those of the preset are, whose edges glint one by one: by two highlights they would be at 0.3. */
const SEQUINS = { preset: 0.18, polished: POLISHED.roughnessMax - 0.01, dull: POLISHED.roughnessMax + 0.01, flip: 0.2, glints: 0.24 };

let renderer;
before(async () => {
  renderer = await createRenderer({ backend: 'egl-surfaceless', cacheDirectory: null });
});
after(() => renderer?.close());

for (const [model, sky, shading] of [
  ['ball', 'sunny-sky', 'three'],
  ['ball-metal', 'overcast-sky', 'fabric'],
]) {
  test(`quality high of ${model} in ${sky} as ${shading} is the path tracer's`, async () => {
    const shot = { size: SIZE, environment: ENVIRONMENTS[sky](), shading };
    const [standard, high] = await errorsOf(renderer, await MODELS[model](), shot, ['standard', PRESETS.high], PATHS);
    const facts = JSON.stringify({ standard, high });
    assert.ok(high.flip <= FLIP_MEAN && high.deltaE <= DELTA_E_P95, facts);
    assert.ok(high.flip <= standard.flip, facts);
  });
}

test('sequins in the sun glint, and where they are dull they do not', async () => {
  const camera = { position: [0, -0.03, 0.95], target: [0.08, 0.03, 0.06], fovY: (30 * SIZE.width) / 512 };
  const shot = { size: SIZE, camera, environment: ENVIRONMENTS['sunny-sky'](), shading: 'fabric' };
  const model = await FABRIC_MODELS['fabric-sequin-thread']();
  const flipOf = async (roughnessFactor) => {
    const made = editedGlb(model, (json) => {
      for (const material of json.materials) material.pbrMetallicRoughness = { ...material.pbrMetallicRoughness, metallicFactor: 1, roughnessFactor };
    });
    const [{ flip }] = await errorsOf(renderer, made, shot, ['standard'], PATHS);
    return flip;
  };
  const [preset, polished, dull] = [await flipOf(SEQUINS.preset), await flipOf(SEQUINS.polished), await flipOf(SEQUINS.dull)];
  const facts = JSON.stringify({ preset, polished, dull });
  assert.ok(preset <= SEQUINS.glints, facts);
  assert.ok(polished <= SEQUINS.flip, facts);
  assert.ok(dull > SEQUINS.flip, facts); // from that roughness on it is one highlight
});

test('quality medium of cloth is between standard and high, and would not be without its directions of the environment', async () => {
  const camera = { position: [0, -0.03, 0.95], target: [0.08, 0.03, 0.06], fovY: (30 * SIZE.width) / 512 };
  const shot = { size: SIZE, camera, environment: ENVIRONMENTS['soft-studio'](), shading: 'fabric' };
  const fault = { samples: 64, noise: 4, environmentSamples: 0 };
  const model = await FABRIC_MODELS['fabric-satin']();
  const [standard, medium, faulty] = await errorsOf(renderer, model, shot, ['standard', 'medium', fault], PATHS);
  const facts = JSON.stringify({ standard, medium, faulty });
  assert.ok(medium.flip <= MEDIUM_FLIP && medium.flip < standard.flip, facts);
  assert.ok(faulty.flip > MEDIUM_FLIP, facts);
});
