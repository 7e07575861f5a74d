import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

const read = (file) => readFileSync(new URL(`../../../${file}`, import.meta.url), 'utf8');

test('formats.md lists the extensions that the loader knows', () => {
  const [, list] = /SUPPORTED\[\] = \{([^}]*)\}/.exec(read('renderer/asset/document/extensions.cpp'));
  const known = [...list.matchAll(/"(\w+)"/g)].map(([, name]) => name);
  const told = [...read('js/docs/formats.md').matchAll(/^\| `(\w+)` \|/gm)].map(([, name]) => name);
  assert.ok(known.length > 15);
  assert.deepEqual(told, known.toSorted());
});
