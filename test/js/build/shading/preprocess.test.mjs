import assert from 'node:assert/strict';
import { test } from 'node:test';
import { reduced } from '../../../../js/build/shading/expression.mjs';
import { conditionNames, decided, included, withoutComments } from '../../../../js/build/shading/preprocess.mjs';

const lines = (...texts) => texts.join('\n');

test('a file is included where it is named first, as renderer/shader has it', () => {
  const files = { a: '#include "b"\nA', b: 'B' };
  assert.equal(included(lines('#include "a"', '#include "b"', '#include <three>'), (name) => files[name]), lines('B', 'A', '', '#include <three>'));
});

test('comments go, code stays', () => {
  assert.equal(withoutComments(lines('// one', 'float a = 1.0;  // two', '', '  b = a / 2.0;')), lines('float a = 1.0;', '  b = a / 2.0;'));
});

test('what is known is decided, with all its branches', () => {
  const text = lines('#if A', 'a', '#elif B', 'b', '#else', 'c', '#endif', 'd');
  assert.equal(decided(text, { A: 1 }), lines('a', 'd'));
  assert.equal(decided(text, { A: 0, B: 1 }), lines('b', 'd'));
  assert.equal(decided(text, { A: 0, B: 0 }), lines('c', 'd'));
  assert.equal(decided(text, { A: 0 }), lines('#if B', 'b', '#else', 'c', '#endif', 'd'));
  assert.equal(decided(text, { B: 1 }), lines('#if A', 'a', '#else', 'b', '#endif', 'd'));
  assert.equal(decided(text, { B: 0 }), lines('#if A', 'a', '#else', 'c', '#endif', 'd'));
});

test('conditions within branches, counts, and conditions of which half is known', () => {
  assert.equal(decided(lines('#if A', '#if B', 'b', '#endif', 'a', '#endif'), { B: 0 }), lines('#if A', 'a', '#endif'));
  assert.equal(decided(lines('#if N + M > 0', 'n', '#endif'), { N: 0, M: 2 }), 'n');
  assert.equal(decided(lines('#if A && B', 'ab', '#endif'), { A: 0 }), '');
  assert.equal(decided(lines('#if A || B', 'ab', '#endif'), { B: 1 }), 'ab');
  assert.equal(decided(lines('#if A && B || C', 'abc', '#endif'), { A: 0 }), lines('#if C', 'abc', '#endif'));
  assert.equal(decided(lines('#ifdef X', 'x', '#endif'), {}), lines('#if defined(X)', 'x', '#endif'));
});

test('what does not fit together is an error', () => {
  assert.throws(() => decided(lines('#if A', 'a'), {}), /without #endif/);
  assert.throws(() => decided(lines('a', '#endif'), {}), /#endif without #if/);
  assert.throws(() => decided(lines('#if 1 ? 2', '#endif'), {}), /not an expression of integers/);
});

test('names of conditions', () => {
  assert.deepEqual([...conditionNames(lines('#if A && defined(B)', '#elif C > 1', 'D', '#endif'))], ['A', 'C']);
});

test('expressions keep their meaning when part of them is known', () => {
  const left = (text, known = {}) => reduced(text, known);
  assert.equal(left('A || (B && TERM != 2)', { B: 0 }), 'A');
  assert.equal(left('A || (B && TERM != 2)', { B: 1 }), 'A || TERM != 2');
  assert.equal(left('A && (B || C)'), 'A && (B || C)');
  assert.equal(left('!(A && B) && !C', { C: 0 }), '!(A && B)');
  assert.equal(left('A - (B - C) > 0', { A: 1 }), '1 - (B - C) > 0');
  assert.equal(left('defined(X) && Y', { Y: 1 }), 'defined(X)');
  assert.equal(left('N + M * 2 >= 4', { N: 2, M: 1 }), 1);
  assert.equal(left('A == 1 || A == 2', { A: 3 }), 0);
  for (const text of ['(A', 'A &&', 'A B', '&& A']) assert.throws(() => reduced(text, {}), /#if/);
});

test('a condition with a name of its own', () => {
  assert.equal(decided(lines('#define FRAME (A || B)', '#if FRAME', 'f', '#endif'), { B: 0 }), lines('#define FRAME (A)', '#if FRAME', 'f', '#endif'));
  assert.equal(decided('#define CHOSEN(slot, number) number', { number: 1 }), '#define CHOSEN(slot, number) number');
});
