import { checkName, checkText, COLUMNS, number, regionRows } from './figures.mjs';
import { escaped } from './markup.mjs';

const STYLE = `body{font:15px system-ui,sans-serif;margin:1.5rem;background:#fff;color:#111}
figure{display:inline-block;margin:0 1rem 1rem 0;max-width:31%;vertical-align:top}
img{max-width:100%;image-rendering:pixelated;background:repeating-conic-gradient(#ddd 0 25%,#fff 0 50%) 0 0/16px 16px}
table{border-collapse:collapse;margin:1rem 0}th,td{padding:.2rem .7rem;text-align:right;border-bottom:1px solid #ccc}
th:first-child{text-align:left}.over{color:#b00020;font-weight:bold}`;

const row = (cells) => `<tr><th scope="row">${escaped(cells[0])}</th>${cells.slice(1).map((cell) => `<td>${escaped(cell)}</td>`).join('')}</tr>`;

const picture = ({ file, title }) => `<figure><img src="${escaped(file)}" alt="${escaped(title)}"><figcaption>${escaped(title)}</figcaption></figure>`;

const check = (item) =>
  `<li class="${item.pass ? 'within' : 'over'}">${item.pass ? 'within' : 'over'}: ${escaped(`${checkName(item)} ${checkText(item)}`)}</li>`;

/**
 * A page with the pictures, the heat map, the verdict and all figures.
 * @param {import('./compare.mjs').Comparison} comparison
 * @param {import('./gates.mjs').Verdict} verdict
 * @param {{expected: string, actual: string, heatMap: string, title?: string}} files as the page links to them
 * @returns {string} HTML
 */
export function htmlReport(comparison, verdict, { expected, actual, heatMap, title = 'Comparison' }) {
  const heading = `${title}: ${verdict.pass ? 'within' : 'over'} the gate "${verdict.gate}"`;
  const pictures = [{ file: expected, title: 'Expected' }, { file: actual, title: 'Actual' }, { file: heatMap, title: 'FLIP: black 0, light yellow 1' }];
  return `<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width"><title>${escaped(heading)}</title><style>${STYLE}</style></head>
<body><h1>${escaped(heading)}</h1>
<ul>${verdict.checks.map(check).join('\n')}</ul>
${pictures.map(picture).join('\n')}
<table><thead><tr><th scope="col">region</th>${COLUMNS.map((name) => `<th scope="col">${name}</th>`).join('')}</tr></thead>
<tbody>${regionRows(comparison).map(row).join('\n')}</tbody></table>
<p>${comparison.width} x ${comparison.height} pixels, SSIM ${number(comparison.ssim)}. max and p99.9 in 1/255.</p>
</body></html>
`;
}
