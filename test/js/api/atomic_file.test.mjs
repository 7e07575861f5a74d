import assert from 'node:assert/strict';
import { execFile, execFileSync } from 'node:child_process';
import { existsSync, lstatSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, symlinkSync, utimesSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, beforeEach, test } from 'node:test';
import { promisify } from 'node:util';
import { sweepStale, writeFileAtomically } from '../../../js/api/atomic_file.mjs';

const root = mkdtempSync(path.join(tmpdir(), 'telar-atomic-'));
after(() => rmSync(root, { recursive: true }));
let folder;
let count = 0;
beforeEach(() => {
  folder = path.join(root, String(++count));
  mkdirSync(folder);
});
const at = (name) => path.join(folder, name);

test('writes and replaces, making the folder', async () => {
  await writeFileAtomically(at('new/a.bin'), Buffer.from('one'));
  await writeFileAtomically(at('new/a.bin'), Buffer.from('two'));
  assert.equal(readFileSync(at('new/a.bin'), 'utf8'), 'two');
  assert.deepEqual(readdirSync(at('new')), ['a.bin']);
});

test('a folder above that takes no folder is X_OUTPUT, not a wait without end', async () => {
  await assert.rejects(writeFileAtomically('/proc/telar/deep/a.bin', Buffer.from('x')), { code: 'X_OUTPUT' });
});

test('a failure tells its cure', async () => {
  writeFileSync(at('file'), '');
  mkdirSync(at('folder'));
  writeFileSync(at('folder/x'), '');
  const cures = [
    [at('file/a.png'), /\(E(EXIST|NOTDIR)\); a file stands where its folder is to be: name another folder, or move that file away$/],
    [at('folder'), /; it is a folder: name a file in it$/],
    ['/proc/telar/a.png', /\(ENOENT\); its folder does not exist and cannot be made: name another one$/],
    [at(`${'x'.repeat(300)}.png`), /\(ENAMETOOLONG\); the name is too long: shorten it$/],
  ];
  for (const [file, message] of cures) {
    await assert.rejects(writeFileAtomically(file, Buffer.from('x')), (error) => {
      assert.equal(error.code, 'X_OUTPUT');
      assert.match(error.message, message);
      return true;
    });
  }
});

test('folders two levels deep are made by several writers at once', async () => {
  await Promise.all(['a', 'b', 'c'].map((name) => writeFileAtomically(at(`new/deep/${name}`), Buffer.from(name))));
  assert.deepEqual(readdirSync(at('new/deep')), ['a', 'b', 'c']);
});

test('a link keeps pointing at the file that is written', async () => {
  writeFileSync(at('real'), 'old');
  symlinkSync('real', at('link'));
  await writeFileAtomically(at('link'), Buffer.from('new'));
  assert.ok(lstatSync(at('link')).isSymbolicLink());
  assert.equal(readFileSync(at('real'), 'utf8'), 'new');
});

test('a device or a pipe is written to, not replaced', async () => {
  execFileSync('mkfifo', [at('pipe')]);
  const [read] = await Promise.all([promisify(execFile)('cat', [at('pipe')]), writeFileAtomically(at('pipe'), Buffer.from('through'))]);
  assert.equal(read.stdout, 'through');
  assert.ok(lstatSync(at('pipe')).isFIFO());
});

test('a failed or aborted write keeps the old file and leaves nothing else', async () => {
  writeFileSync(at('a'), 'old');
  await assert.rejects(writeFileAtomically(at('a'), Buffer.from('new'), AbortSignal.abort(new Error('stop'))), /^Error: stop$/);
  mkdirSync(at('is-a-folder'));
  writeFileSync(at('is-a-folder/x'), '');
  await assert.rejects(writeFileAtomically(at('is-a-folder'), Buffer.from('new')), { code: 'X_OUTPUT' });
  assert.equal(readFileSync(at('a'), 'utf8'), 'old');
  assert.deepEqual(readdirSync(folder).sort(), ['a', 'is-a-folder']);
});

test('a full disk is X_OUTPUT', async () => {
  await assert.rejects(writeFileAtomically('/dev/full', Buffer.from('x')), /"\/dev\/full" cannot be written \(ENOSPC\); the disk is full: free some space$/);
});

test('the sweep takes old leftovers of dead processes, and of one that had the number of this one', async () => {
  const dead = execFileSync(process.execPath, ['-p', 'process.pid'], { encoding: 'utf8' }).trim();
  const leftover = (pid, hex) => `.a.png.telar-${pid}-${hex}.tmp`;
  const old = new Date(Date.now() - 7_200_000);
  const make = (name, time) => {
    writeFileSync(at(name), '');
    if (time) utimesSync(at(name), time, time);
    return at(name);
  };
  const gone = [make(leftover(dead, '0123456789ab'), old), make(leftover(process.pid, '0123456789ab'), old)];
  // One that cannot be removed, as another user's in /tmp, is left.
  const stuck = at(leftover(dead, '3123456789ab'));
  mkdirSync(stuck);
  utimesSync(stuck, old, old);
  const kept = [
    stuck,
    make(leftover(dead, '1123456789ab')),
    make(leftover(process.pid, '1123456789ab')),
    make(leftover(process.ppid, '2123456789ab'), old),
    make('.a.png.tmp', old),
    make('a.png', old),
  ];
  await sweepStale(folder);
  assert.deepEqual(gone.filter(existsSync), []);
  assert.deepEqual(
    kept.filter((file) => !existsSync(file)),
    [],
  );
  await sweepStale(at('absent'));
});
