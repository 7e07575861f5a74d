import assert from 'node:assert/strict';
import { test } from 'node:test';
import { compareImages } from '../../../js/compare/compare.mjs';
import { GATES, judge } from '../../../js/compare/gates.mjs';
import { heatMap } from '../../../js/compare/heat_map.mjs';
import { mean, percentile, weightedPercentile } from '../../../js/compare/statistics.mjs';
import { draw, flat, noise, square, withPixel } from './support.mjs';

const SIZE = 32;
const passes = (comparison) => Object.keys(GATES).filter((gate) => judge(comparison, gate).pass);
const near = (found, wanted, by = 1e-6) => assert.ok(Math.abs(found - wanted) <= by, `${found}, not ${wanted}`);

test('equal pictures pass each gate with figures of 0 and an SSIM of 1', () => {
  const comparison = compareImages(square(SIZE), square(SIZE));
  for (const name of ['frame', 'object', 'interior', 'edge']) {
    const { max, p999, rmse, rmseLinear, flip, deltaE } = comparison[name];
    assert.deepEqual([max, p999, rmse, rmseLinear, ...Object.values(flip), ...Object.values(deltaE)], new Array(12).fill(0), name);
  }
  near(comparison.ssim, 1);
  assert.deepEqual(passes(comparison), Object.keys(GATES));
});

test('interior is what both cover less 2 pixels, edge the rest of the object', () => {
  const pixelsOf = ({ frame, object, interior, edge }) => [frame, object, interior, edge].map((figures) => figures?.pixels ?? null);
  assert.deepEqual(pixelsOf(compareImages(square(SIZE), square(SIZE))), [1024, 24 * 24, 20 * 20, 24 * 24 - 20 * 20]);
  const wider = draw(SIZE, SIZE, (x, y) => (x >= 3 && x < 28 && y >= 4 && y < 28 ? [100, 100, 100, 255] : [0, 0, 0, 0]));
  assert.deepEqual(pixelsOf(compareImages(square(SIZE), wider)), [1024, 25 * 24, 20 * 20, 25 * 24 - 20 * 20]);
  const opaque = flat(SIZE, SIZE, [1, 2, 3, 255]);
  assert.deepEqual(pixelsOf(compareImages(opaque, opaque)), [1024, 1024, 1024, null], 'the border of the frame is no edge');
  const empty = flat(SIZE, SIZE, [0, 0, 0, 0]);
  assert.deepEqual(pixelsOf(compareImages(empty, empty)), [1024, null, null, null]);
});

test('what shows through is object too, and what only one picture covers is edge', () => {
  const glass = draw(SIZE, SIZE, (x, y) => (Math.min(x, y) >= 4 && Math.max(x, y) < 28 ? [10, 10, 10, 1] : [0, 0, 0, 0]));
  assert.equal(compareImages(glass, square(SIZE)).interior.pixels, 20 * 20);
  const { interior, edge } = compareImages(square(SIZE), flat(SIZE, SIZE, [0, 0, 0, 0]));
  assert.deepEqual([interior, edge.pixels], [null, 24 * 24]);
});

test('a mask finds the silhouette before a background, which counts as interior', () => {
  const [x0, x1] = [4, 28];
  const mask = Uint8Array.from({ length: SIZE * SIZE }, (_, i) => {
    const [x, y] = [i % SIZE, Math.floor(i / SIZE)];
    return Math.min(x, y) >= x0 && Math.max(x, y) < x1 ? 255 : 0;
  });
  const opaque = flat(SIZE, SIZE, [50, 60, 70, 255]);
  const within = (x, y) => compareImages(opaque, withPixel(opaque, x, y, [50, 60, 90, 255]), { mask });
  const { interior, edge } = within(16, 16);
  assert.deepEqual([interior.pixels, edge.pixels], [1024 - (28 * 28 - 20 * 20), 28 * 28 - 20 * 20]);
  for (const [x, y, region] of [
    [16, 16, 'interior'],
    [0, 0, 'interior'],
    [2, 16, 'edge'],
    [5, 16, 'edge'],
    [6, 16, 'interior'],
  ]) {
    const comparison = within(x, y);
    assert.deepEqual(
      ['interior', 'edge'].filter((name) => comparison[name].max > 0),
      [region],
      `${x} ${y}`,
    );
  }
  assert.throws(() => compareImages(opaque, opaque, { mask: new Uint8Array(3) }), { code: 'E_OPTION', message: /mask: expected a Uint8Array of 1024/ });
});

test('a mask limits the object: a background does not dilute it', () => {
  const [size, side] = [96, 12];
  const [from, to] = [42, 54];
  const isObject = (x, y) => Math.min(x, y) >= from && Math.max(x, y) < to;
  const mask = Uint8Array.from({ length: size * size }, (_, i) => (isObject(i % size, Math.floor(i / size)) ? 1 : 0));
  const onWhite = (grey) => draw(size, size, (x, y) => (isObject(x, y) ? [grey, grey, grey, 255] : [255, 255, 255, 255]));
  const [expected, actual] = [onWhite(100), onWhite(104)];
  const [diluted, masked] = [compareImages(expected, actual), compareImages(expected, actual, { mask })];
  assert.deepEqual(
    [diluted, masked].map(({ object }) => object.pixels),
    [size * size, (side + 4) ** 2],
  );
  assert.deepEqual(
    [diluted, masked].map((comparison) => judge(comparison, 'standard').pass),
    [true, false],
  );
  near(masked.object.mean, (4 * side ** 2) / (side + 4) ** 2);
  assert.deepEqual([masked.frame.pixels, masked.interior.pixels + masked.edge.pixels], [size * size, size * size]);
  const spotted = compareImages(expected, withPixel(expected, 3, 3, [0, 0, 0, 255]), { mask });
  assert.deepEqual([spotted.object.max, spotted.interior.max, spotted.frame.max], [0, 255, 255]);
  // What one picture alone shows is object wherever it lies.
  const clear = draw(size, size, (x, y) => (isObject(x, y) ? [100, 100, 100, 255] : [0, 0, 0, 0]));
  const stray = compareImages(clear, withPixel(clear, 3, 3, [0, 0, 0, 255]), { mask });
  assert.deepEqual([stray.object.max, stray.edge.max], [255, 255]);
});

test('each pixel counts in its own region, and the worst one is named', () => {
  const inside = compareImages(square(SIZE), withPixel(square(SIZE), 16, 15, [100, 103, 100, 255]));
  assert.deepEqual([inside.interior.max, inside.interior.worst, inside.edge.max, inside.frame.max], [3, [16, 15], 0, 3]);
  near(inside.interior.mean, 3 / 400);
  near(inside.frame.rmse, Math.sqrt((3 / 255) ** 2 / 3 / 1024));
  const edge = compareImages(square(SIZE), withPixel(square(SIZE), 4, 15, [100, 103, 100, 255]));
  assert.deepEqual([edge.interior.max, edge.edge.max, edge.edge.worst], [0, 3, [4, 15]]);
});

test('the linear RMSE is of light: 0 to 255 is 1 either way, 0 to 188 is half the light', () => {
  const of = (grey) => compareImages(flat(4, 4, [0, 0, 0, 255]), flat(4, 4, [grey, grey, grey, 255])).frame;
  near(of(255).rmse, 1);
  near(of(255).rmseLinear, 1);
  near(of(188).rmse, 188 / 255);
  near(of(188).rmseLinear, 0.5029, 1e-4);
});

test('a difference of alpha shows whatever the colour is, and colour where nothing shows does not', () => {
  for (const grey of [0, 128, 255]) {
    const { object } = compareImages(flat(12, 12, [grey, grey, grey, 128]), flat(12, 12, [grey, grey, grey, 255]));
    assert.ok(object.max >= 127 && object.flip.mean > 0.1 && object.deltaE.mean > 5 && object.rmse > 0.2, `grey ${grey}`);
  }
  const hidden = compareImages(flat(12, 12, [255, 0, 0, 0]), flat(12, 12, [0, 255, 0, 0]));
  assert.deepEqual([hidden.frame.max, hidden.frame.rmse, hidden.frame.flip.max], [0, 0, 0]);
});

test('gates: what each one lets through', () => {
  const grey = (change) => draw(SIZE, SIZE, (x, y) => [...[0, 1, 2].map(() => 128 + change(x, y)), 255]);
  const against = (change) =>
    passes(
      compareImages(
        grey(() => 0),
        grey(change),
      ),
    );
  // 128 to 129 is 0.39 of L*: FLIP (0.39 ** 0.7) * 0.95 / (0.4 * 41.3) = 0.03 everywhere.
  assert.deepEqual(
    against(() => 1),
    ['parity', 'other-gl', 'draft'],
  );
  assert.deepEqual(
    against((x) => (x % 16 ? 0 : 1)),
    ['parity', 'standard', 'other-gl', 'draft'],
  );
  assert.deepEqual(
    against((x, y) => (x === 9 && y === 9 ? 2 : 0)),
    ['parity', 'standard', 'other-gl', 'draft'],
    '1 of 1024 pixels is below 0.1 %',
  );
  assert.deepEqual(
    against((x, y) => (x === 9 && y < 2 ? 2 : 0)),
    ['standard', 'other-gl', 'draft'],
    '2 of 1024 pixels are above 0.1 %',
  );
  assert.deepEqual(
    against((x, y) => (x === 9 && y === 9 ? 3 : 0)),
    ['standard', 'other-gl', 'draft'],
  );
  assert.deepEqual(
    against(() => 4),
    [],
  );
});

test('an edge that looks different is over parity, though the interior is the same', () => {
  const frayed = draw(SIZE, SIZE, (x, y) =>
    x === 4 && y >= 4 && y < 28 ? [255, 255, 255, 255] : [...square(SIZE).data.subarray((y * SIZE + x) * 4, (y * SIZE + x) * 4 + 4)],
  );
  const { pass, checks } = judge(compareImages(square(SIZE), frayed), 'parity');
  assert.deepEqual([pass, checks.map((check) => check.pass)], [false, [true, true, false]]);
});

test('equal pictures are within every gate, without an object too', () => {
  for (const image of [flat(SIZE, SIZE, [0, 0, 0, 0]), flat(SIZE, SIZE, [9, 9, 9, 255]), square(SIZE), flat(1, 1, [0, 0, 0, 0])]) {
    assert.deepEqual(passes(compareImages(image, image)), Object.keys(GATES));
    assert.equal(judge(compareImages(image, image), 'standard', { 'interior.max': 0, 'edge.rmse': 0 }).pass, true);
  }
  const unseen = flat(SIZE, SIZE, [200, 0, 0, 0]);
  assert.deepEqual(passes(compareImages(flat(SIZE, SIZE, [0, 0, 0, 0]), unseen)), Object.keys(GATES), 'colour without alpha is not there');
});

test('a region without pixels of pictures that differ is within no gate that asks for it', () => {
  const verdict = judge({ frame: { max: 1 }, object: null, interior: null, edge: null }, 'standard');
  assert.deepEqual([verdict.pass, verdict.checks.map(({ value }) => value)], [false, [null, null, null]]);
});

test('a limit of an edge lets through pictures that have none, in every gate', () => {
  const opaque = compareImages(flat(SIZE, SIZE, [9, 9, 9, 255]), flat(SIZE, SIZE, [10, 9, 9, 255]));
  for (const gate of ['parity', 'draft']) assert.equal(judge(opaque, gate, { 'edge.max': 2 }).pass, true, gate);
});

test("limits stand in place of a gate's, or beside them", () => {
  const comparison = compareImages(square(SIZE), withPixel(square(SIZE), 16, 16, [110, 110, 110, 255]));
  const checks = (limits) => judge(comparison, 'parity', limits).checks.map(({ region, figure, limit, pass }) => [`${region}.${figure}`, limit, pass]);
  assert.deepEqual(checks({}), [
    ['interior.max', 2, false],
    ['interior.p999', 1, false],
    ['edge.flip.mean', 0.01, true],
  ]);
  assert.deepEqual(checks({ 'interior.max': 10, 'interior.p999': 10, 'object.deltaE.max': 3 }), [
    ['interior.max', 10, true],
    ['interior.p999', 10, true],
    ['edge.flip.mean', 0.01, true],
    ['object.deltaE.max', 3, false],
  ]);
  assert.throws(() => judge(comparison, 'exact', { 'body.max': 1 }), { code: 'E_OPTION', message: /limits\.body\.max: expected a region/ });
  assert.throws(() => judge(comparison, 'exact', { 'frame.max': -1 }), { code: 'E_OPTION', message: /at least 0, got -1/ });
});

test('what is ignored is in no figure, and its neighbours do not see it', () => {
  const spot = withPixel(square(SIZE), 16, 16, [255, 0, 0, 255]);
  const ignore = new Uint8Array(SIZE * SIZE);
  ignore[16 * SIZE + 16] = 1;
  const comparison = compareImages(square(SIZE), spot, { ignore });
  assert.deepEqual(passes(comparison), Object.keys(GATES));
  assert.deepEqual([comparison.frame.pixels, comparison.frame.max, Math.max(...comparison.flipMap)], [SIZE * SIZE - 1, 0, 0]);
  const beside = new Uint8Array(SIZE * SIZE);
  beside[16 * SIZE + 17] = 1;
  assert.equal(compareImages(square(SIZE), spot, { ignore: beside }).frame.max, 155);
  assert.throws(() => compareImages(spot, spot, { ignore: new Uint8Array(3) }), {
    code: 'E_OPTION',
    message: /options\.ignore: expected a Uint8Array of 1024 bytes/,
  });
  assert.throws(() => compareImages(spot, spot, { ignore: new Uint8Array(SIZE * SIZE).fill(1) }), { code: 'E_OPTION', message: /leaves no pixel/ });
});

test('the heat map runs from black to light yellow', () => {
  const map = heatMap({ flipMap: Float32Array.of(0, 0.5, 1), width: 3, height: 1 });
  assert.deepEqual([...map.data], [0, 0, 4, 255, 183, 55, 121, 255, 252, 253, 191, 255]);
});

test('percentiles', () => {
  const values = Float32Array.from({ length: 100 }, (_, i) => i + 1);
  assert.deepEqual([percentile(values, 0.95), percentile(values, 0), percentile(values, 1)], [95, 1, 100]);
  assert.equal(mean(values), 50.5);
  // 1 + .. + 71 = 2556 is the first sum of at least half of 5050.
  assert.equal(weightedPercentile(values, 0.5), 71);
  assert.equal(weightedPercentile(new Float32Array(5), 0.5), 0);
});

test('wrong arguments are told', () => {
  const image = noise(8, 8, 1);
  assert.throws(() => compareImages(image, noise(8, 9, 1)), { code: 'E_IMAGE_SIZE', exit: 3, message: /8x8 expected, 8x9 given/ });
  assert.throws(() => compareImages(image, { ...image, width: 7 }), { code: 'E_OPTION', message: /^actual: .* 7 x 8 with 256 bytes/ });
  assert.throws(() => compareImages(null, image), { code: 'E_OPTION', message: /^expected: / });
  assert.throws(() => compareImages(image, { width: 8, height: 8, data: new Float32Array(256) }), { code: 'E_OPTION' });
  assert.throws(() => compareImages(image, image, { pixelsPerDegree: 0 }), { code: 'E_OPTION', message: /pixelsPerDegree/ });
  assert.throws(() => judge(compareImages(image, image), 'strict'), { code: 'E_OPTION', message: /exact, parity, standard, other-gl, draft, got "strict"/ });
});
