import assert from 'node:assert/strict';
import { mkdtemp, readdir, readFile, rm } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { ofShot } from '../../../js/api/draw_request.mjs';
import { writeAnimation } from '../../../js/cli/animation.mjs';
import { TelarError } from '../../../js/error/index.mjs';

// What is told of the frames of one animation; test/js/cli/layers.test.mjs draws them.

let folder;
before(async () => {
  folder = await mkdtemp(path.join(os.tmpdir(), 'telar-animation-'));
});
after(() => rm(folder, { recursive: true }));

const RANGE = (pointer) => ({ code: 'W_RANGE', message: `clamped at ${pointer}`, pointer });
const EXPOSURE = (percent) => ({ code: 'W_EXPOSURE', message: `${percent} % of the model shows no shading` });

const jobsOf = (frames) => frames.map((_, i) => ({ model: 'shirt.glb', variant: 'default', view: `side-${i}`, source: 'shirt.glb', shot: {} }));

/** Warnings that are told of frames which have these. */
async function toldOf(...warnings) {
  const renderer = { renderAll: async () => warnings.map((each) => ({ data: Buffer.from('still'), info: { width: 4, height: 4, warnings: each } })) };
  const told = [];
  const console = { warning: ({ code, message }, about) => told.push([about, code, message]), result: async () => {} };
  const output = path.join(folder, 'turn.webp');
  const exit = await writeAnimation({ jobs: jobsOf(warnings), options: { output }, renderer }, { api: { animateWebp: () => Buffer.from('moving') }, console });
  assert.deepEqual([exit, await readFile(output, 'utf8')], [0, 'moving']);
  return told;
}

test('warnings of every frame are told, each once, by the frame that shows it first', async () => {
  assert.deepEqual(await toldOf([], [EXPOSURE(60)], [EXPOSURE(70), { code: 'W_EMPTY', message: 'none' }], []), [
    ['shirt.glb, side-1', 'W_EXPOSURE', '60 % of the model shows no shading'],
    ['shirt.glb, side-2', 'W_EMPTY', 'none'],
  ]);
});

test('what a file has at several places is told of each', async () => {
  const ofFile = [RANGE('/materials/0'), RANGE('/materials/1')];
  assert.deepEqual(await toldOf(ofFile, ofFile), [
    ['shirt.glb, side-0', 'W_RANGE', 'clamped at /materials/0'],
    ['shirt.glb, side-0', 'W_RANGE', 'clamped at /materials/1'],
  ]);
  assert.deepEqual(await toldOf([], []), []);
});

test('what one animation cannot have is refused', async () => {
  const output = path.join(folder, 'refused.webp');
  const refused = async (job, options = {}) => {
    const jobs = jobsOf([0, 1]).map((each) => ({ ...each, ...job }));
    const error = await writeAnimation({ jobs, options: { output, ...options }, renderer: {} }, { api: {}, console: {} }).catch((thrown) => thrown);
    assert.equal(error.code, 'E_USAGE', error.stack);
    return error.message;
  };
  for (const options of [{ contactSheet: 'c.png' }, { skipUnchanged: true }, { reached: true }])
    assert.match(await refused({}, options), /an animation has no --contact-sheet, no --skip-unchanged and no --reached$/);
  const own = await refused({ where: '--manifest line 2', output: 'own.png' });
  assert.match(own, /^--manifest line 2: output: the animation goes to ".*refused\.webp"; drop one of them$/);
  const other = await refused({ shot: { output: { format: 'png' } } });
  assert.match(other, /refused\.webp" means an animated webp, but the shot's output\.format is png; drop one of them$/);
});

test('a frame that fails is told by its name, and nothing is written', async () => {
  const failure = ofShot(new TelarError('E_WARNING', 'W_EMPTY: none; with failOn "error" it is drawn'), 2);
  const fail = async (error) => {
    const drawing = { jobs: jobsOf([0, 1, 2]), options: { output: path.join(folder, 'none.webp') }, renderer: { renderAll: () => Promise.reject(error) } };
    return writeAnimation(drawing, { api: {}, console: {} });
  };
  await assert.rejects(fail(failure), { code: 'E_WARNING', exit: failure.exit, message: 'shirt.glb, side-2: W_EMPTY: none; with failOn "error" it is drawn' });
  const closed = new TelarError('X_CLOSED', 'the renderer was closed');
  await assert.rejects(fail(closed), (error) => error === closed, 'what is of no frame');
  assert.deepEqual(await readdir(folder), ['turn.webp']);
});
