import '../api/support/real.mjs';
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { readdirSync } from 'node:fs';
import { FolderStore } from '../../../js/queue/folder_store.mjs';
import { judgeChaos, oneOf } from '../../chaos/chaos.mjs';
import { load } from '../../chaos/early_word_hooks.mjs';
import { smallDisk } from '../../chaos/full_disk.mjs';
import { inspect } from '../../../js/index.mjs';
import { MODELS } from '../../fixtures/index.mjs';

// What `npm run chaos` judges by, with planted facts.

const RIGHT = { jobs: 10, done: 10, lost: 0, wrong: 0, doubled: 0, stuck: 0, failed: {}, completed: 10 };

test('nothing lost, doubled or cut is no fault; each planted one is told', () => {
  assert.deepEqual(judgeChaos(RIGHT), []);
  for (const [planted, told] of [
    [{ lost: 1, done: 9 }, ['1 accepted jobs were lost', '1 jobs have no result']],
    [{ wrong: 2, done: 8 }, ['2 results were not the right bytes', '2 jobs have no result']],
    [{ doubled: 1 }, ['1 jobs were completed twice']],
    [{ stuck: 1, done: 9 }, ['1 jobs were not over 90 s after the last end', '1 jobs have no result']],
    [{ failed: { X_QUARANTINE: 3 }, done: 7 }, ['3 jobs failed with X_QUARANTINE', '3 jobs have no result']],
    [{ completed: 9 }, ['1 results are of jobs that were never completed']],
  ]) {
    assert.deepEqual(judgeChaos({ ...RIGHT, ...planted }), told);
  }
});

test('each job has a model of its own, which is drawn as the others are', async () => {
  const glb = Buffer.from(await MODELS.cloth());
  const [one, two] = [oneOf(glb, 1), oneOf(glb, 2)];
  assert.ok(!one.equals(two));
  assert.equal((await inspect(one)).triangles, (await inspect(glb)).triangles);
});

test('the fault that --planted loads is one of the code as it is now', async () => {
  const url = new URL('../../../js/queue/stored.mjs', import.meta.url).href;
  assert.match(load(url, {}, assert.fail).source, /setTimeout\(\(\) => putAll/);
  assert.equal(
    load('file:///another.mjs', {}, (other) => other),
    'file:///another.mjs',
  );
});

test('bytes of a job on a full disk: X_QUEUE, to be tried again, and nothing half written', { skip: process.getuid() !== 0 && 'not root' }, async (t) => {
  const disk = smallDisk(2 ** 20);
  t.after(() => disk.remove());
  const store = await FolderStore.open(disk.folder);
  const bytes = Buffer.alloc(100_000, 7);
  disk.fill();
  const error = await store.put('a', bytes, 1000).catch((thrown) => thrown);
  assert.deepEqual([error.code, error.message, error.retryable, error.http], ['X_QUEUE', 'a file of the queue cannot be written (ENOSPC)', true, 503]);
  disk.free();
  assert.deepEqual(readdirSync(disk.folder), []);
  await store.put('a', bytes, 1000);
  assert.ok((await store.get('a')).equals(bytes));
});
