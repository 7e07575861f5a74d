import assert from 'node:assert/strict';
import { test } from 'node:test';
import { resolveShot } from '../../../js/shot/index.mjs';
import { BASES, SLOTS, resolveTerms } from '../../../js/shot/shading_terms.mjs';

const camera = { position: [0, 0, 3], target: [0, 0, 0], near: 1, far: 5 };
const resolved = (shading) => resolveShot({ camera, shading }).shading;

test('a principled shading resolves to its base with every slot written out', () => {
  for (const [column, base] of BASES.entries()) {
    assert.deepEqual(resolved(base), { base, ...Object.fromEntries(Object.entries(SLOTS).map(([slot, terms]) => [slot, terms[column]])) });
    assert.deepEqual(resolved({ base }), resolved(base));
    assert.deepEqual(resolved(resolved(base)), resolved(base));
  }
});

test('each slot is swapped alone, by name', () => {
  for (const base of BASES) {
    for (const [slot, terms] of Object.entries(SLOTS)) {
      for (const term of terms) {
        const swapped = resolved({ base, [slot]: term });
        assert.deepEqual(swapped, { ...resolveTerms(base), [slot]: term });
        assert.deepEqual(resolved(swapped), swapped);
      }
    }
  }
});

test('the two columns differ in every slot, and no slot names a term twice', () => {
  for (const terms of Object.values(SLOTS)) assert.equal(new Set(terms).size, terms.length);
});
