import assert from 'node:assert/strict';
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { inspectOn } from '../../../js/api/inspect.mjs';
import { SHOT, model, native, openRenderer } from './support/double.mjs';

let renderer, folder;
before(async () => {
  renderer = await openRenderer();
  folder = await mkdtemp(path.join(os.tmpdir(), 'telar-'));
});
after(async () => {
  await renderer.close();
  await rm(folder, { recursive: true });
});

const PLAN = { note: 'seen' };
const planOf = async (source) => JSON.parse((await renderer.load(source)).facts.plan);

test('bytes in every form', async () => {
  const bytes = model(PLAN);
  const padded = new Uint8Array(bytes.length + 16).fill(0xff);
  padded.set(bytes, 8);
  const shared = new SharedArrayBuffer(bytes.length);
  new Uint8Array(shared).set(bytes);
  const exact = new Uint8Array(bytes).buffer;
  for (const source of [
    bytes,
    new Uint8Array(bytes),
    padded.subarray(8, 8 + bytes.length),
    exact,
    new DataView(padded.buffer, 8, bytes.length),
    new Uint8ClampedArray(exact),
    shared,
    new Uint8Array(shared),
  ]) {
    assert.deepEqual(await planOf(source), PLAN);
  }
});

test('paths and file: URLs; a relative path starts at the current folder', async () => {
  // The double takes its plan from the file's name.
  const file = path.join(folder, '{"note":"seen"}.glb');
  await writeFile(file, '');
  for (const source of [file, path.relative(process.cwd(), file), pathToFileURL(file), pathToFileURL(file).href]) {
    assert.deepEqual(await planOf(source), PLAN);
  }
});

test('later writes to bytes, shot and environment change nothing', async () => {
  const busy = Array.from({ length: 4 }, () => renderer.render(model({ drawMs: 30 }), SHOT));
  const bytes = model({ drawMs: 1 });
  const map = new Uint8Array([1, 2, 3]);
  const shot = { size: { width: 4, height: 2 }, environment: { map, intensity: 2 } };
  const job = renderer.render(bytes, shot);
  bytes.fill(0);
  map.fill(9);
  shot.size.width = 7;
  shot.environment.intensity = 5;
  const { info } = await job;
  assert.deepEqual([info.width, info.environmentBytes, info.environmentSum], [4, 3, 6]);
  assert.equal(info.shot.environment.intensity, 2);
  await Promise.all(busy);
});

test('a transferred buffer is refused', async () => {
  const { buffer } = new Uint8Array(8);
  structuredClone(buffer, { transfer: [buffer] });
  await assert.rejects(renderer.load(buffer), { code: 'E_OPTION' });
});

test('environments: name, path from the current folder, bytes', async () => {
  const seen = async (environment) => (await renderer.render(model(), { ...SHOT, environment })).info;
  assert.equal((await seen('studio')).environmentPath, '');
  assert.equal((await seen('none')).shot.environment.map, 'none');
  const relative = await seen('maps/sky.hdr');
  assert.equal(relative.environmentPath, path.resolve('maps/sky.hdr'));
  assert.equal(relative.shot.environment.map, 'maps/sky.hdr', 'info.shot says what the caller said');
  const map = new Uint8Array([4, 5]);
  const bytes = await seen({ map, rotation: 90 });
  assert.deepEqual([bytes.environmentBytes, bytes.environmentSum, bytes.shot.environment.map], [2, 9, map]);
  assert.equal((await seen(map)).environmentBytes, 2);
});

test('inspect: facts and plan', async () => {
  const facts = await inspectOn(native, model(PLAN));
  assert.deepEqual(facts.plan, { features: ['wait'], programs: [], passes: ['wait'] });
  assert.deepEqual(facts.bounds, { min: [-1, -1, -1], max: [1, 1, 1] });
});
