import assert from 'node:assert/strict';
import { test } from 'node:test';
import { lightsOf, numbered } from '../../../js/analyse/index.mjs';

test('names that occur more than once have numbers, and no number makes another name', () => {
  assert.deepEqual(numbered(['shirt', 'skirt']), ['shirt', 'skirt']);
  assert.deepEqual(numbered(['shirt', 'skirt', 'shirt']), ['shirt 1', 'skirt', 'shirt 3']);
  assert.deepEqual(numbered(['shirt', 'shirt', 'shirt 2']), ['shirt 1', 'shirt 3', 'shirt 2']);
});

test('environments of one name are told apart, and draw their own files', () => {
  assert.deepEqual(lightsOf(['a/church.hdr', 'studio', 'b/church.hdr']), [
    { name: 'church.hdr 1', shot: { environment: 'a/church.hdr' } },
    { name: 'studio', shot: { environment: 'studio' } },
    { name: 'church.hdr 3', shot: { environment: 'b/church.hdr' } },
  ]);
});
