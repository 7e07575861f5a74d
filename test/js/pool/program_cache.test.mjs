import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readdirSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { MODELS } from '../../fixtures/index.mjs';
import { until } from '../../until.mjs';
import { open, SHOT } from './support.mjs';

// Where Mesa keeps the programs that a worker compiled: where other workers look, and nobody else does.

const POOL = new URL('../../../js/pool/index.mjs', import.meta.url).href;
const GARMENT = fileURLToPath(new URL('../../../js/assets/tshirt.glb', import.meta.url));

const filesIn = (folder) => (existsSync(folder) ? readdirSync(folder, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile()) : []);

/** A pool whose worker has more in its environment. */
async function openWith(env, options) {
  const before = { ...process.env };
  Object.assign(process.env, env);
  try {
    return await open(options);
  } finally {
    for (const name of Object.keys(env)) delete process.env[name];
    Object.assign(process.env, before);
  }
}

/** Draws in a pool; Mesa's own choice, of programs outside of workers, is below the folder `of the user`. @param {(user: string) => object} [envOf] */
async function draw(t, cacheOf, envOf = () => ({})) {
  const folder = mkdtempSync(path.join(tmpdir(), 'telar-programs-'));
  t.after(() => rmSync(folder, { recursive: true, force: true }));
  const user = path.join(folder, 'of the user');
  mkdirSync(user);
  const pool = await openWith({ XDG_CACHE_HOME: user, ...envOf(user) }, { cacheDirectory: cacheOf(folder) });
  await pool.render(await MODELS.cloth(), SHOT);
  return { pool, programs: { own: path.join(folder, 'telar/mesa_shader_cache'), user: path.join(user, 'mesa_shader_cache') } };
}

test("programs of workers lie in telar's cache, which is made, and not with those of the user", async (t) => {
  const { pool, programs } = await draw(t, (folder) => path.join(folder, 'telar'));
  const kept = () => [filesIn(programs.own).length > 0, filesIn(programs.user).length > 0];
  await until(() => kept().includes(true));
  await pool.close();
  assert.deepEqual(kept(), [true, false]);
});

test('without a cache nothing is kept; planted: where the user has Mesa keep some, they are there', async (t) => {
  const off = await draw(t, () => null);
  await off.pool.close();
  assert.deepEqual([filesIn(off.programs.own), filesIn(off.programs.user)], [[], []]);
  const on = await draw(
    t,
    () => null,
    (user) => ({ MESA_SHADER_CACHE_DISABLE: 'false', MESA_SHADER_CACHE_DIR: user }),
  );
  await until(() => filesIn(on.programs.user).length > 0);
  await on.pool.close();
});

test('a cache that cannot be made stops nothing', async (t) => {
  const { pool, programs } = await draw(t, (folder) => path.join(folder, 'of the user', 'x'.repeat(300)));
  await pool.close();
  assert.deepEqual(filesIn(programs.user), []);
});

test('the list of programs, which Mesa maps, has its place on the disk: a full one does not end a worker', async (t) => {
  const { pool, programs } = await draw(t, (folder) => path.join(folder, 'telar'));
  await pool.close();
  const { size, blocks } = statSync(path.join(programs.own, 'index'));
  assert.ok(size > 0 && blocks * 512 >= size, `${blocks} blocks of ${size} bytes`);
});

const FULL = `mount -t tmpfs -o size=16k tmpfs "$0" && exec "$@"`;
const maySetUp = spawnSync('unshare', ['-m', 'bash', '-c', FULL, tmpdir(), 'true']).status === 0;

test('where the disk is full, pictures are drawn', { skip: maySetUp ? false : 'needs the right to mount' }, (t) => {
  const folder = mkdtempSync(path.join(tmpdir(), 'telar-full-'));
  t.after(() => rmSync(folder, { recursive: true, force: true }));
  const text = `
    const { createPool } = await import('${POOL}');
    const pool = await createPool({ size: 1, cacheDirectory: '${folder}', timeoutMs: null });
    console.log((await pool.render('${GARMENT}', { size: { width: 32, height: 32 } })).info.width);
    await pool.close();`;
  const { stdout, stderr } = spawnSync('unshare', ['-m', 'bash', '-c', FULL, folder, process.execPath, '--input-type=module', '-e', text], {
    encoding: 'utf8',
  });
  assert.equal(stdout, '32\n', stderr);
});
