import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import '../api/support/real.mjs';
import { plane } from '../../fixtures/geometry.mjs';
import { GlbBuilder } from '../../fixtures/glb.mjs';
import { jacket } from '../../fixtures/garments/index.mjs';
import { png } from '../../fixtures/images.mjs';
import { createRenderer } from '../../../js/index.mjs';
import { readColourList } from '../../../js/sheet/colour_list.mjs';
import { LIGHTS, nearestColours } from '../../../js/sheet/colour.mjs';
import { createSheet, firstSpec } from '../../../js/sheet/index.mjs';
import { layOut } from '../../../js/sheet/sheet.mjs';
import { CHEAP } from './square.mjs';

const near = (actual, expected, tolerance) =>
  assert.ok(
    actual.every((value, i) => Math.abs(value - expected[i]) <= tolerance),
    `${actual} is not ${expected}`,
  );

// CSS Color 4 prints the primaries of sRGB as lab() colours, which are of D50, with 2 digits; D65 as in Bruce Lindbloom's calculator.
test('primaries of sRGB in CIE Lab under two lights', () => {
  const primaries = [
    [
      [1, 0, 0],
      [54.29, 80.8, 69.89],
      [53.24, 80.09, 67.2],
    ],
    [
      [0, 1, 0],
      [87.82, -79.27, 80.99],
      [87.74, -86.18, 83.18],
    ],
    [
      [0, 0, 1],
      [29.57, 68.29, -112.03],
      [32.3, 79.19, -107.86],
    ],
    [
      [1, 1, 1],
      [100, 0, 0],
      [100, 0, 0],
    ],
  ];
  // The whites of ICC and of CSS differ in their fourth digits, which is 0.02 of Lab.
  for (const [linear, d50, d65] of primaries) {
    near(LIGHTS.D50(linear), d50, 0.05);
    near(LIGHTS.D65(linear), d65, 0.05);
  }
  // Planted: Lab of the other light is no answer.
  assert.throws(() => near(LIGHTS.D65([0, 0, 1]), [29.57, 68.29, -112.03], 0.05));
});

const bytes = (text) => new TextEncoder().encode(text);

test('a list of colours is read with and without a heading, with commas and semicolons, and quotes', () => {
  const lists = [
    'Sky,60,-10,-30\n"Sea, ""deep""",30,0,-40',
    'L;a;b;Name\r\n60,0;-10;-30;Sky\r\n30;0;-40;"Sea, ""deep"""\r\n\r\n',
    'code\tname\tL*\ta*\tb*\nx\tSky\t60\t-10\t-30\ny\tSea, "deep"\t30\t0\t-40',
  ];
  for (const list of lists)
    assert.deepEqual(readColourList(bytes(list)), [
      { name: 'Sky', lab: [60, -10, -30] },
      { name: 'Sea, "deep"', lab: [30, 0, -40] },
    ]);
  const wrong = [
    ['', /expected rows/],
    ['name,L,a,b\n', /beneath the heading/],
    ['Sky,60,-10', /line 1: expected a name .* got "Sky,60,-10"/],
    ['a,1,2,3\n\nb,101,0,0', /line 3: .*L in \[0, 100\]/],
    ['a,1,2,x', /line 1/],
    ['"a,1,2,3', /line 1/],
    ['"a"b,1,2,3', /line 1/],
    [`${'x'.repeat(121)},1,2,3`, /line 1/],
    ['a,1,2,3\n'.repeat(50_001), /50001 rows, more than 50000/],
    ['x'.repeat(5 * 2 ** 20), /bytes, more than/],
  ];
  for (const [text, message] of wrong) assert.throws(() => readColourList(bytes(text)), { code: 'E_SPEC', pointer: '/colourList/file', message });
});

test('the nearest colours are those of the light of the list', () => {
  const colours = [
    { name: 'under D50', lab: LIGHTS.D50([0.1, 0.1, 0.5]) },
    { name: 'under D65', lab: LIGHTS.D65([0.1, 0.1, 0.5]) },
    { name: 'white', lab: [100, 0, 0] },
  ];
  for (const light of ['D50', 'D65']) {
    const [first, second, third] = nearestColours([0.1, 0.1, 0.5], { light, colours });
    assert.deepEqual([first.name, first.difference < 1e-9, second.difference > 1, third.name], [`under ${light}`, true, true, 'white']);
  }
});

let renderer;
let model;
before(async () => {
  renderer = await createRenderer();
  const builder = new GlbBuilder();
  // Half of it 0.04 and half 0.64 in linear light: the mean is 0.34, that of the encoded values another.
  const encoded = (x) => 1.055 * x ** (1 / 2.4) - 0.055;
  const image = await png(8, 8, (u, v, x) => [...Array(3).fill(encoded(x % 2 === 0 ? 0.04 : 0.64)), 1]);
  builder.add(plane(0.2, 0.2, { uvScale: 3 }), builder.material({ name: 'striped', textures: { baseColor: { image } } }), {
    name: 'panel',
    translation: [0, 0.2, 0],
  });
  model = await renderer.load(await builder.bytes());
});
after(() => renderer.close());

const SPEC = {
  swatches: [{ title: 'Stripe', material: 'striped' }],
  colourList: { file: 'list.csv', light: 'D65' },
  colourways: [{ name: 'Grey', swatches: [{ part: 'body', material: 'striped' }] }],
};
const list = (mean) => bytes(['grey', 'dark'].map((name, i) => `${name},${(LIGHTS.D65(Array(3).fill(i === 0 ? mean : 0.04))).join(',')}`).join('\n'));
const settings = (rest) => ({ renderer, shot: CHEAP, resolve: async () => list(0.34), ...rest });

test('the colour of a swatch is the mean of the albedo, whatever the light, and is named by the list', async () => {
  const { info } = await createSheet(model, SPEC, settings());
  const { info: lit } = await createSheet(model, SPEC, settings({ shot: { environment: 'studio', exposure: 3, quality: 'draft' } }));
  assert.deepEqual(lit.swatches, info.swatches);
  const [swatch] = info.swatches;
  // 8 bits of a texel are half a step of 1/255 off: 0.002 in linear light.
  near(swatch.labD65, LIGHTS.D65([0.34, 0.34, 0.34]), 0.3);
  assert.deepEqual(
    swatch.nearest.map(({ name }) => name),
    ['grey', 'dark'],
  );
  assert.ok(swatch.nearest[0].difference < 0.3 && swatch.nearest[1].difference > 10);
  // Planted: the mean of the encoded values is not it.
  assert.throws(() => near(swatch.labD65, LIGHTS.D65(Array(3).fill(0.26)), 0.3));
});

test('a colourway takes the colour and the name of a material', async () => {
  const { sections, engine } = await layOut(model, SPEC, settings({ format: 'pdf', fonts: [], templates: {} }));
  engine.close();
  const chip = sections.find(({ kind }) => kind === 'colourways').cells[0].swatches[0];
  assert.deepEqual([chip.name, chip.part, sections[0].chips[0].colours], ['grey', 'body', [chip.colour]]);
  assert.match(chip.colour, /^#9e9e9e|#9d9d9d$/);
  const cell = sections.find(({ kind }) => kind === 'swatches').cells[0];
  // 10 cm at 1:2.
  assert.ok(cell.pictures.length === 2 && Math.abs(cell.pictures[0].width - 50) < 0.2, JSON.stringify(cell.pictures));
});

test('what is wrong with a swatch is named', async () => {
  const refused = (changes, pointer, rest) => assert.rejects(createSheet(model, { ...SPEC, ...changes }, settings(rest)), { code: 'E_SPEC', pointer });
  await refused({ swatches: [{ title: 'a' }] }, '/swatches/0');
  await refused({ swatches: [{ title: 'a', node: 'panel', material: 'striped' }] }, '/swatches/0');
  await refused({ swatches: [{ title: 'a', material: 'silk' }] }, '/swatches/0/material');
  await refused({ swatches: [{ title: 'a', node: 'panel', variant: 'navy' }] }, '/swatches/0/variant');
  await refused({ swatches: [{ title: 'a', node: 'panel', scale: '2:1' }] }, '/swatches/0/scale');
  await refused({ colourways: [{ name: 'a', swatches: [{ material: 'striped', color: 'red' }] }] }, '/colourways/0/swatches/0');
  await refused({ colourways: [{ name: 'a', swatches: [{ material: 'silk' }] }] }, '/colourways/0/swatches/0/material');
  await refused({}, '/colourList/file', { resolve: () => null });
  await refused({}, '/colourList/file', { resolve: () => bytes('a,b') });
  const named = { resolve: () => bytes('name,L,a,b\n\nSky,60,-10,-30\n袖,50,0,0\n') };
  await assert.rejects(createSheet(model, SPEC, settings(named)), {
    code: 'E_SPEC',
    pointer: '/colourList/file',
    message: 'spec.colourList.file: line 4: no font has U+8896 "袖"; give one that does with the option fonts, --font FILE',
  });
});

test('a first spec has the colours of each variant, the cloth that is most of it first', async () => {
  const garment = await renderer.load(await jacket());
  const { facts } = garment;
  assert.deepEqual(
    facts.variantMaterials.map((list) => list.map((index) => facts.materials[index].name)),
    facts.variants.map((variant) => ['canvas', 'collar', 'button'].map((cloth) => `${cloth}_${variant}`)),
  );
  const { layout, sections, engine } = await layOut(garment, firstSpec(facts), { renderer, shot: CHEAP, format: 'pdf', fonts: [], templates: {} });
  engine.close();
  assert.deepEqual(layout.warnings, []);
  const { cells } = sections.find(({ kind }) => kind === 'colourways');
  const colours = cells.map(({ swatches }) => swatches.map(({ colour }) => colour));
  assert.ok(colours.flat().every((colour) => /^#[0-9a-f]{6}$/.test(colour)));
  // The cloth of each variant is another, and its buttons of horn are one.
  assert.equal(new Set(colours.map(([cloth]) => cloth)).size, 3);
  assert.equal(colours[1][2], colours[2][2]);
});
