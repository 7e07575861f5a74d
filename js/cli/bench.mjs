import os from 'node:os';
import path from 'node:path';
import { TelarError } from '../error/index.mjs';
import { SETTINGS } from '../predict/settings.mjs';
import { ANY_MODEL } from '../shot/facts.mjs';
import { shown } from '../shot/complain.mjs';
import { resolveShot } from '../shot/index.mjs';
import {
  BENCH_LIGHTS,
  bench,
  benchLights,
  benchSteps,
  CLOTHS,
  clothModels,
  csvOf,
  fileModels,
  KNOB_SETTINGS,
  knobsTable,
  overallPoints,
  scenesOf,
  tablesOf,
  together,
  tradePage,
  tradePlot,
} from '../trade/index.mjs';
import { removeUnfinished, writeFileAtomically } from '../api/atomic_file.mjs';
import { readLimits } from './limits.mjs';
import { checkModel } from './models.mjs';
import { namesOf } from './name_list.mjs';
import { parseShading } from './shot_options.mjs';
import { TradeStore } from './trade_store.mjs';

const usage = (message) => new TelarError('E_USAGE', message);

function wholeOf(option, text, min, max) {
  const value = Number(text);
  if (/^\d+$/.test(text) && value >= min && value <= max) return value;
  throw usage(`--${option}: expected a whole number in [${min}, ${max}], got ${shown(text)}`);
}

/** The ladder's, or those of it that are named, and own ones: NAME=JSON of a quality. Of knobs: each alone. */
function settingsOf({ settings, setting: own = [], knobs }) {
  if (knobs) {
    if (settings !== undefined) throw usage('--knobs has settings of its own: leave --settings out');
    return { ...KNOB_SETTINGS, ...Object.fromEntries(own.map(ownSetting)) };
  }
  const known = Object.keys(SETTINGS);
  const chosen = namesOf('settings', settings, known);
  const unknown = chosen.find((name) => !known.includes(name));
  if (unknown !== undefined) throw usage(`--settings: there is no setting ${shown(unknown)}; expected some of ${known.join(', ')}`);
  return Object.fromEntries([...chosen.map((name) => [name, SETTINGS[name]]), ...own.map(ownSetting)]);
}

function ownSetting(text) {
  const at = text.indexOf('=');
  if (at < 1) throw usage(`--setting ${shown(text)}: expected NAME=JSON of a quality`);
  try {
    const quality = JSON.parse(text.slice(at + 1));
    resolveShot({ quality }, ANY_MODEL);
    return [text.slice(0, at), quality];
  } catch (error) {
    throw usage(`--setting ${shown(text)}: expected NAME=JSON of a quality (${error.message})`);
  }
}

/** Pixels of a window's side: its FLIP needs some, its truth takes time for each. */
const WINDOW = { least: 16, most: 1024 };
const MOST_SECONDS = 86_400;

async function planOf(given, options) {
  const cloths = namesOf('cloths', options.cloths, given.length > 0 ? [] : CLOTHS);
  const models = [];
  for (const each of given) models.push((await checkModel(each)).model);
  const sizes = namesOf('sizes', options.sizes, []).map((text) => wholeOf('sizes', text, WINDOW.least, 8192));
  const scenes = scenesOf({
    models: [...clothModels(cloths), ...fileModels(models)],
    lights: benchLights(namesOf('environments', options.environments, BENCH_LIGHTS)),
    sizes,
    shadings: namesOf('shadings', options.shadings, []).map((text) => parseShading(text, '--shadings')),
  });
  // A wrong shot is told before anything is opened.
  for (const { shot } of scenes) resolveShot(shot, ANY_MODEL);
  return {
    scenes,
    settings: settingsOf(options),
    window: wholeOf('window', options.window, WINDOW.least, WINDOW.most),
    capMs: 1000 * wholeOf('cap', options.cap, 0, MOST_SECONDS),
  };
}

/**
 * telar bench trade [MODEL...]
 * Draws scenes with every setting, and writes what each takes and how far it is off.
 * @param {string[]} models paths beside the cloths
 * @param {object} options as commander parsed them
 * @param {import('./console.mjs').Io & {console: import('./console.mjs').Console, api: object}} context
 * @returns {Promise<number>} exit code
 */
export async function benchTrade(models, options, { console, signal, api, version }) {
  const plan = await planOf(models, options);
  const { output: folder } = options;
  const limits = readLimits(options.limit);
  const store = new TradeStore(folder, version);
  await store.open();
  const renderer = await api.createRenderer({ backend: options.backend, limits, signal });
  const machine = machineOf(renderer);
  const progress = await console.progress(benchSteps(plan));
  let rows;
  try {
    const measure = (settings) => bench(api, renderer, { ...plan, machine, settings }, store, { limits, signal, step: (name) => progress.step(name) });
    rows = await measure(plan.settings);
    if (options.knobs) rows.push(...(await measure(together(rows))));
  } finally {
    progress.stop();
    await renderer.close();
  }
  const files = await writeResult(folder, rows, { ...plan, machine }, signal);
  const tables = { ...tablesOf(rows), ...(options.knobs && { knobs: knobsTable(rows) }) };
  await console.result({ ok: true, exit: 0, files, rows, tables }, [
    ...linesOf(tables.overall),
    '',
    ...linesOf(tables.cheapest),
    '',
    ...linesOf(tables.presets),
    '',
    ...(tables.knobs ? [...linesOf(tables.knobs), ''] : []),
    files[0],
  ]);
  return 0;
}

/** What times depend on. */
function machineOf({ gl }) {
  const cores = os.availableParallelism();
  return `${os.cpus()[0]?.model.trim() ?? os.arch()}, ${cores} ${cores === 1 ? 'core' : 'cores'}, ${gl.renderer ?? 'no GL'}`;
}

/** A table in columns. */
function linesOf({ head, lines }) {
  const all = [head, ...lines];
  const widths = head.map((_, i) => Math.max(...all.map((line) => line[i].length)));
  return all.map((line) => line.map((cell, i) => (i === 0 ? cell.padEnd(widths[i]) : cell.padStart(widths[i]))).join('  '));
}

/** DIR/index.html, which needs no other file, DIR/trade.csv and DIR/trade.svg. @returns {Promise<string[]>} paths */
async function writeResult(folder, rows, { machine, window }, signal) {
  const command = `telar bench trade, ${new Set(rows.map(({ model }) => model)).size} models`;
  const files = {
    'index.html': tradePage(rows, { command, machine, window }),
    'trade.csv': csvOf(rows),
    'trade.svg': tradePlot('Medians of all scenes', overallPoints(rows)),
  };
  try {
    for (const [name, text] of Object.entries(files)) await writeFileAtomically(path.join(folder, name), Buffer.from(text), signal);
  } finally {
    removeUnfinished();
  }
  return Object.keys(files).map((name) => path.join(folder, name));
}
