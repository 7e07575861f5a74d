import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { ENVIRONMENTS, MODELS } from '../../fixtures/index.mjs';
import { changing, figuresOf, launchChromium, openView, pictures, settled, SHIRT } from './support.mjs';

// The page of test/js/view/page.test.mjs with other models, and by another GL.

const folder = mkdtempSync(path.join(tmpdir(), 'telar-view-models-'));
const at = (name) => path.join(folder, name);

let browser;
const said = [];

before(async () => {
  browser = await launchChromium();
});
after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true });
});

async function newPage() {
  const page = await browser.newPage();
  page.on('pageerror', (error) => said.push(String(error)));
  return page;
}

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
  const other = await openView(at('coat/coat #1.gltf'), ['--size', '64', '--quality', 'draft', '--environment', at('lamps.hdr')]);
  t.after(() => other.stop());
  const second = await newPage();
  await second.goto(other.url);
  await settled(second);
  assert.equal(await second.locator('#verdict').textContent(), 'Parity');
  assert.equal(await second.locator('#model-name').textContent(), 'coat #1.gltf');
  assert.ok((await figuresOf(second, 'interior')).pixels > 1000);
  assert.deepEqual(JSON.parse(await second.locator('#shot').inputValue()).environment, { map: 'lamps.hdr' });
  assert.equal(await second.locator('#environment').inputValue(), 'lamps.hdr');
  await second.close();
});

test('a picture of many samples is asked for as it grows, and stands in the end', async (t) => {
  const view = await openView(SHIRT, ['--size', '64']);
  t.after(() => view.stop());
  const page = await newPage();
  const asked = [];
  page.on('request', (request) => asked.push(request.url().split('/').at(-1)));
  await page.goto(view.url);
  await settled(page);
  assert.ok(asked.includes('draw') && !asked.includes('grow'), 'one pass has nothing to grow');
  const [, once] = await pictures(page);
  await page.locator('#shot-text').evaluate((details) => (details.open = true));
  await page.fill('#shot', JSON.stringify({ ...JSON.parse(await page.locator('#shot').inputValue()), quality: { samples: 64 } }));
  await changing(page, () => page.click('#apply-shot'));
  assert.ok(asked.includes('grow'));
  assert.match(await page.locator('#server-time').textContent(), /^\d+ ms$/);
  assert.notEqual((await pictures(page))[1], once);
  await page.close();
});

test('a part is shown in another cloth, alike on both sides, and in its own again', async (t) => {
  const view = await openView(SHIRT, ['--size', '96']);
  t.after(() => view.stop());
  const page = await newPage();
  await page.goto(view.url);
  await settled(page);
  const shotOf = async () => JSON.parse(await page.locator('#shot').inputValue());
  const verdict = () => page.locator('#verdict').textContent();
  const before = await pictures(page);
  await page.locator('#part').selectOption('*');
  await changing(page, () => page.locator('#cloth').selectOption('denim'));
  await changing(page, () => page.locator('#clothColour').fill('#23324f'));
  assert.deepEqual((await shotOf()).materials, { '*': { preset: 'denim', color: '#23324f' } });
  assert.equal(await verdict(), 'Parity');
  assert.notDeepEqual(await pictures(page), before);
  await changing(page, () => page.locator('#clothRotation').fill('45'));
  assert.equal(await verdict(), 'Parity');
  await changing(page, () => page.locator('#cloth').selectOption(''));
  assert.equal((await shotOf()).materials, undefined);
  assert.deepEqual(await pictures(page), before, 'its own again');
  await page.close();
});

test('keys alone: a moment of an animation, framed and drawn alike', async (t) => {
  writeFileSync(at('moving.glb'), await MODELS['morph-and-skin']());
  const other = await openView(at('moving.glb'), ['--size', '64']);
  t.after(() => other.stop());
  const second = await newPage();
  await second.goto(other.url);
  await settled(second);
  assert.equal(await second.locator('#time').isDisabled(), true);
  let last = await pictures(second);
  for (const [selector, key] of [
    ['#animation', 'ArrowDown'],
    ['#time', 'End'],
  ]) {
    await second.focus(selector);
    await changing(second, () => second.keyboard.press(key));
    const now = await pictures(second);
    now.forEach((picture, i) => assert.notEqual(picture, last[i], `${selector} ${i}`));
    assert.equal(await second.locator('#verdict').textContent(), 'Parity', selector);
    assert.equal(await second.locator('#notes li').count(), 0, await second.locator('#notes').textContent());
    last = now;
  }
  const { pose } = JSON.parse(await second.locator('#shot').inputValue());
  assert.ok(pose.animation === 0 && pose.time > 0, JSON.stringify(pose));
  await second.close();
});

test('KTX2 textures and Draco meshes are decoded in the page', async (t) => {
  for (const name of ['ktx2-etc1s', 'draco-edgebreaker']) {
    writeFileSync(at(`${name}.glb`), await MODELS[name]());
    const other = await openView(at(`${name}.glb`), ['--size', '64', '--quality', 'draft']);
    t.after(() => other.stop());
    const second = await newPage();
    await second.goto(other.url);
    await settled(second);
    // Browsers transcode for their GL, which rounds: js/docs has how far.
    const { pixels, max } = await figuresOf(second, 'interior');
    assert.ok(pixels > 200 && max <= (name.startsWith('ktx2') ? 16 : 2), `${name} ${pixels} ${max}`);
    await second.close();
  }
});

test('a browser with another GL is judged by the gate for that', async (t) => {
  const [view, other] = await Promise.all([openView(SHIRT, ['--size', '96']), launchChromium('swiftshader')]);
  t.after(() => Promise.all([view.stop(), other.close()]));
  const elsewhere = await other.newPage();
  await elsewhere.goto(view.url);
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
