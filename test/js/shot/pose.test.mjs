import assert from 'node:assert/strict';
import { test } from 'node:test';
import { resolvePose, resolveShot } from '../../../js/shot/index.mjs';

const facts = {
  animations: [
    { name: 'walk', duration: 2 },
    { name: 'sit', duration: 1 },
  ],
};

test('a pose is an index and a time, or null', () => {
  assert.equal(resolvePose({}, facts), null);
  assert.equal(resolvePose(undefined, facts), null);
  assert.equal(resolvePose({ pose: null }), null);
  assert.deepEqual(resolvePose({ pose: { animation: 'sit', time: 0.5 } }, facts), { animation: 1, time: 0.5 });
  assert.deepEqual(resolvePose({ pose: { animation: 0 } }, facts), { animation: 0, time: 0 });
  assert.deepEqual(resolvePose({ pose: { animation: 7 } }), { animation: 7, time: 0 }, 'without facts an index stands');
});

test('a time out of the animation stays as it is: who draws it clamps', () => {
  assert.equal(resolvePose({ pose: { animation: 0, time: 99 } }, facts).time, 99);
  assert.equal(resolvePose({ pose: { animation: 0, time: -1 } }, facts).time, -1);
});

test('the pose of a resolved shot is the one that resolvePose gives', () => {
  const shot = { pose: { animation: 'sit', time: 0.5 } };
  const known = { ...facts, bounds: { min: [0, 0, 0], max: [1, 1, 1] } };
  assert.deepEqual(resolveShot(shot, known).pose, resolvePose(shot, facts));
});

test('wrong poses are refused with their path', () => {
  const cases = [
    [{ pose: 3 }, 'E_SHOT', 'shot.pose: expected an object, got 3'],
    [{ pose: {} }, 'E_SHOT', 'shot.pose.animation: expected the index or the name of an animation in the model, got nothing'],
    [{ pose: { animation: -1 } }, 'E_SHOT', 'shot.pose.animation: expected the index or the name of an animation in the model, got -1'],
    [{ pose: { animation: 0, time: NaN } }, 'E_SHOT', 'shot.pose.time: expected a number of seconds in [-1e30, 1e30], got NaN'],
    [{ pose: { animation: 0, tiem: 1 } }, 'E_SHOT', 'shot.pose.tiem: unknown key, did you mean time?'],
    [{ pose: { animation: 2 } }, 'E_POSE', 'shot.pose.animation: the model has no animation 2; it has 0 "walk", 1 "sit"'],
  ];
  for (const [shot, code, message] of cases) assert.throws(() => resolvePose(shot, facts), { code, message });
  const none = { animations: [] };
  assert.throws(() => resolvePose({ pose: { animation: 0 } }, none), {
    code: 'E_POSE',
    message: 'shot.pose.animation: the model has no animation 0; it has none',
  });
  assert.throws(() => resolvePose({ pose: { animation: 'walk' } }), { code: 'E_POSE', message: /list no animations/ });
});
