import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, test } from 'node:test';
import { tidy } from '../../../js/setup/lint.mjs';
import { baseCommit, changedSince, gitIn, sourcesToTidy } from '../../../js/setup/tidied.mjs';

// What clang-tidy reads. It itself is not run here.

const folder = mkdtempSync(path.join(tmpdir(), 'telar-lint-'));
after(() => rmSync(folder, { recursive: true }));

const git = gitIn(folder);
const commit = (name) => {
  writeFileSync(path.join(folder, name), name);
  execFileSync('git', ['add', '.'], { cwd: folder });
  execFileSync('git', ['-c', 'user.name=a', '-c', 'user.email=a@b', 'commit', '-qm', name], { cwd: folder });
  return git('rev-parse', 'HEAD');
};

test('the commit to compare with: named, where the branch left, last clean, the one before, none', () => {
  assert.equal(baseCommit(git, {}), undefined, 'no repository');
  execFileSync('git', ['init', '-q', '-b', 'main'], { cwd: folder });
  const first = commit('one.cpp');
  assert.equal(baseCommit(git, {}), undefined, 'the first commit has none before it');
  const second = commit('two.cpp');
  const third = commit('three.cpp');
  assert.equal(baseCommit(git, {}), second);
  assert.equal(baseCommit(git, { clean: first }), first);
  assert.equal(baseCommit(git, { clean: '0'.repeat(40) }), second, 'one that is no longer there');
  assert.equal(baseCommit(git, { named: 'HEAD~2', clean: second }), first);
  assert.equal(baseCommit(git, { named: 'nowhere' }), undefined);
  git('checkout', '-qb', 'other');
  commit('four.cpp');
  commit('five.cpp');
  assert.equal(baseCommit(git, { clean: first }), third);
  assert.deepEqual(changedSince(git, third).filter(Boolean), ['five.cpp', 'four.cpp']);
});

test('without such a commit, or with one that is not there, it fails', async () => {
  const run = () => assert.fail('nothing to read');
  // Named by nobody: CI may name one in the environment.
  const [status, words] = await tidy(run, { git: () => undefined, named: '' });
  assert.equal(status, 1);
  assert.match(words, /^no commit to compare with: fetch the history/);
  assert.match((await tidy(run, { git: () => undefined, named: 'gone' }))[1], /^no commit gone to compare/);
  assert.deepEqual(await tidy(run, { named: 'none' }), [0, 'left out, as TELAR_LINT_BASE is none']);
});

const TEXTS = new Map([
  ['renderer/core/a.h', ''],
  ['renderer/core/a.cpp', '#include "core/a.h"\n'],
  ['renderer/include/telar/b.h', '#include "core/a.h"\n'],
  ...['c', 'd', 'e', 'f'].map((name) => [`renderer/pass/${name}.cpp`, '#include "telar/b.h"\n']),
  ['renderer/brdf/g.cpp', '#include "brdf/g.inl"\n'],
  ['renderer/brdf/g.inl', ''],
  ['renderer/frame/h.cpp', '#include "brdf/g.inl"\n'],
  ['addon/i.h', ''],
  ['addon/i.cpp', '#include "i.h"\n'],
]);

test('sources that changed, and for a header its own one and the nearest', () => {
  const read = (...changed) => sourcesToTidy(changed, TEXTS);
  assert.deepEqual(read('renderer/pass/c.cpp', 'js/a.mjs', 'test/cpp/a.cpp'), { sources: ['renderer/pass/c.cpp'], headers: 0, more: 0 });
  const three = ['renderer/core/a.cpp', 'renderer/pass/c.cpp', 'renderer/pass/d.cpp'];
  assert.deepEqual(read('renderer/core/a.h'), { sources: three, headers: 1, more: 2 });
  assert.deepEqual(read('addon/i.h').sources, ['addon/i.cpp']);
  assert.deepEqual(read('renderer/brdf/g.inl', 'renderer/brdf/g.cpp').sources, ['renderer/frame/h.cpp'], 'clang does not read brdf');
  assert.deepEqual(read('renderer/core/gone.h').sources, []);
});
