import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import Ajv from 'ajv/dist/2020.js';
import { firstSpec } from '../../../js/sheet/first_spec.mjs';
import { TEXT_MAX, readSpec } from '../../../js/sheet/read.mjs';
import { wordsOf } from '../../../js/sheet/words.mjs';

const read = (spec, facts = { variants: ['navy', 'ecru'] }) => readSpec(spec, facts);

/** What a spec is refused with: [pointer, message]. */
function refusal(spec) {
  try {
    wordsOf(read(spec));
  } catch (error) {
    assert.equal(error.code, 'E_SPEC', error.stack);
    return [error.pointer, error.message];
  }
  throw new Error(`accepted ${JSON.stringify(spec)}`);
}

const callout = (changes) => ({ callouts: [{ text: 'a', point: [0, 0, 0], ...changes }] });
const measure = (changes, rest = {}) => ({ header: { sizes: ['S', 'M'], baseSize: 'M' }, measures: [{ code: 'A', description: 'a', ...changes }], ...rest });

const WRONG = [
  [{ paper: { size: 'A5' } }, '/paper/size', 'spec.paper.size: expected "A4", "A3" or "Letter", got "A5"'],
  [{ papers: {} }, '/papers', 'spec.papers: unknown key, did you mean paper?'],
  [{ ppi: 9999 }, '/ppi', 'spec.ppi: expected a number in [36, 600], got 9999'],
  [{ header: { name: 'a\nb' } }, '/header/name', 'spec.header.name: expected a text of at most 120 characters on one line, got "a\\nb"'],
  [{ header: { sizes: ['S'], baseSize: 'M' } }, '/header/baseSize', 'spec.header.baseSize: there is no size in spec.header.sizes "M"; did you mean "S"?'],
  [{ views: [{ name: 'a' }, { name: 'a' }] }, '/views/1/name', 'spec.views[1].name: expected a name that no other has, got "a"'],
  [
    { views: [{ name: 'a', view: 'front', azimuth: 3 }] },
    '/views/0/view',
    'spec.views[0].view: expected a named view, or azimuth and elevation, not both, got "front"',
  ],
  [{ views: [{ name: 'a', scale: '1/5' }] }, '/views/0/scale', 'spec.views[0].scale: expected "fit" or a scale such as "1:5", got "1/5"'],
  [{ views: [{ name: 'a', scale: '0:5' }] }, '/views/0/scale', 'spec.views[0].scale: expected "fit" or a scale such as "1:5", got "0:5"'],
  [{ views: [{ name: 'a', variant: 'nvy' }] }, '/views/0/variant', 'spec.views[0].variant: there is no material variant "nvy"; did you mean "navy"?'],
  [callout({ view: 'fromt' }), '/callouts/0/view', 'spec.callouts[0].view: there is no view "fromt"; did you mean "front"?'],
  [callout({ node: 'Sleeve' }), '/callouts/0', 'spec.callouts[0]: expected one of point, node, material, picture, got {"point", "node"}'],
  [{ callouts: [{ text: 'a' }] }, '/callouts/0', 'spec.callouts[0]: expected one of point, node, material, picture, got {}'],
  [callout({ point: [0, 0] }), '/callouts/0/point', 'spec.callouts[0].point: expected three numbers [x, y, z] in metres, got [0, 0]'],
  [callout({ text: 5 }), '/callouts/0/text', 'spec.callouts[0].text: expected a text of at most 4000 characters, got 5'],
  [callout({ side: 'top' }), '/callouts/0/side', 'spec.callouts[0].side: expected "left" or "right", got "top"'],
  [
    { callouts: [{ text: 'a', picture: [0.5, 1.5] }] },
    '/callouts/0/picture',
    'spec.callouts[0].picture: expected two numbers [x, y] in (0, 1], got [0.5, 1.5]',
  ],
  [measure({ points: [[0, 0, 0]] }), '/measures/0/points', 'spec.measures[0].points: expected a list of 2 to 64 points, got [[0, 0, 0]]'],
  [measure({ points: ['hem', [0, 0, 0]] }), '/measures/0/points/0', 'spec.measures[0].points[0]: there is no anchor "hem"; there is none'],
  [
    measure({ points: ['hen', 'hem'] }, { anchors: { hem: [0, 0, 0] } }),
    '/measures/0/points/0',
    'spec.measures[0].points[0]: there is no anchor "hen"; did you mean "hem"?',
  ],
  [
    measure({ border: true, girth: { point: [0, 0, 0] } }),
    '/measures/0',
    'spec.measures[0]: expected at most one of points, girth, border, got {"girth", "border"}',
  ],
  [measure({ values: { XL: 3 } }), '/measures/0/values/XL', 'spec.measures[0].values.XL: there is no size in spec.header.sizes "XL"; there are "S", "M"'],
  [
    measure({ grade: 2 }),
    '/measures/0/grade',
    'spec.measures[0].grade: expected a length in `values` for the size spec.header.baseSize, from which it grows, got 2',
  ],
  [
    measure({ values: { M: 3 }, grade: 4 }),
    '/measures/0/grade',
    'spec.measures[0].grade: expected one that leaves a length of at least 0 in size "S", not -1, got 4',
  ],
  [
    measure({ values: { M: 3 }, grade: -2 }, { header: { sizes: ['M', 'L', 'XL'], baseSize: 'M' } }),
    '/measures/0/grade',
    'spec.measures[0].grade: expected one that leaves a length of at least 0 in size "XL", not -1, got -2',
  ],
  [measure({ tolerance: -1 }), '/measures/0/tolerance', 'spec.measures[0].tolerance: expected a length in [0, 100000], got -1'],
  [
    { colourways: [{ name: 'a', variant: 'red' }] },
    '/colourways/0/variant',
    'spec.colourways[0].variant: there is no material variant "red"; there are "navy", "ecru"',
  ],
  [{ bill: [{ item: 'a', colours: { 'No.1': 'x' } }] }, '/bill/0/colours/No.1', 'spec.bill[0].colours["No.1"]: there is no colourway "No.1"; there is none'],
  [{ bill: [{ item: 'a', colours: { Navy: 'x' } }] }, '/bill/0/colours/Navy', 'spec.bill[0].colours.Navy: there is no colourway "Navy"; there is none'],
  // Of the names of JavaScript's own properties none is taken for a value that is there, and the one that would be lost is refused.
  [
    measure({ grade: 2 }, { header: { sizes: ['constructor'], baseSize: 'constructor' } }),
    '/measures/0/grade',
    'spec.measures[0].grade: expected a length in `values` for the size spec.header.baseSize, from which it grows, got 2',
  ],
  [JSON.parse('{"anchors": {"__proto__": [0, 0, 0]}}'), '/anchors/__proto__', 'spec.anchors.__proto__: expected another name, got [0, 0, 0]'],
  [JSON.parse('{"words": {"__proto__": "x"}}'), '/words/__proto__', 'spec.words.__proto__: expected another name, got "x"'],
  [
    measure({ values: JSON.parse('{"__proto__": 40}') }, { header: { sizes: ['__proto__'] } }),
    '/measures/0/values/__proto__',
    'spec.measures[0].values.__proto__: expected another name, got 40',
  ],
  [
    { colourways: [{ name: '__proto__' }], bill: [{ item: 'a', colours: JSON.parse('{"__proto__": "x"}') }] },
    '/bill/0/colours/__proto__',
    'spec.bill[0].colours.__proto__: expected another name, got "x"',
  ],
  [{ language: 'qq' }, '/language', 'spec.language: expected "en", "es", or another with its headings in spec.words, got "qq"'],
  [{ words: { nothing: 'x' } }, '/words', 'spec.words: there is no heading "nothing"; js/sheet/strings/en.json lists them'],
  [[], '', 'spec: expected an object, got []'],
];

for (const [spec, pointer, message] of WRONG) {
  test(`refused at ${pointer || 'the top'}: ${message.slice(0, 70)}`, () => {
    assert.deepEqual(refusal(spec), [pointer, message]);
  });
}

test('a care symbol that there is not is refused with those that there are', () => {
  const [pointer, message] = refusal({ care: { symbols: ['wash-31'] } });
  assert.equal(pointer, '/care/symbols/0');
  assert.match(message, /^spec\.care\.symbols\[0\]: expected "wash-95", /);
});

test('hostile specs end in an error, whatever their size', () => {
  assert.equal(refusal({ notes: 'x'.repeat(10 * 2 ** 20) })[0], '');
  assert.match(refusal({ notes: 'x'.repeat(TEXT_MAX + 1) })[1], /at most 300000 characters of text in all/);
  assert.deepEqual(refusal({ callouts: Array(10_000).fill({ text: 'a', point: [0, 0, 0] }) }).slice(0, 1), ['/callouts']);
  assert.deepEqual(refusal({ anchors: Object.fromEntries(Array.from({ length: 300 }, (_, i) => [`p${i}`, [0, 0, 0]])) })[0], '/anchors');
  let deep = {};
  for (let i = 0; i < 5000; ++i) deep = { a: deep };
  assert.equal(refusal({ header: deep })[0], '/header/a');
  let lists = [];
  for (let i = 0; i < 50_000; ++i) lists = [lists];
  assert.equal(refusal({ header: lists })[0], '/header');
  assert.match(refusal({ header: lists })[1], /^spec\.header: expected an object, got \[{30}[^a-z]{10,30}$/);
  assert.equal(refusal({ anchors: { hem: lists } })[0], '/anchors/hem');
  assert.equal(refusal(JSON.parse('{"header": {"__proto__": 1}}'))[0], '/header/__proto__');
});

test('defaults are written out, and nothing of the caller is changed', () => {
  const given = { callouts: [{ text: 'a', point: [0, 0, 0] }], colourways: [{ name: 'Navy', variant: 'navy' }] };
  const copy = structuredClone(given);
  const spec = read(given);
  assert.deepEqual(given, copy);
  assert.deepEqual(
    spec.views.map(({ name, view, cover, variant, scale }) => [name, view, cover, variant, scale]),
    [
      ['front', 'front', true, 'navy', 'fit'],
      ['back', 'back', true, 'navy', 'fit'],
    ],
  );
  assert.equal(spec.callouts[0].view, 'front');
  assert.deepEqual([spec.units, spec.printedUnits, spec.paper], ['cm', 'cm', { size: 'A4', orientation: 'landscape' }]);
  assert.equal(read({ units: 'inch' }).printedUnits, 'inch');
  const chosen = read({ views: [{ name: 'a' }, { name: 'b', cover: true }, { name: 'c' }] });
  assert.deepEqual(
    chosen.views.map(({ cover }) => cover),
    [false, true, false],
  );
});

test('a length of 0 by its grade, and of a size with a value of its own, is taken', () => {
  const read0 = (values) => read(measure({ values, grade: 3 }));
  assert.equal(read0({ M: 3 }).measures[0].grade, 3);
  assert.equal(read0({ S: 1, M: 2 }).measures[0].grade, 3);
});

test('the published schema takes what the reader takes', () => {
  const schema = JSON.parse(readFileSync(new URL('../../../js/sheet/schema.json', import.meta.url), 'utf8'));
  const validate = new Ajv({ strict: false }).compile(schema);
  const facts = {
    name: 'tee',
    bounds: { min: [0, 0, 0], max: [1, 1, 1] },
    materials: [{ name: 'jersey_navy' }, { name: 'jersey_ecru' }],
    variants: ['navy', 'ecru'],
  };
  const spec = firstSpec(facts);
  assert.ok(validate(spec), JSON.stringify(validate.errors));
  assert.equal(read(spec, facts).measures.length, 2);
  for (const [wrong] of WRONG.slice(0, 4)) assert.ok(!validate(wrong), JSON.stringify(wrong));
});

test('a first spec holds what the model tells', () => {
  const outline = [
    [-0.4, 0.5, 0],
    [0.4, 0.5, 0],
    [0, 0.75, 0],
    [0, 0, 0.1],
  ];
  const facts = {
    name: 'crew_neck',
    bounds: { min: [-0.4, 0, 0], max: [0.4, 0.75, 0.1] },
    outline,
    materials: [{ name: 'jersey_navy' }, { name: 'jersey_ecru' }, { name: 'label' }, { name: '' }, { name: '' }],
    variants: ['navy', 'ecru'],
    variantMaterials: [
      [0, 2],
      [1, 2, 4],
    ],
  };
  const spec = firstSpec(facts);
  assert.equal(spec.header.name, 'Crew neck');
  assert.deepEqual(
    spec.bill.map(({ item }) => item),
    ['Jersey', 'Label'],
  );
  assert.deepEqual(
    spec.colourways.map(({ name, variant }) => [name, variant]),
    [
      ['Navy', 'navy'],
      ['Ecru', 'ecru'],
    ],
  );
  assert.deepEqual(
    spec.colourways.map(({ swatches }) => swatches),
    [
      [
        { part: 'Jersey', material: 'jersey_navy' },
        { part: 'Label', material: 'label' },
      ],
      [{ part: 'Jersey', material: 'jersey_ecru' }, { part: 'Label', material: 'label' }, { material: 4 }],
    ],
  );
  assert.deepEqual(
    spec.views.filter(({ style }) => style === 'flat').map(({ name }) => name),
    ['flat-front', 'flat-back'],
  );
  assert.deepEqual(spec.anchors.left, [-0.4, 0.5, 0]);
  assert.deepEqual(
    spec.measures.map(({ values }) => values.M),
    [80, 75.7],
  );
  assert.equal(firstSpec(facts, { language: 'es' }).measures[0].description, 'Ancho total');
});

test('the overall length of a first spec is upright, though the hem is lowest at a side', () => {
  const outline = [
    [-0.11, 0, 0],
    [0.01, 0.003, 0],
    [0.11, 0.006, 0],
    [0, 0.73, 0],
    [-0.35, 0.49, 0],
    [0.35, 0.5, 0],
  ];
  const { anchors, measures } = firstSpec({ bounds: { min: [-0.35, 0, 0], max: [0.35, 0.73, 0] }, outline });
  assert.deepEqual([anchors.bottom, anchors.top], [outline[1], outline[3]]);
  assert.deepEqual(
    measures.map(({ values }) => values.M),
    [70, 72.7],
  );
});
