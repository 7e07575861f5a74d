import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { resolveShot } from '../../../js/shot/index.mjs';
import { families, familyOf, REVISION, REVISION_MIN, termsOfRevision, THREE_SLOTS } from '../../../js/shot/three_terms.mjs';
import { TONE_MAPPINGS } from '../../../js/shot/table/tone_mappings.mjs';

const camera = { position: [0, 0, 3], target: [0, 0, 0], near: 1, far: 5 };
const resolved = (shading, rest = { toneMapping: 'aces' }) => resolveShot({ camera, shading, ...rest }).shading;
const newest = Object.fromEntries(Object.entries(THREE_SLOTS).map(([slot, terms]) => [slot, Object.keys(terms)[0]]));

test('three alone is the newest release', () => {
  assert.equal(resolved({ base: 'three' }), 'three');
  assert.equal(resolved({ base: 'three', revision: REVISION }), 'three');
  assert.deepEqual(termsOfRevision(REVISION), newest);
});

test('each release resolves to every slot of its family, and to itself again', () => {
  for (let revision = REVISION_MIN; revision < REVISION; revision++) {
    const shading = resolved({ base: 'three', revision });
    assert.deepEqual(shading, { base: 'three', revision, ...termsOfRevision(revision) });
    assert.deepEqual(resolved(shading), shading);
    assert.deepEqual(termsOfRevision(revision), termsOfRevision(familyOf(revision).from));
  }
});

test('a release beyond the table is drawn as the nearest in it', () => {
  assert.deepEqual(resolved({ base: 'three', revision: 120 }), { base: 'three', revision: 120, ...termsOfRevision(REVISION_MIN) });
  assert.deepEqual(resolved({ base: 'three', revision: 188 }), { base: 'three', revision: 188, ...newest });
});

test('a slot is swapped alone, by name', () => {
  for (const [slot, terms] of Object.entries(THREE_SLOTS)) {
    for (const term of Object.keys(terms)) {
      assert.deepEqual(resolved({ base: 'three', revision: 180, [slot]: term }), { base: 'three', revision: 180, ...termsOfRevision(180), [slot]: term });
    }
  }
  assert.throws(() => resolved({ base: 'three', dfg: 'lazarov' }), { code: 'E_SHOT' });
});

test('a release is refused a tone mapping that it does not have', () => {
  assert.throws(() => resolved({ base: 'three', revision: 161 }, {}), {
    code: 'E_SHOT',
    message: 'shot.toneMapping: expected a tone mapping that three.js 0.161 has (0.162 brought this one), got "neutral"',
  });
  assert.equal(resolved({ base: 'three', revision: 162 }, {}).revision, 162);
  assert.throws(() => resolved({ base: 'three', revision: 159 }, { toneMapping: 'agx' }), { code: 'E_SHOT' });
});

/** Borders of what no case of the page shows: sorting, the samples behind glass, intensity and packing of shadows, the frames of back sides. */
const UNMEASURED = new Set([152, 154, 166, 167, 185]);

test('the table has every border that was measured, and no other', () => {
  const page = readFileSync(new URL('../../../js/docs/families.md', import.meta.url), 'utf8');
  const rows = [...page.matchAll(/^\| 0\.(\d+)\.\d+(?: to 0\.(\d+)\.\d+)? \| \d+ \|[^|]*\|(?: \d+, at most (\d+))? /gm)];
  const measured = rows.map(([, from, to = from, change]) => ({ from: Number(from), to: Number(to), change: Number(change) }));
  assert.ok(measured.length > 10);
  const borders = families().map(({ from }) => from);
  for (const { to, change } of measured) {
    // A change of up to 2/255 is within the gate's bars, and may be left out of the table.
    const isKnown = borders.includes(to + 1) || Object.values(TONE_MAPPINGS).some(({ since }) => since === to + 1);
    if (change > 2 && to !== 181) assert.ok(isKnown, `0.${to} and 0.${to + 1} differ by ${change}`);
  }
  const starts = new Set(measured.map(({ from }) => from));
  for (const border of borders) assert.ok(starts.has(border) || UNMEASURED.has(border), `nothing was measured to change at 0.${border}`);
});
