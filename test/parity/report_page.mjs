import { checkName, checkText, number } from '../../js/compare/figures.mjs';
import { escaped } from '../../js/compare/markup.mjs';
import { GAIN } from './pictures.mjs';
import { ALLOWANCE } from './rasterizers.mjs';

const STYLE = `body{font:14px system-ui,sans-serif;margin:1.5rem;background:#fff;color:#111}
figure{display:inline-block;margin:0 .5rem .5rem 0;max-width:24%;vertical-align:top}
img{max-width:100%;image-rendering:pixelated;background:repeating-conic-gradient(#ddd 0 25%,#fff 0 50%) 0 0/16px 16px}
table{border-collapse:collapse;margin:.5rem 0}th,td{padding:.1rem .6rem;text-align:right;border-bottom:1px solid #ccc}
th:first-child{text-align:left;white-space:nowrap}thead th{position:sticky;top:0;background:#fff}
.over{color:#b00020;font-weight:bold}h2{font-size:1.1rem;margin:1.5rem 0 .3rem}h3{font-size:1rem;margin:1rem 0 .3rem}p{margin:.3rem 0;max-width:60rem}`;

/**
 * Figures of a case on one line.
 * @param {import('./report.mjs').Row} row
 */
export function figuresText({ difference: { interior, edge, verdict }, rasterizers }) {
  const over = verdict.checks.filter(({ pass }) => !pass).map((check) => `${checkName(check)} ${checkText(check)}`);
  const worst = interior && interior.max > 0 ? ` at ${interior.worst.join(' ')}` : '';
  return [
    interior ? `interior ${interior.pixels} px max ${interior.max}${worst} p99.9 ${interior.p999} >=1 ${interior.atLeast1}` : 'no interior',
    edge ? `edge FLIP ${number(edge.flip.mean)} max ${edge.max}` : 'no edge',
    ...(rasterizers ? [distancesText(rasterizers)] : []),
    ...over.map((text) => `OVER: ${text}`),
  ].join(' | ');
}

function distancesText({ client, telar, pass }) {
  if (!client) return 'other rasteriser: no interior';
  const part = ({ p999, mean, max }) => `p99.9 ${p999} mean ${number(mean)} max ${max}`;
  return `${pass ? '' : 'OVER: '}SwiftShader client ${part(client)}, telar ${part(telar)}`;
}

/** Columns of the table: heading, and the text of a row. */
const COLUMNS = [
  ['interior px', ({ difference }) => difference?.interior?.pixels],
  ['max', ({ difference }) => difference?.interior?.max],
  ['p99.9', ({ difference }) => difference?.interior?.p999],
  ['px >= 1', ({ difference }) => difference?.interior?.atLeast1],
  ['edge FLIP', ({ difference }) => difference?.edge && number(difference.edge.flip.mean)],
  ['edge max', ({ difference }) => difference?.edge?.max],
];
const RASTERIZER_COLUMNS = ['p999', 'mean', 'max'].flatMap((figure) =>
  ['client', 'telar'].map((side) => [
    `SwiftShader ${figure === 'p999' ? 'p99.9' : figure}, ${side}`,
    ({ rasterizers }) => rasterizers?.[side] && number(rasterizers[side][figure]),
  ]),
);

const cell = (value) => `<td>${value === undefined || value === null ? '' : escaped(value)}</td>`;
const anchor = (name) => `case-${encodeURIComponent(name)}`;

function table(rows) {
  const columns = rows.some(({ rasterizers }) => rasterizers) ? [...COLUMNS, ...RASTERIZER_COLUMNS] : COLUMNS;
  const line = (row) =>
    `<tr><th scope="row"><a class="${row.pass ? 'within' : 'over'}" href="#${anchor(row.name)}">${escaped(row.name)}</a></th>${columns
      .map(([, value]) => cell(value(row)))
      .join('')}</tr>`;
  return `<table><thead><tr><th scope="col">case</th>${columns.map(([heading]) => `<th scope="col">${heading}</th>`).join('')}</tr></thead>
<tbody>${rows.map(line).join('\n')}</tbody></table>`;
}

function figures({ name, rasterizers }) {
  const kinds = {
    browser: 'three.js in Chromium',
    telar: 'telar',
    difference: `difference x ${GAIN}`,
    ...(rasterizers && { other: 'three.js on SwiftShader' }),
  };
  return Object.entries(kinds)
    .map(([kind, title]) => {
      const file = `pictures/${encodeURIComponent(name)}.${kind}.png`;
      return `<figure><a href="${file}"><img loading="lazy" src="${file}" alt="${escaped(`${name}: ${title}`)}"></a><figcaption>${title}</figcaption></figure>`;
    })
    .join('\n');
}

const values = (list) => (list ? list.map((value) => Number(value.toPrecision(7))).join(' ') : '');

function traceTable({ pixel, terms, cause }) {
  const drawn = terms.filter(({ browser, telar }) => browser || telar);
  const line = ({ term, browser, telar, difference, differs }) =>
    `<tr${differs ? ' class="over"' : ''}><th scope="row">${escaped(term)}</th><td>${values(browser)}</td><td>${values(telar)}</td><td>${difference.toExponential(1)}</td></tr>`;
  return `<p>Pixel ${pixel.join(' ')} through both shaders: ${escaped(cause)}</p>
<table><thead><tr>${['quantity', 'three.js', 'telar', 'difference'].map((heading) => `<th scope="col">${heading}</th>`).join('')}</tr></thead>
<tbody>${drawn.map(line).join('\n')}</tbody></table>`;
}

function section(row) {
  const heading = `<h2 id="${anchor(row.name)}" class="${row.pass ? 'within' : 'over'}">${row.pass ? 'within' : 'over'}: ${escaped(row.name)}</h2>`;
  if (row.error) return `<section>${heading}<pre>${escaped(row.error)}</pre></section>`;
  return `<section>${heading}<p>${escaped(figuresText(row))}</p>${row.explanation ? `<p>${escaped(row.explanation)}</p>` : ''}\n${figures(row)}\n${row.trace ? traceTable(row.trace) : ''}</section>`;
}

/** What three.js does, what telar does, and both pictures. */
function known(differences, rows) {
  if (differences.length === 0) return '';
  const part = ({ name, three, telar, source, cases }) => `<section><h3>${escaped(name)}</h3>
<p>three.js: ${escaped(three)} (${escaped(source)})</p><p>telar: ${escaped(telar)}</p>
${rows
  .filter((row) => cases.includes(row.name))
  .map((row) => (row.error ? `<pre>${escaped(row.error)}</pre>` : figures(row)))
  .join('\n')}</section>`;
  return `<h2 id="known">Known differences: where three.js itself is wrong. Shown, not judged.</h2>\n${differences.map(part).join('\n')}`;
}

/**
 * The report: a table of all cases, then each with its pictures, those over the bar first. Needs no network and no script.
 * @param {import('./report.mjs').Row[]} rows
 * @param {object} facts
 * @param {string} facts.summary
 * @param {import('./known_differences.mjs').KnownDifference[]} facts.knownDifferences
 * @param {import('./report.mjs').Row[]} facts.knownRows - Their pictures.
 * @returns {string} HTML; its pictures lie in pictures/ beside it.
 */
export function reportPage(rows, { summary, knownDifferences, knownRows }) {
  const sorted = [...rows].sort((a, b) => a.pass - b.pass);
  const title = `telar against three.js: ${rows.filter(({ pass }) => pass).length} of ${rows.length} cases within the bar`;
  return `<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>${title}</title><style>${STYLE}</style></head>
<body><h1>${title}</h1>
<p>${escaped(summary)}${knownDifferences.length ? ` <a href="#known">Known differences</a> stand at the end.` : ''}</p>
<p>Interior: pixels off the silhouette by more than 2 px; at most 2/255 anywhere, 99.9 % at most 1/255. Edge: FLIP mean at most 0.01. SwiftShader:
telar's p99.9 and mean at most ${ALLOWANCE * 100} % above the client's own distance from itself. All figures in 1/255 but FLIP.</p>
${table(sorted)}
${sorted.map(section).join('\n')}
${known(knownDifferences, knownRows)}
</body></html>
`;
}
