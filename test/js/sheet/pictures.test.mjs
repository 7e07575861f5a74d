import assert from 'node:assert/strict';
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';
import '../api/support/real.mjs';
import { encodePng, readImage } from '../../../js/compare/index.mjs';
import { createSheet } from '../../../js/sheet/index.mjs';
import { layOut } from '../../../js/sheet/sheet.mjs';
import { figureFaults } from './documents.mjs';
import { judgedFolder } from './judged_folder.mjs';
import { CHEAP, openSquare } from './square.mjs';

const { folder, run } = judgedFolder('pictures');

let renderer;
let model;
before(async () => {
  ({ renderer, model } = await openSquare());
});
after(() => renderer.close());

const options = (rest) => ({ renderer, shot: CHEAP, ...rest });
const write = async (name, spec) => writeFileSync(path.join(folder, name), (await createSheet(model, spec, options())).files[0]);

const isDark = ({ width, data }, x, y) => data[4 * (y * width + x)] < 128;

/** First and last dark pixel of a line of a page. */
function ends(length, isDarkAt) {
  const dark = Array.from({ length }, (_, i) => i).filter(isDarkAt);
  return dark.length > 0 ? [dark[0], dark.at(-1)] : [];
}

/** Millimetres between the outer edges of the lines that a level and an upright line through (x, y) meet. */
async function outline(file, ppi, [x, y]) {
  const image = await readImage(readFileSync(file));
  const perPixel = 25.4 / ppi;
  const [px, py] = [Math.round(x / perPixel), Math.round(y / perPixel)];
  const [left, right] = ends(image.width, (i) => isDark(image, i, py));
  // Beneath the rule of the page's head.
  const top = Math.round(24 / perPixel);
  const [high, low] = ends(image.height - top, (i) => isDark(image, px, i + top));
  return [(right - left + 1) * perPixel, (low - high + 1) * perPixel];
}

const FLAT = {
  views: [
    { name: 'front', view: 'front', cover: true },
    { name: 'line', view: 'front', style: 'flat', scale: '1:2' },
  ],
  ppi: 100,
};
/** Of the silhouette on paper, millimetres. */
const LINE = 0.5;

test('a flat is vectors in true scale: 300 mm are 150 mm at 1:2 within 0.2 mm', async () => {
  await write('flat.pdf', { ...FLAT, paper: { size: 'A3' } });
  assert.match(run('pdfinfo', 'flat.pdf'), /Pages: +2/);
  assert.equal(run('pdfimages', '-f', '2', '-l', '2', '-list', 'flat.pdf').trim().split('\n').length, 2, 'no image on the page of the flat');
  run('pdftoppm', '-r', '300', '-f', '2', '-l', '2', '-png', '-singlefile', 'flat.pdf', 'flat');
  const isTrue = (sides) =>
    assert.ok(
      sides.every((side) => Math.abs(side - LINE - 150) <= 0.2),
      `${sides} mm`,
    );
  // A little off the middle of the page, where its caption has no letter.
  const sides = await outline(path.join(folder, 'flat.png'), 300, [180, 150]);
  isTrue(sides);
  assert.throws(() => isTrue(sides.map((side) => 1.01 * side)));
});

test('a scale that a row of flats cannot have is refused; neighbours of one scale share a page where they fit', async () => {
  const views = [0, 180, 360, -180, -360].map((azimuth) => ({ name: `at ${azimuth}`, azimuth, style: 'flat', scale: '1:3', cover: false }));
  const { sections, engine } = await layOut(model, { views: [{ name: 'cover', cover: true }, ...views] }, options({ format: 'pdf', fonts: [], templates: {} }));
  engine.close();
  const figures = sections.filter(({ kind }) => kind === 'figure').map(({ figure }) => figure.pictures.length);
  assert.deepEqual(figures, [2, 2, 1]);
  await assert.rejects(
    createSheet(
      model,
      {
        views: [
          { name: 'cover', cover: true },
          { ...views[0], scale: '1:1' },
        ],
      },
      options(),
    ),
    {
      code: 'E_SPEC',
      pointer: '/views/1/scale',
    },
  );
});

test('each view of a row is whole: a higher one has a page of its own, or is refused', async () => {
  const flat = (view) => ({ style: 'flat', scale: '1:2', cover: false, ...view });
  const [low, high] = [flat({ name: 'low', azimuth: 0, elevation: 80 }), flat({ name: 'high', azimuth: 70 })];
  const figuresOf = async (views) => {
    const { sections, engine } = await layOut(
      model,
      { views: [{ name: 'cover', cover: true }, ...views] },
      options({ format: 'pdf', fonts: [], templates: {} }),
    );
    engine.close();
    const figures = sections.filter(({ kind }) => kind === 'figure').map(({ figure }) => figure);
    assert.deepEqual(figures.flatMap(figureFaults), []);
    return figures.map(({ pictures }) => pictures.length);
  };
  assert.deepEqual(await figuresOf([low, high]), [2]);
  // Beside another the long name has more lines, which leave less room.
  assert.deepEqual(await figuresOf([{ ...low, title: 'a long name '.repeat(9) }, high].map((view) => ({ ...view, scale: '1:1.98' }))), [1, 1]);
  const refused = [low, high].map((view) => ({ ...view, scale: '1:1.8' }));
  await assert.rejects(figuresOf(refused), { code: 'E_SPEC', pointer: '/views/2/scale', message: /expected a scale at which 57 x 167 mm fit into/ });
  // Of one whose scale is to fit, the white around it counts too.
  assert.deepEqual(await figuresOf([flat({ name: 'wide', azimuth: 0, elevation: 88, scale: 'fit' })]), [1]);
});

test('a view in a scale of its own has a page that keeps it, on the first page or not, and all flats stand together', async () => {
  const figuresOf = async (spec) => {
    const { sections, engine } = await layOut(model, spec, options({ format: 'pdf', fonts: [], templates: {} }));
    engine.close();
    return sections.filter(({ kind }) => kind === 'figure').map(({ title, figure }) => [title, ...figure.captions.map(({ note }) => note)]);
  };
  const [front, line] = [
    { name: 'front', scale: '1:3' },
    { name: 'line', style: 'flat' },
  ];
  const back = { name: 'back', view: 'back' };
  assert.deepEqual(await figuresOf({ views: [back, front] }), [['Views', 'Scale 1:3']]);
  assert.deepEqual(await figuresOf({ views: [front], details: [{ title: 'Corner', point: [0.15, 0.45, 0] }] }), [['Views', 'Scale 1:3']]);
  assert.deepEqual(await figuresOf({ views: [front], callouts: [{ point: [0, 0.3, 0], text: 'x' }] }), [['Construction', 'Scale 1:3']]);
  assert.deepEqual(await figuresOf({ views: [front], measures: [{ code: 'A', description: 'a', border: true }] }), [['Points of measure', 'Scale 1:3']]);
  const between = { name: 'between', cover: false };
  assert.deepEqual(await figuresOf({ views: [{ ...back, cover: true }, { ...line, cover: true }, between, { ...line, name: 'other', cover: false }] }), [
    ['Views', 'Scale 1:2'],
    ['Flats', 'Scale 1:2.5', 'Scale 1:2.5'],
  ]);
  assert.deepEqual(await figuresOf({ views: [back, { name: 'front' }] }), []);
  await assert.rejects(figuresOf({ views: [{ ...front, scale: '1:1' }] }), { code: 'E_SPEC', pointer: '/views/0/scale' });
});

test('a part that is to be stitched and is not there is named', async () => {
  const spec = { ...FLAT, flats: { stitched: [{ node: 'hem' }] }, paper: { size: 'A3' } };
  await assert.rejects(createSheet(model, spec, options()), { code: 'E_SPEC', pointer: '/flats/stitched', message: /^spec\.flats\.stitched: .*hem/ });
});

test('artwork is shown whole at its size; sides that are not of its proportions are refused', async () => {
  const resolve = () => encodePng({ width: 400, height: 200, data: new Uint8Array(400 * 200 * 4).fill(200) });
  const print = (sides) => ({ artwork: [{ name: 'Print' }, { name: 'Badge', image: 'badge.png', ...sides }] });
  const imagesOf = async (sides) => {
    const { files } = await createSheet(model, print(sides), { ...options({ resolve }), format: 'svg' });
    const page = files.at(-1).toString();
    assert.doesNotMatch(page, /clip-path/, 'nothing is cut off');
    return [...page.matchAll(/<image [^>]*width="([\d.]+)" height="([\d.]+)"/g)].map(([, ...lengths]) => lengths.map((length) => (Number(length) * 25.4) / 72));
  };
  const isNear = ([width, height], wanted) => assert.ok(Math.abs(width - wanted[0]) < 0.01 && Math.abs(height - wanted[1]) < 0.01, `${width} x ${height} mm`);
  isNear((await imagesOf({ width: 5 }))[0], [50, 25]);
  isNear((await imagesOf({ width: 5, height: 2.51 }))[0], [50, 25.1]);
  await assert.rejects(imagesOf({ width: 5, height: 2.52 }), {
    code: 'E_SPEC',
    pointer: '/artwork/1/height',
    message: 'spec.artwork[1].height: expected 2.5, as the image has 400 x 200 pixels, or no height, got 2.52',
  });
});

/** Pixels of a row that are neither black nor white: of an edge that was drawn at its scale a few, of one that was enlarged many. */
function softness({ width, height, data }) {
  const row = Math.round(height * 0.75);
  return Array.from({ length: width }, (_, x) => data[4 * (row * width + x)]).filter((value) => value > 24 && value < 231).length;
}

/** Enlarged n times by linear interpolation, along rows. */
function enlarged({ width, height, data }, n) {
  const out = new Uint8Array(4 * width * n * height);
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width * n; ++x) {
      const at = Math.min(width - 1.001, x / n);
      const [i, t] = [Math.floor(at), at % 1];
      out[4 * (y * width * n + x)] = data[4 * (y * width + i)] * (1 - t) + data[4 * (y * width + i + 1)] * t;
    }
  return { width: width * n, height, data: out };
}

const DETAIL = {
  views: [{ name: 'front', view: 'front' }],
  details: [{ title: 'Corner', point: [0.15, 0.45, 0], size: 0.08, height: 0.05, shape: 'rectangle', scale: '1:1' }],
  paper: { size: 'A3' },
};

test('a detail is drawn anew at its scale, and its place is marked', async () => {
  await write('detail.pdf', DETAIL);
  run('pdfimages', '-png', 'detail.pdf', 'image');
  const files = readdirSync(folder).filter((file) => /^image.*png$/.test(file));
  const images = await Promise.all(files.map((file) => readImage(readFileSync(path.join(folder, file)))));
  // 80 x 50 mm at 200 ppi.
  const detail = images.find(({ width, height }) => width === 630 && height === 394);
  assert.ok(detail, JSON.stringify(images.map(({ width, height }) => [width, height])));
  // The corner is in the middle: the cloth lies to the left of it and beneath.
  assert.ok(isDark(detail, 313, 200) && !isDark(detail, 317, 200) && !isDark(detail, 313, 194));
  assert.ok(softness(detail) <= 3, `${softness(detail)}`);
  // The view of the first page, enlarged to the scale of the detail.
  assert.ok(softness(enlarged(images[0], 6)) > 3, 'planted: enlarged');
  const { sections, engine } = await layOut(model, DETAIL, options({ format: 'pdf', fonts: [], templates: {} }));
  engine.close();
  const { figure } = sections.find(({ kind }) => kind === 'details');
  const [ring] = figure.rings;
  const [parent] = figure.pictures;
  // The frame's middle is the square's corner: the picture has 1.5 mm of white around, and rounds up to pixels.
  const scale = parent.width - 3;
  assert.ok(Math.abs(ring.x + ring.width / 2 - (parent.x + parent.width - 1.5)) < 0.2 && Math.abs(ring.y + ring.height / 2 - (parent.y + 1.5)) < 0.2);
  assert.ok(Math.abs(ring.width - (scale * 80) / 300) < 0.2 && Math.abs(ring.height - (scale * 50) / 300) < 0.2 && !ring.round);
});

test('a detail that is larger than its page in the scale that it asks for is refused', async () => {
  const large = { ...DETAIL, details: [DETAIL.details[0], { ...DETAIL.details[0], size: 0.3 }], paper: { size: 'A4' } };
  const message = /^spec\.details\[1\]\.scale: expected a scale at which 300 x 50 mm fit into \d+ x \d+ mm beside the view, such as "1:2", got "1:1"$/;
  await assert.rejects(createSheet(model, large, options()), { code: 'E_SPEC', pointer: '/details/1/scale', message });
});

test('a round detail has no height; a detail of a flat is a flat', async () => {
  const round = { ...DETAIL, details: [{ ...DETAIL.details[0], shape: 'circle' }] };
  await assert.rejects(createSheet(model, round, options()), { code: 'E_SPEC', pointer: '/details/0/height' });
  const flat = { ...DETAIL, views: [{ name: 'front', style: 'flat' }], details: [DETAIL.details[0], { ...DETAIL.details[0], style: 'render' }] };
  const { sections, engine } = await layOut(model, flat, options({ format: 'pdf', fonts: [], templates: {} }));
  engine.close();
  const { cells } = sections.find(({ kind }) => kind === 'details');
  assert.deepEqual(
    cells.map(({ picture }) => path.extname(picture.file)),
    ['.svg', '.jpg'],
  );
});
