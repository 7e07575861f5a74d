import { spawnSync } from 'node:child_process';
import { copyFile, mkdir, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import sharp from 'sharp';
import { Browser } from '../../../test/parity/browser/chromium.mjs';
import { measured } from '../../../test/js/view/spec_support.mjs';
import { launchChromium, openView, settled } from '../../../test/js/view/support.mjs';
import { createRenderer } from '../../index.mjs';
import { createSheet } from '../../sheet/index.mjs';
import { blindSheet } from './blind.mjs';
import { clothPages, clothSwatches } from './cloth_pages.mjs';
import { PRESETS } from './cloths/index.mjs';
import { clothsPicture } from './cloths_picture.mjs';

// The pictures of README, docs and the page of telar view: npm run pictures [-- NAME...], all of them or those that are named.
// "cloth-pages" and names of presets after it: js/docs/cloths. "blind", which has to be named: a test of recognition in out/blind, its key in out/blind_key.json.

const ASSETS = new URL('..', import.meta.url);
const OUT = new URL('readme/', ASSETS);
const fileOf = (name) => fileURLToPath(new URL(name, ASSETS));
const BACKDROP = '#f4f1ec';

/** The garment drawn by three.js in Chromium, as `npm run parity` draws it, and by telar beside it. */
async function besideBrowser(out) {
  const shot = {
    size: { width: 480, height: 480 },
    camera: { azimuth: 22, elevation: 6 },
    background: BACKDROP,
    variant: 'terracotta',
    output: { format: 'png' },
  };
  const [renderer, browser] = await Promise.all([createRenderer(), Browser.start()]);
  const { data, info } = await renderer.render(fileOf('tshirt.glb'), shot);
  const drawn = await browser.draw({ shot: info.shot, model: fileOf('tshirt.glb'), environment: await readFile(fileOf('studio.hdr')) });
  await Promise.all([renderer.close(), browser.close()]);
  const { width, height } = shot.size;
  // Over an opaque background premultiplied colours are straight ones.
  const theirs = sharp(drawn.image, { raw: { width, height, channels: 4 } });
  await sharp({ create: { width: 2 * width, height, channels: 3, background: BACKDROP } })
    .composite([
      { input: await theirs.png().toBuffer(), left: 0, top: 0 },
      { input: data, left: width, top: 0 },
    ])
    .jpeg({ quality: 90 })
    .toFile(out);
}

async function contactSheet(out) {
  const work = await mkdtemp(path.join(tmpdir(), 'telar-pictures-'));
  const sheet = path.join(work, 'sheet.png');
  spawnSync(
    process.execPath,
    [
      fileOf('../cli/telar.mjs'),
      'thumbnail',
      fileOf('tshirt.glb'),
      fileOf('fabrics.glb'),
      '-o',
      work,
      '--views',
      'front,three-quarter,back',
      '--variants',
      'all',
      '--size',
      '320x400',
      '--contact-sheet',
      sheet,
    ],
    { stdio: ['ignore', 'ignore', 'inherit'] },
  );
  // A photograph of many colours is small as a JPEG.
  await sharp(sheet).resize({ width: 1068 }).jpeg({ quality: 88 }).toFile(out);
  await rm(work, { recursive: true });
}

/** The page of `telar view`. */
async function viewPage(out) {
  const view = await openView(fileOf('tshirt.glb'), ['--size', '640', '--view', 'three-quarter', '--variant', 'indigo', '--background', BACKDROP]);
  const browser = await launchChromium();
  const page = await browser.newPage({ viewport: { width: 1280, height: 660 }, colorScheme: 'light' });
  await page.goto(view.url);
  await settled(page);
  await writeFile(out, await page.screenshot());
  await browser.close();
  await view.stop();
}

/** The page of `telar view --spec`: the example's call-outs and points of measure. */
async function specPage(out) {
  const work = await mkdtemp(path.join(tmpdir(), 'telar-pictures-'));
  const spec = path.join(work, 'tshirt.json');
  await copyFile(fileOf('../docs/sheet/tshirt.json'), spec);
  const view = await openView(fileOf('tshirt.glb'), ['--size', '640', '--background', BACKDROP, '--spec', spec]);
  const browser = await launchChromium();
  const page = await browser.newPage({ viewport: { width: 1280, height: 900 }, colorScheme: 'light' });
  await page.goto(view.url);
  await settled(page);
  await measured(page);
  await page.locator('input[name=tool][value=surface]').check({ force: true });
  await page.locator('#measures [data-field=description]').first().focus();
  await sharp(await page.screenshot())
    .jpeg({ quality: 86 })
    .toFile(out);
  await browser.close();
  await view.stop();
  await rm(work, { recursive: true });
}

/** Four pages of the example's tech sheet: cover, flats, construction, points of measure. */
async function sheetPages(out) {
  const [page, gap] = [{ width: 640, height: 453 }, 8];
  const spec = JSON.parse(await readFile(fileOf('../docs/sheet/tshirt.json'), 'utf8'));
  const renderer = await createRenderer();
  const { files } = await createSheet(fileOf('tshirt.glb'), spec, { renderer, format: 'png', resolve: (name) => readFile(fileOf(`../docs/sheet/${name}`)) });
  await renderer.close();
  const shown = await Promise.all([0, 1, 2, 5].map((i) => sharp(files[i]).flatten({ background: 'white' }).resize(page).png().toBuffer()));
  await sharp({ create: { width: 2 * page.width + 3 * gap, height: 2 * page.height + 3 * gap, channels: 3, background: '#b9b4ab' } })
    .composite(shown.map((input, i) => ({ input, left: gap + (i % 2) * (page.width + gap), top: gap + (i >> 1) * (page.height + gap) })))
    .jpeg({ quality: 86 })
    .toFile(out);
}

/** In js/assets/readme. */
const PICTURES = {
  'beside_browser.jpg': besideBrowser,
  'contact_sheet.jpg': contactSheet,
  'view.png': viewPage,
  'view_spec.jpg': specPage,
  'sheet.jpg': sheetPages,
  'cloths.jpg': clothsPicture,
};

const wanted = process.argv.slice(2);
const isWanted = (name) => wanted.length === 0 || wanted.includes(name);
const tell = async (name) => console.log(`${name}  ${(await readFile(fileOf(`../../${name}`))).length} bytes`);

await mkdir(OUT, { recursive: true });
for (const [name, make] of Object.entries(PICTURES)) {
  if (!isWanted(name)) continue;
  await make(fileURLToPath(new URL(name, OUT)));
  await tell(`js/assets/readme/${name}`);
}
if (isWanted('cloth-swatches')) {
  await clothSwatches(fileOf('../view/page/cloths.webp'));
  await tell('js/view/page/cloths.webp');
}
if (isWanted('cloth-pages')) {
  await clothPages(
    fileOf('../docs/cloths'),
    wanted.filter((name) => name !== 'cloth-pages' && Object.hasOwn(PRESETS, name)),
  );
}
if (wanted.includes('blind')) {
  await blindSheet(fileOf('../../out/blind'), fileOf('../../out/blind_key.json'));
  console.log('out/blind, and the key in out/blind_key.json');
}
