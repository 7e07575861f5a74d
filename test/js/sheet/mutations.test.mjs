import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { readSpec } from '../../../js/sheet/read.mjs';
import '../api/support/real.mjs';

// The whole example with one thing wrong: what a hand that edits a spec gets wrong, and what it is told.

const at = (name) => fileURLToPath(new URL(`../../../js/${name}`, import.meta.url));
const EXAMPLE = readFileSync(at('docs/sheet/tshirt.json'), 'utf8');
const FACTS = { variants: ['natural', 'indigo'] };

/** What is changed: by its path, and the value put there; undefined takes it away. */
const WRONG = [
  ['/header', [], 'an object'],
  ['/header/sizes', 'S,M', 'a list of at most 40 names of sizes'],
  ['/header/sizes/1', '', 'a name of at least one character', { '/header/sizes': ['S', ''] }],
  ['/header/sizes/2', 'S', 'a name that no other has', { '/header/sizes': ['S', 'M', 'S'] }],
  ['/header/baseSize', 38, 'a text of at most 120 characters on one line'],
  ['/header/date', 20260101, 'a text of at most 120 characters on one line'],
  ['/header/name', 'a\u0000b', 'a text of at most 120 characters on one line'],
  ['/paper', 'A4', '{size, orientation}'],
  ['/ppi', '200', 'a number in [36, 600]'],
  ['/units', 'in', '"cm", "mm" or "inch"'],
  ['/language', 'EN', 'a language tag such as "en", "es" or "pt-BR"'],
  ['/template', '../x', 'a name of letters, digits, - and _'],
  ['/views', { front: 1 }, 'a list of at most 24 views'],
  ['/views/0/name', undefined, 'a text of at most 120 characters on one line'],
  ['/views/0/name', '', 'a name of at least one character'],
  ['/views/0/scale', '1:0', '"fit" or a scale such as "1:5"'],
  ['/views/0/view', 'fron', '"front", "back", "left", "right", "top", "bottom" or "three-quarter"'],
  ['/callouts/0/text', undefined, 'a text of at most 4000 characters'],
  ['/callouts/0/point', 'hps', 'three numbers [x, y, z] in metres', { '/callouts/0': { text: 'a', point: 'hps' } }],
  ['/callouts/0/point/1', null, 'a number in [-1e30, 1e30]', { '/callouts/0': { text: 'a', point: [0, null, 0] } }],
  ['/callouts/0/node', -1, 'the index or the name of a node in the model', { '/callouts/0': { text: 'a', node: -1 } }],
  ['/details/0/size', 0, 'a length in metres in [0.0001, 100]'],
  ['/details/0/title', undefined, 'a text of at most 120 characters on one line'],
  ['/measures/0/code', '', 'a name of at least one character'],
  ['/measures/0/code', 'B', 'a name that no other has', { '/measures/0/code': 'B' }, '/measures/1/code'],
  ['/measures/0/girth/normal', [0, 0, 0], 'a direction, not [0, 0, 0]'],
  ['/measures/0/girth/point', undefined, 'a point [x, y, z] in metres or the name of one of `anchors`'],
  ['/measures/0/part', {}, '{node} or {material}'],
  ['/measures/0/part', { node: 'a', material: 'b' }, '{node} or {material}'],
  ['/measures/0/part/node', true, 'the index or the name of a node in the model', { '/measures/0/part': { node: true } }],
  ['/measures/0/border', false, 'true'],
  ['/measures/0/values/M', '54', 'a length in [0, 100000]'],
  ['/measures/0/values/M', -54, 'a length in [0, 100000]'],
  ['/measures/0/times', 0, 'a factor in (0, 100]'],
  ['/measures/0/join', 2, 'a length in metres in [0, 1]'],
  ['/measures/0/tolerance', '1', 'a length in [0, 100000]'],
  ['/measures/1/along', 'cloth', '"straight" or "surface"'],
  ['/anchors', [[0, 0, 0]], 'an object of at most 200 named points'],
  ['/anchors/hps', [0, 0], 'three numbers [x, y, z] in metres'],
  ['/anchors/hps/0', 1e308, 'a number in [-1e30, 1e30]', { '/anchors/hps': [1e308, 0, 0] }],
  ['/bill/0/item', undefined, 'a text of at most 500 characters'],
  ['/notes', ['a'], 'a text of at most 4000 characters'],
  ['/care', ['wash-30'], 'an object'],
  ['/colourList', 5, 'an object'],
];

/** What is wrong in other words than "expected". */
const NAMED = [
  ['/views/0/azimut', 30, /^spec\.views\[0\]\.azimut: unknown key, did you mean azimuth\?$/],
  ['/views/0/variant', 'Indygo', /^spec\.views\[0\]\.variant: there is no material variant "Indygo"; did you mean "indigo"\?$/],
  ['/measures/1/points/0', 'hsp', /^spec\.measures\[1\]\.points\[0\]: there is no anchor "hsp"; did you mean "hps"\?$/],
  ['/measures/0/values/m', 54, /^spec\.measures\[0\]\.values\.m: there is no size in spec\.header\.sizes "m"; did you mean "M"\?$/],
  ['/bill/0/colours/Naturel', 'x', /^spec\.bill\[0\]\.colours\.Naturel: there is no colourway "Naturel"; did you mean "Natural"\?$/],
  ['/_comment', 'x', /^spec\._comment: unknown key, expected one of language, /],
];

/** The example with values put at their paths. */
function changed(changes) {
  const spec = JSON.parse(EXAMPLE);
  for (const [pointer, value] of Object.entries(changes)) {
    const keys = pointer.split('/').slice(1);
    const last = keys.pop();
    const holder = keys.reduce((node, key) => {
      node[key] ??= {};
      return node[key];
    }, spec);
    if (value === undefined) delete holder[last];
    else holder[last] = value;
  }
  return spec;
}

const refusal = (spec) => {
  try {
    readSpec(spec, FACTS);
  } catch ({ code, pointer, message }) {
    return { code, pointer, message };
  }
  return undefined;
};

test('the example itself is sound', () => assert.equal(refusal(changed({})), undefined));

for (const [pointer, value, expected, changes = { [pointer]: value }, told = pointer] of WRONG) {
  test(`${pointer} of ${JSON.stringify(value) ?? 'nothing'}: expected ${expected}`, () => {
    const { code, pointer: said, message } = refusal(changed(changes)) ?? {};
    assert.deepEqual([code, said], ['E_SPEC', told]);
    const place = `spec${told
      .slice(1)
      .split('/')
      .map((key) => (/^\d+$/.test(key) ? `[${key}]` : `.${key}`))
      .join('')}`;
    assert.ok(message.startsWith(`${place}: expected ${expected}, got `), message);
  });
}

for (const [pointer, value, message] of NAMED) {
  test(`${pointer} is named`, () => {
    const found = refusal(changed({ [pointer]: value }));
    assert.deepEqual([found?.code, found?.pointer], ['E_SPEC', pointer]);
    assert.match(found.message, message);
  });
}

test('a list that is too long is told by its length', () => {
  const views = Array.from({ length: 25 }, (_, i) => ({ name: `v${i}` }));
  assert.equal(refusal(changed({ '/views': views })).message, 'spec.views: expected a list of at most 24 views, got 25');
});

test('the command says the same, and writes nothing', (t) => {
  const folder = mkdtempSync(path.join(tmpdir(), 'telar-bad-spec-'));
  t.after(() => rmSync(folder, { recursive: true }));
  const file = path.join(folder, 'spec.json');
  for (const changes of [{ '/paper': 'A4' }, { '/measures/0/part': {} }, { '/measures/1/points/0': 'hsp' }]) {
    const spec = changed(changes);
    writeFileSync(file, JSON.stringify(spec));
    const args = [at('cli/telar.mjs'), 'sheet', at('assets/tshirt.glb'), '--spec', file, '-o', path.join(folder, 'sheet.pdf'), '--json'];
    const { status, stdout, stderr } = spawnSync(process.execPath, args, { encoding: 'utf8', timeout: 600_000 });
    const { code, pointer, message } = refusal(spec);
    assert.equal(status, 2, stderr);
    assert.ok(stderr.includes(message) && stderr.includes(code), stderr);
    const said = JSON.parse(stdout.trim().split('\n').at(-1));
    assert.deepEqual([said.ok, said.error.code, said.error.pointer], [false, code, pointer]);
    assert.deepEqual(readdirSync(folder), ['spec.json']);
  }
});
