import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { createRenderer, inspect } from '../../../js/index.mjs';
import { MODELS } from '../../fixtures/index.mjs';
import './support/real.mjs';

const SHOT = { size: { width: 64, height: 64 }, environment: 'none', lights: [{ type: 'directional', position: [1, 2, 3] }], output: { format: 'raw' } };
const at = (animation, time, camera = { view: 'front' }) => ({ ...SHOT, camera, pose: { animation, time } });

let renderer, bytes;
before(async () => {
  renderer = await createRenderer({ cacheDirectory: null });
  bytes = await MODELS['morph-and-skin']();
});
after(() => renderer.close());

test('a pose changes the picture; info tells it, and how long it took', async () => {
  const rest = await renderer.render(bytes, SHOT);
  const posed = await renderer.render(bytes, at('both', 0.9));
  assert.ok(!posed.data.equals(rest.data));
  assert.deepEqual(posed.info.shot.pose, { animation: 0, time: 0.9 });
  assert.equal(rest.info.shot.pose, null);
  assert.ok(posed.info.milliseconds.pose > 0);
});

test('bytes, a loaded model and many views draw the same pose alike', async () => {
  const shot = at(0, 0.6);
  const { data } = await renderer.render(bytes, shot);
  const model = await renderer.load(bytes);
  assert.ok((await renderer.render(model, shot)).data.equals(data));
  const views = await renderer.renderAll(model, [SHOT, shot, at(0, 0.2), shot]);
  assert.ok(views[1].data.equals(data) && views[3].data.equals(data));
  assert.ok(!views[2].data.equals(data));
  assert.ok((await renderer.render(model, SHOT)).data.equals(views[0].data), 'the model itself is as it was');
});

test('the camera frames the pose', async () => {
  const facts = async (time) => (await inspect(bytes, { shot: at(0, time) })).bounds;
  const [start, end] = [await facts(0), await facts(1)];
  assert.notDeepEqual(start, end);
  const { info } = await renderer.render(bytes, at(0, 1));
  const middle = end.max.map((x, i) => (x + end.min[i]) / 2);
  assert.ok(
    info.shot.camera.target.every((x, i) => Math.abs(x - middle[i]) < 0.2),
    JSON.stringify([info.shot.camera.target, middle]),
  );
});

test('an unknown animation is refused with what there is', async () => {
  const model = await renderer.load(bytes);
  await assert.rejects(renderer.render(model, at('bth', 0)), { code: 'E_POSE', message: /did you mean "both"\?/ });
  await assert.rejects(renderer.render(await MODELS.ball(), at(0, 0)), { code: 'E_POSE', message: /it has none/ });
  await assert.rejects(inspect(bytes, { shot: at(3, 0) }), { code: 'E_POSE' });
});

test('inspect lists animations, and what a pose would compile', async () => {
  const facts = await inspect(await MODELS.skin(), { shot: { pose: { animation: 'grow', time: 1 } } });
  assert.deepEqual(facts.animations, [
    { name: 'wave', duration: 1 },
    { name: 'grow', duration: 1 },
  ]);
  assert.ok(facts.plan.programs.length > 0);
  const instanced = await inspect(await MODELS['instances-colors']());
  assert.ok(instanced.plan.features.includes('instancing') && instanced.plan.features.includes('instance-color'));
});

test('the GPU keeps nothing of poses, and one copy of the textures of their model', async () => {
  const model = await renderer.load(await MODELS.skin());
  const pose = (time) => ({ ...at('wave', time), environment: 'none' });
  await renderer.render(model, pose(0.1));
  const before = await renderer.liveObjects();
  for (const time of [0.2, 0.4, 0.6]) await renderer.render(model, pose(time));
  await renderer.renderAll(model, [0.1, 0.3, 0.5, 0.7].map(pose));
  assert.equal(await renderer.liveObjects(), before);
  await renderer.release(model);
  assert.ok((await renderer.liveObjects()) < before);
});

test('a model drawn once in a pose leaves nothing on the GPU', async () => {
  const source = await MODELS.skin();
  await renderer.render(source, at('wave', 0.1));
  const before = await renderer.liveObjects();
  for (let i = 0; i < 5; ++i) await renderer.render(source, at('wave', i / 5));
  assert.equal(await renderer.liveObjects(), before);
});

test('an aborted pose rejects with its reason', async () => {
  const model = await renderer.load(bytes);
  const controller = new AbortController();
  const job = renderer.render(model, at(0, 0.5), { signal: controller.signal });
  controller.abort(new Error('enough'));
  await assert.rejects(job, /enough/);
});
