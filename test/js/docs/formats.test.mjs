import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { LAYERS } from '../../../js/material/table.mjs';

const read = (file) => readFileSync(new URL(`../../../${file}`, import.meta.url), 'utf8');

test('formats.md lists the extensions that the loader knows', () => {
  const [, list] = /SUPPORTED\[\] = \{([^}]*)\}/.exec(read('renderer/asset/document/extensions.cpp'));
  const layers = LAYERS.flatMap(({ extension, rows }) => [extension, ...rows.map((row) => row.extension ?? extension)]);
  const known = [...new Set([...[...list.matchAll(/^ *"(\w+)"/gm)].map(([, name]) => name), ...layers])];
  const told = [...read('js/docs/formats.md').matchAll(/^\| `(\w+)` \|/gm)].map(([, name]) => name);
  assert.ok(known.length > 15);
  assert.deepEqual(told, known.toSorted());
});
