import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { compareImages } from '../../js/compare/index.mjs';
import * as api from '../../js/index.mjs';
import { TradeStore } from '../../js/cli/trade_store.mjs';
import { windowCamera, windowOf } from '../../js/predict/window.mjs';
import { SETTINGS } from '../../js/predict/settings.mjs';
import { resolveQuality } from '../../js/shot/quality.mjs';
import { bench, benchLights, fileModels, scenesOf, tradePlot, TRUTH } from '../../js/trade/index.mjs';
import { Browser } from '../parity/browser/chromium.mjs';
import { cpuBelow, measured } from '../processes.mjs';

// npm run trade -- --peers [--write]: three.js in headless Chromium, which draws quality `standard` of the shading `three`, as a point among telar's settings.
// --write: js/docs/trade/peers.svg.

const ASSETS = fileURLToPath(new URL('../../js/assets/', import.meta.url));
const PLAN = { window: 40, capMs: 30_000 };
const NAMES = ['draft', 'standard', 'medium', 'denoised 64/64', 'denoised 64/256', 'tracer 4', 'tracer 8', 'tracer noise 4', 'tracer noise 2'];
const PEER = 'three.js in Chromium';

/** Pictures of one loaded model that a time is of. */
const MANY = 9;

/** A drawing buffer as straight alpha. */
const straight = (rgba) => rgba.map((value, i) => (i % 4 === 3 || rgba[i | 3] === 0 ? value : Math.min(255, Math.round((value * 255) / rgba[i | 3]))));

/** @param {string} folder of what is measured @param {{version: string, write: boolean}} options */
export async function measurePeers(folder, { version, write }) {
  const store = new TradeStore(path.join(folder, 'peers'), version);
  await store.open();
  const renderer = await api.createRenderer({ cacheDirectory: path.join(folder, 'cache') });
  const [scene] = scenesOf({ models: fileModels([path.join(ASSETS, 'tshirt.glb')]), lights: benchLights(['studio']), sizes: [512], shadings: ['three'] });
  const settings = Object.fromEntries(NAMES.map((name) => [name, SETTINGS[name]]));
  const rows = await bench(api, renderer, { ...PLAN, scenes: [scene], settings }, store, { step: (name) => process.stderr.write(`${name}\n`) });

  const raw = { ...scene.shot, background: 'transparent', output: { format: 'raw' } };
  const { data, info } = await renderer.render(scene.source, { ...raw, quality: 'draft' });
  const window = windowOf(data, info.shot.size, PLAN.window);
  const size = { width: window.width, height: window.height };
  const standard = { ...info.shot, quality: resolveQuality('standard') };
  const shown = { ...standard, size, camera: windowCamera(info.shot.camera, info.shot.size, window) };
  const truth = (await renderer.render(scene.source, { ...shown, quality: TRUTH }, { timeoutMs: null })).data;
  await renderer.close();

  const browser = await Browser.start({ isMeasured: true });
  const environment = readFileSync(path.join(ASSETS, 'studio.hdr'));
  const drawn = { model: scene.source, environment, keepPrograms: true };
  const { image } = await browser.draw({ ...drawn, shot: shown });
  const times = async (count) => (await measured(cpuBelow, () => browser.sequence({ ...drawn, shots: new Array(count).fill(standard) }))).cpu;
  await times(1);
  const cpuMs = ((await times(1 + MANY)) - (await times(1))) / MANY;
  await browser.close();

  const { flip } = compareImages({ ...size, data: truth }, { ...size, data: straight(image) }).object;
  const peer = { ...rows[0], setting: PEER, family: 'peer', flip: flip.mean, cpuMs, timed: 'picture' };
  const all = [...rows, peer];
  for (const row of all) process.stdout.write(`${row.setting}: FLIP ${row.flip.toFixed(4)}, ${row.cpuMs.toFixed(0)} ms\n`);
  const plot = tradePlot('The T-shirt in shading three, 512 x 512', all);
  if (write) writeFileSync(new URL('../../js/docs/trade/peers.svg', import.meta.url), `${plot}\n`);
}
