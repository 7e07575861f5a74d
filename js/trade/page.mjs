import { escaped } from '../compare/markup.mjs';
import { familyOf } from '../predict/settings.mjs';
import { FROM, KNOB_SETTINGS, knobsTable } from './knobs.mjs';
import { BARS, byScene, cheapestTable, LEEWAY, overall, presetsAboveFront } from './figures.mjs';
import { tradePlot } from './plots.mjs';

/** The result as one HTML page without a script. */

const STYLE = `body{font:15px/1.45 system-ui,sans-serif;margin:2rem auto;max-width:76rem;padding:0 1.5rem;color-scheme:light dark}
h1{font-size:1.4rem}h2{font-size:1.1rem;margin-top:2rem}table{border-collapse:collapse;margin:1rem 0;font-variant-numeric:tabular-nums;font-size:.9rem}
th,td{padding:.25rem .8rem .25rem 0;text-align:right;border-bottom:1px solid #8885}th:first-child{text-align:left;font-weight:500}figure{display:inline-block;margin:0 1rem 1rem 0}svg{max-width:100%;height:auto}`;

export const milliseconds = (ms) => (ms >= 10_000 ? `${(ms / 1000).toFixed(0)} s` : ms >= 1000 ? `${(ms / 1000).toFixed(1)} s` : `${ms.toFixed(0)} ms`);
const errorText = (flip) => flip.toFixed(4);

/** A setting and its time in a cell. */
export const cellText = (row) => (row === undefined ? 'none' : `${row.setting} (${row.timed === 'window' ? '~' : ''}${milliseconds(row.cpuMs)})`);

const table = (head, lines) => {
  const cells = (tag, list) => list.map((value, i) => (i === 0 ? `<th scope="row">${escaped(value)}</th>` : `<${tag}>${escaped(value)}</${tag}>`)).join('');
  return `<table><thead><tr>${cells('th', head)}</tr></thead>\n<tbody>${lines.map((line) => `<tr>${cells('td', line)}</tr>`).join('\n')}</tbody></table>`;
};

/** Heads and lines of the tables, for the page, the terminal and the docs. */
export function tablesOf(rows) {
  return {
    overall: {
      head: ['setting', 'FLIP, median', 'worst', 'CPU time, median', 'scenes'],
      lines: overall(rows).map(({ setting, flip, worst, cpuMs, count }) => [setting, errorText(flip), errorText(worst), milliseconds(cpuMs), String(count)]),
    },
    cheapest: {
      head: ['scene', ...BARS.map((bar) => `FLIP <= ${bar}`)],
      lines: cheapestTable(rows).map(({ name, cells }) => [name, ...cells.map(cellText)]),
    },
    presets: {
      head: ['preset', 'time over the front, median', 'worst', `scenes within ${100 * LEEWAY} %`],
      lines: presetsAboveFront(rows).map(({ preset, times, worst, within, scenes }) => [preset, times.toFixed(2), worst.toFixed(2), `${within} of ${scenes}`]),
    },
  };
}

/** Whether some were measured. */
const hasKnobs = (rows) => rows.some(({ setting }) => setting !== FROM && Object.hasOwn(KNOB_SETTINGS, setting));

/** Medians of settings as a plot takes them. */
export const overallPoints = (rows) => overall(rows).map((point) => ({ ...point, family: familyOf(point.setting) ?? 'other' }));

/**
 * @param {import('./measure.mjs').Row[]} rows not empty
 * @param {{command: string, machine: string, window: number}} about
 * @returns {string} HTML
 */
export function tradePage(rows, { command, machine, window }) {
  const { overall: all, cheapest, presets } = tablesOf(rows);
  const scenes = byScene(rows);
  const knobs = knobsTable(rows);
  const title = 'Time against error';
  return `<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width,initial-scale=1"><title>${title}</title><style>${STYLE}</style></head>
<body><h1>${title}</h1>
<p>${rows.length} measurements: ${scenes.length} scenes. <code>${escaped(command)}</code> on ${escaped(machine)}.</p>
<p>FLIP is the mean over the model's pixels of a window of at most ${window} x ${window}, against the path tracer with light that arrives directly. Time is that of all
threads for the whole picture of a loaded model, the least of several; paler points and "~": only the window was drawn, and its time scaled by covered pixels. The front is
made of the settings that no other one beats in both.</p>
<h2>All scenes</h2>
<figure>${tradePlot('Medians of all scenes', overallPoints(rows))}</figure>
${table(all.head, all.lines)}
<h2>Cheapest setting</h2>
${table(cheapest.head, cheapest.lines)}
<h2>Presets above the front</h2>
${table(presets.head, presets.lines)}
${hasKnobs(rows) ? `<h2>Knobs</h2>\n${table(knobs.head, knobs.lines)}\n` : ''}<h2>Scenes</h2>
${scenes.map(({ name, rows: own }) => `<figure>${tradePlot(name, own)}</figure>`).join('\n')}
</body></html>
`;
}
