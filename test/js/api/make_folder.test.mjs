import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, test } from 'node:test';
import { makeFolder } from '../../../js/api/make_folder.mjs';

const FOLDER = mkdtempSync(path.join(tmpdir(), 'telar-folders-'));
after(() => rmSync(FOLDER, { recursive: true }));

test('a folder is made with those above it, and one that is there stays', () => {
  const folder = path.join(FOLDER, 'a/b/c');
  for (let time = 0; time < 2; time++) makeFolder(folder, 0o700);
  for (const made of ['a', 'a/b', 'a/b/c']) assert.equal(statSync(path.join(FOLDER, made)).mode & 0o777, 0o700);
});

test('where a file lies, and below one, the error is the system’s, and nothing is made', () => {
  const file = path.join(FOLDER, 'file');
  writeFileSync(file, '');
  assert.throws(() => makeFolder(file), { code: 'EEXIST' });
  assert.throws(() => makeFolder(path.join(file, 'a/b')), { code: 'ENOTDIR' });
  assert.throws(() => makeFolder(path.join(FOLDER, 'x'.repeat(300))), { code: 'ENAMETOOLONG' });
});

const LIMIT_MS = 30_000;

test('where a file system makes none, the call ends', { skip: existsSync('/proc/self') ? false : 'no /proc' }, () => {
  const url = new URL('../../../js/api/make_folder.mjs', import.meta.url).href;
  const text = `import { makeFolder } from '${url}'; try { makeFolder('/proc/none/a'); } catch ({ code }) { console.log(code); }`;
  const { stdout, error } = spawnSync(process.execPath, ['--input-type=module', '-e', text], { encoding: 'utf8', timeout: LIMIT_MS });
  assert.equal(error?.code, undefined, 'the process was ended: it would not end by itself');
  assert.equal(stdout, 'ENOENT\n');
});
