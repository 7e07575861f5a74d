import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { TelarError } from '../../../js/error/index.mjs';
import { SHOT, model, openRenderer } from './support/double.mjs';

// renderAll where some of the shots are wrong: which it was, and what becomes of the others.

let renderer;
before(async () => {
  renderer = await openRenderer();
});
after(() => renderer.close());

const WRONG = { size: { width: 0, height: 2 } };
const SHOTS = [SHOT, WRONG, SHOT, null, SHOT];

test('the error says which shot was wrong', async () => {
  const error = await renderer.renderAll(model(), [SHOT, SHOT, WRONG]).catch((thrown) => thrown);
  assert.ok(error instanceof TelarError);
  assert.deepEqual([error.code, error.index, error.pointer, error.cause.code], ['E_SHOT', 2, '/size/width', 'E_SHOT']);
  assert.equal(error.message, 'shots[2]: shot.size.width: expected a whole number of pixels in [1, 8192], got 0');
  assert.equal(error.toJSON().index, 2);
  await assert.rejects(renderer.renderAll(model(), [SHOT, null]), { code: 'E_SHOT', index: 1, message: 'shots[1]: shot: expected an object' });
  await assert.rejects(renderer.renderAll(model({ fail: { stage: 'draw', as: 'error' } }), [SHOT]), {
    code: 'L_VERTICES',
    index: 0,
    limit: { name: 'L_VERTICES', max: 10, actual: 11 },
  });
});

test('settled: one wrong shot does not lose the others', async () => {
  const outcomes = await renderer.renderAll(model(), SHOTS, { settled: true });
  assert.deepEqual(
    outcomes.map(({ status }) => status),
    ['fulfilled', 'rejected', 'fulfilled', 'rejected', 'fulfilled'],
  );
  assert.deepEqual(
    outcomes.filter(({ reason }) => reason).map(({ reason }) => [reason.code, reason.index]),
    [
      ['E_SHOT', 1],
      ['E_SHOT', 3],
    ],
  );
  for (const { value } of outcomes.filter(({ status }) => status === 'fulfilled')) assert.deepEqual([value.info.width, Buffer.isBuffer(value.data)], [4, true]);
  assert.deepEqual(await renderer.renderAll(model(), [], { settled: true }), []);
});

test('settled: shots that share a pose of which one is wrong, and a pose that the model does not have', async () => {
  const posed = { ...SHOT, pose: { animation: 'wait', time: 0.5 } };
  const outcomes = await renderer.renderAll(model(), [posed, { ...posed, variant: 'no such' }, { ...SHOT, pose: { animation: 'no such' } }, posed], {
    settled: true,
  });
  assert.deepEqual(
    outcomes.map(({ reason }) => reason && [reason.code, reason.index]),
    [undefined, ['E_VARIANT', 1], ['E_POSE', 2], undefined],
  );
  assert.equal(await renderer.liveObjects(), 0, 'no pose stays on the GPU');
  // The last shot of a pose is the wrong one: it frees what the first sent.
  await renderer.renderAll(model(), [posed, { ...posed, variant: 'no such' }], { settled: true });
  assert.equal(await renderer.liveObjects(), 0);
});

test('settled: what is of no shot rejects', async () => {
  await assert.rejects(
    renderer.renderAll(model({ fail: { stage: 'load', as: 'error' } }), [SHOT], { settled: true }),
    (error) => error.code === 'L_VERTICES' && error.index === undefined,
  );
  const signal = AbortSignal.timeout(30);
  await assert.rejects(renderer.renderAll(model({ drawMs: 500 }), [SHOT, SHOT], { settled: true, signal }), { name: 'TimeoutError' });
  const stop = new Error('enough');
  await assert.rejects(
    renderer.renderAll(model(), [SHOT, SHOT], {
      settled: true,
      onProgress: () => {
        throw stop;
      },
    }),
    (error) => error === stop,
  );
});

test('settled: progress reaches 1 with failures', async () => {
  const said = [];
  await renderer.renderAll(model(), SHOTS, { settled: true, onProgress: (part) => said.push(part) });
  assert.equal(said.at(-1), 1);
});

test('a warning is an error where failOn says so', async () => {
  // The double's models give one warning each.
  await renderer.render(model(), SHOT);
  const said = { code: 'E_WARNING', kind: 'input', message: 'W_IMAGE: from the model; with failOn "error" it is drawn' };
  await assert.rejects(renderer.render(model(), SHOT, { failOn: 'warning' }), said);
  await assert.rejects(renderer.load(model(), { failOn: 'warning' }), said);
  const loaded = await renderer.load(model());
  await assert.rejects(renderer.render(loaded, SHOT, { failOn: 'warning' }), said);
  const [{ reason }] = await renderer.renderAll(loaded, [SHOT], { failOn: 'warning', settled: true });
  assert.deepEqual([reason.code, reason.index], ['E_WARNING', 0]);
  const strict = await openRenderer({ failOn: 'error' });
  await strict.close();
});
