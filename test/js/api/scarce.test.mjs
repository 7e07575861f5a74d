import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { mkdtemp, rm } from 'node:fs/promises';
import os from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { addonFile, indexUrl } from './support/real.mjs';

// Where a process may have little: open files, threads, memory, no home. What it says then.

const SCRIPT = `
  import { createRenderer } from '${indexUrl}';
  const side = Number(process.env.SIDE);
  try {
    const renderer = await createRenderer();
    await renderer.render(Buffer.from(process.env.MODEL, 'base64'), { size: { width: side, height: side }, output: { format: 'jpeg' } });
    await renderer.close();
    console.log('drawn');
  } catch (error) {
    console.log(error.code, error.message);
  }`;

/** A triangle as text, small enough for an environment variable. */
const corners = Buffer.from(new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]).buffer).toString('base64');
const TRIANGLE = Buffer.from(
  JSON.stringify({
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }],
    buffers: [{ byteLength: 36, uri: `data:application/octet-stream;base64,${corners}` }],
    bufferViews: [{ buffer: 0, byteLength: 36 }],
    accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: 'VEC3', min: [0, 0, 0], max: [1, 1, 0] }],
  }),
).toString('base64');

/** Runs the drawing under a wrapper's limits; the last line that it says. */
async function drawUnder(wrapper, env = {}) {
  const [command, ...args] = [...wrapper, process.execPath, '--input-type=module', '-e', SCRIPT];
  const child = spawn(command, args, { env: { ...process.env, MODEL: TRIANGLE, SIDE: 16, ...env }, stdio: ['ignore', 'pipe', 'pipe'] });
  let text = '';
  for (const stream of [child.stdout, child.stderr])
    stream.on('data', (chunk) => {
      text += chunk;
    });
  const code = await new Promise((resolve) => child.on('close', resolve));
  return `${text.trim().split('\n').at(-1)}${code === 0 ? '' : ` (exit ${code})`}`;
}

const limited = (option, value) => ['prlimit', `--${option}=${value}`];
/** Another user, whose processes nobody else's are counted with; root alone may become one. */
const asUser = (id) => ['setpriv', `--reuid=${id}`, `--regid=${id}`, '--clear-groups'];
const canBeOther = spawnSync(asUser(54_321)[0], [...asUser(54_321).slice(1), 'test', '-r', addonFile]).status === 0;

test('a picture with 64 open files', async () => {
  assert.equal(await drawUnder(limited('nofile', 64)), 'drawn');
});

test('a user without a name and without HOME', { skip: !canBeOther && 'needs root, and files that others may read' }, async (t) => {
  const folder = await mkdtemp(path.join(os.tmpdir(), 'telar-'));
  t.after(() => rm(folder, { recursive: true }));
  assert.equal(await drawUnder([...asUser(54_321), 'env', '-u', 'HOME', '-u', 'XDG_CACHE_HOME']), 'drawn');
});

test('no more threads: told as a lack of what the system gives', { skip: !canBeOther && 'needs root, and files that others may read' }, async () => {
  // Node itself takes some ten; what is between that and enough must be told in words.
  const said = new Set();
  for (const threads of [12, 14, 16, 18]) said.add((await drawUnder([...asUser(54_322), ...limited('nproc', threads)], { HOME: os.tmpdir() })).split(';')[0]);
  said.delete('drawn');
  assert.deepEqual([...said], ['X_MEMORY the system starts no more threads for this process']);
});

test('a picture that does not fit the memory is no fault of the driver', async () => {
  const said = await drawUnder(limited('as', 3 * 2 ** 30), { SIDE: 8192 });
  assert.match(said, /^X_GL_MEMORY the GL driver (has not enough memory for a picture of 8192 x 8192 pixels|ran out of memory)/);
});
