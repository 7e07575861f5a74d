// Ghosts in technical flats: a pocket behind a front, and a mannequin that is larger than both. Every figure stands beside that of the same
// flat without the ghost.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createRenderer } from '../../../js/index.mjs';
import { plane } from '../../fixtures/geometry.mjs';
import { GlbBuilder } from '../../fixtures/glb.mjs';
import './support/real.mjs';

const FRONT = {
  size: { width: 200, height: 200 },
  camera: { projection: 'orthographic', position: [0, 0, 3], target: [0, 0, 0], height: 0.5, near: 1, far: 5 },
};
/** Millimetres of a side, as they are drawn 400 pixels a metre. */
const SIDE = { pocket: 100, front: 200, mannequin: 400 };
const PIXELS = 0.4;

let renderer;
let model;
before(async () => {
  renderer = await createRenderer();
  const builder = new GlbBuilder();
  const cloth = builder.material({ name: 'cloth' });
  const add = (name, side, z) => builder.add(plane(side / 1000, side / 1000), cloth, { name, translation: [0, 0, z] });
  add('pocket', SIDE.pocket, -0.1);
  add('front', SIDE.front, 0);
  add('mannequin', SIDE.mannequin, 0.2);
  model = await renderer.load(await builder.bytes());
});
after(() => renderer.close());

/** Sides of the squares that are drawn, millimetres, with the kinds of their lines. */
async function squares(ghost, options) {
  const { strokes, triangles } = await model.flat({ ...FRONT, ghost }, options);
  const found = strokes.map(({ kind, closed, points }) => {
    const xs = points.map(([x]) => x);
    assert.ok(closed, 'all of a square');
    return [kind, Math.round((Math.max(...xs) - Math.min(...xs)) / PIXELS / 5) * 5];
  });
  return { found: found.sort((a, b) => b[1] - a[1]), triangles };
}

const gone = { node: 'mannequin', opacity: 0 };

test('a part that is left out neither draws nor hides lines', async () => {
  assert.deepEqual((await squares([])).found, [['silhouette', SIDE.mannequin]], 'planted: it hides all');
  assert.deepEqual(await squares([gone]), { found: [['silhouette', SIDE.front]], triangles: 4 });
  assert.deepEqual((await squares([gone, { node: 'front', opacity: 0 }])).found, [['silhouette', SIDE.pocket]]);
});

test('lines of a translucent part are drawn, with those behind it', async () => {
  const both = [
    ['silhouette', SIDE.front],
    ['contour', SIDE.pocket],
  ];
  assert.deepEqual((await squares([gone, { node: 'front', opacity: 0.2 }])).found, both);
  assert.deepEqual((await squares([gone, { node: 'front', opacity: 0.9 }])).found, both, 'as translucent as it may be');
  assert.deepEqual((await squares([gone, { node: 'front', opacity: 1 }])).found, both.slice(0, 1), 'planted: opaque');
  // Nothing opaque is left to be seen through them.
  assert.deepEqual((await squares([gone, { node: 'front' }, { node: 'pocket' }])).found, both.slice(0, 1));
});

test('stitches may be named of a part that is left out, not of one that is not there', async () => {
  const stitched = [{ node: 'mannequin' }];
  assert.deepEqual((await squares([gone], { stitched })).found, [['silhouette', SIDE.front]]);
  await assert.rejects(squares([gone], { stitched: [{ node: 'hood' }] }), { code: 'E_MEASURE', pointer: '/stitched' });
  await assert.rejects(squares([{ node: 'hood', opacity: 0.5 }]), { code: 'E_FRAME', pointer: '/ghost/0' });
});

test('the layer line and the style flat have the ghosts too', async () => {
  const inked = async (ghost, more) => {
    const { data, layers, info } = await renderer.render(model, {
      ...FRONT,
      ghost,
      output: { format: 'raw', bitDepth: 32, layers: { format: 'raw' } },
      ...more,
    });
    const bytes = layers?.line ?? data;
    const floats = new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
    const channels = floats.length / (info.width * info.height);
    // Across the middle row: how many lines.
    const row = Array.from({ length: info.width }, (_, x) => floats[channels * (info.width * 100 + x)] < 0.5);
    return row.filter((dark, x) => dark && !row[x - 1]).length;
  };
  for (const more of [{ layers: ['line'] }, { style: 'flat' }]) {
    assert.equal(await inked([], more), 2);
    assert.equal(await inked([gone, { node: 'front', opacity: 0.2 }], more), 4);
    assert.equal(await inked([gone, { node: 'front', opacity: 0 }], more), 2);
  }
});
