import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { test } from 'node:test';
import { KINDS, TABLE, worstExit } from '../../../js/error/table.mjs';

const ROOT = fileURLToPath(new URL('../../../', import.meta.url));
const CODE = /["'`]([ELXW]_[A-Z0-9_]+)["'`]/g;

/** Code strings of the sources beneath a folder: [{code, file}]. */
function codesIn(folder, suffixes) {
  const path = join(ROOT, folder);
  return readdirSync(path, { recursive: true })
    .filter((name) => suffixes.some((suffix) => name.endsWith(suffix)) && !name.startsWith('dist'))
    .flatMap((name) => [...readFileSync(join(path, name), 'utf8').matchAll(CODE)].map(([, code]) => ({ code, file: relative(ROOT, join(path, name)) })));
}

const codes = [...codesIn('renderer', ['.cpp', '.h']), ...codesIn('addon', ['.cpp', '.h']), ...codesIn('js', ['.mjs', '.cjs'])];

test('each row is a code that something raises', () => {
  const raised = new Set(codes.map(({ code }) => code));
  assert.deepEqual(
    Object.keys(TABLE).filter((code) => !raised.has(code)),
    [],
  );
});

test('each code in the sources has a row', () => {
  assert.ok(
    codes.some(({ code }) => code === 'X_CANCELLED'),
    'the search finds the code that cancel.h throws',
  );
  const missing = codes.filter(({ code }) => !Object.hasOwn(TABLE, code));
  assert.deepEqual(missing, [], 'add these to js/error/table.mjs');
});

test('each limit of limits.h has a row', () => {
  const header = readFileSync(join(ROOT, 'renderer/include/telar/limits.h'), 'utf8');
  const names = [...header.matchAll(/\/\/\/< (L_[A-Z_]+)/g)].map(([, name]) => name);
  assert.ok(names.length > 20);
  assert.deepEqual(
    names.filter((name) => TABLE[name]?.kind !== 'limit'),
    [],
  );
});

test('prefixes say the class', () => {
  for (const [code, row] of Object.entries(TABLE)) {
    assert.match(code, /^[ELXW]_[A-Z0-9_]+$/);
    assert.equal(code.startsWith('W_'), row.kind === 'warning', code);
    assert.equal(code.startsWith('L_'), row.kind === 'limit', code);
    assert.equal(code.startsWith('E_'), ['usage', 'input', 'denied', 'unsupported'].includes(row.kind), code);
    assert.ok(row.meaning.length > 5 && row.cure.length > 5, code);
    assert.ok(Number.isInteger(row.http) && row.http >= 200 && row.http < 600, code);
  }
});

test('exit codes are the documented ones', () => {
  const exits = Object.fromEntries(Object.entries(KINDS).map(([kind, { exit }]) => [kind, exit]));
  assert.deepEqual(exits, {
    usage: 2,
    input: 3,
    denied: 3,
    unsupported: 3,
    limit: 4,
    time: 5,
    memory: 5,
    cancelled: 5,
    busy: 5,
    machine: 6,
    crash: 7,
    internal: 7,
    warning: 0,
  });
});

test('the worst exit of many is the highest', () => {
  assert.equal(worstExit([]), 0);
  assert.equal(worstExit([0, 3, 0]), 3);
  assert.equal(worstExit([3, 6, 4]), 6);
});
