import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { CARE_SYMBOLS, careSvg } from '../../../js/sheet/care.mjs';
import { changesBetween } from '../../../js/sheet/changes.mjs';
import { bundledFonts } from '../../../js/sheet/engine.mjs';
import { charactersOf, checkCharacters, readFonts } from '../../../js/sheet/fonts.mjs';
import { pagesOf } from '../../../js/sheet/output.mjs';
import { hexOf } from '../../../js/sheet/pages/cells.mjs';
import { specifiedIn } from '../../../js/sheet/specified.mjs';
import { differenceText, lengthText, printedOf, printedText } from '../../../js/sheet/units.mjs';
import { LANGUAGES, wordsOf } from '../../../js/sheet/words.mjs';
import { assertWellFormed } from '../analyse/support.mjs';

const strings = (language) => JSON.parse(readFileSync(new URL(`../../../js/sheet/strings/${language}.json`, import.meta.url), 'utf8'));

test('lengths are printed in their unit', () => {
  const texts = (unit, ...lengths) => lengths.map((length) => lengthText(length, unit));
  assert.deepEqual(texts('cm', 520, 695.64, -3, -0.2, 0), ['52.0', '69.6', '−0.3', '0.0', '0.0']);
  assert.deepEqual(texts('mm', 520.4, -0.4), ['520', '0']);
  // A sixteenth of an inch is 1.5875 mm.
  assert.deepEqual(texts('inch', 25.4, 38.1, 1.5875, 19.05, 520, 0, -38.1, 0.1, 25.39), [
    '1',
    '1\u00a01/2',
    '1/16',
    '3/4',
    '20\u00a01/2',
    '0',
    '−1\u00a01/2',
    '0',
    '1',
  ]);
  assert.deepEqual(
    [12, -12, 0.1, 0].map((length) => differenceText(length, 'cm')),
    ['+1.2', '−1.2', '0.0', '0.0'],
  );
});

test('sizes grow from the base size, unless they are given', () => {
  const header = { sizes: ['XS', 'S', 'M', 'L'], baseSize: 'M' };
  const lengths = (measure) => header.sizes.map((size) => specifiedIn(measure, size, header));
  assert.deepEqual(lengths({ values: { M: 52, L: 55 }, grade: 2 }), [48, 50, 52, 55]);
  assert.deepEqual(lengths({ values: { M: 0.3 }, grade: 0.1 }), [0.1, 0.2, 0.3, 0.4]);
  assert.deepEqual(lengths({ values: { M: 52 } }), [undefined, undefined, 52, undefined]);
  assert.equal(specifiedIn({ values: { M: 52 } }, undefined, { sizes: [] }), undefined);
});

/** Texts of specified lengths; "!" behind those that are printed as another length. */
const specified = (units, printedUnits, lengths, isMost = false) =>
  lengths.map((length) => {
    const printed = printedOf(length, { units, printedUnits }, isMost);
    return `${printedText(printed)}${printed.isKept ? '' : '!'}`;
  });

test('specified lengths are printed as they are given', () => {
  assert.deepEqual(specified('cm', 'cm', [50, 50.25, 50.5, 0.125, 0.1 + 0.2, 0]), ['50.0', '50.25', '50.5', '0.125', '0.3', '0.0']);
  assert.deepEqual(specified('mm', 'mm', [12.5, 12, 0.125]), ['12.5', '12', '0.125']);
  assert.deepEqual(specified('mm', 'cm', [12.5, 500]), ['1.25', '50.0']);
  assert.deepEqual(specified('cm', 'mm', [50.25, 50]), ['502.5', '500']);
  assert.deepEqual(specified('inch', 'inch', [1 / 32, 11 + 5 / 64, 20.5, 10.3, 0.0156, 0]), ['1/32', '11\u00a05/64', '20\u00a01/2', '10.3', '1/64', '0']);
  // More decimals than a sheet has, and thirds of an inch, are told.
  assert.deepEqual([...specified('cm', 'cm', [1 / 3]), ...specified('inch', 'inch', [10 + 1 / 3])], ['0.333!', '10.333!']);
});

test('lengths of another unit are rounded, as sheet.md says, and told where nothing is left of them', () => {
  assert.deepEqual(specified('cm', 'inch', [30.2, 2.54, 0]), ['11\u00a07/8', '1', '0']);
  assert.deepEqual(specified('cm', 'inch', [0.05, 0.01]), ['1/32', '0!']);
  assert.deepEqual(specified('inch', 'cm', [10 + 1 / 16, 10, 0.0001]), ['25.56', '25.4', '0.0!']);
  assert.deepEqual(specified('inch', 'mm', [10 + 1 / 16]), ['255.6']);
});

test('tolerances are never printed larger than was given', () => {
  assert.deepEqual(specified('cm', 'cm', [0.25, 0.3, 0.0009, 2 / 3], true), ['0.25', '0.3', '0.0!', '0.666!']);
  assert.deepEqual(specified('inch', 'inch', [1 / 32, 3 / 64, 0.1, 0.3333], true), ['1/32', '3/64', '0.1', '0.333!']);
  assert.deepEqual(specified('cm', 'inch', [0.5, 0.3, 0.1, 0.02, 1], true), ['3/16', '3/32', '1/32', '0!', '3/8']);
  assert.deepEqual(specified('inch', 'cm', [1 / 4, 1 / 16], true), ['0.63', '0.15']);
  for (let i = 1; i < 2000; ++i)
    for (const [units, printedUnits, unit] of [
      ['cm', 'inch', 2.54],
      ['inch', 'cm', 1 / 2.54],
      ['mm', 'inch', 25.4],
      ['inch', 'mm', 1 / 25.4],
    ]) {
      const { value, isKept } = printedOf(i / 1000, { units, printedUnits }, true);
      assert.ok(value * unit <= i / 1000 + 1e-6 && (!isKept || value > 0), `${i} ${units} ${printedUnits}`);
    }
});

test('every language has every heading with the same places, and every care symbol has a name', () => {
  const english = strings('en');
  const places = (text) => [...text.matchAll(/\{\w+\}/g)].map(([place]) => place).sort();
  for (const language of LANGUAGES) {
    const words = strings(language);
    assert.deepEqual(Object.keys(words), Object.keys(english), language);
    for (const [key, text] of Object.entries(words)) assert.deepEqual(places(text), places(english[key]), key);
  }
  for (const key of Object.keys(CARE_SYMBOLS)) assert.ok(english[`care.${key}`], key);
  assert.equal(wordsOf({ language: 'es-MX', words: { bill: 'Materiales' } })('bill'), 'Materiales');
  assert.equal(wordsOf({ language: 'es-MX', words: {} })('page'), 'Página');
  assert.equal(wordsOf({ language: 'en', words: {} })('reduced', { scale: '1:2' }), 'Shown at 1:2');
  // Another language brings its own; what it leaves out is English.
  assert.equal(wordsOf({ language: 'fr', words: { page: 'Page' } })('bill'), 'Bill of materials');
  // What is cleared, or comes to nothing, is that of the language: a PDF/UA has no empty heading and no picture without a text.
  const cleared = wordsOf({ language: 'es', words: { bill: '', 'alt.logo': '{brand}' } });
  assert.deepEqual(
    [cleared('bill'), cleared('alt.logo', { brand: '' }), cleared('alt.logo', { brand: 'Telar' })],
    ['Lista de materiales', 'Logotipo de ', 'Telar'],
  );
});

test('care symbols are vectors without text', () => {
  for (const key of Object.keys(CARE_SYMBOLS)) {
    const svg = careSvg(key);
    assertWellFormed(svg);
    assert.doesNotMatch(svg, /<text|undefined|NaN/, key);
  }
});

test('colours are encoded as sRGB', () => {
  assert.deepEqual(
    [
      [1, 0, 0],
      [0.2158605, 0.2158605, 0.2158605],
      [2, -1, 0.0031308],
    ].map(hexOf),
    ['#ff0000', '#808080', '#ff000a'],
  );
});

test('what differs between revisions is named; what only moves does not', () => {
  const before = {
    header: { revision: 'A', name: 'Tee' },
    measures: [
      { code: 'A', values: { M: 50 } },
      { code: 'B', values: { M: 70 } },
    ],
    notes: 'x',
  };
  const after = {
    header: { revision: 'B', name: 'Tee' },
    measures: [{ code: 'B', values: { M: 71 } }, { code: 'A', values: { M: 50 } }, { code: 'C' }],
    notes: 'x',
  };
  assert.deepEqual(changesBetween(before, after), ['/header/revision', '/measures/0', '/measures/2']);
  assert.deepEqual(changesBetween(before, before), []);
  assert.deepEqual(changesBetween({}, { notes: 'a' }), ['/notes']);
});

test('points of measure are compared by their lengths and places', () => {
  const spec = {
    units: 'cm',
    header: { sizes: ['S', 'M', 'L'], baseSize: 'M' },
    anchors: { hps: [0, 0.7, 0], hem: [0, 0, 0], pit: [0.3, 0.4, 0] },
    measures: [
      { code: 'A', points: ['hps', 'hem'], tolerance: 1, values: { M: 50 }, grade: 2 },
      { code: 'B', girth: { point: 'pit' }, values: { M: 90 } },
    ],
    artwork: [{ name: 'Print', width: 10 }],
  };
  const changed = (changes) => changesBetween(spec, { ...spec, ...changes }).filter((pointer) => /measures|artwork/.test(pointer));
  assert.deepEqual(changed({ units: 'inch' }), ['/measures/0', '/measures/1', '/artwork/0']);
  assert.deepEqual(changed({ header: { ...spec.header, baseSize: 'S' }, measures: [{ ...spec.measures[0], values: { S: 50 } }] }), ['/measures/0']);
  assert.deepEqual(changed({ header: { ...spec.header, sizes: ['S', 'X', 'M', 'L'] } }), ['/measures/0']);
  assert.deepEqual(changed({ anchors: { ...spec.anchors, hem: [0, 0.01, 0] } }), ['/measures/0']);
  assert.deepEqual(changed({ anchors: { ...spec.anchors, pit: [0.3, 0.41, 0] } }), ['/measures/1']);
  // The same lengths and places in other words.
  const inMillimetres = {
    units: 'mm',
    anchors: { neck: [0, 0.7, 0], ...spec.anchors },
    measures: [
      { ...spec.measures[0], points: ['neck', [0, 0, 0]], tolerance: 10, values: { S: 480, M: 500, L: 520 }, grade: undefined },
      { ...spec.measures[1], values: { M: 900 } },
    ],
    artwork: [{ name: 'Print', width: 100 }],
  };
  assert.deepEqual(changed(inMillimetres), []);
  // Centimetres where nothing says another unit.
  const { units, ...rest } = spec;
  assert.deepEqual(changesBetween(rest, spec), ['/units']);
});

test('defaults that are written out are no changes', () => {
  const spec = {
    views: [{ name: 'front' }, { name: 'flat', style: 'flat', azimuth: 10 }],
    measures: [
      {
        code: 'A',
        description: 'a',
        points: [
          [0, 0, 0],
          [0, 1, 0],
        ],
      },
      { code: 'B', description: 'b', girth: { point: [0, 0, 0] } },
    ],
    callouts: [{ text: 'a', node: 'x' }],
    details: [
      { title: 'a', node: 'x' },
      { title: 'b', node: 'x', view: 'flat', shape: 'rectangle' },
    ],
    colourways: [{ name: 'Navy', variant: 'navy' }, { name: 'Own' }],
    swatches: [{ title: 'a', material: 0 }],
    bill: [{ item: 'a' }],
  };
  const written = {
    views: [
      { view: 'front', scale: 'fit', style: 'render', ghost: [], explode: 0, variant: 'navy' },
      { scale: 'fit', explode: 0, title: undefined },
    ],
    measures: [
      { along: 'straight', times: 1, closed: false, join: 0, view: 'front', values: {} },
      { girth: { point: [0, 0, 0], normal: [0, 1, 0], tight: false } },
    ],
    callouts: [{ view: 'front' }],
    details: [
      { view: 'front', size: 0.08, shape: 'circle', scale: 'fit', style: 'render', height: undefined },
      { style: 'flat', height: 0.08 },
    ],
    colourways: [{ swatches: [] }, { variant: '' }],
    swatches: [{ variant: 'navy', scale: '1:2', draped: true }],
    bill: [{ colours: {} }],
  };
  const after = Object.fromEntries(Object.entries(spec).map(([list, items]) => [list, items.map((item, i) => ({ ...item, ...written[list][i] }))]));
  assert.notDeepEqual(after, spec);
  assert.deepEqual([changesBetween(spec, after), changesBetween(after, spec)], [[], []]);
  // Each of these is another value than that of the table, or of the rest of the spec.
  const others = {
    views: [{ scale: '1:5' }, { view: 'front', azimuth: undefined }],
    measures: [{ along: 'surface' }, { girth: { point: [0, 0, 0], tight: true } }],
    callouts: [{ view: 'flat' }],
    details: [{ style: 'flat' }, { height: 0.1 }],
    colourways: [{ variant: '' }, { variant: 'navy' }],
    swatches: [{ variant: '' }],
    bill: [{ colours: { Navy: 'x' } }],
  };
  for (const [list, all] of Object.entries(others))
    all.forEach((other, i) => {
      const changed = { ...spec, [list]: spec[list].map((item, k) => (k === i ? { ...item, ...other } : item)) };
      assert.ok(changesBetween(spec, changed).includes(`/${list}/${i}`), `${list} ${i}`);
    });
});

test('of a last revision no more sizes are looked at than a spec has', () => {
  // Each with each, for 300 points of measure, would take hours.
  const sizes = Array.from({ length: 100_000 }, (_, i) => `${i}`);
  const measures = Array.from({ length: 300 }, (_, i) => ({ code: `${i}`, values: { 0: 1 }, grade: 1 }));
  const before = { header: { sizes, baseSize: '0' }, measures };
  const after = { header: { sizes: ['0', '1'], baseSize: '0' }, measures };
  assert.ok([...changesBetween(before, after)].length > 0);
});

test('of items with one name the n-th is compared with the n-th', () => {
  const callouts = ['Bar tack', 'Bar tack', 'Hem'].map((text, i) => ({ text, picture: [0.1 * (i + 1), 0.5] }));
  assert.deepEqual(changesBetween({ callouts }, { callouts }), []);
  const bill = [
    { item: 'Thread', placement: 'Hem' },
    { item: 'Thread', placement: 'Seams' },
  ];
  assert.deepEqual(changesBetween({ bill }, { bill: [bill[0], { ...bill[1], placement: 'Sides' }, bill[0]] }), ['/bill/1', '/bill/2']);
});

test('what is no spec is compared too', () => {
  const odd = [
    null,
    5,
    'a',
    [],
    [null],
    [[1]],
    [{}],
    { a: 1 },
    [{ code: 'A', points: 5, girth: 'x', values: 'y', grade: 2 }],
    [{ code: 'A', values: { __proto__: null, M: 'x' }, grade: 1 }],
  ];
  for (const measures of odd)
    for (const header of [...odd, { sizes: 'SML', baseSize: 'M' }, { sizes: ['M'], baseSize: 'M' }])
      for (const units of [undefined, 'furlong', 'constructor', 3]) {
        const spec = { units, header, measures, anchors: header, artwork: measures };
        assert.deepEqual(changesBetween(spec, spec), []);
        changesBetween({ measures: odd }, spec);
        changesBetween(spec, { measures: [{ code: 'A', values: { M: 1 }, grade: 2 }], header: { sizes: ['M'], baseSize: 'M' } });
      }
});

test('the bundled fonts have Latin, Greek and Cyrillic; a character that they lack is named with its place', async () => {
  const bundled = await bundledFonts();
  const fonts = readFonts(bundled, bundled.length);
  assert.deepEqual(fonts.families, ['Inter']);
  for (const character of 'aÑß€Ωжї°²½×−–"') assert.ok(fonts.has(character.codePointAt(0)), character);
  checkCharacters({ notes: 'Ñandú\nжук', list: [1, null, true] }, fonts);
  assert.throws(() => checkCharacters({ callouts: [{ text: 'ok' }, { text: '袖口' }] }, fonts), {
    code: 'E_SPEC',
    pointer: '/callouts/1/text',
    message: 'spec.callouts[1].text: no font has U+8896 "袖"; give one that does with the option fonts, --font FILE',
  });
  assert.throws(() => readFonts([...bundled, new Uint8Array(40)], bundled.length), { code: 'E_OPTION', message: /options\.fonts\[0\]/ });
});

test('pages are cut out of one drawing, each with what it refers to', () => {
  const svg = `<svg class="typst-doc" viewBox="0 0 10 20">
    <g>
        <use xlink:href="#a"/>
    </g>
    <g transform="matrix(1 0 0 1 0 10)">
        <use xlink:href="#b"/>
        <g clip-path="url(#c)"></g>
    </g>
    <defs id="glyph">
        <symbol id="a" overflow="visible">
            <path d="M 1"/>
        </symbol>
        <symbol id="b" overflow="visible">
            <path d="M 2"/>
        </symbol>
    </defs>
    <defs id="clip-path">
        <clipPath id="c"><path d="M 3"/></clipPath>
    </defs>
</svg>`;
  const pages = pagesOf(svg, { width: 25.4, height: 50.8 });
  assert.equal(pages.length, 2);
  for (const page of pages) {
    assertWellFormed(page);
    assert.match(page, /width="25\.4mm" height="50\.8mm" viewBox="0 0 72 144"/);
  }
  assert.ok(pages[0].includes('M 1') && !pages[0].includes('M 2') && !pages[0].includes('M 3'));
  assert.ok(!pages[1].includes('M 1') && pages[1].includes('M 2') && pages[1].includes('M 3'));
});

/** A font that has a character map alone. @param {Buffer} map - Of that format. */
function fontOf(map) {
  const font = Buffer.alloc(40);
  font.writeUInt16BE(1, 4);
  font.write('cmap', 12, 'latin1');
  font.writeUInt32BE(28, 20);
  font.writeUInt16BE(1, 30);
  font.writeUInt32BE(12, 36);
  return Buffer.concat([font, map]);
}

test('a character map that has a character many times is read once', () => {
  const groups = Buffer.alloc(16 + 12 * 50);
  groups.writeUInt16BE(12, 0);
  groups.writeUInt32BE(50, 12);
  for (let i = 0; i < 50; ++i) groups.writeUInt32BE(0x10ffff, 16 + 12 * i + 4);
  assert.deepEqual(charactersOf(fontOf(groups)), [[0, 0x10ffff]]);
  // Of format 4: 20 segments of all characters, each glyph the character and one.
  const segments = Buffer.alloc(16 + 8 * 20);
  segments.writeUInt16BE(4, 0);
  segments.writeUInt16BE(40, 6);
  for (let i = 0; i < 20; ++i) {
    segments.writeUInt16BE(0xfffe, 14 + 2 * i);
    segments.writeUInt16BE(1, 16 + 4 * 20 + 2 * i);
  }
  assert.deepEqual(charactersOf(fontOf(segments)), [[0, 0xfffe]]);
});

test('of a map whose groups are out of order, what comes too late is left out', () => {
  const list = [
    [65, 70],
    [71, 80],
    [60, 66],
    [90, 91],
    [91, 95],
    [99, 98],
  ];
  const groups = Buffer.alloc(16 + 12 * list.length);
  groups.writeUInt16BE(12, 0);
  groups.writeUInt32BE(list.length, 12);
  list.flat().forEach((code, i) => groups.writeUInt32BE(code, 16 + 12 * (i >> 1) + 4 * (i & 1)));
  assert.deepEqual(charactersOf(fontOf(groups)), [
    [65, 80],
    [90, 91],
    [92, 95],
  ]);
});
