import assert from 'node:assert/strict';
import { test } from 'node:test';
import { residentBytes } from '../../../js/pool/usage.mjs';
import { MODELS } from '../../fixtures/index.mjs';
import { judgeSoak, soak, withTexture } from '../../soak/soak.mjs';
import { open, SHOT } from './support.mjs';

// A short soak; `npm run soak` is the long one. What judges it is checked with planted leaks.

const MIB = 2 ** 20;

test('renders and hostile files in turns: each ends as before, no worker is lost, threads, descriptors and GL names stay as many', async () => {
  const result = await soak({ renders: 120, looks: 6 });
  assert.deepEqual(judgeSoak(result).faults, []);
  assert.ok(
    result.looks.every(({ processes: [, ...workers] }) => workers.every(({ glObjects }) => glObjects > 0)),
    'workers tell their GL names',
  );
  assert.ok(result.outcomes.picture > 60 && Object.keys(result.outcomes).length > 4, JSON.stringify(result.outcomes));
});

/** Looks at a parent and two workers, as `change` has them; a worker breathes by some MiB. */
const looksOf = (change = (facts) => facts) =>
  Array.from({ length: 20 }, (_, i) => ({
    renders: 500 * (i + 1),
    processes: [0, 1, 2].map((which) =>
      change({ bytes: (300 + ((i * 7) % 5)) * MIB, threads: 12, descriptors: 20, ...(which > 0 && { glObjects: 60 + (i % 3) }) }, which, i),
    ),
  }));
const FLAT = { changed: [], lost: 0 };
const faultsOf = (change, facts = {}) => judgeSoak({ ...FLAT, looks: looksOf(change), ...facts }).faults;

test('planted leaks are found, and what is no leak is not', () => {
  assert.deepEqual(faultsOf(), []);
  const isLast = (which) => which === 2;
  const leak = (facts, which, i) => ({ ...facts, bytes: facts.bytes + (isLast(which) ? i * 6 * MIB : 0) });
  assert.deepEqual(faultsOf(leak), ['worker 2 grew by 78 MiB in 6500 renders']);
  assert.deepEqual(
    faultsOf((facts, which, i) => ({ ...facts, descriptors: 20 + (which === 0 ? i : 0) })),
    ['the parent has 33 descriptors in place of 26'],
  );
  assert.deepEqual(
    faultsOf((facts, which, i) => ({ ...facts, threads: 12 + (isLast(which) && i > 14 ? 1 : 0) })),
    [],
  );
  assert.deepEqual(
    faultsOf((facts, which, i) => ({ ...facts, threads: 12 + (isLast(which) && i > 11 ? 1 : 0) })),
    ['worker 2 has 13 threads in place of 12'],
  );
  assert.deepEqual(
    faultsOf((facts, which, i) => ({ ...facts, ...(isLast(which) && { glObjects: 60 + 2 * i }) })),
    ['worker 2 has 86 glObjects in place of 72'],
  );
  const step = (facts, which, i) => ({ ...facts, bytes: facts.bytes + (isLast(which) && i > 10 ? 40 * MIB : 0) });
  assert.deepEqual(faultsOf(step), [], 'one large file, and flat again');
  assert.deepEqual(faultsOf(undefined, { lost: 1, changed: ['a 24'] }), ['a 24 did not end as it did before', '1 workers ended']);
});

/** Bytes that a worker has more after several large textures than after the first ones. @param {(pool: object, model: Buffer) => Promise<unknown>} use */
async function grownBy(use) {
  const pool = await open();
  const [small, large] = [await MODELS.cloth(), await withTexture()];
  const rounds = async (count) => {
    for (let i = 0; i < count; ++i) {
      await use(pool, large);
      await pool.render(small, SHOT);
    }
    return residentBytes(pool.workers[0].pid);
  };
  const before = await rounds(2);
  const grown = (await rounds(4)) - before;
  await pool.close();
  return grown;
}

test('what a worker keeps of large textures for its next jobs is bounded; planted: models that are held are not', async () => {
  const TEXTURE = 4096 ** 2 * 4;
  const grown = await grownBy((pool, model) => pool.render(model, SHOT));
  assert.ok(grown < TEXTURE / 2, `${grown} bytes`);
  const planted = await grownBy((pool, model) => pool.load(model));
  assert.ok(planted > TEXTURE, `${planted} bytes`);
});
