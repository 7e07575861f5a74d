import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createRendererOn } from '../../../js/api/renderer.mjs';
import { ENDLESS_MS, SHOT, model, native } from './support/double.mjs';

const at = (time) => ({ ...SHOT, pose: { animation: 'wait', time } });

/** A renderer, and the times that poses were made for. */
async function open() {
  const times = [];
  const pose = (scene, animation, time, ...rest) => {
    times.push(time);
    return native.pose(scene, animation, time, ...rest);
  };
  return { renderer: await createRendererOn({ ...native, pose }, { cacheDirectory: null }), times };
}

test('shots that share a pose share the work, and nothing of it stays', async () => {
  const { renderer, times } = await open();
  const loaded = await renderer.load(model({ poseMs: 5, drawMs: 2 }));
  const images = await renderer.renderAll(loaded, [at(0.5), SHOT, at(0.5), at(1), at(0.5), { ...SHOT, pose: null }]);
  assert.deepEqual(times.sort(), [0.5, 1]);
  assert.deepEqual(
    images.map(({ info }) => info.shot.pose?.time),
    [0.5, undefined, 0.5, 1, 0.5, undefined],
  );
  assert.equal(await renderer.liveObjects(), 1, 'the model, which the caller keeps');
  await renderer.close();
});

test('a pose of a model that is drawn once goes with it', async () => {
  const { renderer } = await open();
  await renderer.render(model(), at(0.25));
  await renderer.renderAll(model(), [at(0.25), at(0.75), SHOT]);
  assert.equal(await renderer.liveObjects(), 0);
  await renderer.close();
});

test('a pose that fails or is aborted ends the job, and the model can be drawn again', async () => {
  const { renderer } = await open();
  const broken = await renderer.load(model({ fail: { stage: 'pose', as: 'memory' } }));
  await assert.rejects(renderer.render(broken, at(0)), { code: 'X_MEMORY' });
  await assert.rejects(renderer.renderAll(broken, [SHOT, at(0)]), { code: 'X_MEMORY' });
  await renderer.render(broken, SHOT);
  const slow = await renderer.load(model({ poseMs: ENDLESS_MS }));
  await assert.rejects(renderer.render(slow, at(0), { signal: AbortSignal.timeout(20) }), { name: 'TimeoutError' });
  await renderer.render(slow, SHOT);
  await renderer.close();
});
