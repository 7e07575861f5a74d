import assert from 'node:assert/strict';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { givenUpIn, LEFT_OUT, reportsIn, sanitizedFiles } from '../../../js/setup/sanitize.mjs';

// What `npm run sanitize` runs, and what it counts as a fault.

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
const folder = mkdtempSync(path.join(tmpdir(), 'telar-sanitize-'));
after(() => rmSync(folder, { recursive: true }));

test('tests of each way to the addon are run; each that is left out is there, with its reason', () => {
  const files = sanitizedFiles();
  for (const part of [
    'robust/hostile',
    'robust/hostile_ways',
    'js/api/real',
    'js/pool/life',
    'js/pool/isolation',
    'js/cli/e2e',
    'js/server/hostile',
    'js/queue/worker',
  ])
    assert.ok(files.includes(`test/${part}.test.mjs`), part);
  assert.equal(new Set(files).size, files.length);
  for (const [file, reason] of Object.entries(LEFT_OUT)) {
    assert.ok(existsSync(path.join(ROOT, file)), file);
    assert.ok(reason.length > 20, file);
    assert.ok(!files.includes(file), file);
  }
});

test('planted: what a sanitizer wrote of any process is a report', () => {
  assert.deepEqual(reportsIn(path.join(folder, 'none')), []);
  assert.deepEqual(reportsIn(folder), []);
  writeFileSync(path.join(folder, 'report.42'), 'heap-use-after-free');
  assert.deepEqual(reportsIn(folder), ['heap-use-after-free']);
  const gaveUp = '==43==LeakSanitizer has encountered a fatal error.';
  writeFileSync(path.join(folder, 'report.43'), gaveUp);
  assert.deepEqual(reportsIn(folder), ['heap-use-after-free'], 'a search for leaks that gave up is none');
  assert.equal(givenUpIn(folder), 1);
  writeFileSync(path.join(folder, 'report.43'), `==43==ERROR: LeakSanitizer: detected memory leaks\n${gaveUp}`);
  assert.equal(reportsIn(folder).length, 2, 'but not where it found something first');
  assert.equal(givenUpIn(folder), 0);
});

test('each leak that is passed over has its reason before it', () => {
  const lines = readFileSync(path.join(ROOT, 'test/sanitize/leaks.txt'), 'utf8').trimEnd().split('\n');
  lines.forEach((line, i) => assert.ok(line.startsWith('#') || (/^leak:\S+$/.test(line) && lines[i - 1].startsWith('#')), line));
});
