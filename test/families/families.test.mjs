// What groups releases and explains their borders, against pictures and sources that are known without npm.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { CASES } from './cases.mjs';
import { chunk, editedFiles } from './edits.mjs';
import { familiesOf, rangeOf } from './families.mjs';
import { PAGE } from './places.mjs';
import { compareReleases } from './releases.mjs';
import { SLOT_TERMS } from './slot_terms.mjs';
import { BORDERS } from './slots.mjs';

const THREE = fileURLToPath(new URL('../../node_modules/three/', import.meta.url));
const SETUP = chunk('lights_physical_fragment');

/** Every case with the same picture, but those of `changes`. */
const drawn = (changes = {}) => Object.fromEntries(CASES.map(({ name }) => [name, changes[name] ?? { image: 'a', mask: 'a' }]));

test('cases have names of their own and cover what a shot reaches', () => {
  const names = CASES.map(({ name }) => name);
  assert.equal(new Set(names).size, names.length);
  for (const part of [
    'light-',
    'rect',
    'env-',
    'background-',
    'sheen-',
    'clearcoat-',
    'iridescence-',
    'anisotropy-',
    'specular-',
    'ior-',
    'transmission',
    'shadow-',
    'tone-',
    'topologies',
    'unlit',
    'vertex-colors',
    'alpha-',
  ]) {
    assert.ok(
      names.some((name) => name.startsWith(part)),
      part,
    );
  }
});

test('releases are one family where every case is the same, and until the first that is not', () => {
  const other = { 'env-studio': { image: 'b', mask: 'a' } };
  const absent = { 'tone-agx': { absent: 'no such tone mapping' } };
  const families = familiesOf(
    new Map([
      ['0.150.0', drawn(absent)],
      ['0.150.1', drawn(absent)],
      ['0.151.0', drawn()],
      ['0.152.0', drawn(other)],
      ['0.153.0', drawn(other)],
      ['0.154.0', drawn()],
    ]),
  );
  assert.deepEqual(families.map(rangeOf), ['0.150.0 to 0.150.1', '0.151.0', '0.152.0 to 0.153.0', '0.154.0']);
});

test('releases are ordered by number', () => {
  assert.deepEqual(['0.181.10', '0.181.9', '0.99.0', '0.180.0'].sort(compareReleases), ['0.99.0', '0.180.0', '0.181.9', '0.181.10']);
});

test('an edit changes what it names, and one that names nothing is told', () => {
  const place = () => THREE;
  const edit = (before, after) => editedFiles('0.187.0', [{ file: SETUP, replace: [[before, after]] }], place).get(SETUP);
  assert.match(edit('max( roughnessFactor, 0.045 )', 'max( roughnessFactor, 0.0525 )'), /max\( roughnessFactor, 0\.0525 \)/);
  assert.throws(() => edit('max( roughnessFactor, 0.046 )', ''), /0\.187\.0, src\/.*lights_physical_fragment.*there is no "max\( roughnessFactor, 0\.046 \)"/);
  assert.throws(() => edit({ from: 'PhysicalMaterial material;', to: 'nowhere' }, ''), /nothing from "PhysicalMaterial material;" to "nowhere"/);
});

test('borders follow each other, name slots that have terms on both sides, and cases that are there', () => {
  const names = new Set(CASES.map(({ name }) => name));
  for (const [i, { older, newer, slots }] of BORDERS.entries()) {
    assert.ok(compareReleases(older, newer) < 0, older);
    if (i > 0) assert.ok(compareReleases(BORDERS[i - 1].older, older) < 0, older);
    for (const { slot, cases, edits } of slots) {
      const terms = SLOT_TERMS.find((row) => row.slot === slot)?.terms;
      assert.ok(
        terms?.some(({ to }) => to === older),
        `${slot} has no term to ${older}`,
      );
      assert.ok(edits.length > 0 && cases.length > 0, slot);
      for (const name of cases) assert.ok(names.has(name), `${slot}: ${name}`);
    }
  }
});

test('the terms of a slot follow each other without a gap', () => {
  for (const { slot, terms } of SLOT_TERMS) {
    for (const [i, { from, to, what }] of terms.entries()) {
      assert.ok(what.length > 0, slot);
      if (i > 0) assert.ok(compareReleases(terms[i - 1].to, from) < 0, `${slot} from ${from}`);
      if (from && to) assert.ok(compareReleases(from, to) <= 0, `${slot} from ${from}`);
      assert.equal(to === undefined, i === terms.length - 1, `${slot}: the last term alone goes on`);
    }
  }
});

test('the page has every slot, case and border of today', () => {
  const page = readFileSync(PAGE, 'utf8');
  for (const { slot } of SLOT_TERMS) assert.ok(page.includes(`| **${slot}** |`), `${slot}: run npm run families`);
  for (const { name } of CASES) assert.ok(page.includes(`\n| ${name} |`), `${name}: run npm run families`);
  for (const { older, newer, slots } of BORDERS) {
    assert.ok(page.includes(`| ${older} | ${newer} | ${slots.map(({ slot }) => slot).join(', ')} | nothing:`), `${older} to ${newer}: run npm run families`);
  }
});
