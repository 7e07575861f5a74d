import assert from 'node:assert/strict';
import { existsSync, mkdirSync, mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { MODELS } from '../../fixtures/index.mjs';
import { until } from '../../until.mjs';
import { open, SHOT } from './support.mjs';

// Where Mesa keeps the programs that a worker compiled: where other workers look, and nobody else does.

const filesIn = (folder) => (existsSync(folder) ? readdirSync(folder, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile()) : []);

/** Draws in a pool; Mesa's own choice, of programs outside of workers, is below the folder `of the user`. */
async function draw(t, options, env = {}) {
  const folder = mkdtempSync(path.join(tmpdir(), 'telar-programs-'));
  t.after(() => rmSync(folder, { recursive: true, force: true }));
  const user = path.join(folder, 'of the user');
  mkdirSync(user);
  const set = { XDG_CACHE_HOME: user, ...env };
  const before = Object.fromEntries(Object.keys(set).map((name) => [name, process.env[name]]));
  const restore = () => {
    for (const [name, value] of Object.entries(before)) {
      if (value === undefined) delete process.env[name];
      else process.env[name] = value;
    }
  };
  t.after(restore);
  Object.assign(process.env, set);
  const pool = await open(options(folder));
  await pool.render(await MODELS.cloth(), SHOT);
  const programs = { own: path.join(folder, 'telar/mesa_shader_cache'), user: path.join(user, 'mesa_shader_cache') };
  return { pool, programs, restore };
}

test("programs of workers lie in telar's cache, which is made, and not with those of the user", async (t) => {
  const { pool, programs } = await draw(t, (folder) => ({ cacheDirectory: path.join(folder, 'telar') }));
  await until(() => filesIn(programs.own).length > 0);
  await pool.close();
  assert.deepEqual(filesIn(programs.user), []);
});

test('without a cache nothing is kept; planted: where Mesa may, it is with those of the user', async (t) => {
  const off = await draw(t, () => ({ cacheDirectory: null }));
  await off.pool.close();
  assert.deepEqual([filesIn(off.programs.own), filesIn(off.programs.user)], [[], []]);
  off.restore();
  const on = await draw(t, () => ({ cacheDirectory: null }), { MESA_SHADER_CACHE_DISABLE: 'false' });
  await until(() => filesIn(on.programs.user).length > 0);
  await on.pool.close();
});

test('a cache that cannot be made stops nothing', async (t) => {
  const { pool, programs } = await draw(t, (folder) => ({ cacheDirectory: path.join(folder, 'of the user', 'no\u0001', 'x'.repeat(300)) }));
  await pool.close();
  assert.deepEqual(filesIn(programs.user), []);
});
