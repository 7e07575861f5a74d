import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { embedShot, encodePng, readImage } from '../../../js/compare/index.mjs';
import { createRenderer } from '../../../js/index.mjs';
import { flat, square, withPixel } from '../compare/support.mjs';

const CLI = fileURLToPath(new URL('../../../js/cli/telar.mjs', import.meta.url));
const folder = mkdtempSync(path.join(tmpdir(), 'telar-compare-'));
const at = (name) => path.join(folder, name);
after(() => rmSync(folder, { recursive: true }));
before(async () => {
  const images = { expected: square(32), same: square(32), spot: withPixel(square(32), 16, 16, [255, 0, 0, 255]), small: flat(8, 8, [9, 9, 9, 255]) };
  for (const [name, image] of Object.entries(images)) writeFileSync(at(`${name}.png`), await encodePng(image));
  writeFileSync(at('text.png'), 'no image');
});

function compare(...args) {
  const { status, stdout, stderr } = spawnSync(process.execPath, [CLI, 'compare', ...args], { cwd: folder, encoding: 'utf8' });
  return { status, stdout, stderr };
}

test('within the gate: exit 0, and the figures as a table', () => {
  const { status, stdout, stderr } = compare('expected.png', 'same.png', '--gate', 'exact');
  assert.deepEqual([status, stderr], [0, '']);
  assert.match(stdout, /^interior +400 +0 +0 +0 /m);
  assert.match(stdout, /^within {2}frame max 0\/255, at most 0\/255\nwithin the gate exact\n$/m);
});

test('over the gate: exit 1, one JSON object', () => {
  const { status, stdout } = compare('expected.png', 'spot.png', '--json', '--gate', 'parity');
  const report = JSON.parse(stdout);
  assert.equal(status, 1);
  assert.deepEqual([report.ok, report.exit, report.gate, report.interior.max, report.interior.worst], [false, 1, 'parity', 155, [16, 16]]);
  assert.deepEqual(
    report.checks.map(({ pass }) => pass),
    [false, false, true],
  );
  assert.equal(report.flipMap, undefined);
});

test('the gate is standard unless another is named', () => {
  assert.equal(JSON.parse(compare('expected.png', 'same.png', '--json').stdout).gate, 'standard');
});

test('reports are written whether the gate holds or not', async () => {
  const { status } = compare('expected.png', 'spot.png', '--gate', 'parity', '--heatmap', 'heat.png', '--report', 'out/page', '--junit', 'out/junit.xml');
  assert.equal(status, 1);
  const heat = await readImage(at('heat.png'));
  assert.deepEqual([heat.width, heat.height], [32, 32]);
  assert.ok(heat.data[(16 * 32 + 16) * 4] > heat.data[0], 'the spot is lighter than the corner');
  assert.deepEqual(readdirSync(at('out/page')).sort(), ['actual.png', 'expected.png', 'heatmap.png', 'index.html']);
  assert.deepEqual(new Uint8Array((await readImage(at('out/page/expected.png'))).data), square(32).data);
  assert.match(readFileSync(at('out/page/index.html'), 'utf8'), /expected\.png and spot\.png: over the gate/);
  assert.match(readFileSync(at('out/junit.xml'), 'utf8'), /failures="2"/);
});

test('bad input is exit 3 and names the file, wrong usage exit 2; neither writes a report', () => {
  for (const [args, exit, message] of [
    [['expected.png', 'small.png', '--junit', 'bad.xml'], 3, /differ in size: 32x32 expected, 8x8 given.*E_IMAGE_SIZE/],
    [['expected.png', 'none.png', '--junit', 'bad.xml'], 3, /none\.png cannot be read \(ENOENT\).*E_FILE/],
    [['text.png', 'expected.png'], 3, /text\.png: .*E_IMAGE_FORMAT/],
    [['expected.png', 'same.png', '--limit', 'L_IMAGE_DIMENSION=16'], 4, /expected\.png: .*L_IMAGE_DIMENSION/],
    [['expected.png', 'same.png', '--gate', 'strict'], 2, /--gate.*E_USAGE/],
    [['expected.png'], 2, /either ACTUAL or --model.*E_USAGE/],
    [['expected.png', 'same.png', '--limit', 'L_NOTHING=1'], 2, /L_NOTHING/],
  ]) {
    const { status, stderr } = compare(...args);
    assert.equal(status, exit, `${args}: ${stderr}`);
    assert.match(stderr, message);
    assert.ok(!stderr.includes(folder), 'no path of the machine');
  }
  assert.ok(!existsSync(at('bad.xml')));
});

const MODEL = fileURLToPath(new URL('../../../js/assets/tshirt.glb', import.meta.url));
const SHOT = { size: { width: 64, height: 48 }, camera: { view: 'back' }, variant: 'indigo' };

/** Two screenshots of one shot, the second with a spot, and one of another shot. */
async function saveScreenshots() {
  const renderer = await createRenderer();
  const { data } = await renderer.render(MODEL, SHOT);
  await renderer.close();
  writeFileSync(at('screenshot.png'), embedShot(data, SHOT));
  const spot = withPixel(await readImage(data), 32, 24, [0, 255, 0, 255]);
  writeFileSync(at('spotted.png'), embedShot(await encodePng(spot), { ...SHOT, variant: 'terracotta', output: { format: 'png' } }));
}

test('a screenshot with its shot inside needs the model alone, and tells what it shows', async () => {
  await saveScreenshots();
  const { status, stdout } = compare('screenshot.png', '--model', MODEL, '--gate', 'exact');
  assert.equal(status, 0, stdout);
  assert.match(stdout, /^screenshot\.png shows size=\{"width":64,"height":48\} camera=\{"view":"back"\} variant="indigo"\n/);
  const json = JSON.parse(compare('spotted.png', '--model', MODEL, '--json', '--gate', 'parity', '--report', 'drawn').stdout);
  assert.deepEqual([json.exit, json.actual, json.shots], [1, MODEL, { expected: { ...SHOT, variant: 'terracotta', output: { format: 'png' } }, actual: null }]);
  assert.ok(existsSync(at('drawn/actual.png')));
});

test('a screenshot of another three.js than its shot names: the release is told, and what finding it took', async () => {
  const renderer = await createRenderer();
  const draw = async (shading) => (await renderer.render(MODEL, { ...SHOT, shading })).data;
  writeFileSync(at('older.png'), embedShot(await draw({ base: 'three', revision: 170 }), SHOT));
  await renderer.close();
  const json = JSON.parse(compare('older.png', '--model', MODEL, '--json', '--gate', 'parity').stdout);
  const [hint, ...more] = json.hints;
  assert.deepEqual([json.exit, more, hint.cause, hint.from, hint.to], [1, [], 'release', 164, 180]);
  assert.match(hint.message, /looks like three\.js 0\.164 to 0\.180: mean difference 0\/255, .* three@180 \(.*drawn in [\d.]+ s\)$/);
});

test('two screenshots: both shots are told, and in what they differ', () => {
  const { stdout } = compare('screenshot.png', 'spotted.png');
  assert.match(stdout, /^screenshot\.png shows .*\nspotted\.png shows .*variant="terracotta"\nthe shots differ in variant\n/);
});

test('--model without a shot, with ACTUAL, or with a shot that is damaged', () => {
  const damaged = readFileSync(at('screenshot.png'));
  damaged[damaged.indexOf('telar:shot') + 20] ^= 1;
  writeFileSync(at('damaged.png'), damaged);
  for (const [args, exit, message] of [
    [['expected.png', '--model', MODEL], 2, /expected\.png holds no shot: save the picture in telar view/],
    [['expected.png', 'same.png', '--model', MODEL], 2, /either ACTUAL or --model/],
    [['expected.png', 'same.png', '--explain'], 2, /--explain .* goes with --model/],
    [['damaged.png', '--model', MODEL], 3, /damaged\.png: .*E_IMAGE_CORRUPT/],
    [['screenshot.png', '--model', 'none.glb'], 3, /none\.glb.*E_FILE/],
  ]) {
    const { status, stderr } = compare(...args);
    assert.equal(status, exit, `${args}: ${stderr}`);
    assert.match(stderr, message);
  }
});
