import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createRenderer } from '../../../js/index.mjs';
import { plane, torus } from '../../fixtures/geometry.mjs';
import { GlbBuilder } from '../../fixtures/glb.mjs';
import './support/real.mjs';

let renderer;
let model;
before(async () => {
  renderer = await createRenderer();
  const builder = new GlbBuilder();
  const cloth = builder.material({ doubleSided: true });
  const half = Math.SQRT1_2;
  builder.add(plane(0.4, 0.4), cloth, { name: 'front', translation: [0, 0, 0.1] });
  builder.add(plane(0.4, 0.4), cloth, { name: 'back', translation: [0, 0, -0.1], rotation: [0, 1, 0, 0] });
  builder.add(plane(0.2, 0.4), cloth, { name: 'mirrored', translation: [0.2, 0, 0], rotation: [0, half, 0, half], scale: [-1, 1, 1] });
  builder.add(torus(0.1, 0.02), cloth, { name: 'ring', translation: [0, 0.4, 0] });
  model = await renderer.load(await builder.bytes());
});
after(() => renderer.close());

const where = async (of, name) => {
  const { polyline } = await of.measure({
    points: [
      [0, 0, 9],
      [0, 0, -9],
    ],
    part: { node: name },
  });
  return polyline[0];
};
const near = (a, b) => a.forEach((x, i) => assert.ok(Math.abs(x - b[i]) < 1e-6, `${a}, expected ${b}`));

test('parts move along their mean normals, and tubes away from the middle', async () => {
  const apart = await model.explode(0.5);
  const moved = async (name) => {
    const [from, to] = await Promise.all([where(model, name), where(apart, name)]);
    return to.map((x, i) => x - from[i]);
  };
  near(await moved('front'), [0, 0, 0.5]);
  near(await moved('back'), [0, 0, -0.5]);
  const [x] = await moved('mirrored');
  assert.ok(Math.abs(Math.abs(x) - 0.5) < 1e-6, `${x}`);
  const ring = await moved('ring');
  assert.ok(Math.abs(Math.hypot(...ring) - 0.5) < 1e-6 && ring[1] > 0.45, `${ring}`);
});

test('the camera frames what is apart, and the model stays as it was', async () => {
  const apart = await model.explode(0.5);
  assert.ok(Math.abs(apart.facts.bounds.max[2] - 0.6) < 1e-6);
  assert.ok(Math.abs(apart.facts.bounds.min[2] + 0.6) < 1e-6);
  const shot = { size: { width: 64, height: 64 }, camera: { view: 'right' } };
  const [whole, moved, still] = [await renderer.render(model, shot), await renderer.render(apart, shot), await renderer.render(await model.explode(0), shot)];
  assert.ok(!moved.data.equals(whole.data));
  assert.ok(still.data.equals(whole.data), 'by 0 m it is the same picture');
  assert.notEqual(moved.info.key, whole.info.key);
  assert.ok((await renderer.render(model, shot)).data.equals(whole.data));
});

test('options of loading are refused: nothing is loaded', async () => {
  for (const options of [{ failOn: 'none' }, { resolve: () => null }, { ambientVisibility: true }])
    await assert.rejects(model.explode(0.1, options), { code: 'E_OPTION', message: /unknown key, expected one of timeoutMs, signal/ });
  await model.explode(0.1, { timeoutMs: null, signal: new AbortController().signal });
});

test('a distance that is none is refused', async () => {
  for (const distance of [-1, Number.NaN, '1'])
    await assert.rejects(model.explode(distance), { code: 'E_OPTION', message: /^distance: expected metres, 0 or more/ });
});
