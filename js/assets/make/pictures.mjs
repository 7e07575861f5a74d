import { spawnSync } from 'node:child_process';
import { mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import sharp from 'sharp';
import { launchChromium, openView, settled } from '../../../test/js/view/support.mjs';
import { createRenderer } from '../../index.mjs';

// The pictures of README and docs: the bundled garment in each of its colours, a contact sheet, and the page of `telar view`.
// npm run pictures

const ASSETS = new URL('..', import.meta.url);
const COLOURS = ['natural', 'terracotta', 'indigo'];

const renderer = await createRenderer();
const model = await renderer.load(new URL('tshirt.glb', ASSETS));
const frames = await renderer.renderAll(model, COLOURS.map((variant) => ({
  size: { width: 480, height: 480 },
  camera: { azimuth: 22, elevation: 6 },
  background: '#f4f1ec',
  variant,
})));
await mkdir(new URL('readme/', ASSETS), { recursive: true });
for (const [i, { data }] of frames.entries()) {
  await writeFile(new URL(`readme/${COLOURS[i]}.png`, ASSETS), data);
  console.log(`js/assets/readme/${COLOURS[i]}.png  ${data.length} bytes`);
}
await renderer.close();

const work = await mkdtemp(path.join(tmpdir(), 'telar-pictures-'));
const sheet = path.join(work, 'sheet.png');
spawnSync(process.execPath, [fileURLToPath(new URL('../cli/telar.mjs', ASSETS)), 'thumbnail', ...['tshirt.glb', 'fabrics.glb'].map((name) => fileURLToPath(new URL(name, ASSETS))),
  '-o', work, '--views', 'front,three-quarter,back', '--variants', 'all', '--size', '320x400', '--contact-sheet', sheet], { stdio: ['ignore', 'ignore', 'inherit'] });
// A photograph of many colours is small as a JPEG.
await sharp(sheet).resize({ width: 1068 }).jpeg({ quality: 88 }).toFile(fileURLToPath(new URL('readme/contact_sheet.jpg', ASSETS)));
await rm(work, { recursive: true });
console.log('js/assets/readme/contact_sheet.jpg');

const SHOT = ['--size', '640', '--view', 'three-quarter', '--variant', 'indigo', '--background', '#f4f1ec'];
const view = await openView(fileURLToPath(new URL('tshirt.glb', ASSETS)), SHOT);
const browser = await launchChromium();
const page = await browser.newPage({ viewport: { width: 1280, height: 660 }, colorScheme: 'light' });
await page.goto(view.url);
await settled(page);
await page.screenshot({ path: fileURLToPath(new URL('readme/view.png', ASSETS)) });
console.log('js/assets/readme/view.png');
await browser.close();
await view.stop();
