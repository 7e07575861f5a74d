import { checkName, checkText, number } from './figures.mjs';
import { CAPTIONS, check, figuresTable, hintList, page, picture } from './html_report.mjs';
import { escaped } from './markup.mjs';

/** What each status is called, those that need a person first. */
const STATUSES = {
  failed: 'not compared',
  over: 'over the gate',
  missing: 'missing',
  new: 'new',
  updated: 'accepted',
  within: 'within the gate',
};
const ORDER = Object.keys(STATUSES);
const isGood = (status) => status === 'within' || status === 'updated';

const chip = (status) => `<span class="${isGood(status) ? 'within' : 'over'}">${STATUSES[status]}</span>`;

function section({ name, status, comparison, verdict, hints = [], problem, files = {} }) {
  const pictures = Object.entries(CAPTIONS)
    .filter(([kind]) => files[kind])
    .map(([kind, title]) => picture({ file: files[kind], title }));
  return `<section id="${escaped(encodeURIComponent(name))}"><h2>${escaped(name)}: ${chip(status)}</h2>
${problem ? `<p>${escaped(problem)}</p>` : ''}
${verdict ? `<ul>${verdict.checks.map(check).join('')}</ul>` : ''}
${hintList(hints)}
${pictures.join('\n')}
${comparison ? `<details><summary>Figures</summary>${figuresTable(comparison)}</details>` : ''}</section>`;
}

/** Of all images: what a person looks at first. */
const figuresOf = ({ comparison: { object, frame, ssim } }) => {
  const { flip, deltaE, max } = object ?? frame;
  return [number(flip.mean), number(deltaE.mean), number(deltaE.p95), `${max}`, number(ssim)];
};

function line(compared) {
  const { name, status, comparison, verdict, files } = compared;
  const title = files || status !== 'within' ? `<a href="#${escaped(encodeURIComponent(encodeURIComponent(name)))}">${escaped(name)}</a>` : escaped(name);
  const over =
    verdict?.checks
      .filter(({ pass }) => !pass)
      .map((item) => `${checkName(item)} ${checkText(item)}`)
      .join('; ') ?? '';
  const cells = comparison ? figuresOf(compared) : ['', '', '', '', ''];
  return `<tr title="${escaped(over)}"><th scope="row">${title}</th><td>${chip(status)}</td>${cells.map((cell) => `<td>${escaped(cell)}</td>`).join('')}</tr>`;
}

/**
 * A page about the images of two folders: how many are within the gate, each that is not with its pictures, and all in a
 * table.
 * @param {Array<{name: string, status: string, comparison?: object, verdict?: object, hints?: {message: string}[], problem?: string,
 *   files?: {expected?: string, actual?: string, heatMap?: string}}>} compared status: a key of STATUSES; files: as the page
 *   links to them
 * @param {{title?: string, gate: string}} options
 * @returns {string} HTML
 */
export function foldersReport(compared, { title = 'Comparison', gate }) {
  const sorted = [...compared].sort((a, b) => ORDER.indexOf(a.status) - ORDER.indexOf(b.status));
  const bad = compared.filter(({ status }) => !isGood(status)).length;
  const heading = `${title}: ${bad === 0 ? `all ${compared.length} within the gate` : `${bad} of ${compared.length} not within the gate`} "${gate}"`;
  const counts = ORDER.map((status) => [status, compared.filter((each) => each.status === status).length]).filter(([, count]) => count > 0);
  return page(
    heading,
    `<h1>${escaped(heading)}</h1>
<p>${counts.map(([status, count]) => `${count} ${STATUSES[status]}`).join(', ')}.</p>
${sorted
  .filter(({ status }) => status !== 'within')
  .map(section)
  .join('\n')}
<table><thead><tr><th scope="col">image</th><th scope="col">verdict</th><th scope="col">FLIP mean</th><th scope="col">dE00 mean</th><th scope="col">dE00 p95</th><th scope="col">max</th><th scope="col">SSIM</th></tr></thead>
<tbody>${sorted.map(line).join('\n')}</tbody></table>
<p>Figures of the object, where there is one. max in 1/255.</p>`,
  );
}
