import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { createRenderer, inspect } from '../../../js/index.mjs';
import './support/real.mjs';
import { plane } from '../../fixtures/geometry.mjs';
import { GlbBuilder } from '../../fixtures/glb.mjs';
import { addSkinStreams, addTarget, animate, makeSkin } from '../../fixtures/motion.mjs';
import { strip } from './support/strip.mjs';

let renderer;
let model;
before(async () => {
  renderer = await createRenderer();
  model = await renderer.load(strip());
});
after(() => renderer.close());

const near = (actual, expected) => assert.ok(Math.abs(actual - expected) < 1e-7, `${actual}, expected ${expected}`);
const A = [0.1, 0.1, 0];
const B = [0.5, 0.4, -0.3];

test('a straight length is that of the straight line', async () => {
  const { length, lengths, points, polyline } = await model.measure({ points: [A, B] });
  near(length, Math.hypot(0.4, 0.3, 0.3));
  assert.deepEqual(lengths, [length]);
  assert.deepEqual(
    points.map(({ nodeName, material, moved }) => [nodeName, material, moved < 1e-7]),
    [
      ['strip', 0, true],
      ['strip', 0, true],
    ],
  );
  assert.equal(polyline.length, 2);
});

test('along the surface it is that of the strip laid flat, and the line lies on the fold', async () => {
  const { length, polyline } = await model.measure({ points: [A, B], along: 'surface' });
  near(length, Math.hypot(0.4 + 0.3, 0.3));
  const fold = polyline.find(([x, , z]) => Math.abs(x - 0.5) < 1e-9 && Math.abs(z) < 1e-9);
  near(fold[1], 0.1 + (0.3 * 0.4) / 0.7);
});

test('several points add up, closed they come back', async () => {
  const C = [0.1, 0.4, 0];
  const open = await model.measure({ points: [A, B, C] });
  const closed = await model.measure({ points: [A, B, C], closed: true });
  assert.equal(open.lengths.length, 2);
  near(closed.length - open.length, 0.3);
});

test('a place of a mesh is a point', async () => {
  const { points, length } = await model.measure({
    points: [
      { node: 'strip', vertex: 0 },
      { node: 0, triangle: 2, weights: [0.5, 0.25, 0.25] },
    ],
    along: 'surface',
  });
  assert.deepEqual(points[0].position, [0, 0, 0]);
  near(Math.hypot(...points[1].position.map((x, i) => x - [0.5, 0.125, -0.25][i])), 0);
  near(length, Math.hypot(0.75, 0.125));
});

test('a point beside the surface says how far it was moved', async () => {
  const { points } = await model.measure({ points: [[0.1, 0.1, 0.25], B] });
  near(points[0].moved, 0.25);
});

test("a border is the part's own", async () => {
  const { length, loops } = await model.measure({ border: true, part: { node: 'strip' } });
  near(length, 3);
  assert.deepEqual(
    loops.map(({ closed }) => closed),
    [true],
  );
  near((await model.measure({ border: true, part: { material: 'patch' } })).length, 2 + Math.SQRT2);
});

test('a girth through an open strip is open, and cannot be drawn tight', async () => {
  const girth = { point: [0.2, 0.2, 0], normal: [0, 2, 0] };
  const { length, closed, others } = await model.measure({ girth });
  assert.deepEqual([closed, others], [false, []]);
  near(length, 1);
  await assert.rejects(model.measure({ girth: { ...girth, tight: true } }), { code: 'E_MEASURE', pointer: '/girth' });
});

test('a girth drawn tight is shorter than its section, and stays on the part: chest and sleeve of the bundled garment', async () => {
  const shirt = await renderer.load(fileURLToPath(new URL('../../../js/assets/tshirt.glb', import.meta.url)));
  for (const girth of [{ point: [0, 0.42, 0.1] }, { point: [0.28, 0.5, 0], normal: [1, -0.6, 0] }]) {
    const { length, section, closed } = await shirt.measure({ girth: { ...girth, tight: true } });
    assert.ok(closed && length < section && length > 0.96 * section, `${length} of ${section}`);
  }
});

test('errors say what is not there', async () => {
  const cases = [
    [{ points: [A, [0.2, 5.2, 0]], along: 'surface' }, 'E_MEASURE', /no way over the surface joins points 0 and 1.*option join/],
    [{ border: true, part: { node: 'sleeve' } }, 'E_MEASURE', /no such part: node "sleeve"/],
    [{ girth: { point: [0, 9, 0] } }, 'E_MEASURE', /does not meet/],
    [{ points: [{ node: 'strip', vertex: 99 }, A] }, 'E_MEASURE', /no vertex 99/],
    [{ points: [{ node: 'nothing', vertex: 0 }, A] }, 'E_MEASURE', /no such node/],
    [{ points: [A, B], variant: 'red' }, 'E_VARIANT', /no variant "red"/],
  ];
  for (const [options, code, message] of cases) await assert.rejects(model.measure(options), { code, message });
  await assert.rejects(model.measure({ points: [A, [0.2, 5.2, 0]], along: 'surface' }), { pointer: '/points/1' });
});

test('wrong options are named', async () => {
  const cases = [
    [{}, /options: expected one of points, girth, border/],
    [{ points: [A, B], border: true }, /options: expected one of points, girth, border/],
    [{ points: [A] }, /options\.points: expected a list of 2 to 1024 points, got 1/],
    [{ points: [A, [0, 0]] }, /options\.points\[1\]: expected \[x, y, z\]/],
    [{ points: [A, [0, 0, NaN]] }, /options\.points\[1\]/],
    [{ points: [A, { node: 'strip', triangle: 0, weights: [1, 1, 0] }] }, /options\.points\[1\]\.weights: expected three barycentric/],
    [{ points: [A, B], along: 'air' }, /options\.along: expected "straight" or "surface", got "air"/],
    [{ points: [A, B], part: { node: 'a', material: 'b' } }, /options\.part: expected \{node\} or \{material\}/],
    [{ points: [A, B], join: -1 }, /options\.join: expected metres from 0 to 1/],
    [{ girth: { point: A, normal: [0, 0, 0] } }, /options\.girth\.normal/],
    [{ points: [A, B], alongside: 1 }, /options\.alongside: unknown key/],
  ];
  for (const [options, message] of cases) await assert.rejects(model.measure(options), { code: 'E_OPTION', message });
});

/** A cloth 0.4 m wide and 0.2 m high. "morph" makes it twice as wide in a second; "skin" pulls its right edge 0.3 m away. */
async function movingCloth(name) {
  const glb = new GlbBuilder();
  const shape = plane(0.4, 0.2);
  const primitive = glb.primitive(shape, glb.material());
  const mesh = glb.document.createMesh().addPrimitive(primitive);
  if (name === 'morph') {
    addTarget(glb, primitive, { positions: shape.positions.map((x, i) => (i % 3 === 0 ? x : 0)) });
    const cloth = glb.node({ name, mesh: mesh.setWeights([0]) });
    animate(glb, name, [[cloth, 'weights', 'LINEAR', [0, 1], [0, 1]]]);
    return glb.bytes();
  }
  const isRight = shape.positions.filter((_, i) => i % 3 === 0).map((x) => Number(x > 0));
  addSkinStreams(
    glb,
    primitive,
    isRight.flatMap((joint) => [joint, 0, 0, 0]),
    new Float32Array(isRight.flatMap(() => [1, 0, 0, 0])),
  );
  const joints = ['left', 'right'].map((joint) => glb.node({ name: joint }));
  glb.node({ name, mesh }).setSkin(makeSkin(glb, joints));
  animate(glb, name, [[joints[1], 'translation', 'LINEAR', [0, 1], [0, 0, 0, 0.3, 0, 0]]]);
  return glb.bytes();
}

test('a pose is measured as it stands', async () => {
  for (const [name, widths] of [
    ['morph', [0.4, 0.5, 0.8]],
    ['skin', [0.4, 0.475, 0.7]],
  ]) {
    const moving = await renderer.load(await movingCloth(name));
    const border = async (pose) => (await moving.measure({ border: true, pose })).length;
    for (const [i, time] of [0, 0.25, 1].entries()) near(await border({ animation: name, time }), 2 * (widths[i] + 0.2));
    near(await border(undefined), 2 * (0.4 + 0.2));
  }
  await assert.rejects(model.measure({ points: [A, B], pose: { animation: 'walk', time: 0 } }), { code: 'E_POSE' });
});

test('an abort stops it', async () => {
  const stop = new AbortController();
  const pending = model.measure({ points: [A, B], signal: stop.signal });
  stop.abort(new Error('enough'));
  await assert.rejects(pending, /enough/);
});

test('inspect measures without GL, in order', async () => {
  const { measures } = await inspect(strip(), { measure: [{ points: [A, B] }, { border: true, part: { node: 'patch' } }] });
  near(measures[0].length, Math.hypot(0.4, 0.3, 0.3));
  near(measures[1].length, 2 + Math.SQRT2);
  await assert.rejects(inspect(strip(), { measure: [{ points: [A] }] }), { code: 'E_OPTION', message: /options\.measure\[0\]\.points/ });
  assert.ok(!('measures' in (await inspect(strip()))));
});
