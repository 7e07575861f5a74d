// What groups releases and explains their borders, against pictures and sources that are known without npm.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { CASES } from './cases.mjs';
import { REVISION, REVISION_MIN, termsOfRevision, THREE_SLOTS } from '../../js/shot/three_terms.mjs';
import { chunk, editedFiles } from './edits.mjs';
import { familiesOf, LAST, rangeOf } from './families.mjs';
import { nameOfTerm, slotCells } from './page.mjs';
import { PAGE } from './places.mjs';
import { compareReleases, versionOf } from './releases.mjs';
import { SLOT_TERMS } from './slot_terms.mjs';
import { BORDERS } from './slots.mjs';
import { suspects, verdictOf } from './verdict.mjs';

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

test('a release is told against the one before it', () => {
  const families = familiesOf(
    new Map([
      ['0.185.1', drawn()],
      ['0.186.0', drawn({ ortho: { absent: 'nothing' }, 'tone-agx': { absent: 'nothing' } })],
      ['0.186.1', drawn({ ortho: { absent: 'nothing' }, 'tone-agx': { absent: 'nothing' } })],
    ]),
  );
  assert.match(
    verdictOf('0.186.1', families, '0.186.0')[0],
    /^0\.186\.1 draws all \d+ cases as 0\.186\.0 does.*: no new family; the table has it as three\.js 0\.186$/,
  );
  const [head, cases] = verdictOf('0.186.0', families, '0.185.1');
  assert.match(head, /^0\.186\.0 is a new family after 0\.185\.1: 2 of \d+ cases change/);
  assert.match(cases, /tone-agx \(not in both\), ortho \(not in both\)$/);
});

test('changed cases speak for the slots that they have shown', () => {
  const { slot, cases } = BORDERS.flatMap(({ slots }) => slots).find((row) => row.slot === 'rect light on the coat');
  const [first] = suspects([...cases]);
  assert.deepEqual(first, { slot, changed: cases.length, of: cases.length });
  assert.deepEqual(suspects(['no such case']), []);
});

test('the last release is the one that the project draws with', () => {
  assert.equal(JSON.parse(readFileSync(path.join(THREE, 'package.json'))).version, LAST);
  assert.equal(Number(LAST.split('.')[1]), REVISION);
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

test('the slots of the page and those of a shot are the same, term by term', () => {
  const keys = SLOT_TERMS.map(({ key }) => key).filter(Boolean);
  assert.deepEqual([...keys].sort(), Object.keys(THREE_SLOTS).sort());
  for (const row of SLOT_TERMS.filter(({ key }) => key)) {
    const names = row.terms.map((term) => nameOfTerm(row, term)).filter(Boolean);
    const known = Object.keys(THREE_SLOTS[row.key]).reverse();
    // Nothing is drawn differently before a slot's first term has anything to compute.
    assert.deepEqual(names, known, row.slot);
    for (const term of row.terms) {
      const name = nameOfTerm(row, term);
      const releases = Array.from({ length: REVISION - REVISION_MIN + 1 }, (_, i) => REVISION_MIN + i).filter((revision) => {
        const version = versionOf(revision);
        return compareReleases(term.from ?? version, version) <= 0 && compareReleases(version, term.to ?? version) <= 0;
      });
      if (name) for (const revision of releases) assert.equal(termsOfRevision(revision)[row.key], name, `${row.slot} of 0.${revision}`);
    }
  }
});

test('the page has every slot, case and border of today', () => {
  const page = readFileSync(PAGE, 'utf8');
  for (const row of SLOT_TERMS) {
    for (const i of row.terms.keys()) assert.ok(page.includes(`\n| ${slotCells(row, i).join(' | ')} |`), `${row.slot}: run npm run families`);
  }
  for (const { name } of CASES) assert.ok(page.includes(`\n| ${name} |`), `${name}: run npm run families`);
  for (const { older, newer, slots } of BORDERS) {
    assert.ok(page.includes(`| ${older} | ${newer} | ${slots.map(({ slot }) => slot).join(', ')} | nothing:`), `${older} to ${newer}: run npm run families`);
  }
});
