// Maps of shapes that no panorama has: what they cost goes by their longer side, and a GL has a largest texture.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createRenderer } from '../../js/index.mjs';
import { MODELS } from '../fixtures/index.mjs';

const SHOT = { size: { width: 16, height: 16 }, quality: { samples: 1, environmentSize: 64, prefilterSamples: 16 } };
const TRUSTING = 1e10;

let model;
const renderers = {};
before(async () => {
  model = await Object.values(MODELS)[0]();
  renderers.usual = await createRenderer();
  renderers.trusting = await createRenderer({ limits: { L_ENVIRONMENT_PIXELS: TRUSTING } });
});
after(() => Promise.all(Object.values(renderers).map((renderer) => renderer.close())));

/** All texels alike. */
const hdr = (width, height) =>
  Buffer.concat([Buffer.from(`#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y ${height} +X ${width}\n`), Buffer.alloc(4 * width * height, 128)]);

const render = (renderer, environment, more = {}) => renderer.render(model, { ...SHOT, environment, ...more });

for (const [width, height] of [
  [16384, 1],
  [16384, 4],
  [20000, 4],
  [40000, 2],
  [2, 20000],
]) {
  test(`.hdr ${width} x ${height} is over the limit`, async () => {
    const before = process.memoryUsage().rss;
    await assert.rejects(render(renderers.usual, hdr(width, height)), (error) => {
      assert.deepEqual([error.code, error.http, error.retryable], ['L_ENVIRONMENT_PIXELS', 413, false]);
      assert.match(error.message, new RegExp(`^L_ENVIRONMENT_PIXELS: an environment of ${width} x ${height} pixels costs as much as one of `));
      return true;
    });
    // The cube of 16384 columns alone has 768 MiB without its levels.
    assert.ok(process.memoryUsage().rss - before < 200 * 2 ** 20);
  });
}

test('what no texture of this GL holds is told with its side, though the limit was raised', async () => {
  for (const [width, height, background] of [
    [70000, 4, 'transparent'],
    [2, 70000, 'transparent'],
    [2, 70000, 'environment'],
  ]) {
    await assert.rejects(render(renderers.trusting, hdr(width, height), { background }), (error) => {
      assert.deepEqual([error.code, error.http, error.retryable], ['L_ENVIRONMENT_PIXELS', 413, false]);
      assert.match(
        error.message,
        /^L_ENVIRONMENT_PIXELS: the environment has a side of 70000 pixels, and the largest texture of this OpenGL \d+; give a smaller map$/,
      );
      assert.equal(error.limit.actual, 70000);
      return true;
    });
  }
});

test('a map of another shape that is not too large is drawn', async () => {
  for (const [width, height] of [
    [4096, 1],
    [1, 512],
    [512, 512],
  ])
    assert.equal((await render(renderers.usual, hdr(width, height))).info.size?.width ?? 16, 16);
});
