import { mkdir, writeFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { launchChromium, openView, settled } from '../../../test/js/view/support.mjs';
import { createRenderer } from '../../index.mjs';

// The README's pictures: the bundled garment in each of its colours, and the page of `telar view`. npm run pictures

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
