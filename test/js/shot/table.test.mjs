import assert from 'node:assert/strict';
import { test } from 'node:test';
import { resolveShot } from '../../../js/shot/index.mjs';
import { resolvedShotSchema } from '../../../js/shot/resolved_schema.mjs';
import { SHOT } from '../../../js/shot/table/index.mjs';
import { copied, inOrder } from '../../../js/shot/table/resolved.mjs';
import { boolean, but, choice, number, object, union } from '../../../js/shot/table/rows.mjs';
import { tableFaults } from './table_faults.mjs';

test('each row of the shot says what it means, in which unit, and has a value of its own range', () => {
  assert.deepEqual(tableFaults(SHOT), []);
});

const metres = (rest) => number('Metres', { unit: 'metres', min: 0, ...rest });
const shot = (row) => but(SHOT, { shape: { ...SHOT.shape, planted: row } });

/** A fault in the table, and what is said of it. */
const PLANTED = [
  ['no doc', metres({ doc: '' }), 'has no doc'],
  ['no unit', metres({ unit: undefined }), 'has no unit'],
  ['a default below its range', metres({ default: -1 }), 'has a default that it refuses'],
  ['a default of another type', metres({ default: '1' }), 'has a default that it refuses'],
  ['a value otherwise above its range', metres({ max: 4, otherwise: 5 }), 'has a value otherwise that it refuses'],
  ['a range without a number in it', metres({ max: -1 }), 'has an empty range'],
  ['a range beyond the GPU', metres({ max: 1e31 }), "leaves the range of the GPU's floats"],
  ['a whole number below 0', metres({ integer: true, min: -1, max: 9 }), 'is no index that C++ reads'],
  ['a name twice', choice('Names', ['a', 'b', 'a']), 'names a value twice'],
  ['a default that is no name', choice('Names', ['a', 'b'], { default: 'c' }), 'has a default that it refuses'],
  ['a default, and none', boolean('Whether', { default: true, optional: true }), 'has a default and may be left out'],
];

test('a fault planted in the table is found, and only it', () => {
  for (const [name, row, fault] of PLANTED) {
    assert.deepEqual(tableFaults(shot(row)), [`shot.planted ${fault}`], name);
    assert.deepEqual(tableFaults(shot(object('Group', { inner: row }))), [`shot.planted.inner ${fault}`], name);
  }
  assert.deepEqual(tableFaults(shot(object('Group', { shadow: metres({ when: 'cast' }) }))), ['shot.planted.shadow is there when cast, which is no key']);
  assert.deepEqual(tableFaults(shot(union('One of two', [metres({ unit: undefined }), choice('', ['a'])], 'one of two'))), ['shot.planted.<0> has no unit']);
});

test('a resolved shot has the keys of the table in its order, and those alone', () => {
  const resolved = resolveShot({ camera: { position: [0, 0, 3], target: [0, 0, 0], near: 1, far: 5 } });
  assert.deepEqual(Object.keys(resolved), Object.keys(SHOT.shape));
  assert.equal(resolvedShotSchema.safeParse(resolved).error, undefined);
  for (const key of Object.keys(resolved)) {
    const { [key]: _, ...less } = resolved;
    assert.equal(resolvedShotSchema.safeParse(less).success, false, `without ${key}`);
  }
  assert.equal(resolvedShotSchema.safeParse({ ...resolved, more: 1 }).success, false);
  assert.equal(resolvedShotSchema.safeParse({ ...resolved, exposure: -1 }).success, false, 'ranges hold for resolved shots too');
});

test('values stand in the order of the table; what is left out is what the table knows', () => {
  const row = object('Group', { a: metres({ default: 1 }), b: metres({ otherwise: 2 }), c: metres({ optional: true }), d: metres({}) });
  assert.deepEqual(Object.entries(inOrder(row, { d: 4, a: undefined })), [
    ['a', 1],
    ['b', 2],
    ['d', 4],
  ]);
  assert.deepEqual(Object.entries(inOrder(row, { c: 0, b: null })), [
    ['a', 1],
    ['b', null],
    ['c', 0],
  ]);
});

test('a copy shares nothing but bytes', () => {
  const given = { list: [[1], { deep: [2] }], bytes: new Uint8Array([3]), none: null };
  const copy = copied(given);
  assert.deepEqual(copy, given);
  assert.ok(copy.list !== given.list && copy.list[1].deep !== given.list[1].deep && copy.bytes === given.bytes);
});
