import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { test } from 'node:test';
import { promisify } from 'node:util';
import { fixturesUrl } from '../api/support/real.mjs';
import { MODELS } from '../../fixtures/index.mjs';
import { until } from '../../until.mjs';
import { errorOf, isAlive, open, SHOT } from './support.mjs';

// Processes of workers that cannot be made: a start that failed, and no more.

const url = (path) => JSON.stringify(new URL(path, import.meta.url).href);

/** Longer than the kernel takes as one text of an environment: spawn() throws E2BIG. */
const TOO_LONG = 'x'.repeat(2 ** 18);

test('spawn that throws: X_WORKERS, and when there is room again it draws', async (t) => {
  const glb = await MODELS.cloth();
  t.after(() => delete process.env.TELAR_TOO_LONG);
  process.env.TELAR_TOO_LONG = TOO_LONG;
  const none = await errorOf(open());
  assert.deepEqual([none?.code, none?.message], ['X_WORKERS', 'the process of a worker of the pool cannot be made (E2BIG)']);
  delete process.env.TELAR_TOO_LONG;
  const pool = await open();
  const [{ pid }] = pool.workers;
  process.env.TELAR_TOO_LONG = TOO_LONG;
  process.kill(pid, 'SIGKILL');
  await until(() => !isAlive(pid));
  assert.equal((await errorOf(pool.render(glb, SHOT)))?.code, 'X_WORKERS');
  delete process.env.TELAR_TOO_LONG;
  await until(async () => (await errorOf(pool.render(glb, SHOT))) === undefined);
  await pool.close();
});

test('no descriptor is left (EMFILE): X_WORKERS, the process lives, and when there are some again it draws', async () => {
  const program = `
    import { closeSync, openSync } from 'node:fs';
    import { createPool } from ${url('../../../js/pool/index.mjs')};
    import { MODELS } from ${JSON.stringify(fixturesUrl)};
    import { until } from ${url('../../until.mjs')};
    const glb = await MODELS.cloth();
    const pool = await createPool({ size: 1, cacheDirectory: null });
    const draw = () => pool.render(glb, { size: { width: 16, height: 16 } }).then(() => 'drawn', ({ code }) => code);
    const said = [await draw()];
    const files = [];
    const fill = () => { try { for (;;) files.push(openSync('/dev/null')); } catch ({ code }) { return code; } };
    fill();
    const [{ pid }] = pool.workers;
    process.kill(pid, 'SIGKILL');
    await until(() => { said[1] = fill(); return !pool.workers.some((worker) => worker.pid === pid); });
    fill();
    said.push(await draw());
    for (const file of files) closeSync(file);
    await until(async () => (await draw()) === 'drawn');
    await pool.close();
    console.log(JSON.stringify(said));`;
  const argv = ['-c', 'ulimit -n 200; exec "$0" --input-type=module -e "$1"', process.execPath, program];
  const { stdout } = await promisify(execFile)('bash', argv);
  assert.deepEqual(JSON.parse(stdout), ['drawn', 'EMFILE', 'X_WORKERS']);
});
