import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { CLOTHS } from '../../../js/shot/table/cloths.mjs';
import { box } from '../../fixtures/geometry.mjs';
import { GlbBuilder } from '../../fixtures/glb.mjs';
import { ENVIRONMENTS, MODELS } from '../../fixtures/index.mjs';
import { clickAt, save, tool } from './spec_support.mjs';
import { changing, figuresOf, launchChromium, openView, pictures, settled, SHIRT } from './support.mjs';

// The page of test/js/view/page.test.mjs with other models, and by another GL. All tests share one tab: each new one has a process of its own,
// and the garment's page is compiled once.

const folder = mkdtempSync(path.join(tmpdir(), 'telar-view-models-'));
const at = (name) => path.join(folder, name);

let shirt;
let browser;
let page;
const said = [];

before(async () => {
  [shirt, browser] = await Promise.all([openView(SHIRT, ['--size', '96']), launchChromium()]);
  page = await browser.newPage();
  page.on('pageerror', (error) => said.push(String(error)));
  await page.goto(shirt.url);
  await settled(page);
});
after(async () => {
  await browser?.close();
  await shirt?.stop();
  rmSync(folder, { recursive: true });
});

const shotOf = async () => JSON.parse(await page.locator('#shot').inputValue());
const verdict = () => page.locator('#verdict').textContent();

/** Shows another model. */
async function show(t, ...args) {
  const view = await openView(...args);
  t.after(() => view.stop());
  await page.goto(view.url);
  await settled(page);
}

/** As a reader of the screen finds it. */
const radio = (name) => page.getByRole('radiogroup', { name: 'Cloth' }).getByRole('radio', { name, exact: true });
const chooseCloth = (name) => radio(name).check({ force: true });

test('every cloth has a picture of its own in the picker, and keys choose', async () => {
  const shown = await page.evaluate(async () => {
    const squares = [...document.querySelectorAll('#cloths label span:not(.own)')];
    const [, url] = /url\("(.*)"\)/.exec(getComputedStyle(squares[0]).backgroundImage);
    const image = await createImageBitmap(await (await fetch(url)).blob());
    const context = new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true });
    const side = image.width / 7;
    return squares.map((square) => {
      const [x, y] = getComputedStyle(square)
        .backgroundPosition.split(' ')
        .map((part) => Number.parseFloat(part) / 100);
      context.drawImage(image, Math.round(x * 6) * side, Math.round(y * (image.height / side - 1)) * side, side, side, 0, 0, 1, 1);
      return { name: square.parentElement.title, color: [...context.getImageData(0, 0, 1, 1).data].join(), at: `${x} ${y}`, width: square.clientWidth };
    });
  });
  assert.deepEqual(
    shown.map(({ name }) => name.toLowerCase().replaceAll(' ', '-')),
    [...CLOTHS],
  );
  assert.equal(new Set(shown.map(({ at: place }) => place)).size, CLOTHS.length);
  assert.ok(new Set(shown.map(({ color }) => color)).size > CLOTHS.length / 2, 'pictures differ');
  assert.ok(shown.every(({ width }) => width >= 24));
  await radio('As in the file').focus();
  await changing(page, () => page.keyboard.press('ArrowRight'));
  await changing(page, () => page.keyboard.press('ArrowRight'));
  assert.deepEqual((await shotOf()).materials, { '*': { preset: CLOTHS[1] } });
  assert.equal(await page.locator('#cloth-name').textContent(), 'Denim');
  await changing(page, () => chooseCloth('As in the file'));
  assert.equal((await shotOf()).materials, undefined);
});

test('a part is shown in another cloth, alike on both sides, and in its own again', async () => {
  const before = await pictures(page);
  await page.locator('#part').selectOption('*');
  await changing(page, () => chooseCloth('Denim'));
  await changing(page, () => page.locator('#clothColour').fill('#23324f'));
  assert.deepEqual((await shotOf()).materials, { '*': { preset: 'denim', color: '#23324f' } });
  assert.equal(await verdict(), 'Parity');
  assert.notDeepEqual(await pictures(page), before);
  await changing(page, () => page.locator('#clothRotation').fill('45'));
  assert.equal(await verdict(), 'Parity');
  await changing(page, () => chooseCloth('As in the file'));
  assert.equal((await shotOf()).materials, undefined);
  assert.deepEqual(await pictures(page), before, 'its own again');
});

test('a cloth that does not come is told of as any answer that does not, and is asked for again', async (t) => {
  await page.route('**/cloths/linen.glb', (route) => route.abort(), { times: 1 });
  t.after(() => page.unroute('**/cloths/linen.glb'));
  await chooseCloth('Linen');
  await page.waitForSelector('body[data-phase=error]');
  assert.match(await page.locator('#alert').textContent(), /it has ended \[X_CLOSED\]/);
  await changing(page, () => chooseCloth('As in the file'));
  await changing(page, () => chooseCloth('Linen'));
  assert.equal(await verdict(), 'Parity');
  await changing(page, () => chooseCloth('As in the file'));
});

test('what fails of a shot that is no longer the last is not told, and the last one is drawn', async (t) => {
  let release;
  const held = new Promise((resolve) => (release = resolve));
  await page.route('**/cloths/velvet.glb', (route) => held.then(() => route.abort()));
  t.after(() => page.unroute('**/cloths/velvet.glb'));
  const [before] = await pictures(page);
  await changing(page, async () => {
    const asked = page.waitForRequest('**/cloths/velvet.glb');
    await chooseCloth('Velvet');
    await asked;
    await chooseCloth('As in the file');
    release();
  });
  assert.equal(await page.locator('#alert').isVisible(), false);
  assert.equal((await pictures(page))[0], before);
  assert.equal(await verdict(), 'Parity');
});

test('a picture of many samples is asked for as it grows, and stands in the end', async () => {
  const asked = [];
  page.on('request', (request) => asked.push(request.url().split('/').at(-1)));
  await page.locator('#shot-text').evaluate((details) => (details.open = true));
  const apply = async (changes) => {
    await page.fill('#shot', JSON.stringify({ ...(await shotOf()), ...changes }));
    await changing(page, () => page.click('#apply-shot'));
  };
  await apply({ size: { width: 64, height: 64 } });
  assert.ok(asked.includes('draw') && !asked.includes('grow'), 'one pass has nothing to grow');
  const [, once] = await pictures(page);
  await apply({ quality: { samples: 64 } });
  assert.ok(asked.includes('grow'));
  assert.match(await page.locator('#server-time').textContent(), /^\d+ ms$/);
  assert.notEqual((await pictures(page))[1], once);
});

test('a .gltf with its files beside it, beneath an environment of the command line', async (t) => {
  mkdirSync(at('coat'), { recursive: true });
  const glb = readFileSync(SHIRT);
  const jsonBytes = glb.readUInt32LE(12);
  const document = JSON.parse(glb.toString('utf8', 20, 20 + jsonBytes));
  const bin = glb.subarray(28 + jsonBytes);
  document.buffers[0].uri = 'the%20coat.bin';
  writeFileSync(at('coat/the coat.bin'), bin.subarray(0, document.buffers[0].byteLength));
  document.images.forEach((image, i) => {
    const { byteOffset = 0, byteLength } = document.bufferViews[image.bufferView];
    writeFileSync(at(`coat/${i}.image`), bin.subarray(byteOffset, byteOffset + byteLength));
    document.images[i] = { name: image.name, mimeType: image.mimeType, uri: `${i}.image` };
  });
  writeFileSync(at('coat/coat #1.gltf'), JSON.stringify(document));
  writeFileSync(at('lamps.hdr'), ENVIRONMENTS.lamps());
  await show(t, at('coat/coat #1.gltf'), ['--size', '64', '--environment', at('lamps.hdr')]);
  assert.equal(await verdict(), 'Parity');
  assert.equal(await page.locator('#model-name').textContent(), 'coat #1.gltf');
  assert.ok((await figuresOf(page, 'interior')).pixels > 1000);
  assert.deepEqual((await shotOf()).environment, { map: 'lamps.hdr' });
  assert.equal(await page.locator('#environment').inputValue(), 'lamps.hdr');
});

test('keys alone: a moment of an animation, framed and drawn alike', async (t) => {
  writeFileSync(at('moving.glb'), await MODELS['morph-and-skin']());
  await show(t, at('moving.glb'), ['--size', '64']);
  assert.equal(await page.locator('#time').isDisabled(), true);
  let last = await pictures(page);
  for (const [selector, key] of [
    ['#animation', 'ArrowDown'],
    ['#time', 'End'],
  ]) {
    await page.focus(selector);
    await changing(page, () => page.keyboard.press(key));
    const now = await pictures(page);
    now.forEach((picture, i) => assert.notEqual(picture, last[i], `${selector} ${i}`));
    assert.equal(await verdict(), 'Parity', selector);
    assert.equal(await page.locator('#notes li').count(), 0, await page.locator('#notes').textContent());
    last = now;
  }
  const { pose } = await shotOf();
  assert.ok(pose.animation === 0 && pose.time > 0, JSON.stringify(pose));
});

test('a click goes through what the shot leaves out', async (t) => {
  const builder = new GlbBuilder();
  builder.add(box(0.5), builder.material({ name: 'cloth' }));
  builder.add(box(0.1), builder.material({ name: 'stand' }), { translation: [0, 0, 0.5] });
  const [model, spec] = [at('stand.glb'), at('stand.json')];
  writeFileSync(model, await builder.bytes());
  await show(t, model, ['--size', '96', '--view', 'front', '--set', 'ghost=[{"material":"stand","opacity":0}]', '--spec', spec]);
  await tool(page, 'callout');
  await clickAt(page, [0.5, 0.5]);
  await save(page);
  const [{ point }] = JSON.parse(readFileSync(spec, 'utf8')).callouts;
  assert.ok(Math.abs(point[2] - 0.25) < 1e-4, `${point}`);
});

test('KTX2 textures and Draco meshes are decoded in the page', async (t) => {
  for (const name of ['ktx2-etc1s', 'draco-edgebreaker']) {
    writeFileSync(at(`${name}.glb`), await MODELS[name]());
    await show(t, at(`${name}.glb`), ['--size', '64']);
    // Browsers transcode for their GL, which rounds: js/docs has how far.
    const { pixels, max } = await figuresOf(page, 'interior');
    assert.ok(pixels > 200 && max <= (name.startsWith('ktx2') ? 16 : 2), `${name} ${pixels} ${max}`);
  }
});

test('a browser with another GL is judged by the gate for that', async (t) => {
  const other = await launchChromium('swiftshader');
  t.after(() => other.close());
  const elsewhere = await other.newPage();
  await elsewhere.goto(shirt.url);
  await settled(elsewhere);
  assert.equal(await elsewhere.locator('#gl-hint').isVisible(), true);
  assert.equal(await elsewhere.locator('#gate-command').textContent(), 'telar compare --gate other-gl');
  // The gate is for pictures, not for icons, which are silhouette for the most part.
  await elsewhere.focus('#width');
  await changing(elsewhere, async () => {
    await elsewhere.fill('#width', '256');
    await elsewhere.fill('#height', '256');
    await elsewhere.keyboard.press('Tab');
  });
  assert.equal(await elsewhere.locator('#verdict').textContent(), 'Alike by two GLs');
  assert.match(await elsewhere.locator('#checks').textContent(), /object CIEDE2000 p95: .*, at most 3/);
});

test('nothing was said against the page', () => assert.deepEqual(said, []));
