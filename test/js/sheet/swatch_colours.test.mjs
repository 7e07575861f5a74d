import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import '../api/support/real.mjs';
import { plane } from '../../fixtures/geometry.mjs';
import { GlbBuilder } from '../../fixtures/glb.mjs';
import { png } from '../../fixtures/images.mjs';
import { createRenderer } from '../../../js/index.mjs';
import { meanOf, Squares } from '../../../js/sheet/squares.mjs';

// The colour that a sheet prints is that of the texels, not of mip levels, which round at each: a driver that rounds otherwise printed another code.

let renderer;
before(async () => {
  renderer = await createRenderer();
});
after(() => renderer.close());

const SIDE = 128;
const codeOf = (x, y, c) => (x * 37 + y * 101 + c * 53 + ((x * y) % 17) * 11) % 256;
const linear = (code) => (code / 255 <= 0.04045 ? code / 255 / 12.92 : ((code / 255 + 0.055) / 1.055) ** 2.4);
const noise = () => png(SIDE, SIDE, (u, v, x, y) => [...[0, 1, 2].map((c) => codeOf(x, y, c) / 255), 1]);

function meanOfNoise() {
  const sums = [0, 0, 0];
  for (let y = 0; y < SIDE; ++y) for (let x = 0; x < SIDE; ++x) for (let c = 0; c < 3; ++c) sums[c] += linear(codeOf(x, y, c));
  return sums.map((sum) => sum / SIDE ** 2);
}

/** A panel of 20 cm. @param {object} material @param {number} tiles that lie on it along each side */
async function panel(material, tiles, colors = {}) {
  const builder = new GlbBuilder();
  builder.add({ ...plane(0.2, 0.2, { uvScale: tiles }), ...colors }, builder.material({ name: 'cloth', ...material }), { name: 'panel' });
  return renderer.load(await builder.bytes());
}

/** What a sheet prints, and what is known of it without drawing. */
async function coloursOf(model) {
  const squares = new Squares({ model, renderer, call: {} });
  const what = { material: 'cloth', variant: '' };
  return { ...(await squares.colour(what, [])), exact: (await squares.model(what, [])).facts.meanBaseColor };
}

const near = (actual, expected, tolerance) =>
  assert.ok(
    actual.every((value, c) => Math.abs(value - expected[c]) <= tolerance),
    `${actual} is not ${expected}`,
  );

test('it is the mean over the texels, however small they lie', async () => {
  const baseColor = { image: await noise(), wrap: [10497, 10497] };
  const factor = [0.9, 0.5, 0.25];
  const expected = meanOfNoise().map((value, c) => value * factor[c]);
  for (const tiles of [2, 3.7, 40]) {
    const { linear: printed } = await coloursOf(await panel({ baseColor: [...factor, 1], textures: { baseColor } }, tiles));
    near(printed, expected, 1e-7);
  }
  // Planted: levels of the texture, of which the picture of the square is drawn.
  const masked = await coloursOf(await panel({ baseColor: [...factor, 1], textures: { baseColor }, alphaMode: 'MASK' }, 40));
  assert.throws(() => near(masked.linear, expected, 1e-4));
  near(masked.linear, expected, 0.01);
});

test('without a texture it is the factor', async () => {
  near((await coloursOf(await panel({ baseColor: [0.3, 0.2, 0.1, 1] }, 1))).exact, [0.3, 0.2, 0.1], 1e-7);
});

test('a draped square is not asked for it', async () => {
  const model = await panel({ baseColor: [0.3, 0.2, 0.1, 1] }, 1);
  assert.equal((await model.swatch({ part: { material: 'cloth' }, draped: true })).facts.meanBaseColor, null);
});

test('what is no number is black, and no colour of letters', () => {
  assert.deepEqual(meanOf(new Float32Array([NaN, 0.5, 0.25, 1, 0.5, 0.75]), new Float32Array([1, 1])), [0.5, 0.5, 0.5]);
});

test('of what does not repeat on the square, or has holes, it is what is seen', async () => {
  // A light square in the middle of a dark one: the swatch shows the middle.
  const middle = (t) => Math.abs(t - 0.5) < 0.26;
  const light = await png(64, 64, (u, v) => [...Array(3).fill(middle(u) && middle(v) ? 0.8 : 0.1), 1]);
  const seen = async (textures, tiles, rest) => {
    const { exact, linear: printed } = await coloursOf(await panel({ baseColor: [1, 1, 1, 1], textures, ...rest }, tiles));
    assert.equal(exact, null);
    return printed[0];
  };
  const print = linear(Math.round(0.8 * 255));
  assert.ok(Math.abs((await seen({ baseColor: { image: light, wrap: [10497, 10497] } }, 1)) - print) < 0.01, 'half of a tile');
  const clamped = await seen({ baseColor: { image: light, wrap: [33071, 33071] } }, 4);
  assert.ok(clamped < 0.2, `${clamped}: one tile and what its edges are drawn out to`);
  const holes = await png(64, 64, (u) => (u < 0.5 ? [0.8, 0.8, 0.8, 1] : [0.1, 0.1, 0.1, 0]));
  const there = await seen({ baseColor: { image: holes, wrap: [10497, 10497] } }, 4, { alphaMode: 'MASK' });
  assert.ok(there > 0.5, `${there}: what is there`);
});
