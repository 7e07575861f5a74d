import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import sharp from 'sharp';
import { sphereAndSlope } from '../api/support/layer_scenes.mjs';
import '../api/support/real.mjs';

const TELAR = fileURLToPath(new URL('../../../js/cli/telar.mjs', import.meta.url));

let folder;
let model;
before(async () => {
  folder = mkdtempSync(path.join(tmpdir(), 'telar-layers-'));
  model = path.join(folder, 'ball.glb');
  writeFileSync(model, await sphereAndSlope());
});
after(() => rmSync(folder, { recursive: true, force: true }));

const at = (name) => path.join(folder, name);

/** @returns {Promise<{exit: number, stdout: string, stderr: string}>} */
const telar = (...argv) =>
  new Promise((resolve) => {
    execFile(process.execPath, [TELAR, 'thumbnail', model, ...argv], (error, stdout, stderr) => resolve({ exit: error?.code ?? 0, stdout, stderr }));
  });

test('layers stand beside the picture, named after it', async () => {
  const { exit, stdout, stderr } = await telar('-o', at('a.png'), '--size', '64x48', '--layers', 'depth,partId', '--json');
  assert.equal(exit, 0, stderr);
  const [image] = JSON.parse(stdout).images;
  assert.deepEqual(image.layers, { depth: at('a.depth.png'), partId: at('a.partId.png') });
  assert.deepEqual(
    image.info.layers.partId.legend.map(({ name }) => name),
    ['ball', 'slope'],
  );
  for (const name of ['a.png', 'a.depth.png', 'a.partId.png']) {
    const { width, height } = await sharp(at(name)).metadata();
    assert.deepEqual([width, height], [64, 48], name);
  }
});

test('layers need a file to stand beside, and take nobody else’s name', async () => {
  const stdout = await telar('-o', '-', '--layers', 'depth');
  assert.equal(stdout.exit, 2);
  assert.match(stdout.stderr, /layers go to files beside the picture/);
  const unknown = await telar('-o', at('b.png'), '--layers', 'deep');
  assert.equal(unknown.exit, 2);
  assert.match(unknown.stderr, /shot\.layers\[0\]: expected "beauty", "depth"/);
  assert.ok(!readdirSync(folder).includes('b.png'));
});

test('a flat in true scale from the command line', async () => {
  const { exit, stdout, stderr } = await telar('-o', at('flat.png'), '--style', 'flat', '--scale', '1:10', '--json');
  assert.equal(exit, 0, stderr);
  const [{ info }] = JSON.parse(stdout).images;
  assert.ok(Math.abs(info.millimetresPerPixel - (25.4 / 300) * 10) < 1e-12);
  const { density, width } = await sharp(at('flat.png')).metadata();
  assert.equal(density, 300);
  assert.equal(width, info.width);
});

test('a turntable as files and as one animation', async () => {
  const files = await telar('-o', `${at('turn')}/`, '--size', '40x40', '--turntable', '4');
  assert.equal(files.exit, 0, files.stderr);
  assert.deepEqual(readdirSync(at('turn')).toSorted(), ['ball-side-000.png', 'ball-side-090.png', 'ball-side-180.png', 'ball-side-270.png']);
  const named = await telar('-o', at('named/{view}.png'), '--size', '40x40', '--turntable', '2');
  assert.equal(named.exit, 0, named.stderr);
  assert.deepEqual(readdirSync(at('named')).toSorted(), ['side-000.png', 'side-180.png']);
  const animated = await telar('-o', at('turn.webp'), '--size', '40x40', '--turntable', '4');
  assert.equal(animated.exit, 0, animated.stderr);
  assert.equal((await sharp(at('turn.webp'), { animated: true }).metadata()).pages, 4);
  const wrong = await telar('-o', at('x/'), '--turntable', '0');
  assert.equal(wrong.exit, 2);
  assert.match(wrong.stderr, /--turntable: expected a whole number of frames from 1 to 720, got "0"/);
});

test('--explode moves parts apart, in files and in an animation', async () => {
  const bytesOf = async (name, ...argv) => {
    const { exit, stderr } = await telar('-o', at(name), '--size', '40x40', '--view', 'right', ...argv);
    assert.equal(exit, 0, stderr);
    return readFileSync(at(name));
  };
  const [whole, still, apart] = [await bytesOf('w.png'), await bytesOf('s.png', '--explode', '0'), await bytesOf('e.png', '--explode', '0.5')];
  assert.ok(still.equals(whole), 'by 0 m it is the same picture');
  assert.ok(!apart.equals(whole));
  const turn = ['--turntable', '3'];
  const [plain, moved] = [await bytesOf('plain.webp', ...turn), await bytesOf('moved.webp', ...turn, '--explode', '0.5')];
  assert.equal((await sharp(moved, { animated: true }).metadata()).pages, 3);
  assert.ok(!moved.equals(plain), 'the frames show the parts apart');
  for (const wrong of ['-1', 'far', ' ']) {
    const { exit, stderr } = await telar('-o', at('x.png'), `--explode=${wrong}`);
    assert.equal(exit, 2);
    assert.match(stderr, /--explode: expected metres, 0 or more, got "/);
  }
  const known = await telar('-o', at('x.png'), '--explode', '0.1', '--skip-unchanged');
  assert.equal(known.exit, 2);
  assert.match(known.stderr, /--explode and --skip-unchanged: give one of them/);
});

test('--ghost draws parts translucent, by default or as opaque as it says', async () => {
  const partsOf = async (...argv) => {
    const { exit, stdout, stderr } = await telar(
      '-o',
      at('g.png'),
      '--size',
      '40x40',
      '--layers',
      'partId',
      '--set',
      'output.layers.bitDepth=8',
      '--json',
      ...argv,
    );
    assert.equal(exit, 0, stderr);
    const ids = await sharp(at('g.partId.png')).raw().toBuffer();
    return { ghost: JSON.parse(stdout).images[0].info.shot.ghost, parts: [...new Set(ids)].sort() };
  };
  assert.deepEqual(await partsOf(), { ghost: [], parts: [0, 1, 2] });
  assert.deepEqual(await partsOf('--ghost', 'node=ba*'), { ghost: [{ node: 'ba*', opacity: 0.25 }], parts: [0, 2] });
  assert.deepEqual(await partsOf('--ghost', 'node=ball:0.8', '--ghost', 'material=1:0'), {
    ghost: [
      { node: 'ball', opacity: 0.8 },
      { material: 1, opacity: 0 },
    ],
    parts: [0, 1],
  });
  for (const wrong of ['ball', 'node=ball:7']) {
    const { exit, stderr } = await telar('-o', at('x.png'), '--ghost', wrong);
    assert.equal(exit, 2, stderr);
    assert.match(stderr, /shot\.ghost\[0\]/);
  }
});
