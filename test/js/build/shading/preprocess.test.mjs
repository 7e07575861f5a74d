import assert from 'node:assert/strict';
import { test } from 'node:test';
import { conditionNames, included, withoutComments } from '../../../../js/build/shading/preprocess.mjs';

const lines = (...texts) => texts.join('\n');

test('a file is included where it is named first, as renderer/shader has it', () => {
  const files = { a: '#include "b"\nA', b: 'B' };
  assert.equal(
    included(lines('#include "a"', '#include "b"', '#include <three>'), (name) => files[name]),
    lines('B', 'A', '', '#include <three>'),
  );
});

test('comments go, code stays', () => {
  assert.equal(withoutComments(lines('// one', 'float a = 1.0;  // two', '', '  b = a / 2.0;')), lines('float a = 1.0;', '  b = a / 2.0;'));
});

test('names of conditions', () => {
  assert.deepEqual([...conditionNames(lines('#if A && defined(B)', '#elif C > 1', 'D', '#endif'))], ['A', 'C']);
});

test('names of a condition with a name of its own', () => {
  assert.deepEqual(
    [...conditionNames(lines('#define FRAME (A || B)', '#define MASK (C)', '#define sum(a, b) (a || b)', '#ifdef X', 'D', '#endif'))],
    ['A', 'B'],
  );
});
