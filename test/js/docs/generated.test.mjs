import assert from 'node:assert/strict';
import { test } from 'node:test';
import { generatedFiles, staleFiles } from '../../../js/build/docs/generate.mjs';
import { typeText } from '../../../js/build/docs/types.mjs';

test('committed types, schema and tables are those that the sources give', () => {
  assert.deepEqual(staleFiles(), [], 'run node js/build/docs/generate.mjs');
  assert.ok(Object.keys(generatedFiles()).length > 25);
});

test('the JSON Schema has no value that JSON cannot hold', () => {
  const text = generatedFiles()['js/shot/schema.json'];
  assert.doesNotMatch(text, /tsType|Uint8Array/);
  assert.match(text, /"additionalProperties": false/);
});

test('schema nodes become types', () => {
  assert.equal(typeText({ type: 'array', items: { enum: ['a', 'b'] } }), "Array<'a' | 'b'>");
  assert.equal(typeText({ type: 'array', items: { type: 'integer' } }), 'number[]');
  assert.equal(typeText({ prefixItems: [{ type: 'number' }, { type: 'string' }] }), '[number, string]');
  assert.throws(() => typeText({ type: 'bytes' }), /no type for/);
});
