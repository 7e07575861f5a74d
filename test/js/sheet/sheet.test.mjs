import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import '../api/support/real.mjs';
import { readImage, encodePng } from '../../../js/compare/index.mjs';
import { createSheet, firstSpec } from '../../../js/sheet/index.mjs';
import { readOptions } from '../../../js/sheet/options.mjs';
import { layOut } from '../../../js/sheet/sheet.mjs';
import { strip } from '../api/support/strip.mjs';
import { judgedFolder } from './judged_folder.mjs';
import { editedGlb } from '../../fixtures/edited_glb.mjs';
import { CHEAP, openSquare, squareModel } from './square.mjs';

const { folder, run } = judgedFolder('sheet');

let renderer;
let model;
before(async () => {
  ({ renderer, model } = await openSquare());
});
after(() => renderer.close());

const sheet = (spec, options = {}) => createSheet(model, spec, { renderer, shot: CHEAP, ...options });

/** Rows and columns of a page that are dark over a long way: [from, to] of each, pixels. */
function darkExtent({ width, height, data }) {
  const isDark = (x, y) => data[4 * (y * width + x)] < 128;
  const rows = new Uint32Array(height);
  for (let y = 0; y < height; ++y) for (let x = 0; x < width; ++x) rows[y] += isDark(x, y);
  const row = rows.indexOf(Math.max(...rows.map((dark, y) => (rows.slice(y, y + 200).every((each) => each > 400) ? dark : 0))));
  const line = (length, at) => {
    let [best, run] = [[0, 0], 0];
    for (let i = 0; i <= length; ++i) {
      if (i < length && at(i)) run += 1;
      else {
        if (run > best[1] - best[0]) best = [i - run, i];
        run = 0;
      }
    }
    return best;
  };
  const [left, right] = line(width, (x) => isDark(x, row + 100));
  const middle = Math.round((left + right) / 2);
  const [top, bottom] = line(height, (y) => isDark(middle, y));
  return { width: right - left, height: bottom - top };
}

/** Millimetres of the square on paper in a PNG of a page. */
async function measured(png, ppi) {
  const extent = darkExtent(await readImage(png));
  return { width: (extent.width * 25.4) / ppi, height: (extent.height * 25.4) / ppi };
}

const TRUE = {
  views: [{ name: 'front', view: 'front', scale: '1:2' }],
  ppi: 300,
  callouts: [{ point: [0.12, 0.2, 0], text: 'off the middle' }],
  paper: { size: 'A3' },
};

test('300 mm are 150 mm at 1:2, within 0.2 mm at 300 ppi, in PDF, PNG and SVG', async () => {
  const isTrue = ({ width, height }, name) => assert.ok(Math.abs(width - 150) <= 0.2 && Math.abs(height - 150) <= 0.2, `${name}: ${width} x ${height} mm`);
  writeFileSync(path.join(folder, 'true.pdf'), (await sheet(TRUE)).files[0]);
  run('pdftoppm', '-r', '300', '-f', '2', '-l', '2', '-png', '-singlefile', 'true.pdf', 'true');
  isTrue(await measured(readFileSync(path.join(folder, 'true.png')), 300), 'PDF');
  isTrue(await measured((await sheet(TRUE, { format: 'png' })).files[1], 300), 'PNG');
  const svg = (await sheet(TRUE, { format: 'svg' })).files[1].toString();
  assert.match(svg, /^<svg [^>]*width="420mm" height="297mm"/);
  const { Resvg } = await import('@resvg/resvg-js');
  isTrue(await measured(new Resvg(svg, { fitTo: { mode: 'width', value: Math.round((420 / 25.4) * 300) } }).render().asPng(), 300), 'SVG');
  // A page that is 1 % too large is seen.
  const wrong = await measured(new Resvg(svg, { fitTo: { mode: 'width', value: Math.round((424.2 / 25.4) * 300) } }).render().asPng(), 300);
  assert.throws(() => isTrue(wrong, 'planted'));
});

test('a scale that does not fit is refused with one that does', async () => {
  await assert.rejects(sheet({ ...TRUE, views: [{ name: 'front', scale: '1:1' }], paper: { size: 'A4' } }), {
    code: 'E_SPEC',
    pointer: '/views/0/scale',
    message: /^spec\.views\[0\]\.scale: expected a scale at which 300 x 300 mm fit into 1\d\d x 1\d\d mm of this paper, such as "1:2\.5", got "1:1"$/,
  });
});

const FULL = {
  language: 'es',
  header: { style: 'T-1', name: 'Prueba', sizes: ['S', 'M'], baseSize: 'M', author: 'A. Autora', brand: 'Telar' },
  callouts: [
    { point: [0.1, 0.4, 0], text: 'first call-out #read("/etc/passwd") *bold* $x^2$ @cite \\ #panic()' },
    { picture: [0.2, 0.9], text: 'Ωmega жук ñandú' },
    { node: 'square', text: 'a node' },
    { material: 'black', view: 'back', text: 'a material' },
  ],
  details: [{ title: 'Corner', point: [0.15, 0.45, 0], text: 'sharp' }],
  anchors: { a: [-0.15, 0.15, 0], b: [0.15, 0.15, 0] },
  measures: [
    { code: 'A', description: 'width', points: ['a', 'b'], tolerance: 0.5, values: { M: 30.2 }, grade: 2 },
    { code: 'B', description: 'diagonal', points: ['a', [0.15, 0.45, 0]], along: 'surface', tolerance: 0.5, values: { M: 40 } },
    { code: 'C', description: 'not on the model' },
    { code: 'D', description: 'border', border: true, part: { material: 'black' } },
  ],
  colourways: [{ name: 'Noche', swatches: [{ name: 'negro', color: 'black' }] }],
  bill: Array.from({ length: 60 }, (_, i) => ({ item: `material ${i}`, colours: { Noche: `negro ${i}` }, color: 'teal' })),
  construction: [{ part: 'side', stitch: '504' }],
  labels: [{ name: 'main', text: 'woven' }],
  care: { symbols: ['wash-30-mild', 'iron-no'], text: 'gently' },
  artwork: [{ name: 'Badge', image: 'badge.png', width: 5, technique: 'embroidery' }],
  notes: 'line one\nline two',
  revisions: [{ revision: 'A', text: 'first' }],
};

const badge = () => encodePng({ width: 4, height: 2, data: new Uint8Array(32).fill(200) });
const FULL_OPTIONS = { resolve: async (name) => (name === 'badge.png' ? badge() : null) };

test('the PDF is PDF/UA-1, whole, in the reading order, and holds every text', async () => {
  const { files, info } = await sheet(FULL, { ...FULL_OPTIONS, previous: { ...FULL, bill: FULL.bill.slice(1) } });
  writeFileSync(path.join(folder, 'full.pdf'), files[0]);
  assert.doesNotMatch(run('qpdf', '--check', 'full.pdf'), /WARNING|ERROR/);
  const facts = run('pdfinfo', 'full.pdf');
  assert.match(facts, /^Tagged: +yes$/m);
  assert.match(facts, /^Title: +Ficha técnica: T-1 Prueba$/m);
  assert.match(facts, /^Author: +A\. Autora$/m);
  assert.doesNotMatch(facts, /CreationDate/);
  assert.match(run('pdfinfo', '-meta', 'full.pdf'), /pdfuaid:part>1</);
  for (const line of run('pdffonts', 'full.pdf').trim().split('\n').slice(2)) assert.match(line, /Inter.* yes yes yes /);
  const text = run('pdftotext', '-layout', 'full.pdf', '-').replaceAll(/\s+/g, ' ');
  const told = [
    'first call-out #read("/etc/passwd") *bold* $x^2$ @cite \\ #panic()',
    'Ωmega жук ñandú',
    'a node',
    'a material',
    'Corner',
    'sharp',
    'diagonal',
    'not on the model',
  ];
  for (const each of [...told, 'Noche', 'negro 59', 'embroidery', 'gently', 'line one', 'line two', 'Puntos de medida', 'Lavar a 30 °C, suave']) {
    assert.ok(text.includes(each) || text.includes(each.slice(0, 20)), each);
  }
  for (const { item } of FULL.bill) assert.ok(text.includes(`${item} `), item);
  // The head of a table is repeated where it breaks.
  const pages = Number(/^Pages: +(\d+)$/m.exec(facts)[1]);
  const billPages = Array.from({ length: pages }, (_, i) => run('pdftotext', '-layout', '-f', String(i + 1), '-l', String(i + 1), 'full.pdf', '-')).filter(
    (page) => /material \d/.test(page),
  );
  assert.ok(billPages.length > 1);
  for (const page of billPages) assert.match(page, /Artículo/);
  // Straight and along a flat cloth alike: 300 mm and its diagonal; a border of 4 sides.
  const lengths = Object.fromEntries(info.measures.map(({ code, millimetres }) => [code, millimetres]));
  assert.ok(Math.abs(lengths.A - 300) < 0.1 && Math.abs(lengths.B - 300 * Math.SQRT2) < 0.1 && Math.abs(lengths.D - 1200) < 0.1, JSON.stringify(lengths));
  assert.match(text, /A width 0\.5 28\.2 30\.2 30\.0 −0\.2/);
  assert.match(text, /B diagonal 0\.5 40\.0 42\.4 \+2\.4/);
});

test('the same spec gives the same bytes; PNG and SVG have the pages of the PDF', async () => {
  const [first, again] = [await sheet(FULL, FULL_OPTIONS), await sheet(FULL, FULL_OPTIONS)];
  assert.ok(first.files[0].equals(again.files[0]));
  writeFileSync(path.join(folder, 'again.pdf'), first.files[0]);
  const pages = Number(/^Pages: +(\d+)$/m.exec(run('pdfinfo', 'again.pdf'))[1]);
  const svg = await sheet({ ...FULL, ppi: 72 }, { ...FULL_OPTIONS, format: 'svg' });
  const png = await sheet({ ...FULL, ppi: 72 }, { ...FULL_OPTIONS, format: 'png' });
  assert.deepEqual([svg.files.length, png.files.length], [pages, pages]);
  const { width, height } = await readImage(png.files[0]);
  assert.deepEqual([width, height], [842, 595]);
});

test('what was measured is what the model has, in every unit', async () => {
  const spec = { ...FULL, units: 'cm', printedUnits: 'inch', artwork: [], bill: [] };
  writeFileSync(path.join(folder, 'inch.pdf'), (await sheet(spec)).files[0]);
  const text = run('pdftotext', '-layout', 'inch.pdf', '-').replaceAll(/\s+/g, ' ');
  // 30.2 cm are 11 14/16 in, 30 cm 11 13/16.
  assert.match(text, /A width 3\/16 11 1\/8 11 7\/8 11 13\/16 −1\/16/);
});

test('lengths of the spec stand as they are given in columns of as many decimals, and what is printed as another length is told', async () => {
  const header = { sizes: ['S', 'M', 'L'], baseSize: 'M' };
  const measures = [
    { code: 'A', description: 'graded', tolerance: 0.25, values: { M: 50 }, grade: 0.25 },
    { code: 'B', description: 'third', tolerance: 1, values: { S: 1 / 3, L: 12.5 } },
  ];
  const artwork = [{ name: 'Print', width: 7.55, height: 0.1234 }];
  const { layout, sections, engine } = await layOut(model, { header, measures, artwork }, readOptions({ renderer, shot: CHEAP }));
  engine.close();
  const rows = sections.find(({ kind }) => kind === 'table').rows.map(({ cells }) => cells.map((cell) => cell.text ?? cell));
  assert.deepEqual(rows, [
    ['A', 'graded', '0.25', '49.750', '50.000', '50.250'],
    ['B', 'third', '1.00', '0.333', '', '12.500'],
  ]);
  const [print] = sections.find(({ kind }) => kind === 'artwork').prints;
  assert.deepEqual(
    print.facts.map(([, value]) => value),
    ['7.55', '0.123'],
  );
  assert.deepEqual(layout.warnings, [
    { code: 'W_SHEET_ROUND', message: 'spec.measures[1].values.S: 0.3333333333333333 cm is printed as 0.333 cm', pointer: '/measures/1/values/S' },
    { code: 'W_SHEET_ROUND', message: 'spec.artwork[0].height: 0.1234 cm is printed as 0.123 cm', pointer: '/artwork/0/height' },
  ]);
});

test('a call-out outside of its view, a part that is not there, an image that is not there are named', async () => {
  const refused = (spec, code, pointer, options) => assert.rejects(sheet(spec, options), { code, pointer });
  await refused({ callouts: [{ point: [5, 0, 0], text: 'far' }] }, 'E_SPEC', '/callouts/0');
  await refused({ callouts: [{ node: 'sleeve', text: 'none' }] }, 'E_SPEC', '/callouts/0/node');
  await refused({ header: { logo: 'x.png' } }, 'E_SPEC', '/header/logo');
  await refused({ header: { logo: 'x.png' } }, 'E_SPEC', '/header/logo', { resolve: () => null });
  await refused({ header: { logo: 'x.png' } }, 'E_IMAGE_FORMAT', '/header/logo', { resolve: () => new Uint8Array(50) });
  await assert.rejects(sheet({ bill: [{ item: 'yarn', image: 'x.png' }] }), {
    pointer: '/bill/0/image',
    message: 'spec.bill[0].image: there is no image "x.png"; give the option resolve',
  });
  await refused({ notes: '袖' }, 'E_SPEC', '/notes');
  await refused({ measures: [{ code: 'A', description: 'a', border: true, part: { node: 'sleeve' } }] }, 'E_MEASURE', '/measures/0');
  await assert.rejects(sheet({}, { template: 'x' }), { code: 'E_OPTION' });
  await assert.rejects(createSheet(model, {}, {}), { code: 'E_OPTION', message: /options\.renderer/ });
});

test('a name of the model that no font has is refused where it is printed', async () => {
  const file = JSON.parse(strip());
  file.scenes[0].name = '袖';
  const named = await renderer.load(Buffer.from(JSON.stringify(file)));
  const made = (header) => createSheet(named, { header, ppi: 36 }, { renderer, shot: CHEAP });
  await assert.rejects(made({}), {
    code: 'E_SPEC',
    pointer: '/header/name',
    message: /^the name of the model, in place of spec\.header\.name: no font has U\+8896 "袖"/,
  });
  assert.equal((await made({ style: 'TL-01' })).files.length, 1);
});

test('a logo that is a bomb is refused by the limits of images', async () => {
  // 30000 x 30000 pixels in a few hundred bytes: the header alone says so.
  const png = await encodePng({ width: 1, height: 1, data: new Uint8Array([1, 2, 3, 255]) });
  const bomb = Buffer.from(png);
  bomb.writeUInt32BE(30000, 16);
  bomb.writeUInt32BE(30000, 20);
  await assert.rejects(
    sheet({ header: { logo: 'bomb.png' } }, { resolve: () => bomb }),
    ({ code, pointer }) => /^(L_IMAGE|E_IMAGE)/.test(code) && pointer === '/header/logo',
  );
});

test('many call-outs take further pages; a text of a whole page becomes a note; nothing is lost', async () => {
  const callouts = Array.from({ length: 120 }, (_, i) => ({
    point: [((i * 37) % 29) / 100 - 0.14, 0.16 + ((i * 17) % 28) / 100, 0],
    text: `call-out number ${i} ${'word '.repeat(i % 12)}end${i}.`,
  }));
  callouts.push({ point: [0, 0.3, 0], text: `long ${'words and more '.repeat(240)} endlong` });
  const { files } = await sheet({ callouts, ppi: 72 });
  writeFileSync(path.join(folder, 'many.pdf'), files[0]);
  const text = run('pdftotext', 'many.pdf', '-').replaceAll(/\s+/g, ' ');
  for (let i = 0; i < 120; ++i) assert.ok(text.includes(`end${i}.`), `call-out ${i}`);
  assert.ok(text.includes('endlong') && text.includes('see the notes'));
});

test('a spec made from the model alone gives a sheet', async () => {
  const { files, info } = await sheet(firstSpec(model.facts, { name: 'square' }));
  assert.equal(files[0].subarray(0, 5).toString(), '%PDF-');
  assert.deepEqual(
    info.measures.map(({ code, millimetres }) => [code, Math.round(millimetres)]),
    [
      ['A', 300],
      ['B', 300],
    ],
  );
});

test('a template of one’s own is found by name, and says what is wrong with it', async () => {
  const own = path.join(folder, 'own');
  run('cp', '-r', new URL('../../../js/sheet/template', import.meta.url).pathname, own);
  writeFileSync(
    path.join(own, 'sheet.typ'),
    '#set document(title: "own")\n#set text(font: "Inter", lang: "en")\n#let sheet = json(bytes(sys.inputs.sheet))\n= My own\n#sheet.head.name',
  );
  const spec = { template: 'own', header: { name: 'Named' } };
  writeFileSync(path.join(folder, 'own.pdf'), (await sheet(spec, { templates: { own } })).files[0]);
  assert.match(run('pdftotext', 'own.pdf', '-'), /My own\s+Named/);
  await assert.rejects(sheet(spec), { code: 'E_SPEC', pointer: '/template' });
  writeFileSync(path.join(own, 'sheet.typ'), '#nothing');
  await assert.rejects(sheet(spec, { templates: { own } }), { code: 'X_SHEET', message: /unknown variable: nothing/ });
  writeFileSync(path.join(own, 'sheet.typ'), '#read("../full.pdf")');
  await assert.rejects(sheet(spec, { templates: { own } }), { code: 'X_SHEET' });
});

test('a signal stops the work', async () => {
  const stop = new AbortController();
  stop.abort(new Error('enough'));
  await assert.rejects(sheet(FULL, { ...FULL_OPTIONS, signal: stop.signal }), /enough/);
});

test('where Typst is not installed, the error says what to install', () => {
  const script = `
    import { register } from 'node:module';
    register('data:text/javascript,' + encodeURIComponent("export async function resolve(name, context, next) { if (name.startsWith('@myriaddreamin')) throw new Error('not found'); return next(name, context); }"));
    const { Engine, bundledFonts } = await import('${new URL('../../../js/sheet/engine.mjs', import.meta.url).href}');
    await Engine.create({ fonts: await bundledFonts() }).catch((error) => console.log(error.code, error.message));`;
  const { stdout } = spawnSync(process.execPath, ['--input-type=module', '-e', script], { encoding: 'utf8' });
  assert.match(stdout, /^X_LIBRARY_MISSING .*npm install @myriaddreamin\/typst-ts-node-compiler/);
});

test('a sheet without a name is set: cleared names fall through to what there is, and to the words of the sheet', async () => {
  const titleOf = async (garment, spec) => {
    const { sections, engine } = await layOut(garment, spec, readOptions({ renderer, shot: CHEAP }));
    engine.close();
    return sections[0].title;
  };
  assert.equal(await titleOf(model, { header: { name: '', style: 'TL-01' } }), 'TL-01');
  assert.equal(await titleOf(model, { header: { name: '', style: '' } }), 'Tech sheet');
  const spec = firstSpec(model.facts);
  assert.equal(spec.header.name, '');
  const { files } = await sheet({ ...spec, words: { measures: '', 'alt.view': '{name}', 'alt.flat': '' }, bill: [{ item: 'Jersey' }] });
  assert.equal(files[0].subarray(0, 5).toString(), '%PDF-');
  const named = await renderer.load(editedGlb(await squareModel(), (json) => (json.scenes[0].name = `${'long '.repeat(40)}\nname`)));
  assert.equal(await titleOf(named, {}), `${'long '.repeat(24).trim()}…`);
});

test('a place in the picture is one of the picture that is printed, to its corners, on every paper', async () => {
  const places = [
    [0.02, 0.02],
    [0.5, 0.5],
    [0.3, 0.9],
    [1, 1],
    [1e-6, 1],
  ];
  for (const size of ['A3', 'A4']) {
    const spec = {
      header: { style: 'TL-01' },
      paper: { size },
      callouts: places.map((picture, i) => ({ text: `${i + 1}`, picture })),
      details: places.map((picture, i) => ({ title: `${i + 1}`, picture, size: 0.02 })),
    };
    const { sections, engine } = await layOut(model, spec, readOptions({ renderer, shot: CHEAP }));
    engine.close();
    const figuresOf = (key) => sections.map(({ figure }) => figure).filter((figure) => figure?.[key].length > 0);
    const partsOf = (figure, [x, y]) => {
      const [picture] = figure.pictures;
      return [(x - picture.x) / picture.width, (y - picture.y) / picture.height];
    };
    const called = figuresOf('sites').flatMap((figure) => figure.sites.map((site) => partsOf(figure, site)));
    const ringed = figuresOf('rings').flatMap((figure) => figure.rings.map((ring) => partsOf(figure, [ring.x + ring.width / 2, ring.y + ring.height / 2])));
    for (const found of [called, ringed]) {
      assert.equal(found.length, places.length);
      // Sums of doubles.
      for (const place of places)
        assert.ok(
          found.some((at) => Math.hypot(at[0] - place[0], at[1] - place[1]) < 1e-9),
          `${place} among ${found} on ${size}`,
        );
    }
  }
});

test('colourways and sizes may have the names of JavaScript’s own properties', async () => {
  for (const name of ['constructor', 'toString', 'hasOwnProperty', 'valueOf', '__proto__']) {
    const isKey = name !== '__proto__';
    const spec = {
      header: { style: 'TL-01', sizes: [name], baseSize: name },
      words: { 'alt.logo': '{constructor}{brand}' },
      colourways: [{ name, swatches: [{ name: 'Red', color: '#f00' }] }],
      bill: [{ item: 'Jersey' }, { item: 'Rib', colours: isKey ? { [name]: 'Scarlet' } : {} }],
      measures: [{ code: 'A', description: 'a', values: isKey ? { [name]: 40 } : {} }],
    };
    const { sections, engine, layout } = await layOut(model, spec, readOptions({ renderer, shot: CHEAP }));
    engine.close();
    const cellsOf = (title) => sections.find((section) => section.title === title).rows.map(({ cells }) => cells.slice(1));
    assert.deepEqual(cellsOf('Bill of materials'), isKey ? [[''], ['Scarlet']] : [[], []], name);
    assert.deepEqual(cellsOf('Measurements')[0].at(-1), { kind: 'strong', text: isKey ? '40.0' : '' }, name);
    assert.equal(layout.words('alt.logo', { brand: 'Telar' }), 'Telar');
    await sheet(spec, { format: 'svg' });
  }
});
