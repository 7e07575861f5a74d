import { readFileSync, writeFileSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import * as api from '../../js/index.mjs';
import { versions } from '../../js/api/versions.mjs';
import { TradeStore } from '../../js/cli/trade_store.mjs';
import { calibrate } from '../../js/predict/calibrate.mjs';
import { fitTable } from '../../js/predict/fit.mjs';
import { SETTINGS } from '../../js/predict/settings.mjs';
import { bench, csvOf, overallPoints, tradePage, tradePlot } from '../../js/trade/index.mjs';
import { docsPage } from './docs_page.mjs';
import { judge } from './judge.mjs';
import { keptKnobs, measureKnobs } from './knobs.mjs';
import { measurePeers } from './peers.mjs';
import { answersOf, looksOf } from './looks.mjs';
import { tradeScenes } from './scenes.mjs';

// npm run trade [-- --minutes N] [--write]: measures the scenes of scenes.mjs, as far as the minutes go (a run goes on where the last one stopped),
// fits what {maxError} and {budgetMs} go by, and judges it by scenes that it does not know. --write: js/predict/table.json, js/docs/trade.md.

const { values } = parseArgs({
  options: {
    minutes: { type: 'string', default: '600' },
    write: { type: 'boolean', default: false },
    knobs: { type: 'boolean', default: false },
    peers: { type: 'boolean', default: false },
  },
});
const ROOT = fileURLToPath(new URL('../../', import.meta.url));
const OUT = path.join(ROOT, 'out/trade');
const WINDOW = 40;
const CAP_MS = 1500;

const how = { version: versions.telar, write: values.write };
if (values.knobs) await measureKnobs(OUT, how);
if (values.peers) await measurePeers(OUT, how);
if (values.knobs || values.peers) process.exit();

const end = Date.now() + 60_000 * Number(values.minutes);
const store = new TradeStore(OUT, versions.telar);
await store.open();
const renderer = await api.createRenderer({ cacheDirectory: path.join(OUT, 'cache') });

/** Once for all that is measured here. */
async function machineHere() {
  const file = path.join(OUT, 'machine.json');
  try {
    return JSON.parse(readFileSync(file, 'utf8'));
  } catch {
    const machine = await calibrate((source, shot) => renderer.render(source, shot), { tracer: true });
    writeFileSync(file, JSON.stringify(machine));
    return machine;
  }
}

const machine = await machineHere();
const { fit, heldOut } = tradeScenes(path.join(OUT, 'skies'));
// Three of the one, one of the other, so that few minutes give both.
/** Scenes of which all is measured come first: they cost nothing. */
const isDone = ({ model, light, shot }) => {
  const own = store.rows().filter((row) => row.model === model && row.light === light && row.size === shot.size.width && row.shading === shot.shading);
  return own.length >= Object.keys(SETTINGS).length;
};
const order = [...fit.map((scene, i) => ({ scene, kind: 'fit', at: i / 3 })), ...heldOut.map((scene, i) => ({ scene, kind: 'heldOut', at: i + 0.9 }))]
  .map((each) => ({ ...each, isDone: isDone(each.scene) }))
  .toSorted((a, b) => b.isDone - a.isDone || a.at - b.at);
const measured = { fit: [], heldOut: [] };
const looks = [];
const held = [];

/** With its model. */
async function withModel({ source }, work) {
  const model = await renderer.load(source);
  try {
    return await work(model);
  } finally {
    await renderer.release(model);
  }
}

/** Kept as what is measured is. */
async function keptLooks(scene, rows) {
  const key = store.keyOf({ looks: { ...scene, settings: SETTINGS } });
  const kept = store.row(key) ?? { looks: await withModel(scene, (model) => looksOf(renderer, model, scene, rows)) };
  if (!store.row(key)) await store.keep(key, kept);
  return kept.looks;
}

let done = 0;
for (const { scene, kind, isDone: isKept } of order) {
  if (!isKept && Date.now() > end) break;
  const rows = await bench(api, renderer, { scenes: [scene], settings: SETTINGS, window: WINDOW, capMs: CAP_MS }, store);
  measured[kind].push(rows);
  if (kind === 'fit') looks.push(...(await keptLooks(scene, rows)));
  else held.push(scene);
  done += 1;
  process.stderr.write(`${done} of ${order.length}, ${kind}: ${scene.model}, ${scene.light}, ${scene.shot.size.width}, ${scene.shot.shading}\n`);
}
const gl = renderer.gl.renderer;
const table = fitTable(measured.fit.flat(), machine, looks);
const answers = [];
for (const [i, scene] of held.entries())
  answers.push(await withModel(scene, (model) => answersOf(renderer, model, scene, table, measured.heldOut[i][0].features)));
await renderer.close();

const verdict = judge(table, measured.heldOut, machine, answers);
const byClass = judge(table, measured.heldOut, machine);
const command = 'npm run trade -- --write';
const rows = [...measured.fit, ...measured.heldOut].flat();
const machineName = `${os.cpus()[0].model.trim()}, ${gl}`;
writeFileSync(path.join(OUT, 'trade.csv'), csvOf(rows));
writeFileSync(path.join(OUT, 'index.html'), tradePage(rows, { command, machine: machineName, window: WINDOW }));
process.stdout.write(`${JSON.stringify(verdict, null, 1)}\n`);
if (values.write) {
  writeFileSync(path.join(ROOT, 'js/predict/table.json'), `${JSON.stringify(table, null, 1)}\n`);
  writeFileSync(path.join(ROOT, 'js/docs/trade/trade.svg'), `${tradePlot('Medians of all scenes', overallPoints(rows))}\n`);
  writeFileSync(
    path.join(ROOT, 'js/docs/trade.md'),
    docsPage({
      rows,
      table,
      verdict,
      byClass,
      knobs: keptKnobs(),
      command,
      machine: machineName,
      window: WINDOW,
      counts: { fit: measured.fit.length, heldOut: measured.heldOut.length },
    }),
  );
}
