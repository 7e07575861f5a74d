import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';

// What npm test runs JavaScript's tests with: the order that is given, the status of the worst file, and the tests that are skipped.

const PROGRAM = fileURLToPath(new URL('../../../js/setup/run_tests.mjs', import.meta.url));
const folder = mkdtempSync(path.join(tmpdir(), 'telar-run-tests-'));
after(() => rmSync(folder, { recursive: true }));

const FILES = {
  'b.test.mjs': "test('of b', () => {});\ntest('left out', { skip: 'no GPU' }, () => {});",
  'a.test.mjs': "test('of a', () => {});\ntest('to do', { todo: true }, () => { throw new Error('later'); });",
  'wrong.test.mjs': "test('of wrong', () => { throw new Error('planted'); });",
  'broken.test.mjs': "throw new Error('planted');",
};
for (const [name, text] of Object.entries(FILES)) writeFileSync(path.join(folder, name), `import { test } from 'node:test';\n${text}\n`);

function ran(names) {
  const log = path.join(folder, 'skipped.log');
  const { NODE_TEST_CONTEXT, ...env } = process.env;
  const wanted = { files: names.map((name) => path.join(folder, name)), concurrency: 1, timeout: 600_000, log };
  const { status, stdout } = spawnSync(process.execPath, [PROGRAM, JSON.stringify(wanted)], { encoding: 'utf8', env });
  return { status, order: [...stdout.matchAll(/^. (of \S+)/gm)].map(([, name]) => name), skipped: readFileSync(log, 'utf8') };
}

test('files run in the order that is given, and those that are skipped are told', () => {
  assert.deepEqual(ran(['b.test.mjs', 'a.test.mjs']), { status: 0, order: ['of b', 'of a'], skipped: `${folder}/b.test.mjs: left out (no GPU)\n` });
  assert.deepEqual(ran(['a.test.mjs', 'b.test.mjs']).order, ['of a', 'of b']);
});

for (const name of ['wrong.test.mjs', 'broken.test.mjs'])
  test(`planted: ${name} among others is not passed`, () => {
    assert.equal(ran([name, 'a.test.mjs']).status, 1);
  });
