import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createRenderer } from '../../../js/index.mjs';
import { plane } from '../../fixtures/geometry.mjs';
import { GlbBuilder } from '../../fixtures/glb.mjs';
import './support/real.mjs';

const INCH = 25.4;

let renderer;
let square;
before(async () => {
  renderer = await createRenderer();
  const builder = new GlbBuilder();
  builder.add(plane(0.3, 0.3), builder.material({ name: 'black', unlit: true, baseColor: [0, 0, 0, 1] }), { name: 'square', translation: [0.2, 0.7, 0.1] });
  square = await renderer.load(await builder.bytes());
});
after(() => renderer.close());

/** Width and height of what is dark, in pixels to a part of one: each row and column by the mean of its ink. */
function inkOf({ data, info: { width, height } }) {
  const rows = new Float64Array(height);
  const columns = new Float64Array(width);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const ink = 1 - data[4 * (y * width + x)] / 255;
      rows[y] += ink;
      columns[x] += ink;
    }
  }
  const lengthOf = (sums) => sums.reduce((a, b) => a + b, 0) / sums.reduce((a, b) => Math.max(a, b), 0);
  return { width: lengthOf(columns), height: lengthOf(rows) };
}

const RAW = { format: 'raw', ppi: 300 };

for (const [scale, ratio] of [
  ['1:1', 1],
  ['1:5', 5],
  ['2:3', 1.5],
]) {
  test(`a square of 300 mm is right within 0.2 mm of paper at ${scale} and 300 ppi`, async () => {
    const drawn = await renderer.render(square, { scale, background: 'white', toneMapping: 'none', output: RAW });
    const { info } = drawn;
    const ink = inkOf(drawn);
    const millimetres = (pixels) => (pixels * INCH) / 300;
    const off = (side) => Math.abs(millimetres(side) - 300 / ratio);
    assert.ok(off(ink.width) < 0.2 && off(ink.height) < 0.2, `${millimetres(ink.width)} x ${millimetres(ink.height)} mm`);
    assert.ok(off(ink.width * (1 + 0.3 / (300 / ratio))) > 0.2, 'a square that is 0.3 mm too wide');
    assert.ok(Math.abs(info.millimetresPerPixel - (INCH / 300) * ratio) < 1e-12, `${info.millimetresPerPixel}`);
    // Its corners by the matrix.
    const pixelOf = ([x, y, z]) =>
      [0, 1].map((r) => info.worldToPixel[r] * x + info.worldToPixel[4 + r] * y + info.worldToPixel[8 + r] * z + info.worldToPixel[12 + r]);
    const [a, b] = [pixelOf([0.05, 0.85, 0.1]), pixelOf([0.35, 0.55, 0.1])];
    assert.ok(Math.abs(b[0] - a[0] - 300 / info.millimetresPerPixel) < 1e-6);
    assert.ok(Math.abs(b[1] - a[1] - 300 / info.millimetresPerPixel) < 1e-6);
    // 0.9 of the frame, as large as that needs.
    const side = Math.ceil((300 / info.millimetresPerPixel / 0.9) * (1 - 1e-9));
    assert.ok(Math.abs(info.width - side) <= 1 && Math.abs(info.height - side) <= 1, `${info.width} x ${info.height}, not ${side}`);
    assert.ok(Math.abs(a[0] + b[0] - info.width) < 1e-3, 'in the middle');
  });
}

test('a size that is given stays, and the scale holds', async () => {
  const drawn = await renderer.render(square, {
    scale: '1:4',
    size: { width: 1001, height: 900 },
    background: 'white',
    toneMapping: 'none',
    output: RAW,
  });
  assert.deepEqual([drawn.info.width, drawn.info.height], [1001, 900]);
  assert.ok(Math.abs((inkOf(drawn).width * INCH) / 300 - 75) < 0.2);
});

test('a resolved shot with a scale resolves to itself', async () => {
  const { info } = await renderer.render(square, { scale: '1:7', output: { format: 'png', ppi: 150 }, camera: { view: 'three-quarter' } });
  const again = await renderer.render(square, info.shot);
  assert.deepEqual(again.info.shot, info.shot);
  assert.equal(info.shot.camera.projection, 'orthographic');
});

test('in perspective there is no scale', async () => {
  const { info } = await renderer.render(square, { size: { width: 32, height: 32 } });
  assert.equal(info.millimetresPerPixel, null);
});

test('the flat is drawn by the camera of the colour: lines in true scale, ink on paper or on nothing', async () => {
  const shot = { scale: '1:2', output: RAW, style: 'flat', flat: { weights: { silhouette: 1 } } };
  const { data, info } = await renderer.render(square, shot);
  assert.deepEqual(info.passes, ['flat']);
  const row = (y) => Array.from({ length: info.width }, (_, x) => 1 - data[4 * (y * info.width + x)] / 255);
  const middle = row(Math.floor(info.height / 2));
  // Two lines of 1 mm, 150 mm of paper apart.
  const ink = middle.reduce((a, b) => a + b, 0);
  assert.ok(Math.abs((ink * INCH) / 300 - 2) < 0.05, `${(ink * INCH) / 300} mm of ink`);
  const half = info.width / 2;
  const centre = (part) => part.reduce((sum, { x, v }) => sum + (x + 0.5) * v, 0) / part.reduce((sum, { v }) => sum + v, 0);
  const sides = [middle.map((v, x) => ({ x, v })).filter(({ x }) => x < half), middle.map((v, x) => ({ x, v })).filter(({ x }) => x >= half)];
  const apart = ((centre(sides[1]) - centre(sides[0])) * INCH) / 300;
  assert.ok(Math.abs(apart - 150) < 0.2, `${apart} mm`);
  const clear = await renderer.render(square, { ...shot, background: 'transparent' });
  assert.equal(clear.data[3], 0);
  for (let i = 0; i < data.length; i += 4) assert.equal(clear.data[i + 3], 255 - data[i]);
  const layer = await renderer.render(square, {
    ...shot,
    style: 'shaded',
    background: 'white',
    layers: ['line'],
    output: { ...RAW, layers: { format: 'raw' } },
  });
  const lines = new Float32Array(layer.layers.line.buffer.slice(layer.layers.line.byteOffset, layer.layers.line.byteOffset + layer.layers.line.length));
  for (let i = 0; i < lines.length; i++) assert.equal(Math.round(lines[i] * 255), data[4 * i]);
});

test('seams of parts that are stitched are dashed, and a part that is not there is named', async () => {
  const shirt = await renderer.load(new URL('../../../js/assets/tshirt.glb', import.meta.url));
  // Stitches alone: without a list there are none.
  const weights = { silhouette: 0, contour: 0, seam: 0, crease: 0, stitch: 1 };
  const shot = { size: { width: 200, height: 200 }, camera: { view: 'front', projection: 'orthographic' }, style: 'flat', output: { format: 'raw' } };
  const inkOf = async (flat) => (await renderer.render(shirt, { ...shot, flat: { weights, ...flat } })).data.filter((v, i) => i % 4 === 0 && v < 255).length;
  assert.equal(await inkOf({}), 0);
  const byMaterial = await inkOf({ stitched: [{ material: 'stitched_natural' }] });
  assert.ok(byMaterial > 100, `${byMaterial}`);
  const { strokes } = await shirt.flat(shot, { stitched: [{ node: 'neck_rib' }] });
  const [byNode, length] = [await inkOf({ stitched: [{ node: 'neck_rib' }] }), strokes.filter(({ kind }) => kind === 'stitch').length];
  assert.ok(byNode > 0 && byNode < byMaterial && length > 0, `${byNode} of ${byMaterial}`);
  await assert.rejects(renderer.render(shirt, { ...shot, flat: { stitched: [{ node: 'pocket' }] } }), { code: 'E_MEASURE', pointer: '/flat/stitched' });
  const { info } = await renderer.render(shirt, { ...shot, flat: { stitched: [{ node: 'neck_rib' }] } });
  assert.deepEqual(info.shot.flat.stitched, [{ node: 'neck_rib' }]);
  assert.deepEqual((await renderer.render(shirt, info.shot)).info.shot, info.shot);
});
