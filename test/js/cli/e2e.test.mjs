import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, test } from 'node:test';
import { setTimeout as sleep } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';
import sharp from 'sharp';

// The real program on the real renderer and the bundled garment.

const BIN = fileURLToPath(new URL('../../../js/cli/telar.mjs', import.meta.url));
const SHIRT = fileURLToPath(new URL('../../../js/assets/tshirt.glb', import.meta.url));
const SMALL = ['--size', '64', '--quality', 'draft'];

const root = mkdtempSync(path.join(tmpdir(), 'telar-e2e-'));
after(() => rmSync(root, { recursive: true }));

let folders = 0;
function freshFolder() {
  const folder = path.join(root, String(++folders));
  mkdirSync(folder);
  return Object.assign((...names) => path.join(folder, ...names), { folder });
}

/** Runs telar to its end: {status, signal, stdout: Buffer, stderr: string}. */
function telar(argv, options = {}) {
  const result = spawnSync(BIN, argv, { maxBuffer: 1 << 28, timeout: 600_000, ...options });
  return { ...result, stderr: result.stderr.toString() };
}

function drawn(argv, options) {
  const result = telar(argv, options);
  assert.equal(result.status, 0, result.stderr);
  return result;
}

const jsonOf = ({ stdout }) => {
  assert.equal(stdout.toString().trim().split('\n').length, 1, 'one JSON object on stdout');
  return JSON.parse(stdout);
};

/** Straight RGBA pixels and their size. */
async function pixelsOf(image) {
  const { data, info } = await sharp(image).ensureAlpha().raw().toBuffer({ resolveWithObject: true });
  return { data, width: info.width, height: info.height, alphaAt: (x, y) => data[(y * info.width + x) * 4 + 3] };
}

const isWholePng = (file) => readFileSync(file).subarray(-8, -4).toString() === 'IEND';

test('a garment becomes a thumbnail: transparent around, opaque in the middle, as large as the frame allows', async () => {
  const at = freshFolder();
  const { stdout } = drawn(['thumbnail', SHIRT, '-o', at('shirt.png'), '--size', '96x64']);
  assert.equal(stdout.toString(), `${at('shirt.png')}\n`);
  const image = await pixelsOf(at('shirt.png'));
  assert.deepEqual([image.width, image.height], [96, 64]);
  assert.deepEqual([image.alphaAt(0, 0), image.alphaAt(95, 63), image.alphaAt(48, 32)], [0, 0, 255]);
  // The box of the garment takes 0.9; the garment is narrower than its box at the front, where perspective widens most.
  const rows = Array.from({ length: 64 }, (_, y) => y).filter((y) => Array.from({ length: 96 }, (_, x) => image.alphaAt(x, y)).some((alpha) => alpha > 0));
  const covered = (rows.at(-1) - rows[0] + 1) / 64;
  assert.ok(covered > 0.7 && covered <= 0.94, `fills ${covered} of the height`);
  assert.deepEqual(readdirSync(at.folder), ['shirt.png']);
});

test('stdin to stdout gives the bytes that files give', () => {
  const at = freshFolder();
  drawn(['thumbnail', SHIRT, '-o', at('shirt.png'), ...SMALL]);
  const { stdout } = drawn(['thumbnail', '-', '-o', '-', ...SMALL], { input: readFileSync(SHIRT) });
  assert.ok(stdout.equals(readFileSync(at('shirt.png'))));
});

test('--json: info of the frame, the shot with every default', () => {
  const at = freshFolder();
  const {
    ok,
    images: [{ info }],
  } = jsonOf(drawn(['thumbnail', SHIRT, '--json', '-o', at('a.png'), ...SMALL, '--background', 'white']));
  assert.equal(ok, true);
  assert.deepEqual([info.width, info.height, info.format], [64, 64, 'png']);
  assert.ok(info.features.length > 0 && info.passes.length > 0);
  assert.ok(['egl-device', 'egl-surfaceless', 'osmesa'].includes(info.backend));
  assert.deepEqual(info.shot.background, [1, 1, 1]);
  assert.equal(info.shot.camera.fovY, 30);
  assert.ok(info.milliseconds.total > 0);
});

test('the extension gives the format', () => {
  const at = freshFolder();
  const magic = { 'a.jpg': 'ffd8ff', 'a.webp': '52494646', 'a.png': '89504e47', 'a.raw': '' };
  for (const [name, bytes] of Object.entries(magic)) {
    drawn(['thumbnail', SHIRT, '-o', at(name), ...SMALL]);
    assert.ok(readFileSync(at(name)).toString('hex').startsWith(bytes), name);
  }
  assert.equal(readFileSync(at('a.raw')).length, 64 * 64 * 4);
});

test('views, variants and backgrounds change the picture', () => {
  const { variants } = jsonOf(drawn(['inspect', SHIRT, '--json']));
  assert.ok(variants.length >= 2);
  const picture = (...argv) => drawn(['thumbnail', SHIRT, '-o', '-', ...SMALL, ...argv]).stdout.toString('hex');
  const pictures = [[], ['--view', 'back'], ['--view', 'three-quarter'], ['--variant', variants[1]], ['--background', 'environment']].map((argv) =>
    picture(...argv),
  );
  assert.equal(new Set(pictures).size, pictures.length);
});

test('one broken model among many: the others are drawn, the exit code says input', () => {
  const at = freshFolder();
  writeFileSync(at('cut.glb'), readFileSync(SHIRT).subarray(0, 5000));
  writeFileSync(at('empty.glb'), '');
  writeFileSync(at('page.glb'), '<!doctype html>');
  const models = [SHIRT, at('cut.glb'), at('empty.glb'), at('page.glb'), at('absent.glb')];
  const result = telar(['thumbnail', ...models, '-o', at('out'), '--json', ...SMALL]);
  assert.equal(result.status, 3, result.stderr);
  const { images } = jsonOf(result);
  assert.deepEqual(
    images.map(({ ok }) => ok),
    [true, false, false, false, false],
  );
  assert.ok(images.slice(1).every(({ error }) => error.kind === 'input'));
  assert.equal(images[2].error.code, 'E_EMPTY');
  assert.deepEqual(readdirSync(at('out')), ['tshirt.png']);
  for (const { error } of images.slice(1)) assert.ok(!error.message.includes(at.folder), error.message);
});

test('exit codes: usage 2, input 3, limit 4, machine 6', () => {
  const at = freshFolder();
  const out = ['-o', at('a.png')];
  const exits = (...argv) => {
    const { status, stdout } = telar([...argv, '--json']);
    const { error, images } = JSON.parse(stdout);
    return [status, (error ?? images[0].error).code];
  };
  assert.deepEqual(exits('thumbnail', SHIRT, ...out, '--size', '0'), [2, 'E_SHOT']);
  assert.deepEqual(exits('thumbnail', SHIRT, ...out, '--limit', 'L_NOTHING=1'), [2, 'E_OPTION']);
  assert.deepEqual(exits('thumbnail', SHIRT, ...out, '--variant', 'no such colour'), [3, 'E_VARIANT']);
  assert.deepEqual(exits('thumbnail', SHIRT, ...out, '--environment', at('absent.hdr')), [3, 'E_ENVIRONMENT_MISSING']);
  assert.deepEqual(exits('thumbnail', SHIRT, ...out, '--limit', 'L_TRIANGLES=1'), [4, 'L_TRIANGLES']);
  assert.deepEqual(exits('thumbnail', SHIRT, '-o', '/dev/full', '--set', 'output.format=png', ...SMALL), [6, 'X_OUTPUT']);
  assert.deepEqual(readdirSync(at.folder), []);
});

test('inspect says what is in the garment and what a render compiles', () => {
  const facts = jsonOf(drawn(['inspect', SHIRT, '--json']));
  assert.ok(facts.size.every((metres) => metres > 0.05 && metres < 2));
  assert.ok(facts.triangles > 100 && facts.materials.length > 0 && facts.plan.features.length > 0 && facts.plan.passes.length > 0);
  const fewer = jsonOf(drawn(['inspect', SHIRT, '--json', '--environment', 'none']));
  assert.notDeepEqual(fewer.plan.features, facts.plan.features);
  const text = drawn(['inspect', SHIRT]).stdout.toString();
  for (const line of ['size', 'geometry', 'materials', 'variants', 'features', 'passes']) assert.match(text, new RegExp(`^${line} +\\S`, 'm'));
});

test('doctor finds a backend here', () => {
  const report = jsonOf(drawn(['doctor', '--json']));
  assert.equal(report.ok, true);
  assert.ok(report.backends.some(({ backend, works }) => backend === report.chosen && works));
  assert.match(drawn(['doctor']).stdout.toString(), /^chosen +\S+/m);
});

test('each backend that doctor finds draws', () => {
  const { backends } = jsonOf(drawn(['doctor', '--json']));
  for (const { backend } of backends.filter(({ works }) => works)) {
    const at = freshFolder();
    const {
      images: [{ info }],
    } = jsonOf(drawn(['thumbnail', SHIRT, '-o', at('a.png'), '--json', '--backend', backend, ...SMALL]));
    assert.equal(info.backend, backend);
  }
});

for (const jobs of [[], ['--jobs', '2']]) {
  test(`SIGINT ends the run as a signal does and leaves whole files only ${jobs.join(' ')}`, async () => {
    const at = freshFolder();
    const copies = Array.from({ length: 40 }, (_, i) => {
      writeFileSync(at(`${i}.glb`), readFileSync(SHIRT));
      return at(`${i}.glb`);
    });
    const child = spawn(BIN, ['thumbnail', ...copies, '-o', at('out'), '--size', '1500', ...jobs], { stdio: ['ignore', 'pipe', 'pipe'] });
    const ended = once(child, 'close');
    const deadline = Date.now() + 60_000;
    while (!(existsSync(at('out')) && readdirSync(at('out')).some((name) => name.endsWith('.png'))) && Date.now() < deadline) await sleep(5);
    child.kill('SIGINT');
    const [code, signal] = await ended;
    assert.deepEqual([code, signal], [null, 'SIGINT']);
    const files = readdirSync(at('out'));
    assert.ok(files.length >= 1 && files.length < copies.length, `${files.length} files`);
    for (const file of files) assert.ok(/^\d+\.png$/.test(file) && isWholePng(at('out', file)), file);
  });
}

test('--jobs draws the same bytes, and a file that is damaged stops no other', () => {
  const at = freshFolder();
  const models = ['a', 'b', 'c'].map((name) => at(`${name}.glb`));
  for (const model of models) writeFileSync(model, readFileSync(SHIRT));
  writeFileSync(models[1], 'no model');
  const [own, far] = [[], ['--jobs', '2']].map((jobs) => {
    const out = at(`out${jobs.length}`);
    const { status, stdout } = telar(['thumbnail', ...models, '-o', out, '--views', 'front,back', '--json', ...SMALL, ...jobs]);
    const { images } = jsonOf({ stdout });
    const pictures = images.map(({ ok, error, output }) => [ok, error?.code, ok && readFileSync(output).toString('base64')]);
    return { status, pictures };
  });
  assert.equal(far.status, 3);
  assert.equal(far.pictures.filter(([ok]) => ok).length, 4);
  assert.deepEqual(far, own);
});

test('a reader that leaves early is an output error, not a hang', async () => {
  const child = spawn(BIN, ['thumbnail', SHIRT, '-o', '-', '--size', '512', '--set', 'output.format=raw'], { stdio: ['ignore', 'pipe', 'pipe'] });
  child.stdout.destroy();
  const [code] = await once(child, 'close');
  assert.equal(code, 6);
});
