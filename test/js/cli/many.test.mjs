import assert from 'node:assert/strict';
import { copyFileSync, existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { drewNothing, fakeApi, runFake } from './fake.mjs';

// Many pictures by one command, drawn by the fake API: names, folders, manifests, what is left out, what is refused.

const root = mkdtempSync(path.join(tmpdir(), 'telar-many-'));
after(() => rmSync(root, { recursive: true }));
let folders = 0;

/** A fresh empty folder, and a function that makes paths in it. */
function freshFolder() {
  const folder = path.join(root, String(++folders));
  mkdirSync(folder);
  return Object.assign((...names) => path.join(folder, ...names), { folder });
}

const gltf = (variants = []) =>
  JSON.stringify({
    asset: { version: '2.0' },
    ...(variants.length > 0 && { extensions: { KHR_materials_variants: { variants: variants.map((name) => ({ name })) } } }),
  });

/** Files by path, with their folders. */
function fill(at, files) {
  for (const [name, text] of Object.entries(files)) {
    mkdirSync(path.dirname(at(name)), { recursive: true });
    writeFileSync(at(name), text);
  }
}

/** Paths of all files beneath a folder, in order. */
const filesIn = (folder) =>
  readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => path.relative(folder, path.join(entry.parentPath ?? entry.path, entry.name)))
    .sort();

const usageOf = async (...argv) => {
  const { exit, stderr, calls } = await runFake(['thumbnail', ...argv]);
  assert.deepEqual([exit, drewNothing(calls)], [2, true], stderr);
  return stderr;
};

test('-r draws every model beneath a folder, into folders alike', async () => {
  const at = freshFolder();
  fill(at, { 'in/a.glb': '', 'in/x/b.GLTF': '', 'in/x/y/c.glb': '', 'in/x/notes.txt': '', 'in/.hidden/d.glb': '', 'in/.e.glb': '' });
  const { exit, stdout } = await runFake(['thumbnail', '-r', at('in'), '-o', at('out')]);
  assert.equal(exit, 0);
  assert.deepEqual(filesIn(at('out')), ['a.png', 'x/b.png', 'x/y/c.png']);
  assert.equal(stdout, ['a.png', 'x/b.png', 'x/y/c.png'].map((name) => `${at('out', name)}\n`).join(''));
  assert.match(await usageOf(at('in'), '-o', at('no')), /is a folder; -r draws every \.glb and \.gltf file beneath it/);
  mkdirSync(at('empty'));
  assert.match(await usageOf('-r', at('empty'), '-o', at('no')), /holds no \.glb or \.gltf file/);
});

test('{parent}, {folder}, {variant} and {view} in names', async () => {
  const at = freshFolder();
  fill(at, { 'in/AW26/1234/model.glb': gltf(['navy', 'red/blue']), 'in/AW26/1235/model.glb': gltf() });
  const run = async (pattern, ...argv) => {
    const folder = at(`out${++folders}`);
    const { exit, stderr } = await runFake(['thumbnail', '-r', at('in'), '-o', path.join(folder, pattern), ...argv]);
    assert.equal(exit, 0, stderr);
    return filesIn(folder);
  };
  assert.deepEqual(await run('{parent}.png'), ['1234.png', '1235.png']);
  assert.deepEqual(await run('{folder}-{name}.png'), ['AW26/1234-model.png', 'AW26/1235-model.png']);
  assert.deepEqual(await run('{parent}_{view}.webp', '--views', 'front,three-quarter'), [
    '1234_front.webp',
    '1234_three-quarter.webp',
    '1235_front.webp',
    '1235_three-quarter.webp',
  ]);
  assert.deepEqual(await run('{parent}/{variant}.jpg', '--view', 'back', '--variant', 'navy'), ['1234/navy.jpg', '1235/navy.jpg']);
  assert.deepEqual(await run('{view}-{variant}-{parent}.png', '--set', 'camera.azimuth=10'), ['camera-default-1234.png', 'camera-default-1235.png']);
});

test('every variant and every view, of a model that is decoded once', async () => {
  const at = freshFolder();
  fill(at, { 'shirt.glb': gltf(['navy', 'navy', '']), 'plain.glb': gltf(), 'broken.glb': '{' });
  const fake = fakeApi();
  const { exit, calls } = await runFake(
    ['thumbnail', at('shirt.glb'), at('plain.glb'), at('broken.glb'), '-o', at('out/'), '--variants', 'all', '--views', 'all'],
    { fake },
  );
  assert.equal(exit, 0);
  const views = ['back', 'bottom', 'front', 'left', 'right', 'three-quarter', 'top'];
  const named = (name) => views.map((view) => `${name}-${view}.png`);
  assert.deepEqual(filesIn(at('out')), [...named('broken-default'), ...named('plain-default'), ...named('shirt-navy')]);
  assert.deepEqual([calls.loaded.length, calls.released, calls.rendered.length], [3, 3, 21]);
  assert.equal(calls.rendered.filter(({ shot }) => shot.variant === 'navy').length, 7);
});

test('names of variants lead nowhere', async () => {
  const at = freshFolder();
  fill(at, { 'a.gltf': gltf(['../../etc/passwd', '.hidden', 'a\u0000b', '名'.repeat(200)]) });
  const api = fakeApi().api;
  const createRenderer = async () => ({
    load: async (x) => x,
    release: async () => {},
    close: async () => {},
    render: async () => ({ data: Buffer.from('x'), info: {} }),
  });
  const { exit, stderr } = await runFake(['thumbnail', at('a.gltf'), '-o', at('out/{variant}.png'), '--variants', 'all'], { api: { ...api, createRenderer } });
  assert.equal(exit, 0, stderr);
  assert.deepEqual(filesIn(at('out')), ['-..-etc-passwd.png', 'a-b.png', 'hidden.png', `${'名'.repeat(60)}.png`]);
});

test('two pictures of one name are refused before anything is drawn, with the part that tells them apart', async () => {
  const at = freshFolder();
  fill(at, { 'x/a.glb': gltf(['navy', 'red']), 'y/a.glb': gltf() });
  assert.match(await usageOf(at('x/a.glb'), at('y/a.glb'), '-o', at('{name}.png')), /would both be written to .*use a pattern with \{parent\}/);
  assert.match(await usageOf(at('x/a.glb'), '-o', at('{name}.png'), '--variants', 'all'), /variant "navy" and .*variant "red" would both.*\{variant\}/);
  assert.match(await usageOf(at('x/a.glb'), '-o', at('{name}.png'), '--views', 'front,back'), /view "front" and .*view "back" would both.*\{view\}/);
  assert.match(await usageOf(at('x/a.glb'), at('x/a.glb'), '-o', at('{name}.png')), /use a pattern with \{index\}/);
  assert.match(await usageOf(at('x/a.glb'), '-o', at('a.png'), '--views', 'front,back'), /many pictures need a folder/);
  assert.match(await usageOf(at('x/a.glb'), '-o', at('{nmae}.png')), /\{nmae\} stands for nothing; did you mean \{name\}\?/);
  assert.match(await usageOf(at('x/a.glb'), '-o', at('{size}.png')), /\{size\} stands for nothing; expected \{name\} \{index\}/);
  assert.match(await usageOf(at('x/a.glb'), '-o', at('a.png'), '--views', 'frnt'), /there is no view "frnt"; did you mean front\?/);
  assert.match(await usageOf(at('x/a.glb'), '-o', at('a.png'), '--views', 'front', '--view', 'back'), /give one of them/);
  assert.match(await usageOf(at('x/a.glb'), '-o', at('a.png'), '--variants', ','), /--variants: expected names/);
});

test('a picture is not written over a part of a model', async () => {
  const at = freshFolder();
  fill(at, {
    'x/shirt.gltf': JSON.stringify({ asset: { version: '2.0' }, images: [{ uri: 'textures/shirt.png' }] }),
    'x/textures/shirt.png': 'a texture',
    'y/broken.gltf': '{',
  });
  assert.match(
    await usageOf(at('y/broken.gltf'), at('x/shirt.gltf'), '-o', at('x/textures/{name}.png')),
    /"shirt\.png" would be overwritten, a part of the model ".*shirt\.gltf"/,
  );
  const parts = ['shirt.normal.png', 'body.webp', 'body.png'];
  fill(at, { 'z/shirt.gltf': JSON.stringify({ asset: { version: '2.0' }, images: parts.map((uri) => ({ uri })) }) });
  fill(at, Object.fromEntries(parts.map((part) => [`z/${part}`, 'a texture'])));
  for (const [part, argv] of [
    ['shirt.normal.png', ['-o', at('z/shirt.png'), '--layers', 'normal']],
    ['body.webp', ['-o', at('z/body.webp'), '--turntable', '4']],
    ['body.png', ['-o', at('z/{name}.png'), '--contact-sheet', at('z/body.png')]],
  ])
    assert.ok((await usageOf(at('z/shirt.gltf'), ...argv)).includes(`"${part}" would be overwritten, a part of the model`), part);
  assert.equal((await runFake(['thumbnail', at('x/shirt.gltf'), '-o', at('x/{name}.png')])).exit, 0);
});

test('an address and a pattern that no shell expanded say what to do', async () => {
  const at = freshFolder();
  for (const command of [['thumbnail', '-o', at('a.png')], ['inspect'], ['view']]) {
    const run = (model) => runFake([command[0], model, ...command.slice(1)]);
    const address = await run('https://example.com/shirt.glb');
    assert.deepEqual([address.exit, drewNothing(address.calls)], [2, true]);
    assert.match(address.stderr, /is an address, and telar fetches nothing: copy the file to this machine, or hand it over as in `curl -fsS ADDRESS \| telar /);
    const pattern = await run(at('*.glb'));
    assert.equal(pattern.exit, 2);
    assert.match(pattern.stderr, /telar expands no patterns: write it without quotes/);
  }
  writeFileSync(at('a[1].glb'), '');
  assert.equal((await runFake(['thumbnail', at('a[1].glb'), '-o', at('b.png')])).exit, 0);
});

test('a manifest names models, shots and outputs, relative to itself', async () => {
  const at = freshFolder();
  fill(at, {
    'season/a.glb': gltf(),
    'season/b.glb': gltf(),
    'season/shots/back.json': '{"camera": {"view": "back"}, "environment": "sky.hdr"}',
    'season/jobs.jsonl': [
      '{"model": "a.glb", "shot": {"exposure": 3, "environment": "in.exr"}, "output": "out/one.jpg"}',
      '',
      '{"model": "b.glb", "shot": "shots/back.json"}',
      `{"model": "${at('season/a.glb')}", "output": "out/{name}-{view}.png"}`,
    ].join('\r\n'),
  });
  const { exit, stdout, stderr, calls } = await runFake([
    'thumbnail',
    '--manifest',
    at('season/jobs.jsonl'),
    '-o',
    at('rest/{name}.png'),
    '--set',
    'exposure=2',
    '--json',
  ]);
  assert.equal(exit, 0, stderr);
  assert.deepEqual(
    JSON.parse(stdout).images.map(({ model, output, view }) => [model, output, view]),
    [
      [at('season/a.glb'), at('season/out/one.jpg'), 'front'],
      [at('season/b.glb'), at('rest/b.png'), 'back'],
      [at('season/a.glb'), at('season/out/a-front.png'), 'front'],
    ],
  );
  const shots = Object.fromEntries(calls.rendered.map(({ source, shot }) => [`${path.basename(source.loaded ?? source)} ${shot.output.format}`, shot]));
  assert.deepEqual([shots['a.glb jpeg'].exposure, shots['a.glb jpeg'].environment.map], [3, at('season/in.exr')]);
  assert.deepEqual([shots['b.glb png'].exposure, shots['b.glb png'].environment.map], [2, at('season/shots/sky.hdr')]);
});

test('a manifest on stdin, and what a wrong one says', async () => {
  const at = freshFolder();
  const stdin = (lines) => ({ stdin: lines.join('\n') });
  const { exit } = await runFake(['thumbnail', '--manifest', '-'], stdin([JSON.stringify({ model: at('a.glb'), output: at('a.png') })]));
  assert.equal(exit, 0);
  assert.ok(existsSync(at('a.png')));
  for (const [lines, message, ...argv] of [
    [['{"model": "a.glb", "output": "a.png"}', '{"model": '], /--manifest line 2: not JSON/],
    [['[]'], /line 1: expected an object with "model", got \[\]/],
    [['{"model": "a.glb", "ouput": "b.png"}'], /line 1: unknown key "ouput", did you mean output\?/],
    [['{"model": 3}'], /line 1: model: expected a path, got 3/],
    [['{"model": "a.glb", "shot": 3}'], /line 1: shot: expected an object or the path of one/],
    [['{"model": "a.glb", "shot": {"exposure": "x"}, "output": "b.png"}'], /--manifest line 1: shot\.exposure: expected.*E_SHOT/],
    [['{"model": "a.glb"}'], /line 1: there is no output/],
    [['{"model": "http://x/a.glb", "output": "b.png"}'], /line 1: "http:\/\/x\/a\.glb" is an address/],
    [['{"model": "a.glb", "output": "b.png"}', '{"model": "c.glb", "output": "b.png"}'], /would both be written to/],
    [[''], /has no lines/],
    [['{}'], /models and --manifest: give one of them/, 'x.glb'],
  ]) {
    const wrong = await runFake(['thumbnail', ...argv, '--manifest', '-'], stdin(lines));
    assert.deepEqual([wrong.exit, drewNothing(wrong.calls)], [2, true], String(message));
    assert.match(wrong.stderr, message);
  }
  assert.equal((await runFake(['thumbnail', '--manifest', at('none.jsonl')])).exit, 3);
});

test('one bad file does not lose the others, whatever is crossed with it', async () => {
  const at = freshFolder();
  fill(at, { 'a.glb': gltf(), 'E_JSON.glb': gltf() });
  const { exit, stdout, stderr } = await runFake(['thumbnail', at('E_JSON.glb'), at('a.glb'), '-o', at('out'), '--views', 'front,back', '--json']);
  assert.equal(exit, 3);
  assert.deepEqual(
    JSON.parse(stdout).images.map(({ ok, view, output }) => [ok, view, output && path.basename(output)]),
    [
      [false, 'front', undefined],
      [false, 'back', undefined],
      [true, 'front', 'a-front.png'],
      [true, 'back', 'a-back.png'],
    ],
  );
  assert.equal(stderr.match(/E_JSON at/g).length, 1, 'what two pictures have in common is said once');
  assert.match(stderr, /2 of 4 pictures drawn/);
});

test('what is wrong with an environment is told of its file, everything else of the model', async () => {
  const at = freshFolder();
  for (const [code, environment, named] of [
    ['E_ENVIRONMENT_CORRUPT', 'hall.hdr', 'hall.hdr'],
    ['L_ENVIRONMENT_PIXELS', 'hall.hdr', 'hall.hdr'],
    ['E_ENVIRONMENT_CORRUPT', undefined, at('E_ENVIRONMENT_CORRUPT.glb')],
    ['E_JSON', 'hall.hdr', at('E_JSON.glb')],
  ]) {
    fill(at, { [`${code}.glb`]: gltf() });
    const { stderr } = await runFake(['thumbnail', at(`${code}.glb`), '-o', at('out.png'), ...(environment ? ['--environment', environment] : [])]);
    assert.ok(stderr.includes(`telar: ${named}: it fails [${code}`), stderr);
  }
});

test('--skip-unchanged leaves out what would be the same, and nothing else', async () => {
  const at = freshFolder();
  const drawn = async (...argv) => {
    const { exit, stdout, calls } = await runFake(['thumbnail', 'a.glb', 'b.glb', '-o', at('out'), '--skip-unchanged', '--json', ...argv]);
    assert.equal(exit, 0);
    const { images } = JSON.parse(stdout);
    assert.deepEqual(
      images.map(({ ok, unchanged = false, key, info }) => ok && (unchanged ? /^[\da-f]{64}$/.test(key) : /^[\da-f]{64}$/.test(info.key))),
      [true, true],
    );
    return calls.rendered.map(({ source }) => source).sort();
  };
  assert.deepEqual(await drawn(), ['a.glb', 'b.glb']);
  assert.deepEqual(await drawn(), []);
  assert.deepEqual(filesIn(at('out')), ['.telar-keys.json', 'a.png', 'b.png']);
  writeFileSync(at('out/a.png'), 'edited');
  assert.deepEqual(await drawn(), ['a.glb']);
  rmSync(at('out/b.png'));
  assert.deepEqual(await drawn(), ['b.glb']);
  assert.deepEqual(await drawn('--set', 'exposure=2'), ['a.glb', 'b.glb']);
  assert.deepEqual(await drawn('--set', 'exposure=2'), []);
  // A picture that was drawn in spite of a fault is not one that has none.
  assert.deepEqual(await drawn('--set', 'exposure=2', '--fail-on', 'warning'), ['a.glb', 'b.glb']);
  assert.deepEqual(await drawn('--set', 'exposure=2', '--fail-on', 'warning'), []);
  assert.deepEqual(await drawn('--set', 'exposure=2'), ['a.glb', 'b.glb']);
  writeFileSync(at('out/.telar-keys.json'), '{"version": 1, "pictures": {"a.png": 3, "b.png"');
  assert.deepEqual(await drawn('--set', 'exposure=2'), ['a.glb', 'b.glb']);
  assert.match((await runFake(['thumbnail', 'a.glb', '-o', '-', '--skip-unchanged'])).stderr, /give a file to -o/);
});

test('a run that is interrupted keeps the keys of what it has drawn', async () => {
  const at = freshFolder();
  const abort = new AbortController();
  const { api } = fakeApi();
  const createRenderer = async (options) => {
    const renderer = await api.createRenderer(options);
    let drawn = 0;
    const render = async (...args) => {
      if (++drawn > 6) {
        abort.abort();
        throw abort.signal.reason;
      }
      return renderer.render(...args);
    };
    return { ...renderer, render };
  };
  const models = Array.from({ length: 12 }, (_, i) => `m${i}.glb`);
  const { exit } = await runFake(['thumbnail', ...models, '-o', at('out'), '--skip-unchanged'], { api: { ...api, createRenderer }, signal: abort.signal });
  assert.equal(exit, 5);
  const kept = Object.keys(JSON.parse(readFileSync(at('out/.telar-keys.json'))).pictures);
  assert.deepEqual(
    kept,
    filesIn(at('out')).filter((name) => name.endsWith('.png')),
  );
  assert.ok(kept.length > 0 && kept.length < 12, `${kept.length} drawn`);
});

test('what a contact sheet cannot show is refused first', async () => {
  const at = freshFolder();
  copyFileSync(fileURLToPath(import.meta.url), at('a.glb'));
  assert.match(
    await usageOf(at('a.glb'), '-o', at('a.exr'), '--contact-sheet', at('s.png')),
    /it shows pictures in png, jpeg, webp files, and one goes to .*a\.exr/,
  );
  assert.match(await usageOf(at('a.glb'), '-o', at('a.png'), '--contact-sheet', at('s.pdf')), /expected a name that ends in \.png/);
  assert.match(await usageOf(at('a.glb'), '-o', at('a.png'), '--contact-sheet', at('a.png')), /a picture or a model has this name/);
  assert.match(await usageOf(at('a.glb'), '-o', '-', '--contact-sheet', at('s.png')), /one goes to stdout/);
});

test('--jobs draws in a pool of so many, and keeps them all busy', async () => {
  const at = freshFolder();
  fill(at, Object.fromEntries(Array.from({ length: 12 }, (_, i) => [`in/${i}.glb`, ''])));
  const fake = () => fakeApi({ delayMs: 20 });
  for (const [args, size, most] of [
    [['--jobs', '6', '--timeout-ms', '70'], 6, 6],
    [['--jobs', 'auto'], 3, 4],
  ]) {
    const { exit, calls } = await runFake(['thumbnail', '-r', at('in'), '-o', at(`out${size}`), ...args], { fake: fake() });
    assert.deepEqual([exit, calls.created.length, calls.created[0].size, calls.closed, calls.mostAtOnce], [0, 1, size, 1, most]);
    assert.equal(filesIn(at(`out${size}`)).length, 12);
    if (size === 6) assert.equal(calls.created[0].timeoutMs, 70);
  }
  assert.equal((await runFake(['thumbnail', '-r', at('in'), '-o', at('one')], { fake: fake() })).calls.created[0].size, undefined, 'without it, a renderer');
  for (const wrong of ['0', '-1', '1.5', 'all', '1025']) {
    assert.match(await usageOf('-r', at('in'), '-o', at('no'), '--jobs', wrong), /--jobs: expected processes from 1 to 1024, or auto, got/);
  }
});
