import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import { FloatType } from 'three';
import { HDRLoader } from 'three/examples/jsm/loaders/HDRLoader.js';
import { encodeRgbe } from '../../../js/assets/make/rgbe.mjs';
import { FRONT_LEVEL, STUDIO_HEIGHT, STUDIO_WIDTH, irradiance, makeStudio } from '../../../js/assets/make/studio.mjs';

const file = new URL('../../../js/assets/studio.hdr', import.meta.url);

async function readStudio() {
  const bytes = await readFile(file);
  const { data, width, height } = new HDRLoader().setDataType(FloatType).parse(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
  return { bytes, data, width, height };
}

function meanColour(data, width, height) {
  const mean = [0, 0, 0];
  for (let i = 0; i < width * height; i++) {
    const weight = Math.cos((0.5 - (Math.floor(i / width) + 0.5) / height) * Math.PI);
    for (let c = 0; c < 3; c++) mean[c] += data[i * 4 + c] * weight;
  }
  return mean;
}

test('the committed studio is what its script makes', async () => {
  assert.ok(makeStudio().equals(await readFile(file)), 'js/assets/studio.hdr is stale: npm run assets');
});

test('the studio is small, equirectangular and readable by the browser client', async () => {
  const { bytes, data, width, height } = await readStudio();
  assert.ok(bytes.length < 400e3);
  assert.deepEqual([width, height], [STUDIO_WIDTH, STUDIO_HEIGHT]);
  assert.ok(data.every((value) => Number.isFinite(value) && value >= 0));
});

test('the studio is neutral within 0.5 %', async () => {
  const { data, width, height } = await readStudio();
  const mean = meanColour(data, width, height);
  const grey = (mean[0] + mean[1] + mean[2]) / 3;
  for (const value of mean) assert.ok(Math.abs(value / grey - 1) < 0.005);
});

test('a white cloth that faces the camera is exposed for the neutral tone curve', async () => {
  const { data, width, height } = await readStudio();
  const grey = Float64Array.from({ length: width * height }, (_, i) => data[i * 4]);
  const front = irradiance(grey, width, height, [0, 0, 1]);
  assert.ok(Math.abs(front / FRONT_LEVEL - 1) < 0.01);
  // Neutral subtracts 0.04 below its shoulder at 0.76 (Khronos PBR Neutral); then the sRGB curve.
  const shown = 1.055 * (0.8 * front - 0.04) ** (1 / 2.4) - 0.055;
  assert.ok(shown > 0.78 && shown < 0.87, `shown ${shown}`);
});

test('the key is strong enough to model folds and soft enough to be free of fireflies', async () => {
  const { data, width, height } = await readStudio();
  const grey = Float64Array.from({ length: width * height }, (_, i) => data[i * 4]);
  const unit = (x, y, z) => [x, y, z].map((v) => v / Math.hypot(x, y, z));
  const key = irradiance(grey, width, height, unit(-0.75, 0.5, 0.5));
  const fill = irradiance(grey, width, height, unit(0.9, -0.1, 0.5));
  assert.ok(key / fill > 2 && key / fill < 4, `key over fill ${key / fill}`);
  const peak = grey.reduce((a, b) => Math.max(a, b));
  assert.ok(peak < 10, `peak ${peak}`);
});

test("shared exponents keep every value within one part in 128 of the texel's largest", () => {
  const width = 16;
  const values = Float64Array.from({ length: width * 2 * 3 }, (_, i) => [0, 1e-3, 0.4999, 0.99999, 1, 7.97, 130][i % 7]);
  const bytes = encodeRgbe(values, width, 2);
  const { data } = new HDRLoader().setDataType(FloatType).parse(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
  for (let i = 0; i < width * 2; i++) {
    const texel = [0, 1, 2].map((c) => values[i * 3 + c]);
    for (let c = 0; c < 3; c++) assert.ok(Math.abs(data[i * 4 + c] - texel[c]) <= Math.max(...texel) / 128 + 1e-9, `${texel[c]} became ${data[i * 4 + c]}`);
  }
});

test('a picture that the run-length form cannot hold is refused', () => {
  assert.throws(() => encodeRgbe(new Float64Array(4 * 4 * 3), 4, 4), /Expected a width in 8\.\.32767 but received 4/);
});
