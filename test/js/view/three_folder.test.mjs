import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { openThree } from '../../../js/view/three_folder.mjs';
import { fetchRelease } from '../../families/releases.mjs';
import { changing, figuresOf, launchChromium, openView, settled, SHIRT } from './support.mjs';

// `telar view --three`: the browser's picture by another release than the page brings, a real one.

const folder = mkdtempSync(path.join(tmpdir(), 'telar-three-'));
const at = (...names) => path.join(folder, ...names);
const RELEASE = '0.170.0';

let browser;
before(async () => {
  browser = await launchChromium();
});
after(async () => {
  await browser?.close();
  rmSync(folder, { recursive: true });
});

/** A package that looks like three.js. */
function planted(name, { version = '0.170.0', files = ['build/three.module.js', 'examples/jsm/loaders/HDRLoader.js'] } = {}) {
  for (const file of files) {
    mkdirSync(path.dirname(at(name, file)), { recursive: true });
    writeFileSync(at(name, file), 'export {};');
  }
  writeFileSync(at(name, 'package.json'), JSON.stringify({ name: 'three', version }));
  return at(name);
}

test('the folder of the package or of a project is opened; what else is there is not for the page', () => {
  const own = planted('project/node_modules/three', { files: ['build/three.module.js', 'examples/jsm/libs/draco/gltf/draco_decoder.js', 'src/Secret.js'] });
  const { revision, files, decoders, importMap } = openThree(at('project'));
  assert.equal(revision, 170);
  assert.deepEqual([...files.keys()].sort(), ['build/three.module.js', 'examples/jsm/libs/draco/gltf/draco_decoder.js']);
  assert.deepEqual([...decoders], [['draco/draco_decoder.js', path.join(own, 'examples/jsm/libs/draco/gltf/draco_decoder.js')]]);
  assert.match(importMap, /HDRLoader\.js":"\.\/page\/hdr_loader\.js"/);
  assert.deepEqual([...openThree(own).files.keys()], [...files.keys()]);
  assert.doesNotMatch(openThree(planted('newer')).importMap, /hdr_loader/);
});

test('what is no three.js, or too old, is refused', () => {
  assert.throws(() => openThree(at('nowhere')), { code: 'E_USAGE', message: /--three .*expected the folder of the npm package three/ });
  assert.throws(() => openThree(planted('old', { version: '0.149.0' })), { code: 'E_USAGE', message: /0\.150 or later, got "0\.149\.0"/ });
  assert.throws(() => openThree(planted('empty', { files: ['src/Three.js'] })), { code: 'E_USAGE' });
});

test('a real older release draws the page, and the server follows it', async (t) => {
  const view = await openView(SHIRT, ['--size', '96', '--three', await fetchRelease(RELEASE)]);
  t.after(() => view.stop());
  const page = await browser.newPage();
  const said = [];
  page.on('pageerror', (error) => said.push(String(error)));
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) said.push(message.text());
  });
  await page.goto(view.url);
  await settled(page);
  assert.match(await page.locator('#client-gl').textContent(), /^three\.js r170, /);
  const shading = async () => JSON.parse(await page.locator('#shot').inputValue()).shading;
  assert.deepEqual(await shading(), { base: 'three', revision: 170 });
  const followed = await figuresOf(page, 'interior');
  assert.ok(followed.pixels > 3000 && followed.max <= 2 && followed['p99.9'] <= 1, JSON.stringify(followed));
  assert.deepEqual(said, []);

  // The release that the page does not have: the server draws it, and the page says so.
  await changing(page, async () => {
    await page.locator('summary').evaluate((node) => (node.parentElement.open = true));
    await page.locator('#shot').fill(JSON.stringify({ size: { width: 96, height: 96 }, shading: 'three' }));
    await page.locator('#apply-shot').click();
  });
  const other = await figuresOf(page, 'interior');
  // 26/255 with telar as 0.187 and this garment.
  assert.ok(other.max > 10, `${other.max}`);
  assert.ok(
    said.some((line) => /three\.js 0\.170 .*three\.js 0\.187/.test(line)),
    said.join('\n'),
  );

  // "three" of the form is the page's own again.
  await changing(page, () => page.locator('#shading').selectOption('fabric'));
  await changing(page, () => page.locator('#shading').selectOption('three'));
  assert.deepEqual(await shading(), { base: 'three', revision: 170 });
});
