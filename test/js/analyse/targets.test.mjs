import assert from 'node:assert/strict';
import { test } from 'node:test';
import { numbered } from '../../../js/analyse/index.mjs';

test('names that occur more than once have numbers, and no number makes another name', () => {
  assert.deepEqual(numbered(['shirt', 'skirt']), ['shirt', 'skirt']);
  assert.deepEqual(numbered(['shirt', 'skirt', 'shirt']), ['shirt 1', 'skirt', 'shirt 3']);
  assert.deepEqual(numbered(['shirt', 'shirt', 'shirt 2']), ['shirt 1', 'shirt 3', 'shirt 2']);
});
