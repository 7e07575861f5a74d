// The same shot gives the same bytes: in another process, on another number of rasteriser threads, on another backend.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { createRenderer } from '../../js/index.mjs';
import { ENVIRONMENTS, MODELS } from '../fixtures/index.mjs';

const root = fileURLToPath(new URL('../../', import.meta.url));
const folder = mkdtempSync(path.join(tmpdir(), 'telar-determinism-'));
after(() => rmSync(folder, { recursive: true }));

function thumbnail(name, environment) {
  const out = path.join(folder, name);
  const run = spawnSync(process.execPath, ['js/cli/telar.mjs', 'thumbnail', 'js/assets/tshirt.glb', '-o', out, '--view', 'three-quarter'], {
    cwd: root,
    env: { ...process.env, ...environment },
    encoding: 'utf8',
  });
  assert.equal(run.status, 0, run.stderr);
  return readFileSync(out);
}

test('two processes, one and two rasteriser threads: the same PNG', () => {
  const first = thumbnail('a.png', {});
  assert.deepEqual(thumbnail('b.png', {}), first);
  assert.deepEqual(thumbnail('one.png', { LP_NUM_THREADS: '1' }), first);
  assert.deepEqual(thumbnail('two.png', { LP_NUM_THREADS: '2' }), first);
  assert.deepEqual(thumbnail('none.png', { LP_NUM_THREADS: '0' }), first);
});

let egl;
let osmesa;
before(async () => {
  // Bytes are asked for, not time: on a busy machine a program may take longer to compile than a render may take.
  egl = await createRenderer({ backend: 'egl-surfaceless', timeoutMs: null });
  osmesa = await createRenderer({ backend: 'osmesa', timeoutMs: null });
});
after(async () => {
  await egl?.close();
  await osmesa?.close();
});

const lamps = ENVIRONMENTS.lamps();
const lights = [
  { type: 'hemisphere', color: [0.8, 0.9, 1], groundColor: [0.2, 0.15, 0.1], intensity: 0.5 },
  { type: 'directional', color: 'white', intensity: 2, position: [3, 4, 5] },
];

/** One model of each kind, which the first word of a name tells: both backends are one rasteriser, and each program is compiled twice here. */
const kindOf = (name) => name.split('-')[0];
const KINDS = Object.entries(MODELS).filter(
  ([name], i, all) => /everything|layers/.test(name) || all.findIndex(([other]) => kindOf(other) === kindOf(name)) === i,
);

for (const [name, make] of KINDS) {
  test(`EGL surfaceless and OSMesa draw ${name} byte for byte alike`, async () => {
    const model = await make();
    const shot = {
      size: { width: 128, height: 128 },
      environment: { map: lamps },
      lights,
      camera: { view: 'three-quarter' },
      background: name === 'ball' ? 'environment' : 'transparent',
      output: { format: 'raw' },
    };
    const a = await egl.render(model, shot);
    const b = await osmesa.render(model, shot);
    assert.equal(a.info.backend, 'egl-surfaceless');
    assert.equal(b.info.backend, 'osmesa');
    assert.ok(a.data.equals(b.data));
    assert.ok(
      a.data.some((byte) => byte !== 0),
      'something is drawn',
    );
  });
}

test('EGL surfaceless and OSMesa draw the bundled garment byte for byte alike', async () => {
  const file = path.join(root, 'js/assets/tshirt.glb');
  const [a, b] = [await egl.render(file, {}), await osmesa.render(file, {})];
  assert.ok(a.data.equals(b.data));
});

test('EGL surfaceless and OSMesa draw layers of cut-out cloth byte for byte alike, and again', async () => {
  const model = await MODELS['cloth-layers']();
  for (const samples of [1, 4]) {
    const shot = { size: { width: 128, height: 128 }, environment: 'none', lights, shading: 'fabric', quality: { samples }, output: { format: 'raw' } };
    const { data } = await egl.render(model, shot);
    assert.deepEqual((await osmesa.render(model, shot)).data, data);
    assert.deepEqual((await egl.render(model, shot)).data, data);
  }
});

test('a first picture in floats has the bytes of the next one', async () => {
  const file = path.join(root, 'js/assets/tshirt.glb');
  for (const [shading, quality] of [
    ['three', { samples: 16 }],
    ['fabric', 'medium'],
  ]) {
    const renderer = await createRenderer();
    const draw = () => renderer.render(file, { size: { width: 70, height: 70 }, shading, quality, output: { format: 'raw', bitDepth: 32 } });
    const [first, next] = [await draw(), await draw()];
    assert.ok(first.data.equals(next.data), shading);
    await renderer.close();
  }
});

test('a picture in floats has the same bytes after a large one of its model', async () => {
  const renderer = await createRenderer();
  const model = await renderer.load(path.join(root, 'js/assets/tshirt.glb'));
  const floats = { size: { width: 90, height: 90 }, output: { format: 'raw', bitDepth: 32 } };
  const shots = [floats, { ...floats, shading: 'fabric' }, { ...floats, quality: 'medium' }];
  const first = await renderer.renderAll(model, shots);
  await renderer.render(model, { size: { width: 1024, height: 1024 }, camera: { fit: 4 }, quality: 'draft' });
  const next = await renderer.renderAll(model, shots);
  for (const i of shots.keys()) assert.ok(first[i].data.equals(next[i].data), `shots[${i}]`);
  await renderer.close();
});
