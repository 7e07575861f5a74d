import assert from 'node:assert/strict';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { createRenderer } from '../../../js/index.mjs';
import { compareImages, readImage } from '../../../js/compare/index.mjs';
import { createPool } from '../../../js/pool/index.mjs';
import { MODELS } from '../../fixtures/index.mjs';
import './support/real.mjs';

// The option onPreview: the picture so far.

const SIZE = { width: 48, height: 48 };
const SHOT = { size: SIZE, shading: 'fabric', output: { format: 'raw' } };
const QUALITIES = {
  raster: { samples: 256, environmentSamples: 512 },
  tracer: { preset: 'reference', transport: 'direct', samples: 300 },
  'tracer with noise': { preset: 'reference', transport: 'direct', samples: 2048, noise: 1 },
};

let renderer, model;
before(async () => {
  renderer = await createRenderer({ cacheDirectory: null });
  model = await renderer.load(await MODELS.ball());
});
after(() => renderer.close());

async function drawn(quality, more = {}) {
  const previews = [];
  const { data, info } = await renderer.render(model, { ...SHOT, ...more, quality }, { onPreview: (preview) => previews.push(preview) });
  return { data, info, previews };
}

for (const [name, quality] of Object.entries(QUALITIES)) {
  test(`${name}: powers of two, nearer and nearer, and the same bytes in the end`, async () => {
    const { data, info, previews } = await drawn(quality);
    assert.ok(previews.length >= 2, String(previews.length));
    const samples = previews.map((preview) => preview.samples);
    assert.deepEqual(
      samples,
      [...new Set(samples)].toSorted((a, b) => a - b),
    );
    assert.ok(
      samples.every((count) => Number.isInteger(Math.log2(count)) && count < info.samples),
      `${samples} of ${info.samples}`,
    );
    const apart = (bytes) => compareImages({ ...SIZE, data }, { ...SIZE, data: bytes }).object.flip.mean;
    for (const { width, height, bitDepth, data: bytes } of previews) assert.deepEqual([width, height, bitDepth, bytes.length], [48, 48, 8, 48 * 48 * 4]);
    const errors = previews.map((preview) => apart(preview.data));
    assert.ok(errors.at(-1) < errors[0] && errors.at(-1) > 0, String(errors));
    const flipped = Buffer.from(previews.at(-1).data).reverse();
    assert.ok(apart(flipped) > 2 * errors.at(-1), 'planted fault: a preview upside down');
    const plain = await renderer.render(model, { ...SHOT, quality });
    assert.ok(plain.data.equals(data), 'previews change nothing');
  });
}

test('an abort and what it throws end the work', async () => {
  const endless = { preset: 'reference', samples: 65536 };
  const ended = new AbortController();
  let last;
  const onPreview = (preview) => {
    last = preview;
    if (preview.samples >= 8) ended.abort();
  };
  await assert.rejects(renderer.render(model, { ...SHOT, quality: endless }, { onPreview, signal: ended.signal }), { name: 'AbortError' });
  assert.ok(last.samples >= 8 && last.samples < 65536);
  const thrown = new Error('enough');
  const fail = () => {
    throw thrown;
  };
  await assert.rejects(renderer.render(model, { ...SHOT, quality: endless }, { onPreview: fail }), (error) => error === thrown);
});

for (const [name, quality] of Object.entries({ ...QUALITIES, 'all paths': { preset: 'reference', samples: 65536 } })) {
  test(`${name}: a caller who has enough gets the picture as it is, encoded, with a key of its own`, async () => {
    const enough = new AbortController();
    let last;
    const onPreview = (preview) => {
      last = preview;
      if (preview.samples >= 4) enough.abort();
    };
    const output = { format: 'png' };
    const { data, info } = await renderer.render(model, { ...SHOT, quality, output }, { onPreview, enough: enough.signal });
    assert.ok(info.ended >= 4 && info.ended === info.samples && info.samples < quality.samples, `${info.ended} of ${info.samples}`);
    const { data: pixels } = await readImage(data);
    const apart = (bytes) => compareImages({ ...SIZE, data: last.data }, { ...SIZE, data: bytes }).object.flip.mean;
    assert.ok(apart(pixels) < 0.2, String(apart(pixels)));
    assert.ok(apart(Buffer.from(pixels).reverse()) > 2 * apart(pixels), 'planted fault: upside down');
    const { key } = (await renderer.render(model, { ...SHOT, quality: 'standard', output })).info;
    assert.notEqual(info.key, key);
  });
}

test('who has enough before it begins gets one round; a picture of one pass is finished, with its own key', async () => {
  const enough = AbortSignal.abort();
  const { info } = await renderer.render(model, { ...SHOT, quality: QUALITIES.tracer }, { enough });
  assert.equal(info.ended, 1);
  const [plain, asked] = [await renderer.render(model, SHOT), await renderer.render(model, SHOT, { enough })];
  assert.deepEqual([asked.info.ended, asked.info.key], [undefined, plain.info.key]);
  assert.ok(asked.data.equals(plain.data));
  await assert.rejects(renderer.render(model, SHOT, { enough: true }), {
    code: 'E_OPTION',
    message: 'options.enough: expected an AbortSignal, got true',
  });
});

test('floats for outputs of floats; none where one pass is all', async () => {
  const output = { format: 'raw', bitDepth: 32 };
  const { previews } = await drawn(QUALITIES.tracer, { output });
  assert.deepEqual([previews[0].bitDepth, previews[0].data.length], [32, 48 * 48 * 16]);
  assert.deepEqual((await drawn('standard')).previews, []);
});

test('of a pool: the same previews, an abort, and what it throws', async () => {
  const pool = await createPool({ size: 1, cacheDirectory: null });
  try {
    const size = { width: 40, height: 30 };
    const quality = { preset: 'reference', samples: 64 };
    const [previews, own] = [[], await drawn(quality, { size })];
    const { data } = await pool.render(await MODELS.ball(), { ...SHOT, size, quality }, { onPreview: (preview) => previews.push(preview) });
    assert.ok(data.equals(own.data));
    // Which are overtaken by the next goes by the load of the machine.
    const bySamples = new Map(own.previews.map((preview) => [preview.samples, preview]));
    const common = previews.filter(({ samples }) => bySamples.has(samples));
    assert.ok(common.length > 0, `${previews.map(({ samples }) => samples)} and ${[...bySamples.keys()]}`);
    for (const preview of common) assert.deepEqual(preview, bySamples.get(preview.samples));
    assert.notDeepEqual(common[0].data, Buffer.from(common[0].data).reverse(), 'planted fault: upside down');
    const thrown = new Error('enough');
    const fail = () => {
      throw thrown;
    };
    const endless = { ...SHOT, quality: { preset: 'reference', samples: 65536 } };
    await assert.rejects(pool.render(await MODELS.ball(), endless, { onPreview: fail }), (error) => error === thrown);
  } finally {
    await pool.close();
  }
});

test('what is no function is refused, by a pool too', async () => {
  await assert.rejects(renderer.render(model, SHOT, { onPreview: 1 }), { code: 'E_OPTION', message: 'options.onPreview: expected a function, got 1' });
  const pool = await createPool({ size: 1 });
  try {
    await assert.rejects(pool.render(path.resolve('none.glb'), SHOT, { onPreview: 1 }), { code: 'E_OPTION' });
  } finally {
    await pool.close();
  }
});
