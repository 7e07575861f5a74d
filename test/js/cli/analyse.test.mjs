import assert from 'node:assert/strict';
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, test } from 'node:test';
import * as realApi from '../../../js/index.mjs';
import { termsOfRevision, THREE_SLOTS } from '../../../js/shot/three_terms.mjs';
import { assertWellFormed, plantedApi } from '../analyse/support.mjs';
import { runFake } from './fake.mjs';

const folder = mkdtempSync(path.join(tmpdir(), 'telar-analyse-'));
after(() => rmSync(folder, { recursive: true }));

const planted = () => plantedApi((swapped, cosine) => (swapped.has('sheen') && cosine < 0.6 ? 80 : 0) + (swapped.has('diffuse') ? 6 : 0));
const run = (argv, fake = planted(), more = {}) => runFake(['analyse', ...argv], { fake, api: fake.api, ...more });
const SMALL = ['--size', '32', '--lights', 'studio'];

test('the table: the whole difference, then the terms by their effect', async () => {
  const { exit, stdout, stderr, calls } = await run(['--fabrics', 'leather,velvet', ...SMALL]);
  assert.equal(exit, 0, stderr);
  assert.match(stdout, /^disney-2012 against three-r115, all terms:\nleather, studio +FLIP 0\.\d+ +dE00 /);
  const rows = stdout
    .split('\n')
    .filter((line) => /^ *\d+ {2}\w/.test(line))
    .map((line) => line.trim().split(/ {2,}/));
  assert.deepEqual(
    rows.slice(0, 2).map((row) => row.slice(0, 4)),
    [
      ['1', 'sheen', 'charlie-neubelt', 'disney-2012'],
      ['2', 'diffuse', 'lambert', 'disney-2012'],
    ],
  );
  assert.match(rows[0].at(-1), /^much brighter limb/);
  assert.match(stderr, /W_RANGE/);
  assert.equal(calls.closed, 1);
});

test('--json: one object with the ranking and every figure; no pictures', async () => {
  const { stdout } = await run(['--json', ...SMALL, '--fabrics', 'wool']);
  const result = JSON.parse(stdout);
  assert.deepEqual([result.ok, result.exit, result.from.base, result.to.base], [true, 0, 'three-r115', 'disney-2012']);
  assert.deepEqual(
    result.ranking.slice(0, 2).map(({ slot, rank }) => [slot, rank]),
    [
      ['sheen', 1],
      ['diffuse', 2],
    ],
  );
  const [cell] = result.cells;
  assert.deepEqual(
    [cell.target, cell.light, Object.keys(cell.terms).length, cell.terms.diffuse.alone.map],
    ['wool', 'studio', result.ranking.length, undefined],
  );
  assert.equal(cell.terms.fresnel.alone.words, 'no change');
  assert.ok(stdout.length < 60_000);
});

test('--terms lists slots and terms and draws nothing', async () => {
  const { exit, stdout, calls } = await run(['--terms']);
  assert.deepEqual([exit, calls.rendered], [0, 0]);
  assert.match(stdout, /^diffuse\n {2}lambert +in three-r115\n {2}disney-2012 +in disney-2012\n {2}frostbite\n/m);
  const { slots } = JSON.parse((await run(['--terms', '--json'])).stdout);
  assert.ok(slots.sheen.includes('zeltner'));
});

test('--report: one page that needs nothing else, and the figures beside it', async () => {
  const at = path.join(folder, 'page');
  const { stdout } = await run([...SMALL, '--report', at, 'shirt.glb', 'other/shirt.glb']);
  assert.ok(stdout.endsWith(`\n${path.join(at, 'index.html')}\n`));
  assert.deepEqual(readdirSync(at).sort(), ['analysis.json', 'index.html']);
  const page = readFileSync(path.join(at, 'index.html'), 'utf8');
  assertWellFormed(page);
  assert.doesNotMatch(page, /<script|<link|https?:\/\/(?!www\.w3\.org\/2000\/svg)/);
  for (const [, source] of page.matchAll(/src="([^"]{0,22})/g)) assert.equal(source, 'data:image/png;base64,');
  assert.deepEqual(
    [...page.matchAll(/<h3>([^<]+)<\/h3>/g)].map(([, name]) => name),
    ['shirt 1', 'shirt 2', 'shirt 1, studio', 'shirt 2, studio'],
  );
  assert.match(page, /prefers-color-scheme:dark[\s\S]*@media print/);
  assert.ok(page.indexOf('>sheen<br>') > 0 && page.indexOf('>sheen<br>') < page.indexOf('>diffuse<br>'));
  assert.equal(JSON.parse(readFileSync(path.join(at, 'analysis.json'))).cells.length, 2);
});

test('shadings without terms are compared as a whole', async () => {
  const at = path.join(folder, 'whole');
  const { exit, stdout, calls } = await run(['--from', 'three', '--fabrics', 'wool', ...SMALL, '--report', at]);
  assert.deepEqual([exit, calls.rendered], [0, 2]);
  assert.match(stdout, /^disney-2012 against three:\nwool, studio +FLIP 0\.\d+/);
  const page = readFileSync(path.join(at, 'index.html'), 'utf8');
  assertWellFormed(page);
  assert.ok(!page.includes('Which terms') && page.includes('wool: directional albedo'));
});

test('two releases of three.js are compared slot by slot', async () => {
  const { exit, stdout, stderr, calls } = await run(['--from', 'three@185', '--to', 'three@186', '--fabrics', 'wool', '--json', ...SMALL]);
  assert.equal(exit, 0, stderr);
  const { ranking, from, to } = JSON.parse(stdout);
  const differing = Object.keys(THREE_SLOTS).filter((slot) => termsOfRevision(185)[slot] !== termsOfRevision(186)[slot]);
  assert.deepEqual(ranking.map(({ slot }) => slot).sort(), differing.sort());
  assert.deepEqual([from.revision, to.revision], [185, 186]);
  assert.equal(calls.rendered, 2 + 2 * differing.length);
});

test('plain three is the release that it stands for', async () => {
  const { stdout } = await run(['--from', 'three@186', '--to', 'three', '--fabrics', 'wool', ...SMALL]);
  assert.match(stdout, /^three against three@186, all terms:/);
  assert.match(stdout, /roughnessMin +0\.0525 +0\.045/);
});

test('releases without the default tone mapping are shown with one that they have', async () => {
  const { exit, stderr } = await run(['--from', 'three@160', '--to', 'three@180', '--fabrics', 'wool', ...SMALL]);
  assert.equal(exit, 0, stderr);
});

test('wrong usage is exit 2 and says what is expected', async () => {
  for (const [argv, message] of [
    [['--from', 'three', '--to', 'three'], /--to: expected another shading than --from/],
    [['--to', 'three-r115'], /--to: expected a shading that differs/],
    [['--fabrics', 'lether'], /--fabrics: expected some of leather, wool, towel, velvet, got "lether"; did you mean leather\?/],
    [['--lights', 'stdio'], /--lights: .*did you mean studio\?/],
    [['--lights', ','], /--lights: expected names/],
    [['m.glb', '--fabrics', 'wool'], /--fabrics are of the bundled drape/],
    [['--size', 'big'], /--size/],
    [['--view', 'inside'], /camera\.view/],
    [['--quality', 'best'], /quality/],
    [['--from', 'phong'], /shading/],
    [['--from', 'three@'], /--from: expected a release of three\.js as in three@180, got "three@"/],
    [['--from', 'three@187', '--to', 'three'], /--to: expected another shading than --from/],
    [['--from', 'three@170', '--to', 'three@180'], /--to: expected a shading that differs/],
  ]) {
    const { exit, stderr, calls } = await run(argv);
    assert.equal(exit, 2, `${argv}: ${stderr}`);
    assert.match(stderr, message);
    assert.equal(calls.rendered, 0);
  }
});

test('a signal stops it between pictures; nothing is written', async () => {
  const controller = new AbortController();
  const fake = planted();
  fake.renderer.load = async (source) => {
    controller.abort();
    return { source, facts: { materials: [] } };
  };
  const at = path.join(folder, 'never');
  const { exit } = await run(['--report', at, ...SMALL], fake, { signal: controller.signal });
  assert.equal(exit, 5);
  assert.deepEqual([fake.calls.closed, existsSync(at)], [1, false]);
});

test('the real thing: terms of r115 on the bundled velvet', async () => {
  const to = JSON.stringify({ base: 'three-r115', diffuse: 'disney-2012', sheen: 'disney-2012' });
  const { exit, stdout, stderr } = await runFake(
    ['analyse', '--to', to, '--fabrics', 'velvet', '--lights', 'studio', '--size', '64', '--quality', 'draft', '--json'],
    { api: realApi },
  );
  assert.equal(exit, 0, stderr);
  const { ranking, cells } = JSON.parse(stdout);
  assert.deepEqual(ranking.map(({ slot }) => slot).sort(), ['diffuse', 'sheen']);
  assert.ok(ranking[0].effect > 0.005, JSON.stringify(ranking[0].alone));
  assert.ok(cells[0].pixels > 800 && cells[0].all.limb !== null && cells[0].all.centre !== null);
});
