import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import '../api/support/real.mjs';
import { plane } from '../../fixtures/geometry.mjs';
import { GlbBuilder } from '../../fixtures/glb.mjs';
import { png } from '../../fixtures/images.mjs';
import { createRenderer } from '../../../js/index.mjs';
import { ALBEDO, meanOf, Squares } from '../../../js/sheet/squares.mjs';

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
  // Planted: levels of the texture, of which the picture of a square is drawn.
  const masked = await panel({ baseColor: [...factor, 1], textures: { baseColor }, alphaMode: 'MASK' }, 40);
  const square = await new Squares({ model: masked, renderer, call: {} }).model({ material: 'cloth', variant: '' }, []);
  const { layers } = await renderer.render(square, ALBEDO);
  const [albedo, coverage] = [layers.albedo, layers.coverage].map((bytes) => new Float32Array(Uint8Array.from(bytes).buffer));
  assert.throws(() => near(meanOf(albedo, coverage), expected, 1e-4));
  near((await coloursOf(masked)).linear, expected, 1e-7);
});

test('without a texture it is the factor', async () => {
  near((await coloursOf(await panel({ baseColor: [0.3, 0.2, 0.1, 1] }, 1))).exact, [0.3, 0.2, 0.1], 1e-7);
});

/** An atlas: two panels in its corners, between them and around them what no triangle wears. */
const ATLAS = { red: [0.75, 0.2, 0.1], blue: [0.1, 0.3, 0.8], padding: [0, 1, 0] };
const atlas = (alpha = 1) =>
  png(256, 256, (u, v) => {
    const panel = [u, v].every((x) => x < 0.35) ? ATLAS.red : [u, v].every((x) => x > 0.7) ? ATLAS.blue : ATLAS.padding;
    return [...panel, panel === ATLAS.blue ? alpha : 1];
  });

/** A panel of 30 by 10 cm in red, one of 10 by 10 cm in blue. */
async function atlasModel(material) {
  const builder = new GlbBuilder();
  const index = builder.material({ name: 'cloth', ...material });
  const panels = [
    [0.3, 0.05, 0.3],
    [0.1, 0.72, 0.97],
  ];
  panels.forEach(([width, from, to], i) => {
    const flat = plane(width, 0.1, { cells: 8 });
    const uvs = Float32Array.from(flat.uvs, (x) => from + x * (to - from));
    builder.add({ ...flat, uvs }, index, { name: `panel-${i}` });
  });
  return renderer.load(await builder.bytes());
}

test('of an atlas it is the mean over what the garment shows of it, by area', async () => {
  const mixed = (red, blue) => ATLAS.red.map((value, c) => red * linear(Math.round(value * 255)) + blue * linear(Math.round(ATLAS.blue[c] * 255)));
  const colours = await coloursOf(await atlasModel({ textures: { baseColor: { image: await atlas() } } }));
  near(colours.linear, mixed(3 / 4, 1 / 4), 1e-6);
  // What is half there counts half; what is cut out does not.
  const blend = await coloursOf(await atlasModel({ alphaMode: 'BLEND', textures: { baseColor: { image: await atlas(0.5) } } }));
  near(blend.linear, mixed(6 / 7, 1 / 7), 1e-3);
  const mask = await coloursOf(await atlasModel({ alphaMode: 'MASK', textures: { baseColor: { image: await atlas(0) } } }));
  near(mask.linear, mixed(1, 0), 1e-6);
});

test('a square of an atlas shows the inside of a panel', async () => {
  const model = await atlasModel({ textures: { baseColor: { image: await atlas() } } });
  const square = await model.swatch({ part: { material: 'cloth' }, size: 0.02 });
  const shot = { size: { width: 33, height: 33 }, quality: 'draft', layers: ['albedo'], output: { layers: { format: 'raw' } } };
  const { albedo } = (await renderer.render(square, shot)).layers;
  const pixels = new Float32Array(albedo.buffer.slice(albedo.byteOffset, albedo.byteOffset + albedo.byteLength));
  const middle = 3 * (16 * 33 + 16);
  near(
    [...pixels.subarray(middle, middle + 3)],
    ATLAS.red.map((value) => linear(Math.round(value * 255))),
    0.01,
  );
});

test('a draped square is not asked for it', async () => {
  const model = await panel({ baseColor: [0.3, 0.2, 0.1, 1] }, 1);
  assert.equal((await model.swatch({ part: { material: 'cloth' }, draped: true })).facts.meanBaseColor, null);
});

test('what is no number is black, and no colour of letters', () => {
  assert.deepEqual(meanOf(new Float32Array([NaN, 0.5, 0.25, 1, 0.5, 0.75]), new Float32Array([1, 1])), [0.5, 0.5, 0.5]);
});

test('of a print of which the garment wears a part it is the mean over the panel', async () => {
  // A light square in the middle of a dark one.
  const side = 64;
  const [light, dark] = [0.8, 0.1].map((value) => linear(Math.round(value * 255)));
  const isLight = (t) => Math.abs(t - 0.5) < 0.25;
  const picture = await png(side, side, (u, v) => [...Array(3).fill(isLight(u) && isLight(v) ? 0.8 : 0.1), 1]);
  const colours = async (textures, tiles, rest) => coloursOf(await panel({ baseColor: [1, 1, 1, 1], textures, ...rest }, tiles));
  const print = await colours({ baseColor: { image: picture, wrap: [10497, 10497] } }, 1);
  near(print.linear, Array(3).fill(light / 4 + (dark * 3) / 4), 1e-3);
  const clamped = await colours({ baseColor: { image: picture, wrap: [33071, 33071] } }, 4);
  near(clamped.linear, Array(3).fill(light / 64 + (dark * 63) / 64), 1e-3);
  const mirrored = await colours({ baseColor: { image: await png(2, 2, (u) => [u, u, u, 1]), wrap: [33648, 33648] } }, 1.5);
  const [low, high] = [0.25, 0.75].map((value) => linear(Math.round(value * 255)));
  near(mirrored.linear, Array(3).fill(low / 3 + (high * 2) / 3), 1e-3); // low, high, and the mirror image of high
});

/** Half of it cloth of this colour, half a hole: what lies in the hole is of no colour, and its own is that of a file that says black or white there. */
const holed = (cloth, alpha, hole) => png(64, 64, (u, v, x) => (x % 8 < 4 ? [...cloth, alpha] : [...hole, 0]));

test('what is sheer or has holes has the colour of its cloth', async () => {
  const cloth = [0.8, 0.6, 0.4];
  const expected = cloth.map((value) => linear(Math.round(value * 255)));
  for (const alphaMode of ['BLEND', 'MASK'])
    for (const hole of [
      [0, 0, 0],
      [1, 1, 1],
    ])
      for (const tiles of [0.9, 4, 40]) {
        const baseColor = { image: await holed(cloth, alphaMode === 'MASK' ? 1 : 0.3, hole), wrap: [10497, 10497] };
        const { exact, linear: printed } = await coloursOf(
          await panel({ baseColor: [1, 1, 1, 1], textures: { baseColor }, alphaMode, doubleSided: true }, tiles),
        );
        near(printed, expected, 1e-6);
        assert.ok(exact, `${alphaMode}, ${tiles} tiles: not by a picture`);
      }
  // Without a texture, however sheer: also where nothing is left of it.
  for (const alpha of [1, 0.49, 0.1, 0])
    for (const alphaMode of ['BLEND', 'MASK'])
      near((await coloursOf(await panel({ baseColor: [0.8, 0.4, 0.2, alpha], alphaMode }, 1))).linear, [0.8, 0.4, 0.2], 1e-6);
  // A texture that cuts all away still has colours.
  const gone = { image: await png(4, 4, () => [...cloth, 0]), wrap: [10497, 10497] };
  for (const tiles of [0.5, 4]) near((await coloursOf(await panel({ textures: { baseColor: gone }, alphaMode: 'BLEND' }, tiles))).linear, expected, 1e-6);
});

test('what is sheer has its colour also where a picture tells it', async () => {
  // Texture coordinates are missing: no texel can be told.
  const builder = new GlbBuilder();
  const { uvs, ...bare } = plane(0.2, 0.2);
  const baseColor = { image: await png(4, 4, () => [0.8, 0.6, 0.4, 0.3]) };
  builder.add(bare, builder.material({ name: 'cloth', alphaMode: 'BLEND', textures: { baseColor } }), { name: 'panel' });
  const { exact, linear: printed } = await coloursOf(await renderer.load(await builder.bytes()));
  assert.equal(exact, null);
  near(
    printed,
    [0.8, 0.6, 0.4].map((value) => linear(Math.round(value * 255))),
    0.005,
  );
});

test('colours of vertices count by what covers there', async () => {
  const { positions } = plane(0.2, 0.2);
  const isLeft = Array.from({ length: positions.length / 3 }, (_, i) => positions[3 * i] < 0);
  // From red that covers to blue that does not: the alpha falls along the panel as the blue grows.
  const colors = Float32Array.from(isLeft.flatMap((left) => (left ? [1, 0, 0, 1] : [0, 0, 1, 0])));
  const { linear: printed } = await coloursOf(await panel({ alphaMode: 'BLEND' }, 1, { colors }));
  near(printed, [2 / 3, 0, 1 / 3], 1e-3);
});

test('a trim of any size has the colour of what it wears of an atlas', async () => {
  // Cloth in the middle, padding around it.
  const isCloth = (t) => t > 0.25 && t < 0.75;
  const baseColor = { image: await png(64, 64, (u, v) => [...(isCloth(u) && isCloth(v) ? [0.86, 0.12, 0.12] : [0, 0, 0]), 1]), wrap: [10497, 10497] };
  const expected = [0.86, 0.12, 0.12].map((value) => linear(Math.round(value * 255)));
  for (const side of [0.3, 0.05, 0.005])
    for (const offset of [0, 3]) {
      const builder = new GlbBuilder();
      const label = plane(side, side, { cells: 4 });
      const uvs = Float32Array.from(label.uvs, (t) => offset + 0.3 + 0.4 * t);
      builder.add({ ...label, uvs }, builder.material({ name: 'cloth', textures: { baseColor } }), { name: 'label' });
      near((await coloursOf(await renderer.load(await builder.bytes()))).linear, expected, 1e-6);
    }
});
