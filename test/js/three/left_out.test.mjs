// What a shot leaves out is not framed: a shirt on a larger mannequin, by server and browser. Every check has the mannequin that is only
// translucent beside it, of which the camera has to be another.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { createRenderer } from '../../../js/index.mjs';
import { resolveLeftOut, resolveShot } from '../../../js/shot/index.mjs';
import { factsOf } from '../../../js/three/index.mjs';
import { box, sphere } from '../../fixtures/geometry.mjs';
import { GlbBuilder } from '../../fixtures/glb.mjs';
import '../api/support/real.mjs';

/** A shirt with a collar; where it is worn, of a body with a head of another material. */
async function shirt({ worn }) {
  const builder = new GlbBuilder();
  const cloth = builder.material({ name: 'cloth', baseColor: [0.2, 0.3, 0.6, 1] });
  const skin = builder.material({ name: 'skin', baseColor: [0.7, 0.5, 0.4, 1] });
  builder.add(box(0.5), cloth, { name: 'shirt', translation: [0.1, 1, 0] });
  builder.add(sphere(0.1, { rings: 12 }), cloth, { name: 'collar', translation: [0.1, 1.3, 0] });
  if (!worn) return builder.bytes();
  const body = builder.add(box(0.4), skin, { name: 'mannequin_body', translation: [0.1, 0.9, 0], scale: [1, 4, 1] });
  builder.add(sphere(0.12, { rings: 12 }), cloth, { name: 'wig', parent: body, translation: [0, 0.3, 0] });
  return builder.bytes();
}

let renderer, alone, worn;
before(async () => {
  renderer = await createRenderer({ cacheDirectory: null });
  [alone, worn] = await Promise.all([false, true].map(both));
});
after(() => renderer.close());

async function both(isWorn) {
  const bytes = await shirt({ worn: isWorn });
  const client = await new GLTFLoader().parseAsync(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), '');
  return { server: await renderer.load(bytes), client };
}

const SIDES = {
  server: async ({ server }, shot) => resolveShot(shot, await renderer.factsOf(server, shot)),
  browser: async ({ client }, shot) =>
    resolveShot(shot, factsOf(client, { THREE, frame: shot.camera?.frame, variant: shot.variant, ghost: resolveLeftOut(shot) })),
};
const shotWith = (ghost, more = {}) => ({
  camera: { view: 'three-quarter' },
  lights: [{ type: 'directional', castShadow: true }],
  ground: { shadow: true, opacity: 0.5 },
  ghost,
  ...more,
});

/** What the shot is fitted to its model by: camera, shadows and ground. */
const fitted = ({ camera, lights, ground }) => [camera, lights.map(({ shadow, position, target }) => [shadow, position, target]), ground];
const numbersOf = (value) => (typeof value === 'number' ? [value] : value && typeof value === 'object' ? Object.values(value).flatMap(numbersOf) : []);
/** Greatest difference of any number, metres or degrees. */
const apart = (a, b) => {
  const [p, q] = [a, b].map((shot) => numbersOf(fitted(shot)));
  assert.equal(p.length, q.length);
  assert.ok(p.length > 20);
  return Math.max(...p.map((x, i) => Math.abs(x - q[i])));
};
/** The two sides add up floats of a file by their own matrices; a camera some metres away differs by their rounding. */
const ROUNDING = 1e-5;

for (const [side, resolve] of Object.entries(SIDES)) {
  test(`${side}: a garment without its mannequin is framed as the garment alone`, async () => {
    const wanted = await resolve(alone, shotWith([]));
    for (const ghost of [
      [{ node: 'mannequin*', opacity: 0 }],
      [{ node: 2, opacity: 0 }],
      [
        { material: 'skin', opacity: 0 },
        { node: 'wig', opacity: 0 },
      ],
      [
        { node: '*', opacity: 0 },
        { node: 'shirt', opacity: 0.5 },
        { node: 'collar', opacity: 1 },
      ],
    ])
      assert.ok(apart(wanted, await resolve(worn, shotWith(ghost))) < ROUNDING, JSON.stringify(ghost));
    // Planted: a mannequin that is translucent, one whose child stays, and a ghost that a later one takes back.
    for (const ghost of [
      [{ node: 'mannequin*' }],
      [{ material: 'skin', opacity: 0 }],
      [
        { node: 'mannequin*', opacity: 0 },
        { node: 'wig', opacity: 0.1 },
      ],
    ])
      assert.ok(apart(wanted, await resolve(worn, shotWith(ghost))) > 0.05, JSON.stringify(ghost));
  });

  test(`${side}: nor does it count within a part that is framed`, async () => {
    const framing = (ghost, frame) => shotWith(ghost, { camera: { view: 'front', frame } });
    const skin = [{ material: 'skin', opacity: 0 }];
    const [whole, head] = [await resolve(worn, framing([], { node: 'mannequin_body' })), await resolve(worn, framing(skin, { node: 'mannequin_body' }))];
    const wig = await resolve(worn, framing(skin, { node: 'wig' }));
    assert.ok(apart(head, wig) < ROUNDING);
    assert.ok(apart(whole, wig) > 0.05, 'planted: with the body');
    await assert.rejects(async () => resolve(worn, framing([{ node: 'mannequin*', opacity: 0 }], { node: 'wig' })), {
      code: 'E_FRAME',
      message: /the node "wig" draws nothing/,
    });
  });

  test(`${side}: a shot that leaves everything out has nothing to frame`, async () => {
    await assert.rejects(async () => resolve(worn, shotWith([{ node: '*', opacity: 0 }])), { code: 'E_NO_GEOMETRY' });
  });
}

test('a picture without its mannequin is the picture of the garment alone', async () => {
  const drawn = async ({ server }, ghost) => {
    const shot = { ...shotWith(ghost), size: { width: 96, height: 96 }, quality: 'draft', output: { format: 'raw' } };
    return (await renderer.render(server, shot)).data;
  };
  const [wanted, shown, sheer] = [await drawn(alone, []), await drawn(worn, [{ node: 'mannequin*', opacity: 0 }]), await drawn(worn, [{ node: 'mannequin*' }])];
  const far = (a, b) => a.reduce((most, value, i) => Math.max(most, Math.abs(value - b[i])), 0);
  // Cameras that differ by rounding move an edge by less than a step of 8 bits.
  assert.ok(far(wanted, shown) <= 1, String(far(wanted, shown)));
  assert.ok(far(wanted, sheer) > 50, 'planted');
});

test('a ghost that is not there is named before anything is measured', async () => {
  await assert.rejects(renderer.factsOf(worn.server, shotWith([{ node: 'body_form', opacity: 0 }])), { code: 'E_FRAME', pointer: '/ghost/0' });
});
