import assert from 'node:assert/strict';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, test } from 'node:test';
import { resolveShot } from '../../../js/shot/index.mjs';
import { drewNothing, fakeApi, runFake } from './fake.mjs';

const root = mkdtempSync(path.join(tmpdir(), 'telar-cli-'));
after(() => rmSync(root, { recursive: true }));

let folders = 0;
/** A fresh empty folder, and a function that makes paths in it. */
function freshFolder() {
  const folder = path.join(root, String(++folders));
  mkdirSync(folder);
  return Object.assign((...names) => path.join(folder, ...names), { folder });
}

const shotIn = (file) => JSON.parse(readFileSync(file, 'utf8'));

test('one model to one file, whose path is the result', async () => {
  const at = freshFolder();
  const { exit, stdout, stderr, calls } = await runFake(['thumbnail', 'shirt.glb', '-o', at('a.png')]);
  assert.deepEqual([exit, stdout, stderr], [0, `${at('a.png')}\n`, '']);
  assert.equal(shotIn(at('a.png')).output.format, 'png');
  assert.deepEqual(readdirSync(at.folder), ['a.png']);
  assert.equal(calls.closed, 1);
});

test('--json is exactly one object on stdout', async () => {
  const at = freshFolder();
  const { exit, stdout } = await runFake(['thumbnail', 'shirt.glb', '--json', '-o', at('a.png')]);
  assert.equal(exit, 0);
  assert.equal(stdout.trim().split('\n').length, 1);
  const {
    ok,
    images: [image],
  } = JSON.parse(stdout);
  assert.deepEqual([ok, image.model, image.ok, image.output], [true, 'shirt.glb', true, at('a.png')]);
  assert.equal(image.info.shot.size.width, 512);
});

test('the extension gives the format', async () => {
  const at = freshFolder();
  for (const [name, format] of [
    ['a.jpg', 'jpeg'],
    ['a.JPEG', 'jpeg'],
    ['a.webp', 'webp'],
    ['a.tif', 'tiff'],
    ['a.exr', 'exr'],
    ['a.raw', 'raw'],
  ]) {
    assert.equal((await runFake(['thumbnail', 'm.glb', '-o', at(name)])).exit, 0, name);
    assert.equal(shotIn(at(name)).output.format, format);
  }
});

test('flags, --set and --shot make the shot, each over the one before', async () => {
  const at = freshFolder();
  writeFileSync(
    at('shot.json'),
    JSON.stringify({
      size: { width: 10, height: 20 },
      camera: { view: 'back', fit: 0.5 },
      environment: { map: 'maps/a.hdr', rotation: 5 },
      exposure: 2,
    }),
  );
  const { exit, stderr, calls } = await runFake([
    'thumbnail',
    'm.glb',
    '-o',
    at('a.png'),
    '--shot',
    at('shot.json'),
    '--view',
    'top',
    '--quality',
    'draft',
    '--background',
    'rgb(255, 0, 0)',
    '--variant',
    'navy',
    '--shading',
    'three',
    '--set',
    'exposure=3',
    '--set',
    'lights.0.type=point',
    '--set',
    'lights.0.color=[0, 1, 0]',
    '--set',
    'output.ppi=72',
  ]);
  assert.equal(exit, 0, stderr);
  const { shot } = calls.rendered[0];
  assert.deepEqual(shot.size, { width: 10, height: 20 });
  assert.deepEqual(shot.camera.up, [0, 0, -1]);
  assert.deepEqual(shot.environment, { map: at('maps/a.hdr'), intensity: 1, rotation: 5 });
  assert.deepEqual([shot.quality.preset, shot.background, shot.variant, shot.exposure, shot.output.ppi], ['draft', [1, 0, 0], 'navy', 3, 72]);
  assert.deepEqual(shot.lights, [{ type: 'point', color: [0, 1, 0], intensity: 1, position: [0, 0, 0], range: 0, castShadow: false }]);
});

test('--frame and --fit-to say how a view frames, and --view keeps it', async () => {
  const at = freshFolder();
  writeFileSync(at('shot.json'), JSON.stringify({ camera: { view: 'back', frame: 'model', fitTo: 'all', fit: 1.5 } }));
  const rendered = async (...flags) => (await runFake(['thumbnail', 'm.glb', '-o', at('a.png'), ...flags])).calls.rendered[0].shot.camera;
  const facts = { min: [-1, 0, -1], max: [1, 2, 1] };
  const camera = (wanted) => resolveShot({ camera: wanted }, facts).camera;
  assert.deepEqual(await rendered('--view', 'left', '--fit-to', 'turntable'), camera({ view: 'left', fitTo: 'turntable' }));
  assert.deepEqual(await rendered('--shot', at('shot.json'), '--view', 'top'), camera({ view: 'top', fit: 1.5, fitTo: 'all' }));
  for (const [flag, code] of [
    ['node=Sleeve', 'E_FRAME'],
    ['material=3', 'E_FRAME'],
    ['sleeve', 'E_SHOT'],
  ]) {
    const { exit, stderr } = await runFake(['thumbnail', 'm.glb', '-o', at('a.png'), '--frame', flag]);
    assert.ok(exit === (code === 'E_SHOT' ? 2 : 3) && stderr.includes(code), stderr);
  }
});

test('--set says more of what a flag names', async () => {
  const at = freshFolder();
  const { calls } = await runFake(['thumbnail', 'm.glb', '-o', at('a.png'), '--shading', 'disney-2012', '--set', 'shading.sheen=zeltner']);
  const { base, sheen, fresnel } = calls.rendered[0].shot.shading;
  assert.deepEqual({ base, sheen, fresnel }, { base: 'disney-2012', sheen: 'zeltner', fresnel: 'schlick' });
});

test('three@180 names a release of three.js, and --set swaps a term of it', async () => {
  const at = freshFolder();
  const rendered = async (...flags) => (await runFake(['thumbnail', 'm.glb', '-o', at('a.png'), ...flags])).calls.rendered[0].shot.shading;
  const release = resolveShot({ shading: { base: 'three', revision: 180 } }, { min: [0, 0, 0], max: [1, 1, 1] }).shading;
  for (const text of ['three@180', 'three@0.180', 'three@0.180.3']) assert.deepEqual(await rendered('--shading', text), release, text);
  assert.deepEqual(await rendered('--set', 'shading=three@180'), release);
  assert.deepEqual(await rendered('--shading', 'three@180', '--set', 'shading.dfg=table-16'), { ...release, dfg: 'table-16' });
  assert.deepEqual(await rendered('--shading', 'three', '--set', 'shading.revision=180'), release);
  for (const [text, message] of [
    ['three@', /--shading: expected a release of three\.js as in three@180, got "three@" \[E_USAGE\]/],
    ['three@r180', /E_USAGE/],
    ['three@1.180', /E_USAGE/],
    ['three@0', /revision.*E_SHOT/],
    ['fabric@180', /shading.*E_SHOT/],
  ]) {
    const { exit, stderr } = await runFake(['thumbnail', 'm.glb', '-o', at('a.png'), '--shading', text]);
    assert.equal(exit, 2, text);
    assert.match(stderr, message);
  }
});

test('--environment starts at the current folder, --size takes one or two numbers', async () => {
  const at = freshFolder();
  const { calls } = await runFake(['thumbnail', 'm.glb', '-o', at('a.png'), '--environment', 'b.exr', '--size', '30x40']);
  assert.equal(calls.rendered[0].shot.environment.map, 'b.exr');
  assert.deepEqual(calls.rendered[0].shot.size, { width: 30, height: 40 });
  assert.deepEqual((await runFake(['thumbnail', 'm.glb', '-o', at('b.png'), '--size', '64'])).calls.rendered[0].shot.size, { width: 64, height: 64 });
});

test('stdin and stdout', async () => {
  const { exit, stdout, calls } = await runFake(['thumbnail', '-', '-o', '-'], { stdin: 'glTF bytes' });
  assert.equal(exit, 0);
  assert.equal(JSON.parse(stdout).output.format, 'png');
  assert.equal(calls.rendered[0].source.toString(), 'glTF bytes');
  const shotFromStdin = await runFake(['thumbnail', 'm.glb', '--shot', '-', '-o', '-'], { stdin: '{"exposure": 4}' });
  assert.equal(JSON.parse(shotFromStdin.stdout).exposure, 4);
  const tooLong = await runFake(['thumbnail', '-', '-o', '-', '--limit', 'L_FILE_BYTES=3'], { stdin: 'abcd' });
  assert.deepEqual([tooLong.exit, tooLong.stdout], [4, '']);
});

test('many models go to a folder or by a pattern', async () => {
  const at = freshFolder();
  assert.equal((await runFake(['thumbnail', 'x/a.glb', 'y/b.gltf', '-o', at('new')])).exit, 0);
  assert.deepEqual(readdirSync(at('new')).sort(), ['a.png', 'b.png']);
  assert.equal((await runFake(['thumbnail', 'x/a.glb', 'y/a.gltf', '-o', at('p', '{index}-{name}.webp')])).exit, 0);
  assert.deepEqual(readdirSync(at('p')).sort(), ['1-a.webp', '2-a.webp']);
  assert.equal((await runFake(['thumbnail', 'a.glb', '-o', `${at('q')}/`, '--set', 'output.format=jpeg'])).exit, 0);
  assert.deepEqual(readdirSync(at('q')), ['a.jpg']);
});

test('a model that fails does not stop the others; the highest exit code is told', async () => {
  const at = freshFolder();
  const models = ['a.glb', 'E_JSON.glb', 'b.glb', 'L_NODES.glb', 'c.glb', 'd.glb', 'e.glb'];
  const { exit, stdout, stderr, calls } = await runFake(['thumbnail', ...models, '-o', at.folder]);
  assert.equal(exit, 4);
  assert.deepEqual(readdirSync(at.folder).sort(), ['a.png', 'b.png', 'c.png', 'd.png', 'e.png']);
  assert.equal(stdout.trim().split('\n').length, 5);
  assert.match(stderr, /^telar: E_JSON\.glb: it fails \[E_JSON at \/nodes\/0\]$/m);
  assert.match(stderr, /5 of 7 models drawn/);
  assert.equal(calls.closed, 1);
  const json = JSON.parse((await runFake(['thumbnail', ...models, '-o', at.folder, '--json'])).stdout);
  assert.deepEqual([json.ok, json.exit, json.images.map(({ ok }) => ok)], [false, 4, [true, false, true, false, true, true, true]]);
  assert.deepEqual(json.images[1].error, { code: 'E_JSON', kind: 'input', message: 'it fails', retryable: false, pointer: '/nodes/0' });
});

test('usage errors: exit 2, nothing drawn, one JSON object with --json', async () => {
  const at = freshFolder();
  writeFileSync(at('shot.json'), '{"size": ');
  writeFileSync(at('list.json'), '[]');
  writeFileSync(at('m.png'), '');
  const out = ['-o', at('a.png')];
  const wrong = [
    [[], /expected a command: thumbnail, .* or \w+ /],
    [['bench'], /expected a command of bench: trade /],
    [['thumbnial'], /unknown command 'thumbnial' \(Did you mean thumbnail\?\)/],
    [['thumbnail', 'm.glb'], /required option '-o, --output <out>' not specified/],
    [['thumbnail', ...out], /missing required argument 'model'/],
    [['thumbnail', 'm.glb', ...out, '--veiw', 'top'], /unknown option '--veiw' \(Did you mean --view\?\)/],
    [['thumbnail', 'm.glb', ...out, '--size', '5y6'], /--size: expected WxH in pixels, as in 512x512, got "5y6"/],
    [['thumbnail', 'm.glb', ...out, '--size', '0'], /shot\.size\.width: expected a whole number of pixels in \[1, 8192\], got 0/],
    [['thumbnail', 'm.glb', ...out, '--view', 'up'], /shot\.camera\.view: expected "front"/],
    [['thumbnail', 'm.glb', ...out, '--backend', 'x11'], /Allowed choices are auto, egl-device/],
    [['thumbnail', 'm.glb', ...out, '--set', 'exposure'], /--set: expected key=value/],
    [['thumbnail', 'm.glb', ...out, '--set', 'lights.1.type=point'], /expected an index up to 0 in place of "1"/],
    [['thumbnail', 'm.glb', ...out, '--material', '__proto__=denim'], /shot\.materials\.__proto__: expected another name/],
    [['thumbnail', 'm.glb', ...out, '--set', '__proto__.x=1'], /shot\.__proto__: unknown key/],
    [['thumbnail', 'm.glb', ...out, '--shot', at('shot.json')], /is not JSON/],
    [['thumbnail', 'm.glb', ...out, '--shot', at('list.json')], /expected an object, got \[\]/],
    [['thumbnail', 'm.glb', ...out, '--limit', 'L_NODES'], /--limit: expected NAME=N/],
    [['thumbnail', 'm.glb', '-o', at('a.bmp')], /expected a name that ends in \.png/],
    [['thumbnail', 'm.glb', '-o', at('a.png'), '--set', 'output.format=jpeg'], /means png, but the shot's output\.format is jpeg/],
    [['thumbnail', 'a.glb', 'b.glb', '-o', '-'], /only one image fits on stdout/],
    [['thumbnail', 'a.glb', 'b.glb', '-o', at('a.png')], /many models need a folder/],
    [['thumbnail', 'x/a.glb', 'y/a.glb', '-o', at('many')], /would both be written to/],
    [['thumbnail', at('m.png'), '-o', at('m.png')], /would overwrite the model/],
    [['thumbnail', '-', '-', '-o', at('{index}.png')], /stdin\) can stand for one file only/],
    [['inspect', 'a.glb', 'b.glb'], /too many arguments/],
    [['doctor', 'x'], /too many arguments/],
  ];
  for (const [argv, message] of wrong) {
    const text = await runFake(argv);
    assert.deepEqual([text.exit, text.stdout], [2, ''], argv.join(' '));
    assert.match(text.stderr, message);
    assert.ok(drewNothing(text.calls), argv.join(' '));
    const { exit, stdout } = await runFake([...argv, '--json']);
    assert.equal(exit, 2);
    const parsed = JSON.parse(stdout);
    assert.deepEqual([parsed.ok, parsed.exit, parsed.error.kind], [false, 2, 'usage'], argv.join(' '));
  }
  assert.ok(!existsSync(at('a.png')));
  assert.equal({}.x, undefined);
});

test('missing files and a machine without GL have their own exit codes', async () => {
  const at = freshFolder();
  const exits = async (...argv) => (await runFake(['thumbnail', 'm.glb', '-o', at('a.png'), ...argv])).exit;
  assert.equal(await exits('--variant', 'crimson'), 3);
  assert.equal(await exits('--shot', at('absent.json')), 3);
  assert.equal(await exits('--backend', 'egl-device'), 6);
  assert.deepEqual(readdirSync(at.folder), []);
});

test('a GL that does not open is told once, not of each model', async () => {
  const at = freshFolder();
  const { exit, stdout, stderr, calls } = await runFake(['thumbnail', 'a.glb', 'b.glb', '-o', at.folder, '--backend', 'egl-device', '--json']);
  assert.equal(exit, 6);
  assert.equal(stderr, 'telar: no device [X_GL]\n');
  assert.equal(JSON.parse(stdout).error.code, 'X_GL');
  assert.equal(calls.rendered.length, 0);
});

test('warnings go to stderr, --quiet drops them', async () => {
  const at = freshFolder();
  const { stderr } = await runFake(['thumbnail', 'warn.glb', '-o', at('a.png')]);
  assert.equal(stderr, 'warning: warn.glb: clamped [W_RANGE at /materials/0]\n');
  assert.equal((await runFake(['thumbnail', 'warn.glb', '-o', at('a.png'), '--quiet'])).stderr, '');
});

test('a progress bar is for people only', async () => {
  const at = freshFolder();
  const argv = ['thumbnail', 'a.glb', 'b.glb', '-o', at.folder];
  const bar = /2\/2/;
  assert.match((await runFake(argv, { tty: true })).stderr, bar);
  assert.doesNotMatch((await runFake(argv)).stderr, bar);
  assert.doesNotMatch((await runFake(argv, { tty: true, env: { CI: 'true' } })).stderr, bar);
  assert.equal((await runFake([...argv, '--quiet'], { tty: true })).stderr, '');
  const { stdout } = await runFake([...argv, '--json'], { tty: true });
  assert.equal(JSON.parse(stdout).ok, true);
});

test('a traced picture shows how far it is, one alone too', async () => {
  const argv = ['thumbnail', 'a.glb', '-o', freshFolder()('a.png')];
  assert.equal((await runFake(argv, { tty: true })).stderr, '');
  for (const quality of [
    ['--quality', 'reference'],
    ['--set', 'quality={"preset":"reference","samples":4}'],
    ['--quality', 'high', '--shading', 'fabric'],
  ]) {
    const { stderr } = await runFake([...argv, ...quality], { tty: true, fake: fakeApi({ delayMs: 200 }) });
    assert.match(stderr, /50%/);
    assert.equal((await runFake([...argv, ...quality], { tty: true, fake: fakeApi({ delayMs: 200, told: 1 }) })).stderr, '', 'the raster tells its end only');
    assert.equal((await runFake([...argv, ...quality])).stderr, '');
  }
});

test('colour on a terminal, none with NO_COLOR or in a pipe', async () => {
  const argv = ['thumbnail', 'm.glb'];
  assert.ok((await runFake(argv, { tty: true })).stderr.includes('\u001b[31m'));
  assert.ok(!(await runFake(argv, { tty: true, env: { NO_COLOR: '1' } })).stderr.includes('\u001b'));
  assert.ok(!(await runFake(argv, { tty: true, env: { TERM: 'dumb' } })).stderr.includes('\u001b'));
  assert.ok(!(await runFake(argv)).stderr.includes('\u001b'));
});

test('an abort leaves no file and closes the renderer', async () => {
  const at = freshFolder();
  const abort = new AbortController();
  setTimeout(() => abort.abort(), 30);
  const { exit, stdout, calls } = await runFake(['thumbnail', ...'abcdefgh'.split('').map((name) => `${name}.glb`), '-o', at.folder, '--json'], {
    signal: abort.signal,
    fake: fakeApi({ delayMs: 20_000 }),
  });
  assert.equal(exit, 5);
  assert.ok(JSON.parse(stdout).images.every(({ error }) => error.code === 'X_CANCELLED'));
  assert.deepEqual(readdirSync(at.folder), []);
  assert.equal(calls.closed, 1);
});

test('an output that cannot be written is X_OUTPUT and leaves nothing', async () => {
  const at = freshFolder();
  writeFileSync(at('file'), '');
  const { exit, stderr } = await runFake(['thumbnail', 'm.glb', '-o', at('file', 'a.png')]);
  assert.equal(exit, 6);
  assert.match(stderr, /cannot be written \((ENOTDIR|EEXIST)\)/);
  assert.deepEqual(readdirSync(at.folder), ['file']);
});

test('--fail-on reaches the renderer and inspect', async () => {
  const at = freshFolder();
  const levels = async (...args) => (await runFake(['thumbnail', 'shirt.glb', '-o', at('a.png'), ...args])).calls.created.map(({ failOn }) => failOn);
  assert.deepEqual(await levels(), ['error']);
  for (const level of ['error', 'warning', 'none']) assert.deepEqual(await levels('--fail-on', level), [level]);
  assert.equal((await runFake(['inspect', 'shirt.glb', '--fail-on', 'none'])).calls.inspected[0].options.failOn, 'none');
  const wrong = await runFake(['thumbnail', 'shirt.glb', '-o', at('a.png'), '--fail-on', 'all']);
  assert.equal(wrong.exit, 2);
  assert.match(wrong.stderr, /Allowed choices are error, warning, none/);
});
