import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createRenderer } from '../../../js/index.mjs';
import { colored, plane } from '../../fixtures/geometry.mjs';
import { GlbBuilder } from '../../fixtures/glb.mjs';
import { png } from '../../fixtures/images.mjs';
import './support/real.mjs';

const PRIMARIES = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];
/** Three upright bands, red, green, blue, without filtering. */
const bands = async () => ({ image: await png(3, 1, (x) => [...PRIMARIES[Math.min(2, Math.floor(x * 3))], 1]), filter: [9728, 9728] });

const SIDE = 240;
const front = (size) => ({
  size: { width: SIDE, height: SIDE },
  camera: { projection: 'orthographic', position: [0, 0, 1], target: [0, 0, 0], height: size, near: 0.5, far: 2 },
});

let renderer;
before(async () => {
  renderer = await createRenderer();
});
after(() => renderer.close());

/** A sheet of cloth, 0.3 m wide, that shows the bands once over its width; twice as large where it is scaled. */
async function cloth({ scale = 1, mesh = plane(0.3, 0.2) } = {}) {
  const builder = new GlbBuilder();
  const striped = builder.material({ name: 'striped', textures: { baseColor: await bands() } });
  builder.add(mesh, striped, { name: 'panel', scale: [scale, scale, scale] });
  builder.add(plane(0.02, 0.02), builder.material({ name: 'button', baseColor: [0.1, 0.2, 0.3, 1] }), { name: 'button' });
  return renderer.load(await builder.bytes());
}

/** Shares of red, green and blue on the square. */
async function shares(model, options) {
  const size = options.size ?? 0.1;
  const { data } = await renderer.renderQuantity(await model.swatch(options), front(size), 'baseColor');
  const sums = [0, 0, 0];
  for (let i = 0; i < data.length; i += 4) for (let c = 0; c < 3; ++c) sums[c] += data[i + c] / (SIDE * SIDE);
  return sums;
}

const near = (actual, expected, tolerance = 0.01) =>
  assert.ok(
    actual.every((value, i) => Math.abs(value - expected[i]) <= tolerance),
    `${actual} is not ${expected}`,
  );

test('a square has the texture in the size that the garment has', async () => {
  const model = await cloth();
  const part = { material: 'striped' };
  near(await shares(model, { part }), [0, 1, 0]);
  near(await shares(model, { part, size: 0.2 }), [0.25, 0.5, 0.25]);
  near(await shares(model, { part, size: 0.3 }), [1 / 3, 1 / 3, 1 / 3]);
  const twice = await cloth({ scale: 2 });
  near(await shares(twice, { part, size: 0.4 }), [0.25, 0.5, 0.25]);
  // Planted: a garment twice as large is another square.
  assert.throws(() => near([0.25, 0.5, 0.25], [0, 1, 0]));
});

test('it is not mirrored; a garment whose texture is mirrored has it mirrored', async () => {
  const left = async (model) => {
    const { data } = await renderer.renderQuantity(await model.swatch({ part: { node: 'panel' }, size: 0.2 }), front(0.2), 'baseColor');
    return [data[4 * (SIDE * 120 + 5)], data[4 * (SIDE * 120 + SIDE - 5) + 2]];
  };
  near(await left(await cloth()), [1, 1]);
  const turned = plane(0.3, 0.2);
  turned.uvs = turned.uvs.map((value, i) => (i % 2 === 0 ? 1 - value : value));
  const { data } = await renderer.renderQuantity(await (await cloth({ mesh: turned })).swatch({ part: { node: 'panel' }, size: 0.2 }), front(0.2), 'baseColor');
  near([data[4 * (SIDE * 120 + 5) + 2]], [1]);
});

test('of a node the material that covers most of it is shown, in its variant and with the colours of its vertices', async () => {
  const model = await cloth();
  near(await shares(model, { part: { material: 'button' } }), [0.1, 0.2, 0.3]);
  near(await shares(model, { part: { node: 'button' } }), [0.1, 0.2, 0.3]);
  const half = await cloth({ mesh: colored(plane(0.3, 0.2), () => [0.5, 0.5, 0.5]) });
  near(await shares(half, { part: { material: 'striped' } }), [0, 0.5, 0]);
  const shirt = await renderer.load(new URL('../../../js/assets/tshirt.glb', import.meta.url));
  const [natural, indigo] = await Promise.all(['natural', 'indigo'].map((variant) => shares(shirt, { part: { node: 'front' }, variant })));
  assert.ok(natural[0] > 4 * indigo[0], `${natural} ${indigo}`);
});

test('draped, its rows keep their length and it stays in its place', async () => {
  const square = await (await cloth()).swatch({ part: { material: 'striped' }, draped: true, size: 0.1 });
  const { min, max } = square.facts.bounds;
  assert.ok(Math.abs(min[1] + 0.05) < 1e-6 && Math.abs(max[1] - 0.05) < 1e-6 && max[0] - min[0] > 0.099 && max[2] - min[2] > 0.008);
  const corner = (x, y) => ({ node: 'swatch', vertex: x + 65 * y });
  const along = async (y) => (await square.measure({ points: Array.from({ length: 65 }, (_, x) => corner(x, y)) })).length;
  // 64 chords of a curve whose radius is at least 7 mm are 0.1 % shorter than it.
  for (const y of [0, 20, 64]) assert.ok(Math.abs((await along(y)) - 0.1) < 2e-4, `row ${y}: ${await along(y)}`);
  // The lowest row is folded: it is much shorter through the air.
  const { length } = await square.measure({ points: [corner(0, 0), corner(64, 0)] });
  assert.ok(length < 0.085, `${length}`);
});

test('it renders, and wrong options are named', async () => {
  const model = await cloth();
  const { info } = await renderer.render(await model.swatch({ part: { material: 'striped' } }), { size: { width: 40, height: 40 }, environment: 'none' });
  const other = await renderer.render(await model.swatch({ part: { material: 'button' } }), { size: { width: 40, height: 40 }, environment: 'none' });
  assert.notEqual(info.key, other.info.key);
  const cases = [
    [{}, /options\.part/],
    [{ part: { material: 'striped' }, size: 0 }, /options\.size: expected metres from 0\.001 to 10/],
    [{ part: { material: 'striped' }, draped: 1 }, /options\.draped/],
    [{ part: { material: 'striped' }, drape: true }, /options\.drape: unknown key/],
  ];
  for (const [options, message] of cases) await assert.rejects(model.swatch(options), { code: 'E_OPTION', message });
  await assert.rejects(model.swatch({ part: { material: 'silk' } }), { code: 'E_MEASURE', pointer: '/part' });
  await assert.rejects(model.swatch({ part: { material: 'striped' }, variant: 'silk' }), { code: 'E_VARIANT' });
});
