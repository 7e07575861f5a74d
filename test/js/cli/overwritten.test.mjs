import assert from 'node:assert/strict';
import { linkSync, mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, test } from 'node:test';
import { embedShot, encodePng } from '../../../js/compare/index.mjs';
import { square, withPixel } from '../compare/support.mjs';
import { drewNothing, runFake } from './fake.mjs';

// Nothing that a command reads is written over, and nothing that it writes is lost to another thing that it writes.

const root = mkdtempSync(path.join(tmpdir(), 'telar-overwritten-'));
after(() => rmSync(root, { recursive: true }));
let folders = 0;

/** A fresh folder with files, and a function that makes paths in it. */
function tree(files) {
  const folder = path.join(root, String(++folders));
  const at = (name) => path.join(folder, name);
  mkdirSync(folder);
  for (const [name, content] of Object.entries(files)) {
    mkdirSync(path.dirname(at(name)), { recursive: true });
    writeFileSync(at(name), content);
  }
  return at;
}

/** Refused before anything is drawn, and the files are as they were. */
async function refused(argv, words, kept) {
  const before = kept.map((file) => readFileSync(file, 'latin1'));
  const { exit, stderr, calls } = await runFake(argv);
  assert.deepEqual([exit, drewNothing(calls)], [2, true], `${argv.join(' ')}: ${stderr}`);
  assert.match(stderr, words);
  assert.match(stderr, /E_USAGE/);
  assert.deepEqual(
    kept.map((file) => readFileSync(file, 'latin1')),
    before,
    argv.join(' '),
  );
}

const gltf = (...uris) => JSON.stringify({ asset: { version: '2.0' }, images: uris.map((uri) => ({ uri })) });

test('a thumbnail is not written over a shot, a manifest or an environment', async () => {
  const shot = '{"output":{"format":"png"}}';
  const at = tree({
    'm.glb': '',
    's.json': shot,
    'e.hdr': 'light',
    'lit.json': '{"environment":"e.hdr","output":{"format":"png"}}',
    'own.jsonl': '{"model":"m.glb","shot":{"output":{"format":"png"}},"output":"own.jsonl"}',
    'line.jsonl': '{"model":"m.glb","shot":"s.json","output":"s.json"}',
    'lit.jsonl': '{"model":"m.glb","shot":{"environment":"e.hdr","output":{"format":"png"}},"output":"sub/../e.hdr"}',
  });
  symlinkSync(at('s.json'), at('link.json'));
  symlinkSync(at('.'), at('folder'));
  const draw = (...argv) => ['thumbnail', at('m.glb'), ...argv];
  const format = ['--set', 'output.format=png'];
  for (const [argv, words, kept] of [
    [draw('--shot', at('s.json'), '-o', at('s.json')), /-o would overwrite the shot ".*": name another file/, 's.json'],
    [draw('--shot', at('link.json'), '-o', at('s.json')), /-o would overwrite the shot/, 's.json'],
    [draw('--shot', at('s.json'), '-o', at('folder/s.json')), /-o would overwrite the shot/, 's.json'],
    [draw('-o', at('e.hdr'), '--environment', at('e.hdr'), ...format), /-o would overwrite the environment ".*"/, 'e.hdr'],
    [draw('-o', at('e.hdr'), '--shot', at('lit.json')), /-o would overwrite the environment/, 'e.hdr'],
    [['thumbnail', '--manifest', at('own.jsonl')], /--manifest line 1: output would overwrite the manifest/, 'own.jsonl'],
    [['thumbnail', '--manifest', at('line.jsonl'), ...format], /--manifest line 1: output would overwrite the shot/, 's.json'],
    [['thumbnail', '--manifest', at('lit.jsonl')], /--manifest line 1: output would overwrite the environment/, 'e.hdr'],
  ])
    await refused(argv, words, [at(kept)]);
  symlinkSync(at('s.json'), at('turn.webp'));
  await refused(draw('--shot', at('s.json'), '-o', at('turn.webp'), '--turntable', '4'), /-o would overwrite the shot/, [at('s.json')]);
});

test('pictures, layers and the contact sheet of a command are files of their own', async () => {
  const at = tree({ 'm.glb': '', 'n.glb': '', 'a.depth.png': 'of before', 's.png': '{}', 'out/m.png': 'of before' });
  symlinkSync(at('out'), at('link'));
  symlinkSync(at('out/m.png'), at('out/n.png'));
  const argv = ['thumbnail', at('m.glb')];
  for (const sheet of ['a.depth.png', 'new.depth.png'])
    await refused(
      [...argv, '-o', at(sheet.replace('.depth', '')), '--layers', 'depth', '--contact-sheet', at(sheet)],
      /the layer depth and --contact-sheet would both be written to ".*": name two files/,
      [at('a.depth.png')],
    );
  // Neither is there yet.
  await refused([...argv, '-o', at('out/new.png'), '--contact-sheet', at('link/new.png')], /-o and --contact-sheet would both be written to/, []);
  await refused(['thumbnail', at('m.glb'), at('n.glb'), '-o', at('out/{name}.png')], /-o and -o would both be written to ".*"/, [at('out/m.png')]);
  await refused([...argv, '-o', at('a.png'), '--shot', at('s.png'), '--contact-sheet', at('s.png')], /--contact-sheet would overwrite the shot/, [at('s.png')]);
});

test('what stays as it is may be named: hard links, devices, other files of one name', async () => {
  const at = tree({ 'm.glb': '', 's.json': '{"output":{"format":"png"}}', 'out/other.json': '' });
  linkSync(at('s.json'), at('hard.json'));
  const draw = async (...argv) => {
    const { exit, stderr } = await runFake(['thumbnail', at('m.glb'), '--shot', at('s.json'), ...argv]);
    assert.equal(exit, 0, stderr);
  };
  await draw('-o', at('hard.json'));
  assert.equal(readFileSync(at('s.json'), 'utf8'), '{"output":{"format":"png"}}', 'what the other name leads to');
  await draw('-o', at('out/s.json'));
  await draw('-o', at('out/s.json'));
  await draw('-o', '/dev/null');
});

test('a sheet is not written over what it is made of', async () => {
  const spec = {
    header: { logo: 'logo.png' },
    bill: [{ item: 'jersey', image: 'pics/bill.png' }],
    labels: [{ name: 'care', image: 'label-2.png' }],
    artwork: [{ name: 'print', image: 'art.svg' }],
  };
  const at = tree({
    'X.gltf': gltf('X_BaseColor.png', 'tee-1.png'),
    'X_BaseColor.png': 'a texture',
    'tee-1.png': 'a texture',
    'logo.png': 'a picture',
    'pics/bill.png': 'a picture',
    'label-2.png': 'a picture',
    'art.svg': 'a picture',
    'font.pdf': 'a font',
    'e.png': 'light',
    's.json': JSON.stringify(spec),
    'previous.json': '{}',
    'shot.json': '{}',
    'odd.json': '{"header":7,"bill":[3,{"image":{}}],"labels":"none"}',
  });
  const sheet = (...argv) => ['sheet', at('X.gltf'), ...argv];
  for (const [output, words, ...argv] of [
    ['X_BaseColor.png', /"X_BaseColor\.png" would be overwritten, a part of the model/],
    ['tee.png', /"tee-1\.png" would be overwritten, a part of the model/],
    ['logo.png', /-o would overwrite an image of the spec ".*"/],
    ['pics/bill.png', /-o would overwrite an image of the spec/],
    ['label.png', /-o would overwrite an image of the spec ".*"/],
    ['art.svg', /-o would overwrite an image of the spec/],
    ['font.pdf', /-o would overwrite the font/, '--font', at('font.pdf')],
    ['e.png', /-o would overwrite the environment/, '--set', `environment=${at('e.png')}`],
    ['s.json', /-o would overwrite the spec/, '--init'],
    ['previous.json', /-o would overwrite the spec of the last revision/, '--init', '--previous', at('previous.json')],
    ['shot.json', /-o would overwrite the shot/, '--init', '--shot', at('shot.json')],
  ]) {
    const kept = [
      'X_BaseColor.png',
      'tee-1.png',
      'logo.png',
      'pics/bill.png',
      'label-2.png',
      'art.svg',
      'font.pdf',
      'e.png',
      's.json',
      'previous.json',
      'shot.json',
    ];
    await refused(sheet('--spec', at('s.json'), '-o', at(output), ...argv), words, kept.map(at));
  }
  const { stderr } = await runFake(sheet('--spec', at('odd.json'), '-o', at('new.png')));
  assert.doesNotMatch(stderr, /E_USAGE|X_INTERNAL: .*image/, 'what is no spec is told as such');
});

test('a comparison keeps what is compared', async () => {
  const [golden, other] = [await encodePng(square(32)), await encodePng(withPixel(square(32), 16, 16, [255, 0, 0, 255]))];
  const at = tree({
    'A.png': golden,
    'shown.png': embedShot(golden, { environment: { map: 'e.hdr' } }),
    'B.png': other,
    'mask.png': golden,
    'report/expected.png': golden,
    'report/index.html': '',
    'e.hdr': '',
    'm.gltf': gltf('t.png'),
    't.png': '',
  });
  symlinkSync(at('A.png'), at('link.png'));
  const pair = (...argv) => ['compare', at('A.png'), at('B.png'), ...argv];
  for (const [argv, words] of [
    [pair('--heatmap', at('A.png')), /--heatmap would overwrite EXPECTED ".*": name another file/],
    [pair('--heatmap', at('link.png')), /--heatmap would overwrite EXPECTED/],
    [pair('--heatmap', at('B.png')), /--heatmap would overwrite ACTUAL/],
    [pair('--junit', at('A.png')), /--junit would overwrite EXPECTED/],
    [pair('--junit', at('B.png'), '--update'), /--junit would overwrite ACTUAL/],
    [pair('--mask', at('mask.png'), '--junit', at('mask.png')), /--junit would overwrite the mask/],
    [pair('--ignore', '0,0,1,1', '--ignore', at('mask.png'), '--heatmap', at('mask.png')), /--heatmap would overwrite what --ignore names, ".*"/],
    [pair('--heatmap', at('new'), '--junit', at('new')), /--heatmap and --junit would both be written to/],
    [pair('--report', at('report'), '--junit', at('report/index.html')), /--report and --junit would both be written to/],
    [['compare', at('report/expected.png'), at('B.png'), '--report', at('report')], /--report would overwrite EXPECTED/],
    [['compare', at('new.png'), at('A.png'), '--update', '--junit', at('new.png')], /--junit would overwrite EXPECTED/],
    [['compare', at('A.png'), '--model', at('m.gltf'), '--heatmap', at('t.png')], /"t\.png" would be overwritten, a part of the model/],
    [['compare', at('A.png'), '--model', at('m.gltf'), '--heatmap', at('m.gltf')], /--heatmap would overwrite the model/],
    [['compare', at('shown.png'), '--model', at('m.gltf'), '--junit', at('e.hdr')], /--junit would overwrite the environment/],
    [['compare', at('A.png'), '--model', at('m.gltf'), '--environment', at('e.hdr'), '--junit', at('e.hdr')], /--junit would overwrite the environment/],
  ])
    await refused(argv, words, ['A.png', 'B.png', 'mask.png', 'report/expected.png', 'e.hdr', 'm.gltf', 't.png'].map(at));
  const written = await runFake(pair('--report', at('new'), '--heatmap', at('new/heatmap.png'), '--junit', at('new/j.xml')));
  assert.equal(written.exit, 0, written.stderr);
  assert.ok(readFileSync(at('new/heatmap.png')).length > 0, 'one map, in one file');
  assert.equal((await runFake(pair('--heatmap', '/dev/null', '--junit', '/dev/null'))).exit, 0);
});

test('a comparison of two folders keeps what is compared', async () => {
  const golden = await encodePng(square(32));
  const at = tree({ 'a/x.png': golden, 'b/x.png': golden, 'mask/x.png': golden, 'b/pictures/x.png/expected.png': golden });
  const pair = (...argv) => ['compare', at('a'), at('b'), ...argv];
  for (const [argv, words] of [
    [pair('--junit', at('a/x.png')), /--junit would overwrite EXPECTED/],
    [pair('--junit', at('b/x.png')), /--junit would overwrite ACTUAL/],
    [pair('--mask', at('mask'), '--junit', at('mask/x.png')), /--junit would overwrite the mask/],
    [pair('--report', at('b')), /--report would overwrite ACTUAL ".*"/],
    [pair('--report', at('r'), '--junit', at('r/index.html')), /--report and --junit would both be written to/],
  ])
    await refused(argv, words, ['a/x.png', 'b/x.png', 'mask/x.png', 'b/pictures/x.png/expected.png'].map(at));
});

test('a baked model and the spec that a view edits take the place of nothing that is read', async () => {
  const at = tree({ 'm.glb': '', 'm.gltf': gltf('t.gltf'), 't.gltf': '', 'shot.json': '{}' });
  symlinkSync(at('m.glb'), at('link.glb'));
  for (const [argv, words] of [
    [['bake', at('m.glb'), '-o', at('m.glb')], /-o would overwrite the model/],
    [['bake', at('link.glb'), '-o', at('m.glb')], /-o would overwrite the model/],
    [['bake', at('m.gltf'), '-o', at('t.gltf')], /"t\.gltf" would be overwritten, a part of the model/],
    [['view', at('m.glb'), '--shot', at('shot.json'), '--spec', at('shot.json')], /--spec would overwrite the shot/],
  ]) {
    const before = readFileSync(at('t.gltf'), 'utf8');
    const { exit, stderr, calls } = await runFake(argv);
    assert.deepEqual([exit, calls.baked.length, calls.created.length], [2, 0, 0], stderr);
    assert.match(stderr, words);
    assert.equal(readFileSync(at('t.gltf'), 'utf8'), before);
  }
});
