import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import * as api from '../../js/index.mjs';
import { versions } from '../../js/api/versions.mjs';
import { TradeStore } from '../../js/cli/trade_store.mjs';
import { calibrate } from '../../js/predict/calibrate.mjs';
import { fitTable } from '../../js/predict/fit.mjs';
import { drawnBy, SETTINGS } from '../../js/predict/settings.mjs';
import { bench, csvOf, overallPoints, TRUTH, tradePage, tradePlot } from '../../js/trade/index.mjs';
import { docsPage } from './docs_page.mjs';
import { judge, knowingAnswers } from './judge.mjs';
import { keptKnobs, measureKnobs } from './knobs.mjs';
import { answersOf, looksOf } from './looks.mjs';
import { tradeScenes } from './scenes.mjs';

// npm run trade [-- --minutes N] [--write]: measures the scenes of scenes.mjs, as far as the minutes go (a run goes on where the last one stopped),
// fits what {maxError} and {budgetMs} go by, and judges it by scenes that it does not know. --write: js/predict/table.json, js/docs/trade.md.
// On a machine of many cores, several processes at once, each with cores of its own (taskset): `--share scenes` in each measures the next scene that no
// other has taken (out/trade/taken; remove it after a process that was killed); then `--share answers` in each, what a renderer would choose of the judging ones. `--kept --write` writes what out/trade holds of
// whichever machine, and draws nothing. `--quick`: against a truth of fewer paths.

const { values } = parseArgs({
  options: {
    minutes: { type: 'string', default: '600' },
    write: { type: 'boolean', default: false },
    knobs: { type: 'boolean', default: false },
    peers: { type: 'boolean', default: false },
    share: { type: 'string' },
    kept: { type: 'boolean', default: false },
    quick: { type: 'boolean', default: false },
  },
});
const ROOT = fileURLToPath(new URL('../../', import.meta.url));
const OUT = path.join(ROOT, 'out/trade');
const WINDOW = 40;
/**
 * CPU time above which a setting is drawn in the window alone. What cheaper pictures tell of the tracer's dearer ones is right within a fifth, of `high` by the raster
 * mostly within a half.
 */
const CAP_MS = { raster: 40_000, tracer: 4000 };
/** So that of each scene some picture is drawn whole that stops where its noise is small. @param {{width: number}} size pixels */
const capOf = (by, { width }) => CAP_MS[by] * (by === 'tracer' ? Math.max(1, width / 256) ** 1.5 : 1);
/** In an eighth of the time. Its noise makes the FLIP of the most accurate settings 0.003 more. */
const QUICK_TRUTH = { ...TRUTH, samples: 2048, noise: 1.2 };
const truth = values.quick ? QUICK_TRUTH : TRUTH;

const how = { version: versions.telar, write: values.write };
if (values.knobs) await measureKnobs(OUT, how);
// The browser's driver is loaded for them alone.
if (values.peers) await (await import('./peers.mjs')).measurePeers(OUT, how);
if (values.knobs || values.peers) process.exit();

const end = Date.now() + 60_000 * Number(values.minutes);
const store = new TradeStore(OUT, versions.telar);
await store.open();
const renderer = values.kept ? undefined : await api.createRenderer({ cacheDirectory: path.join(OUT, 'cache') });

/** Whether this process is the first that takes it, of those that share a folder. */
function isFirst(job) {
  mkdirSync(path.join(OUT, 'taken'), { recursive: true });
  try {
    writeFileSync(path.join(OUT, 'taken', store.keyOf({ job })), '', { flag: 'wx' });
    return true;
  } catch (error) {
    if (error.code === 'EEXIST') return false;
    throw error;
  }
}
const takes = (job) => !values.share || isFirst(job);

/** Once for all that is measured here: its speed and its name. */
async function machineHere() {
  const file = path.join(OUT, 'machine.json');
  try {
    return JSON.parse(readFileSync(file, 'utf8'));
  } catch (error) {
    if (values.kept) throw error;
    const speed = await calibrate((source, shot) => renderer.render(source, shot), { tracer: true });
    const machine = { ...speed, name: `${os.cpus()[0].model.trim()}, ${renderer.gl.renderer}` };
    writeFileSync(file, JSON.stringify(machine));
    return machine;
  }
}

const { fit, heldOut } = await tradeScenes(path.join(OUT, 'inputs'));
/** What is kept of a scene. */
const rowsOf = ({ model, light, shot }) => {
  const own = store.rows().filter((row) => row.model === model && row.light === light && row.size === shot.size.width && row.shading === shot.shading);
  return Object.keys(SETTINGS).flatMap((setting) => own.findLast((row) => row.setting === setting) ?? []);
};
const isDone = (scene) => rowsOf(scene).length >= Object.keys(SETTINGS).length;
// Three of the one, one of the other, so that few minutes give both. Scenes of which all is measured come first: they cost nothing.
const order = [...fit.map((scene, i) => ({ scene, kind: 'fit', at: i / 3 })), ...heldOut.map((scene, i) => ({ scene, kind: 'heldOut', at: i + 0.9 }))]
  .map((each) => ({ ...each, isDone: isDone(each.scene) }))
  .toSorted((a, b) => b.isDone - a.isDone || a.at - b.at);

/** With its model. */
async function withModel({ source }, work) {
  const model = await renderer.load(source);
  try {
    return await work(model);
  } finally {
    await renderer.release(model);
  }
}

/** What is kept under these parts, else what `make` gives, which is then kept. */
async function keptOr(parts, make) {
  const key = store.keyOf(parts);
  if (values.kept && !store.row(key)) throw new Error(`not kept in ${OUT}: ${JSON.stringify(parts).slice(0, 200)}`);
  const kept = store.row(key) ?? (await make());
  if (!store.row(key)) await store.keep(key, kept);
  return kept;
}
/** A scene without the paths of this machine; by what was measured of it, where it is kept. */
const nameOf = ({ model, light, shot }, rows = []) => [model, light, shot.size, shot.shading, rows.map(({ flip }) => flip)];
const keptLooks = async (scene, rows) =>
  (await keptOr({ looks: nameOf(scene, rows) }, async () => ({ looks: await withModel(scene, (model) => looksOf(renderer, model, scene, rows)) }))).looks;

/** Rows of a scene with all settings. */
async function measure(scene) {
  const rows = [];
  for (const by of Object.keys(CAP_MS)) {
    const capMs = capOf(by, scene.shot.size);
    const settings = Object.fromEntries(Object.entries(SETTINGS).filter(([name]) => drawnBy(name) === by));
    rows.push(...(await bench(api, renderer, { scenes: [scene], settings, window: WINDOW, capMs, truth }, store)));
  }
  return rows;
}

const measured = { fit: [], heldOut: [] };
const looks = [];
const held = [];
const drawsNone = values.kept || values.share === 'answers';

if (values.share === 'scenes' && isFirst('machine')) await machineHere();
let done = 0;
for (const { scene, kind, isDone: isKept } of order) {
  if (drawsNone && !isKept) break;
  if (!isKept && Date.now() > end) break;
  if (values.share === 'scenes' && (isKept || !takes(nameOf(scene)))) continue;
  const rows = drawsNone ? rowsOf(scene) : await measure(scene);
  measured[kind].push(rows);
  if (kind === 'fit') looks.push(...(await keptLooks(scene, rows)));
  else held.push(scene);
  done += 1;
  process.stderr.write(`${done} of ${order.length}, ${kind}: ${scene.model}, ${scene.light}, ${scene.shot.size.width}, ${scene.shot.shading}\n`);
}
if (values.share === 'scenes') {
  await renderer.close();
  process.exit();
}
const { name: machineName, ...machine } = await machineHere();
const table = fitTable(measured.fit.flat(), machine, looks);
const answers = [];
for (const [i, scene] of held.entries()) {
  if (!takes({ answers: nameOf(scene, measured.heldOut[i]), table })) continue;
  const answer = () => withModel(scene, (model) => answersOf(renderer, model, scene, table, measured.heldOut[i][0].features));
  answers.push(await keptOr({ answers: nameOf(scene, measured.heldOut[i]), table }, answer));
}
await renderer?.close();
if (values.share) process.exit();

const verdict = judge(table, measured.heldOut, machine, answers);
const byClass = judge(table, measured.heldOut, machine);
const knowing = judge(table, measured.heldOut, machine, knowingAnswers(measured.heldOut));
const command = `npm run trade -- ${values.quick ? '--quick ' : ''}--write`;
const rows = [...measured.fit, ...measured.heldOut].flat();
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
      knowing,
      knobs: keptKnobs(),
      command,
      machine: machineName,
      window: WINDOW,
      truth,
      capOf,
      counts: { fit: measured.fit.length, heldOut: measured.heldOut.length },
    }),
  );
}
