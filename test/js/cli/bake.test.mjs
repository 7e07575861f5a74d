import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { runFake } from './fake.mjs';

let folder;
before(() => {
  folder = mkdtempSync(path.join(os.tmpdir(), 'telar-cli-bake-'));
});
after(() => rmSync(folder, { recursive: true }));

test('the baked model is written, and how is handed on', async () => {
  const file = path.join(folder, 'out.glb');
  const { exit, stdout, stderr, calls } = await runFake([
    'bake',
    'warn.glb',
    '-o',
    file,
    '--rays',
    '64',
    '--limit',
    'L_VISIBILITY_RAYS=9',
    '--timeout-ms',
    'none',
  ]);
  assert.deepEqual([exit, stdout], [0, `${file}\n`]);
  assert.match(stderr, /W_RANGE/);
  assert.equal(readFileSync(file, 'utf8'), 'baked');
  const [{ source, options }] = calls.baked;
  assert.equal(source, 'warn.glb');
  assert.deepEqual([options.rays, options.limits, options.timeoutMs, options.failOn], [64, { L_VISIBILITY_RAYS: 9 }, null, 'error']);
});

test('- is stdin and stdout', async () => {
  const { exit, stdout, calls } = await runFake(['bake', '-', '-o', '-'], { stdin: 'bytes' });
  assert.deepEqual([exit, stdout, calls.baked[0].source.toString()], [0, 'baked', 'bytes']);
  assert.ok(!('rays' in calls.baked[0].options), 'the default is that of the API');
});

test('what cannot be written is refused, and why', async () => {
  const complaint = async (...args) => {
    const { exit, stderr } = await runFake(['bake', ...args]);
    return `${exit} ${stderr}`;
  };
  assert.match(await complaint('m.glb', '-o', path.join(folder, 'm.gltf')), /^2 .*the model is a \.glb file, and so is what is written/s);
  assert.match(await complaint('m.gltf', '-o', path.join(folder, 'm.gltf')), /^2 .*the model names "m\.bin" beside it; write into the folder of the model/s);
  assert.match(await complaint('m.glb', '-o', 'o.glb', '--rays', 'many'), /^2 .*--rays: expected a whole number, got "many"/s);
  assert.match(await complaint('m.glb'), /^2 .*required option '-o, --output <out>' not specified/s);
  assert.match(await complaint('E_INDEX.glb', '-o', 'o.glb'), /^3 /);
  assert.match(await complaint('m.glb', '-o', '-', '--json'), /^2 .*both want stdout/s);
});

test('thumbnails of models that are loaded with it', async () => {
  const file = path.join(folder, 'm.png');
  const { exit, calls } = await runFake(['thumbnail', 'm.glb', '-o', file, '--ambient-visibility']);
  assert.equal(exit, 0);
  assert.equal(calls.created[0].ambientVisibility, true);
  const { calls: without } = await runFake(['thumbnail', 'm.glb', '-o', file]);
  assert.ok(!('ambientVisibility' in without.created[0]));
});
