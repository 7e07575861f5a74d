import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { heading, row } from '../../js/build/docs/tables.mjs';
import * as api from '../../js/index.mjs';
import { TradeStore } from '../../js/cli/trade_store.mjs';
import { bench, benchLights, clothModels, KNOB_SETTINGS, knobsTable, scenesOf, together } from '../../js/trade/index.mjs';

// npm run trade -- --knobs [--write]: each number of a quality and of shadows alone, from `standard`, and the steepest together. --write: its part of
// js/docs/trade.md.

const CLOTHS = ['denim', 'cable-knit', 'velvet', 'satin', 'nylon-shell', 'waxed-cotton'];
const PLAN = { window: 40, capMs: 2000 };

const DOCS = new URL('../../js/docs/trade.md', import.meta.url);
const PART = /<!-- knobs -->\n[\s\S]*?<!-- end -->\n/;

/** The part of the page that this file writes, as it stands there. */
export const keptKnobs = () => PART.exec(readFileSync(DOCS, 'utf8'))?.[0] ?? '<!-- knobs -->\n<!-- end -->\n';

/** @param {import('../../js/trade/measure.mjs').Row[]} rows */
export const knobsPart = (rows) => {
  const { head, lines } = knobsTable(rows);
  return `<!-- knobs -->\n${[...heading(head), ...lines.map(row)].join('\n')}\n<!-- end -->\n`;
};

/** @param {string} folder of what is measured @param {{version: string, write: boolean}} options */
export async function measureKnobs(folder, { version, write }) {
  const store = new TradeStore(path.join(folder, 'knobs'), version);
  await store.open();
  const renderer = await api.createRenderer({ cacheDirectory: path.join(folder, 'cache') });
  const scenes = scenesOf({ models: clothModels(CLOTHS), lights: benchLights(['studio', 'sun']), sizes: [256], shadings: ['fabric'] });
  const measure = (settings) => bench(api, renderer, { ...PLAN, scenes, settings }, store, { step: (name) => process.stderr.write(`${name}\n`) });
  const rows = await measure(KNOB_SETTINGS);
  rows.push(...(await measure(together(rows))));
  await renderer.close();
  process.stdout.write(knobsPart(rows));
  if (write)
    writeFileSync(
      DOCS,
      readFileSync(DOCS, 'utf8').replace(PART, () => knobsPart(rows)),
    );
}
