import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { createRenderer } from '../../../js/index.mjs';
import { resolveShot } from '../../../js/shot/index.mjs';
import { factsOf } from '../../../js/three/index.mjs';
import { MODELS } from '../../fixtures/index.mjs';
import '../api/support/real.mjs';

let renderer, bytes, server, client;
before(async () => {
  renderer = await createRenderer({ cacheDirectory: null });
  bytes = await MODELS.parts();
  server = await renderer.load(bytes);
  client = await new GLTFLoader().parseAsync(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), '');
});
after(() => renderer.close());

const factsOn = async (shot) => [await renderer.factsOf(server, shot), factsOf(client, { THREE, frame: shot.camera.frame, variant: shot.variant })];
const framing = (frame, more = {}) => ({ camera: { view: 'three-quarter', frame }, ...more });
const far = (a, b) => Math.max(...a.map((x, i) => Math.abs(x - b[i])));

/** What each part measures by its making (test/fixtures/scenes_parts.mjs): x from, x to; the files' order of nodes. */
const PARTS = [
  [{ node: 'Body' }, {}, [-0.5, 0.5]],
  [{ node: 'Buttons' }, {}, [0.04, 0.16]],
  // Both nodes of the name, the cuff beneath one of them among it.
  [{ node: 'Sleeve' }, {}, [-0.85, 0.8915]],
  [{ node: 'Cuff' }, {}, [-0.85, -0.55]],
  [{ node: 'Jacket' }, {}, [-0.85, 0.8915]],
  [{ material: 'Brass' }, {}, [0.04, 0.16]],
  [{ material: 'Lining' }, {}, [-0.85, 0.5]],
  [{ material: 'Lining' }, { variant: 'winter' }, [-0.85, 0.5]],
  [{ material: 2 }, {}, [0.04, 0.16]],
];

for (const [frame, more, [low, high]] of PARTS) {
  test(`browser and server measure and frame ${JSON.stringify(frame)} alike, ${JSON.stringify(more)}`, async () => {
    const shot = framing(frame, more);
    const [here, there] = await factsOn(shot);
    for (const { part } of [here, there]) {
      assert.ok(part.found);
      assert.ok(Math.abs(part.bounds.min[0] - low) < 0.01 && Math.abs(part.bounds.max[0] - high) < 0.01, JSON.stringify(part.bounds));
    }
    assert.ok(far(here.part.bounds.min, there.part.bounds.min) < 1e-6 && far(here.part.bounds.max, there.part.bounds.max) < 1e-6);
    const cameras = [here, there].map((facts) => resolveShot(shot, facts).camera);
    for (const key of ['position', 'target']) assert.ok(far(cameras[0][key], cameras[1][key]) < 1e-5, JSON.stringify(cameras));
  });
}

test('the empty name is that of the nodes without one, on both sides', async () => {
  const nameless = await MODELS.boxes();
  const shot = framing({ node: '' });
  const here = await renderer.factsOf(await renderer.load(nameless), shot);
  const model = await new GLTFLoader().parseAsync(nameless.buffer.slice(nameless.byteOffset, nameless.byteOffset + nameless.length), '');
  const there = factsOf(model, { THREE, frame: shot.camera.frame });
  assert.ok(here.part.found && there.part.found);
  assert.ok(far(here.part.bounds.min, there.part.bounds.min) < 1e-6 && far(here.part.bounds.max, there.part.bounds.max) < 1e-6);
});

test('a variant changes what a material is drawn on', async () => {
  const [plain] = await factsOn(framing({ material: 'Lining' }));
  const [winter] = await factsOn(framing({ material: 'Lining' }, { variant: 'winter' }));
  // The buttons stand before the lining.
  assert.ok(Math.abs(plain.part.bounds.max[2] - 0.5) < 1e-3 && Math.abs(winter.part.bounds.max[2] - 0.56) < 1e-3);
  const [there, gone] = [await factsOn(framing({ material: 'Brass' })), await factsOn(framing({ material: 'Brass' }, { variant: 'winter' }))];
  for (const { part } of there) assert.ok(part.bounds);
  for (const { part } of gone) assert.deepEqual([part.found, part.bounds, part.names], [true, null, ['Denim', 'Lining']]);
});

/** Messages word for word, of both sides. */
const NODES = '"Jacket", "Body", "Sleeve", "Cuff", "Right", "Buttons"';
const WRONG = [
  [{ node: 'Sleve' }, '.node: the model has no node "Sleve"; did you mean "Sleeve"?'],
  [{ node: 'Hood' }, `.node: the model has no node "Hood"; it has ${NODES}`],
  [{ node: 'Tag' }, `.node: the node "Tag" draws nothing; it has ${NODES}`],
  [{ node: 99 }, `.node: the model has no node 99; it has ${NODES}`],
  [{ material: 'Denin' }, '.material: the model has no material "Denin"; did you mean "Denim"?'],
  [{ material: 'Silk' }, '.material: the model has no material "Silk"; it has "Denim", "Lining", "Brass"'],
];
test('a part that is not there is told with what is there', async () => {
  for (const [frame, message] of WRONG) {
    for (const facts of await factsOn(framing(frame))) {
      const [kind] = Object.keys(frame);
      assert.throws(() => resolveShot(framing(frame), facts), {
        code: 'E_FRAME',
        exit: 3,
        message: `shot.camera.frame${message}`,
        pointer: `/camera/frame/${kind}`,
      });
    }
    await assert.rejects(renderer.render(server, { size: { width: 8, height: 8 }, ...framing(frame) }), {
      code: 'E_FRAME',
      message: `shot.camera.frame${message}`,
    });
  }
});

test('facts that measure no part, or another one, do not do', async () => {
  const message =
    'shot.camera.frame.node: the facts of the model do not measure the node "Body"; renderer.factsOf does, and factsOf of telar/three with `frame`';
  const [other] = await factsOn(framing({ node: 'Cuff' }));
  for (const facts of [server.facts, other, { min: [0, 0, 0], max: [1, 1, 1] }]) {
    assert.throws(() => resolveShot(framing({ node: 'Body' }), facts), { code: 'E_FRAME', message });
  }
});

test('a part fills the frame, whatever else stands around it', async () => {
  for (const projection of ['perspective', 'orthographic']) {
    const shot = {
      size: { width: 128, height: 128 },
      camera: { frame: { node: 'Buttons' }, projection, fit: 0.5 },
      environment: 'none',
      lights: [{ type: 'ambient' }],
      output: { format: 'raw' },
    };
    // Alone in the picture by its colour: brass has no diffuse light, and the rest has.
    const { data, info } = await renderer.render(server, shot);
    const isPart = (x, y) => data[4 * (128 * y + x)] < 8;
    const rows = Array.from({ length: 128 }, (_, y) => Array.from({ length: 128 }, (__, x) => isPart(x, y)).filter(Boolean).length);
    assert.ok(Math.abs(Math.max(...rows) - 64) <= 2, `${projection}: ${Math.max(...rows)} pixels wide`);
    assert.ok(info.shot.camera.far > 0.9, 'what lies behind is drawn too');
    assert.ok(rows[2] < 128 && data[3] === 255, 'the body behind it fills the rest');
  }
});
