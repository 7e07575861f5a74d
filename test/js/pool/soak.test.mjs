import assert from 'node:assert/strict';
import { test } from 'node:test';
import { judgeSoak, soak } from '../../soak/soak.mjs';
import '../api/support/real.mjs';

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
