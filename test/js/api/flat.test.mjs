import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createRenderer } from '../../../js/index.mjs';
import { plane } from '../../fixtures/geometry.mjs';
import { GlbBuilder } from '../../fixtures/glb.mjs';
import './support/real.mjs';

const FRONT = {
  size: { width: 400, height: 400 },
  camera: { projection: 'orthographic', position: [0, 0, 3], target: [0, 0, 0], height: 0.4, near: 1, far: 5 },
};

let renderer;
let model;
before(async () => {
  renderer = await createRenderer();
  const builder = new GlbBuilder();
  builder.add(plane(0.3, 0.3), builder.material({ name: 'black' }), { name: 'square' });
  model = await renderer.load(await builder.bytes());
});
after(() => renderer.close());

const near = (actual, expected, tolerance) => assert.ok(Math.abs(actual - expected) <= tolerance, `${actual}, expected ${expected}`);

test('a square of 300 mm is 300 mm at the scale 1:1, and 30 mm at 1:10', async () => {
  for (const [scale, side] of [
    [1, 300],
    [10, 30],
  ]) {
    const { svg, strokes, millimetresPerPixel } = await model.flat(FRONT, { scale });
    assert.equal(strokes.length, 1);
    near(millimetresPerPixel, 1, 1e-12);
    assert.match(svg, new RegExp(`width="${400 / scale}mm" height="${400 / scale}mm" viewBox="0 0 ${400 / scale} ${400 / scale}"`));
    const numbers = /class="silhouette"[^>]* d="M([^Z]*)Z/.exec(svg)[1].split(/[L ]/).map(Number);
    const xs = numbers.filter((_, i) => i % 2 === 0);
    const ys = numbers.filter((_, i) => i % 2 === 1);
    near(Math.max(...xs) - Math.min(...xs), side, 0.01);
    near(Math.max(...ys) - Math.min(...ys), side, 0.01);
  }
});

test('it needs few points, and says where the world is', async () => {
  const { strokes, worldToPixel, width } = await model.flat(FRONT);
  assert.deepEqual([strokes[0].kind, strokes[0].closed, strokes[0].points.length], ['silhouette', true, 4]);
  const [x, y] = strokes[0].points.find(([px, py]) => px < width / 2 && py < width / 2);
  near(worldToPixel[0] * -0.15 + worldToPixel[12], x, 0.01);
  near(worldToPixel[5] * 0.15 + worldToPixel[13], y, 0.01);
});

test('the same model gives the same bytes', async () => {
  const shirt = await renderer.load(new URL('../../../js/assets/tshirt.glb', import.meta.url));
  const shot = { size: { width: 400, height: 400 }, camera: { view: 'front', projection: 'orthographic' } };
  const options = { stitched: [{ material: 'stitched_natural' }] };
  const [first, again] = [await shirt.flat(shot, options), await shirt.flat(shot, options)];
  assert.equal(first.svg, again.svg);
  assert.ok(['silhouette', 'contour', 'seam', 'stitch'].every((kind) => first.strokes.some((stroke) => stroke.kind === kind)));
  assert.match(first.svg, /class="stitch"[^>]*stroke-dasharray/);
  const light = await shirt.flat(shot, { ...options, weights: { stitch: 0 } });
  assert.doesNotMatch(light.svg, /class="stitch"/);
  const sleeve = await shirt.flat(shot, { part: { node: 'sleeve_left' } });
  assert.ok(sleeve.triangles < first.triangles / 4);
});

test('wrong options are named', async () => {
  const cases = [
    [{ scale: 0 }, /options\.scale: expected n of the scale 1:n/],
    [{ creaseAngle: 0 }, /options\.creaseAngle: expected degrees from 1 to 180/],
    [{ stitched: 'hem' }, /options\.stitched: expected a list/],
    [{ weights: { line: 1 } }, /options\.weights\.line: unknown key/],
    [{ color: '"/><script>' }, /options\.color: expected a CSS name/],
  ];
  for (const [options, message] of cases) await assert.rejects(model.flat(FRONT, options), { code: 'E_OPTION', message });
  await assert.rejects(model.flat({}, { scale: 10 }), { code: 'E_OPTION', message: /none where the camera is not orthographic/ });
  await assert.rejects(model.flat(FRONT, { stitched: [{ node: 'hem' }] }), { code: 'E_MEASURE', pointer: '/stitched' });
  await assert.rejects(model.flat({ sise: 1 }), { code: 'E_SHOT' });
});
