import { checkName, checkText, COLUMNS, number, regionRows } from './figures.mjs';
import { escaped } from './markup.mjs';

/** Of every report. */
export const STYLE = `body{font:15px/1.45 system-ui,sans-serif;margin:2rem auto;max-width:76rem;padding:0 1.5rem;background:#fff;color:#1c1b19}
h1{font-size:1.4rem;font-weight:600}h2{font-size:1.05rem;font-weight:600;margin:0}
figure{display:inline-block;margin:0 1rem 1rem 0;max-width:31%;vertical-align:top}figcaption{color:#6b6762;font-size:.85rem}
img{max-width:100%;image-rendering:pixelated;background:repeating-conic-gradient(#e9e7e4 0 25%,#fff 0 50%) 0 0/16px 16px}
table{border-collapse:collapse;margin:1rem 0;font-variant-numeric:tabular-nums}th,td{padding:.25rem .8rem .25rem 0;text-align:right;border-bottom:1px solid #e3e0dc}
th:first-child{text-align:left}thead th{color:#6b6762;font-weight:500}section{border-top:1px solid #e3e0dc;padding-top:1.2rem;margin:1.2rem 0 1.8rem}ul{padding-left:1.2rem}.over{color:#b00020;font-weight:600}.hint{color:#6b4e00}`;

export const row = (cells) =>
  `<tr><th scope="row">${escaped(cells[0])}</th>${cells
    .slice(1)
    .map((cell) => `<td>${escaped(cell)}</td>`)
    .join('')}</tr>`;

export const picture = ({ file, title }) => `<figure><img src="${escaped(file)}" alt="${escaped(title)}"><figcaption>${escaped(title)}</figcaption></figure>`;

export const check = (item) =>
  `<li class="${item.pass ? 'within' : 'over'}">${item.pass ? 'within' : 'over'}: ${escaped(`${checkName(item)} ${checkText(item)}`)}</li>`;

/** What explains the difference. */
export const hintList = (hints) => (hints.length > 0 ? `<p class="hint">${hints.map(({ message }) => `Hint: ${escaped(message)}.`).join(' ')}</p>` : '');

/** Figures of every region. */
export const figuresTable = (
  comparison,
) => `<table><thead><tr><th scope="col">region</th>${COLUMNS.map((name) => `<th scope="col">${name}</th>`).join('')}</tr></thead>
<tbody>${regionRows(comparison).map(row).join('\n')}</tbody></table>
<p>${comparison.width} x ${comparison.height} pixels, SSIM ${number(comparison.ssim)}. max and p99.9 in 1/255.</p>`;

export const page = (title, body) => `<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>${escaped(title)}</title><style>${STYLE}</style></head>
<body>${body}
</body></html>
`;

/** Captions of the three pictures. */
export const CAPTIONS = { expected: 'Expected', actual: 'Actual', heatMap: 'FLIP: black 0, light yellow 1' };

/**
 * A page with the pictures, the heat map, the verdict and all figures.
 * @param {import('./compare.mjs').Comparison} comparison
 * @param {import('./gates.mjs').Verdict} verdict
 * @param {{expected: string, actual: string, heatMap: string, title?: string, hints?: {message: string}[]}} files as the page
 *   links to them
 * @returns {string} HTML
 */
export function htmlReport(comparison, verdict, { expected, actual, heatMap, title = 'Comparison', hints = [] }) {
  const heading = `${title}: ${verdict.pass ? 'within' : 'over'} the gate "${verdict.gate}"`;
  const pictures = Object.entries({ expected, actual, heatMap }).map(([kind, file]) => ({ file, title: CAPTIONS[kind] }));
  return page(
    heading,
    `<h1>${escaped(heading)}</h1>
<ul>${verdict.checks.map(check).join('\n')}</ul>
${hintList(hints)}
${pictures.map(picture).join('\n')}
${figuresTable(comparison)}`,
  );
}
