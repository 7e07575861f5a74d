// The examples of js/docs/browser.md, bundled as a client does it and run in Chromium.
import assert from 'node:assert/strict';
import { createReadStream, existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import sharp from 'sharp';
import { launchChromium } from '../view/support.mjs';
import '../built.mjs';
import { startHost } from '../../http_host.mjs';

const ROOT = fileURLToPath(new URL('../../..', import.meta.url));
const TYPES = { '.js': 'text/javascript', '.html': 'text/html' };
const examples = [...readFileSync(path.join(ROOT, 'js/docs/browser.md'), 'utf8').matchAll(/^```js\n([\s\S]*?)^```$/gm)].map(([, text]) => text);

let folder;
let host;
let browser;
let page;

before(async () => {
  folder = mkdtempSync(path.join(tmpdir(), 'telar-browser-'));
  mkdirSync(path.join(folder, 'node_modules'));
  symlinkSync(ROOT, path.join(folder, 'node_modules/telar'));
  symlinkSync(path.join(ROOT, 'node_modules/three'), path.join(folder, 'node_modules/three'));
  examples.forEach((text, i) =>
    writeFileSync(path.join(folder, `example${i}.mjs`), `${text}\nwindow.done = true;\n${text.includes('denim') ? 'window.denim = denim;' : ''}`),
  );
  await build({
    absWorkingDir: folder,
    entryPoints: examples.map((_, i) => `example${i}.mjs`),
    outdir: 'out',
    bundle: true,
    splitting: true,
    format: 'esm',
    target: 'es2022',
    logLevel: 'warning',
  });
  host = await startHost(({ url }, response) => {
    const name = url.slice(1);
    const file = { 'shirt.glb': 'js/assets/tshirt.glb', 'studio.hdr': 'js/assets/studio.hdr' }[name];
    if (name.endsWith('.html'))
      response
        .setHeader('Content-Type', TYPES['.html'])
        .end(`<!doctype html><link rel="icon" href="data:,"><body><script type="module" src="${name.replace('.html', '.js')}"></script>`);
    else if (file) createReadStream(path.join(ROOT, file)).pipe(response);
    else if (existsSync(path.join(folder, 'out', name)))
      createReadStream(path.join(folder, 'out', name)).pipe(response.setHeader('Content-Type', TYPES['.js']));
    else response.writeHead(404).end();
  });
  browser = await launchChromium();
  page = await browser.newPage();
});
after(async () => {
  await browser?.close();
  host?.stop();
  rmSync(folder, { recursive: true });
});

/** Runs one example to its end. */
async function run(index) {
  const said = [];
  page.removeAllListeners();
  page.on('pageerror', (error) => said.push(String(error)));
  page.on('console', (message) => message.type() === 'error' && said.push(message.text()));
  await page.goto(`${host.origin}/example${index}.html`);
  await page.waitForFunction(() => window.done, undefined, { timeout: 600_000 });
  assert.deepEqual(said, []);
}

test('the example with a model draws it as cloth', async () => {
  await run(0);
  const { data, info } = await sharp(await page.locator('canvas').screenshot())
    .removeAlpha()
    .raw()
    .toBuffer({ resolveWithObject: true });
  assert.deepEqual([info.width, info.height], [512, 512]);
  const drawn = data.filter((value, i) => i % 3 === 0 && value < 255).length;
  assert.ok(drawn > 50_000, `${drawn} pixels are not the page's white`);
});

test('the example by hand makes a material', async () => {
  await run(1);
  assert.deepEqual(await page.evaluate(() => [window.denim.isFabricMaterial, window.denim.isMeshPhysicalMaterial, window.denim.fabric.weave.warp.coverage]), [
    true,
    true,
    0.6,
  ]);
});

test('shader text is fetched by whom it is asked for: no part that is loaded at once holds any', () => {
  const out = path.join(folder, 'out');
  const imports = (file, seen = new Set()) => {
    if (seen.has(file)) return seen;
    seen.add(file);
    const text = readFileSync(path.join(out, file), 'utf8');
    for (const [, name] of text.matchAll(/(?:from|import) "\.\/([\w-]+\.js)"/g)) imports(name, seen);
    return seen;
  };
  const holders = readdirSync(out).filter((file) => readFileSync(path.join(out, file), 'utf8').includes('telar_SurfaceInfo'));
  assert.ok(holders.length >= 3, holders.join(' '));
  assert.deepEqual(
    holders.filter((file) => imports('example0.js').has(file)),
    [],
  );
});
