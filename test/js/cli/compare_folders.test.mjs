import assert from 'node:assert/strict';
import { existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import '../api/support/real.mjs';
import { encodePng } from '../../../js/compare/index.mjs';
import { draw, flat, square, withPixel } from '../compare/support.mjs';
import { runFake } from './fake.mjs';

// telar compare: two folders, thresholds, masks, sizes, hints, --update.

const root = mkdtempSync(path.join(tmpdir(), 'telar-folders-'));
after(() => rmSync(root, { recursive: true }));
const pngs = {};
before(async () => {
  const scaled = (image, factor) =>
    draw(image.width * factor, image.height * factor, (x, y) => {
      const i = (Math.floor(y / factor) * image.width + Math.floor(x / factor)) * 4;
      return image.data.subarray(i, i + 4);
    });
  const images = {
    square: square(32),
    grey: square(32, 101),
    spot: withPixel(square(32), 16, 16, [255, 0, 0, 255]),
    twice: scaled(square(32), 2),
    wide: flat(40, 32, [0, 0, 0, 255]),
    onWhite: draw(32, 32, (x, y) => (Math.min(x, y) >= 4 && Math.max(x, y) < 28 ? [100, 100, 100, 255] : [255, 255, 255, 255])),
    black: flat(32, 32, [0, 0, 0, 255]),
    middle: draw(32, 32, (x, y) => (Math.hypot(x - 16, y - 16) < 4 ? [255, 255, 255, 255] : [0, 0, 0, 255])),
  };
  for (const [name, image] of Object.entries(images)) pngs[name] = await encodePng(image);
});

let folders = 0;
/** Fresh folders with files by path; a function that makes paths beside them. */
function tree(files) {
  const folder = path.join(root, String(++folders));
  mkdirSync(folder);
  for (const [name, data] of Object.entries(files)) {
    mkdirSync(path.dirname(path.join(folder, name)), { recursive: true });
    writeFileSync(path.join(folder, name), data);
  }
  return (...names) => path.join(folder, ...names);
}

const compare = (...argv) => runFake(['compare', ...argv]);
const json = async (...argv) => {
  const { exit, stdout } = await compare(...argv, '--json');
  const result = JSON.parse(stdout);
  assert.equal(result.exit, exit);
  assert.equal(result.ok, exit === 0);
  return result;
};

/** Two folders with one image of each kind. */
const season = () =>
  tree({
    'e/same.png': pngs.square,
    'a/same.png': pngs.square,
    'e/x/over.png': pngs.square,
    'a/x/over.png': pngs.spot,
    'e/gone.png': pngs.square,
    'a/fresh.png': pngs.grey,
    'e/notes.txt': '',
    'a/.hidden.png': 'x',
  });

test('images of one name are compared: one report, one JUnit, each with its status', async () => {
  const at = season();
  const report = await json(at('e'), at('a'), '--gate', 'parity', '--report', at('report'), '--junit', at('junit.xml'));
  assert.equal(report.exit, 1);
  assert.deepEqual(
    report.pictures.map(({ name, status, ok }) => [name, status, ok]),
    [
      ['fresh.png', 'new', false],
      ['gone.png', 'missing', false],
      ['same.png', 'within', true],
      ['x/over.png', 'over', false],
    ],
  );
  assert.deepEqual(report.counts, { new: 1, missing: 1, within: 1, over: 1 });
  assert.equal(report.pictures[3].interior.max, 155);
  const page = readFileSync(at('report/index.html'), 'utf8');
  assert.match(page, /3 of 4 not within the gate &#34;parity&#34;/);
  const links = [...page.matchAll(/<img src="([^"]+)"/g)].map(([, file]) => file);
  assert.deepEqual(links.sort(), [
    'pictures/fresh.png/actual.png',
    'pictures/gone.png/expected.png',
    ...['actual', 'expected', 'heatMap'].map((kind) => `pictures/x/over.png/${kind}.png`),
  ]);
  for (const link of links) assert.ok(existsSync(at('report', link)), link);
  const anchors = [...page.matchAll(/href="#([^"]+)"/g)].map(([, anchor]) => decodeURIComponent(anchor));
  assert.equal(anchors.length, 3);
  for (const anchor of anchors) assert.ok(page.includes(`id="${anchor}"`), anchor);
  assert.doesNotMatch(page, /<script|https?:/);
  const junit = readFileSync(at('junit.xml'), 'utf8');
  assert.equal(junit.match(/<testsuite /g).length, 4);
  assert.match(junit, /<testsuite name="x\/over\.png \(parity\)" tests="3" failures="2">/);
  assert.match(junit, /<testsuite name="gone\.png" tests="1" failures="1" errors="0">[\s\S]*there is no actual image: draw it/);
});

test('the text names what a person must look at', async () => {
  const at = season();
  const { exit, stdout } = await compare(at('e'), at('a'), '--gate', 'exact');
  assert.equal(exit, 1);
  assert.equal(
    stdout,
    [
      'new      fresh.png: there is no expected image: --update accepts it',
      'missing  gone.png: there is no actual image: draw it, or delete the expected one',
      'over     x/over.png: frame max 155/255, at most 0/255',
      '4 images: 1 new, 1 missing, 1 within the gate, 1 over it (gate exact)\n',
    ].join('\n'),
  );
});

test('all within: exit 0', async () => {
  const at = tree({ 'e/1.png': pngs.square, 'a/1.png': pngs.square, 'e/2.png': pngs.black, 'a/2.png': pngs.black });
  assert.deepEqual((await json(at('e'), at('a'))).counts, { within: 2 });
});

test('an image that is damaged does not lose the others, and is not accepted', async () => {
  const at = tree({
    'e/1.png': pngs.square,
    'a/1.png': 'no image',
    'e/2.png': pngs.square,
    'a/2.png': pngs.square,
    'a/3.png': 'no image',
    'e/4.png': pngs.square,
    'a/4.png': pngs.wide,
  });
  const { exit, stderr } = await compare(at('e'), at('a'), '--update', '--junit', at('junit.xml'));
  assert.equal(exit, 3);
  assert.equal(stderr.match(/E_IMAGE_FORMAT/g).length, 2);
  assert.match(stderr, /differ in size: 32x32 expected, 40x32 given; their shapes differ/);
  assert.deepEqual(readFileSync(at('e/1.png')), pngs.square);
  assert.ok(!existsSync(at('e/3.png')));
  assert.match(readFileSync(at('junit.xml'), 'utf8'), /<testsuite name="1\.png" tests="1" failures="0" errors="1">/);
});

test('--update accepts what is over the gate and what is new, and nothing else', async () => {
  const at = season();
  const before = readFileSync(at('e/same.png'));
  writeFileSync(at('a/same.png'), await encodePng(square(32), {})); // other bytes would do as well
  const first = await json(at('e'), at('a'), '--update', '--gate', 'parity');
  assert.deepEqual([first.exit, first.counts], [1, { updated: 2, missing: 1, within: 1 }]);
  assert.deepEqual(readFileSync(at('e/x/over.png')), pngs.spot);
  assert.deepEqual(readFileSync(at('e/fresh.png')), pngs.grey);
  assert.deepEqual(readFileSync(at('e/same.png')), before);
  assert.deepEqual(readdirSync(at('e')).sort(), ['fresh.png', 'gone.png', 'notes.txt', 'same.png', 'x']);
  rmSync(at('e/gone.png'));
  assert.equal((await json(at('e'), at('a'), '--gate', 'exact')).exit, 0);
});

test('--update of two images', async () => {
  const at = tree({ 'e.png': pngs.square, 'a.png': pngs.spot });
  const { exit, stdout } = await compare(at('e.png'), at('a.png'), '--gate', 'exact', '--update');
  assert.deepEqual([exit, readFileSync(at('e.png'))], [0, pngs.spot]);
  assert.match(stdout, /over the gate exact\naccepted: .*e\.png is now .*a\.png\n$/);
  assert.equal((await json(at('e.png'), at('a.png'), '--update')).updated, false);
});

test('--update accepts a first image and a first folder', async () => {
  const at = tree({ 'a.png': pngs.spot, 'a/1.png': pngs.square, 'a/x/2.png': pngs.spot, 'text.png': 'no image' });
  const one = await json(at('new/e.png'), at('a.png'), '--update', '--report', at('r'), '--junit', at('j.xml'));
  assert.deepEqual([one.exit, one.updated, one.checks, readFileSync(at('new/e.png'))], [0, true, [], pngs.spot]);
  assert.match(readFileSync(at('r/index.html'), 'utf8'), /all 1 within the gate[\s\S]*<img src="actual\.png"/);
  assert.ok(existsSync(at('r/actual.png')));
  assert.match(readFileSync(at('j.xml'), 'utf8'), /tests="1" failures="0">\n {4}<testcase classname="[^"]+" name="accepted"\/>/);
  assert.match((await compare(at('f.png'), at('a.png'), '--update')).stdout, /^accepted: .*f\.png is now .*a\.png\n$/);
  const many = await json(at('e'), at('a'), '--update');
  assert.deepEqual([many.exit, many.counts, readFileSync(at('e/x/2.png'))], [0, { updated: 2 }, pngs.spot]);
  for (const [argv, exit, message] of [
    [[at('g.png'), at('text.png'), '--update'], 3, /text\.png: .*E_IMAGE_FORMAT/],
    [[at('g.png'), at('none.png'), '--update'], 3, /none\.png cannot be read \(ENOENT\)/],
    [[at('g.png'), at('a.png')], 3, /g\.png cannot be read \(ENOENT\)/],
    [[at('g'), at('a')], 2, /a is a folder and .*g is not/],
  ]) {
    const { exit: found, stderr } = await compare(...argv);
    assert.equal(found, exit, stderr);
    assert.match(stderr, message);
  }
  assert.ok(!existsSync(at('g.png')) && !existsSync(at('g')));
});

test('what --update accepts is no failure in the JUnit file of two images', async () => {
  const at = tree({ 'e.png': pngs.square, 'a.png': pngs.spot });
  const { exit } = await compare(at('e.png'), at('a.png'), '--gate', 'parity', '--update', '--junit', at('j.xml'));
  assert.equal(exit, 0);
  assert.match(readFileSync(at('j.xml'), 'utf8'), /tests="3" failures="0"/);
});

test('names of files are encoded where the page links to them', async () => {
  const at = tree({ 'e/shirt#2 50%.png': pngs.square, 'a/shirt#2 50%.png': pngs.spot });
  await compare(at('e'), at('a'), '--gate', 'exact', '--report', at('r'));
  const [, link] = /<img src="([^"]+)"/.exec(readFileSync(at('r/index.html'), 'utf8'));
  assert.equal(link, 'pictures/shirt%232%2050%25.png/expected.png');
  assert.ok(existsSync(at('r', decodeURIComponent(link))));
});

test('--threshold moves a limit', async () => {
  const at = tree({ 'e.png': pngs.square, 'a.png': pngs.spot, 'e/1.png': pngs.square, 'a/1.png': pngs.grey });
  const loose = ['--gate', 'parity', '--threshold', 'interior.max=155', '--threshold', 'interior.p999=155'];
  assert.equal((await json(at('e.png'), at('a.png'), ...loose)).exit, 0);
  assert.equal((await json(at('e.png'), at('a.png'), '--gate', 'parity', '--threshold', 'interior.max=154.5')).exit, 1);
  assert.equal((await json(at('e'), at('a'), '--threshold', 'object.max=0')).exit, 1);
  for (const [given, message] of [
    ['interior.max', /expected REGION\.FIGURE=N/],
    ['interior.mx=1', /did you mean interior\.max\?/],
    ['x=1', /expected one of frame, object/],
  ]) {
    const { exit, stderr } = await compare(at('e.png'), at('a.png'), '--threshold', given);
    assert.equal(exit, 2);
    assert.match(stderr, message);
  }
});

test('--ignore leaves areas out, by a picture, a folder of pictures or numbers', async () => {
  const at = tree({
    'e/1.png': pngs.square,
    'a/1.png': pngs.spot,
    'masks/1.png': pngs.middle,
    'nowhere.png': pngs.black,
    'all.png': pngs.onWhite,
    'wide.png': pngs.wide,
  });
  for (const ignore of [at('masks'), at('masks/1.png'), '12,12,8,8', '16,16,1,1'])
    assert.equal((await json(at('e'), at('a'), '--gate', 'exact', '--ignore', ignore)).exit, 0, ignore);
  for (const ignore of [at('nowhere.png'), '17,16,9,9', '0,0,16,16', '40,40,9,9'])
    assert.equal((await json(at('e'), at('a'), '--gate', 'exact', '--ignore', ignore)).exit, 1, ignore);
  const single = [at('e/1.png'), at('a/1.png'), '--gate', 'exact'];
  assert.equal((await json(...single, '--ignore', '0,0,3,3', '--ignore', '16,16,1,1')).frame.pixels, 32 * 32 - 10);
  for (const [ignore, exit, message] of [
    [at('all.png'), 2, /leaves no pixel/],
    [at('masks'), 2, /is a folder: it goes with two folders/],
    [at('wide.png'), 3, /has 40x32 pixels, the images 32x32/],
    [at('none.png'), 3, /none\.png.*cannot be read \(ENOENT\)/],
  ]) {
    const wrong = await compare(...single, '--ignore', ignore);
    assert.equal(wrong.exit, exit, wrong.stderr);
    assert.match(wrong.stderr, message);
  }
});

test('--mask says where the object is', async () => {
  const at = tree({ 'e.png': pngs.onWhite, 'a.png': pngs.onWhite, 'mask.png': pngs.square });
  assert.deepEqual(
    [(await json(at('e.png'), at('a.png'))).edge, (await json(at('e.png'), at('a.png'), '--mask', at('mask.png'))).edge.pixels > 100],
    [null, true],
  );
});

test('a screenshot of a dense screen: the error says --resize, and that compares', async () => {
  const at = tree({ 'e.png': pngs.square, 'a.png': pngs.twice });
  const refused = await compare(at('e.png'), at('a.png'));
  assert.equal(refused.exit, 3);
  assert.match(refused.stderr, /32x32 expected, 64x64 given; the actual one is 2 times as large, as screenshots of dense screens are: --resize shrinks it/);
  for (const pair of [
    ['e.png', 'a.png'],
    ['a.png', 'e.png'],
  ])
    assert.equal((await json(...pair.map((name) => at(name)), '--resize', '--gate', 'exact')).exit, 0);
});

test('a hint where the background explains the difference, in the text, JSON, page and JUnit', async () => {
  const at = tree({ 'e/1.png': pngs.square, 'a/1.png': pngs.onWhite });
  const words = /the expected picture is transparent where the actual one shows #ffffff: draw both on one background/;
  assert.match((await compare(at('e/1.png'), at('a/1.png'))).stdout, new RegExp(`^hint    ${words.source}$`, 'm'));
  assert.match((await compare(at('e'), at('a'), '--report', at('r'), '--junit', at('j.xml'))).stdout, new RegExp(`^ +hint: ${words.source}$`, 'm'));
  const {
    pictures: [{ hints }],
  } = await json(at('e'), at('a'));
  assert.deepEqual(
    hints.map(({ cause }) => cause),
    ['background'],
  );
  for (const file of ['r/index.html', 'j.xml']) assert.match(readFileSync(at(file), 'utf8'), words);
});

test('halves and empty folders are told', async () => {
  const at = tree({ 'e/1.png': pngs.square, 'a.png': pngs.square, 'empty/notes.txt': '' });
  for (const [argv, message] of [
    [[at('e'), at('a.png')], /e is a folder and .*a\.png is not: give two images or two folders/],
    [[at('a.png'), at('e')], /e is a folder and .*a\.png is not/],
    [[at('e'), '--model', 'x.glb'], /is a folder: --model draws the shot of one image/],
    [[at('a.png'), '--model', 'x.glb', '--update'], /--update accepts ACTUAL/],
    [[at('e'), at('e'), '--heatmap', at('h.png')], /--heatmap is of two images/],
    [[at('e'), at('e'), '--explain'], /--explain draws .* it goes with --model/],
    [[at('e'), at('e'), '--environment', 'x.hdr'], /--environment goes with --model/],
    [[at('a.png'), at('a.png'), '--environment', 'x.hdr'], /--environment goes with --model/],
    [[at('empty'), at('empty')], /hold no PNG, JPEG or WebP/],
  ]) {
    const { exit, stderr } = await compare(...argv);
    assert.equal(exit, 2, stderr);
    assert.match(stderr, message);
  }
});
