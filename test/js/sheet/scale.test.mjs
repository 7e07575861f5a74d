import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import '../api/support/real.mjs';
import { createRenderer } from '../../../js/index.mjs';
import { cornersOfBox } from '../../../js/shot/frame.mjs';
import { PIXELS_MAX } from '../../../js/shot/true_scale.mjs';
import { basisOf, extentOf, fittingRatio, ratioOf, scaleText, trueView } from '../../../js/sheet/scale.mjs';
import { squareModel } from './square.mjs';

let renderer;
before(async () => {
  renderer = await createRenderer();
});
after(() => renderer.close());

/** What a direction sees of some points. */
function seenOf(points, basis) {
  const alongOf = (axis) => points.map((point) => point.reduce((sum, value, i) => sum + value * axis[i], 0));
  return extentOf(
    [basis.right, basis.up, basis.back].map(alongOf).map((along) => [Math.min(...along), Math.max(...along)]),
    basis,
  );
}

const BOX = { min: [-0.2, 0, -0.1], max: [0.4, 0.7, 0.3] };

test('scales are read and written', () => {
  assert.deepEqual(['1:5', '2:1', '1:2.5', '3:4'].map(ratioOf), [5, 0.5, 2.5, 4 / 3]);
  assert.deepEqual([5, 0.5, 2.5, 1, 0.1].map(scaleText), ['1:5', '2:1', '1:2.5', '1:1', '10:1']);
});

test('the largest usual scale that fits is taken', () => {
  const fitting = (width, height) => fittingRatio([{ width, height }], { width: 100, height: 150 });
  assert.deepEqual([fitting(0.5, 0.5), fitting(0.501, 0.5), fitting(0.1, 0.9), fitting(0.1, 0.15), fitting(0.02, 0.02)], [5, 6, 6, 1, 0.2]);
  // Beyond every usual one it is what just fits.
  assert.equal(fitting(1000, 1), 10000);
});

test('an extent is that of the direction', () => {
  const extent = (view, points = cornersOfBox(BOX)) => seenOf(points, basisOf(view));
  const sizes = ['front', 'right', 'top'].map((view) => extent({ view })).map(({ width, height }) => [width, height].map((x) => Number(x.toFixed(9))));
  assert.deepEqual(sizes, [
    [0.6, 0.7],
    [0.4, 0.7],
    [0.6, 0.4],
  ]);
  extent({ view: 'back' }).centre.forEach((x, i) => assert.ok(Math.abs(x - [0.1, 0.35, 0.1][i]) < 1e-12));
  // A diamond seen from a corner is narrower than its box.
  const diamond = [
    [-1, 0, 0],
    [1, 0, 0],
    [0, 0, -1],
    [0, 0, 1],
    [0, 1, 0],
  ];
  const turned = extent({ azimuth: 45, elevation: 0 }, diamond);
  assert.ok(Math.abs(turned.width - Math.SQRT2) < 1e-12, String(turned.width));
});

test('a millimetre on paper is the same length of the model all over the picture', () => {
  for (const [ratio, ppi] of [
    [1, 250],
    [5, 200],
    [0.5, 140],
  ]) {
    const view = trueView(seenOf(cornersOfBox(BOX), basisOf({ view: 'front' })), { ratio, ppi, margin: 2 });
    const [a, b] = [
      [0, 0.1, 0.3],
      [0.3, 0.1, -0.1],
    ].map(view.paperOf);
    assert.ok(Math.abs(b[0] - a[0] - 300 / ratio) < 1e-9 && Math.abs(b[1] - a[1]) < 1e-9);
    assert.ok(Math.abs(view.paper.width - (view.size.width * 25.4) / ppi) < 1e-9);
    assert.ok(view.paper.width >= 600 / ratio + 4 && view.paper.width < 600 / ratio + 4 + 25.4 / ppi + 1e-9);
  }
});

test('a picture of more pixels than can be drawn has a lower resolution, and all of the garment', () => {
  const view = trueView(seenOf(cornersOfBox(BOX), basisOf({ view: 'front' })), { ratio: 1, ppi: 600, margin: 2 });
  assert.ok(Math.max(view.size.width, view.size.height) <= PIXELS_MAX, JSON.stringify(view.size));
  assert.ok(Math.abs(view.paper.width - 604) < 0.1, `${view.paper.width}`);
  const [[left], [right]] = [BOX.min, BOX.max].map(view.paperOf);
  assert.ok(Math.abs(left - 2) < 0.1 && Math.abs(right - 602) < 0.1, `${left} ${right}`);
});

test('a point is drawn where the pure function says, by the matrix of the renderer', async () => {
  const model = await renderer.load(await squareModel());
  for (const view of [{ view: 'front' }, { view: 'back' }, { azimuth: 37, elevation: 21 }]) {
    const seen = trueView(seenOf(model.facts.outline, basisOf(view)), { ratio: 4, ppi: 100, margin: 3 });
    const { info } = await renderer.render(model, { size: seen.size, camera: seen.camera, environment: 'none' });
    const m = info.worldToPixel;
    for (const [x, y, z] of [
      [0.15, 0.45, 0],
      [-0.15, 0.15, 0],
      [0.1, 0.2, 0.05],
    ]) {
      const w = m[3] * x + m[7] * y + m[11] * z + m[15];
      const pixel = [0, 1].map((row) => (m[row] * x + m[4 + row] * y + m[8 + row] * z + m[12 + row]) / w);
      const paper = seen.paperOf([x, y, z]).map((mm) => (mm * 100) / 25.4);
      // The renderer's matrix is in floats: a hundredth of a pixel.
      for (const axis of [0, 1]) assert.ok(Math.abs(pixel[axis] - paper[axis]) < 0.01, `${pixel} ${paper}`);
    }
  }
});
