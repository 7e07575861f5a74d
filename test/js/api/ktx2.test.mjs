import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createRenderer } from '../../../js/index.mjs';
import { MODELS } from '../../fixtures/index.mjs';
import './support/real.mjs';

let renderer;
before(async () => {
  renderer = await createRenderer({ cacheDirectory: null });
});
after(() => renderer.close());

const SHOT = {
  size: { width: 48, height: 48 },
  environment: 'none',
  lights: [{ type: 'directional', position: [1, 2, 3], intensity: 3 }],
  toneMapping: 'none',
  output: { format: 'raw', bitDepth: 32 },
};
const traced = { preset: 'reference', samples: 64, transport: 'direct' };

/** Mean of red, green and blue. */
async function meanOf(name, quality) {
  const { data } = await renderer.render(await MODELS[name](), quality ? { ...SHOT, quality } : SHOT);
  const floats = new Float32Array(data.buffer.slice(data.byteOffset, data.byteOffset + data.length));
  return [0, 1, 2].map((c) => floats.reduce((sum, value, i) => sum + (i % 4 === c ? value : 0), 0) / (floats.length / 4));
}

const farthest = (a, b) => Math.max(...a.map((value, c) => Math.abs(value / b[c] - 1)));

test('the path tracer reads the floats that the raster draws', async () => {
  const bytes = await meanOf('ktx2-raw-rgba8-srgb');
  for (const name of ['ktx2-raw-rgba16f', 'ktx2-raw-rgba32f', 'ktx2-raw-rgba16', 'ktx2-raw-e5b9g9r9']) {
    const raster = await meanOf(name);
    assert.ok(farthest(await meanOf(name, traced), raster) < 0.02, `${name}: ${raster}`);
    // Planted: the same texels decoded from sRGB, which floats are not, would be told.
    assert.ok(farthest(bytes, raster) > 0.1, `${name} against sRGB`);
  }
});

test('blocks of GPUs: drawn, and refused by name where there is no GPU', async () => {
  const model = await MODELS['ktx2-blocks-bc7-srgb']();
  await renderer.render(model, SHOT);
  await assert.rejects(renderer.render(model, { ...SHOT, quality: { ...traced, samples: 1 } }), {
    code: 'E_IMAGE_FORMAT',
    message: /the image is KTX2 BC7, blocks that only a GPU reads; for quality "reference" use a texture in PNG, or KTX2 in ETC1S or UASTC/,
  });
});
