import { escaped } from '../compare/markup.mjs';
import { CENTRE_ABOVE, HIGHLIGHT_SHARE, LIMB_BELOW } from './differences.mjs';
import { percent, ranksText, shortFigure as figure } from './lines.mjs';
import { ALBEDO_ANGLES, LIGHT_ANGLES } from './lobes.mjs';
import { albedoPlot, lobePlot } from './plots.mjs';
import { strongestIn } from './ranking.mjs';
import { STYLE } from './report_style.mjs';
import { inWords } from './words.mjs';

/** The report: one HTML file without a script, pictures and plots within it. */

const th = (name, more = '') => `<th scope="col"${more}>${escaped(name)}</th>`;
const td = (value, className = '') => `<td${className ? ` class="${className}"` : ''}>${escaped(value)}</td>`;

/** Bar of a share of the largest effect, after the term. */
const bar = (share) => `<td class="bar" aria-hidden="true"><span style="width:${Math.round(share * 100)}%"></span></td>`;

/** [heading, cell, class of its words or ''] of the ranking. */
const COLUMNS = [
  ['rank', ({ rank }) => rank],
  ['term', ({ slot, from, to }) => [slot, `${from} → ${to}`], 'words'],
  ['FLIP alone', ({ alone }) => [figure(alone.flip.mean), `± ${figure(alone.flip.deviation)}`]],
  ['range', ({ alone }) => [`from ${figure(alone.flip.min)}`, `to ${figure(alone.flip.max)}`]],
  ['FLIP last', ({ rest }) => figure(rest.flip.mean)],
  ['dE00 alone', ({ alone }) => [alone.deltaE.mean.toFixed(2), `p95 ${alone.deltaEp95.mean.toFixed(2)}`]],
  ['of the whole', ({ share }) => percent(share)],
  ['ranks', ({ ranks, rankByColour }) => [ranksText(ranks), `dE00 ${rankByColour}`]],
  ['alone, it makes the cloth', ({ words }) => words, 'words'],
  ['interaction: it changes', ({ interaction }) => interaction, 'words'],
];

/** A cell, with a second line where there is one. */
function rankCell(value, className, isHeader) {
  const [first, second] = [value].flat();
  const name = isHeader ? 'th' : 'td';
  const attributes = `${isHeader ? ' scope="row"' : ''}${className ? ` class="${className}"` : ''}`;
  return `<${name}${attributes}>${escaped(first)}${second === undefined ? '' : `<br><small>${escaped(second)}</small>`}</${name}>`;
}

function rankTable({ rows }) {
  const largest = rows[0].effect || 1;
  const line = (row) => {
    const cells = COLUMNS.map(([heading, cellOf, className]) => rankCell(cellOf(row), className, heading === 'term'));
    return `<tr${row.effect === 0 ? ' class="none"' : ''}>${cells.toSpliced(2, 0, bar(row.effect / largest)).join('')}</tr>`;
  };
  const headings = COLUMNS.map(([heading, , className]) => th(heading, className ? ` class="${className}"` : '')).toSpliced(
    2,
    0,
    th('effect', ' class="words"'),
  );
  return `<div class="wide"><table><thead><tr>${headings.join('')}</tr></thead>\n<tbody>${rows.map(line).join('\n')}</tbody></table></div>`;
}

/** Rows of terms by columns of cells: FLIP alone, darker where larger. */
function cellTable({ rows, cells }) {
  const largest = Math.max(...cells.flatMap(({ terms }) => Object.values(terms).map(({ alone }) => alone.flip.mean)), 1e-9);
  const shaded = (value) => `<td style="--heat:${Math.round((value / largest) * 100)}%">${figure(value)}</td>`;
  const line = ({ slot }) => `<tr><th scope="row">${escaped(slot)}</th>${cells.map(({ terms }) => shaded(terms[slot].alone.flip.mean)).join('')}</tr>`;
  const all = `<tr class="sum"><th scope="row">all terms</th>${cells.map((cell) => td(figure(cell.all.flip.mean))).join('')}</tr>`;
  return `<div class="wide"><table class="heat"><thead><tr>${th('FLIP alone')}${cells.map(({ target, light }) => th(`${target}, ${light}`)).join('')}</tr></thead>
<tbody>${rows.map(line).join('\n')}\n${all}</tbody></table></div>`;
}

const picture = (source, title, note = '') =>
  `<figure><img src="${source}" alt="${escaped(title)}"><figcaption><b>${escaped(title)}</b>${note ? `<br>${escaped(note)}` : ''}</figcaption></figure>`;

const differenceNote = (difference) =>
  `FLIP ${figure(difference.flip.mean)}, dE00 ${difference.deltaE.mean.toFixed(2)} (p95 ${difference.deltaE.p95.toFixed(2)}): ${inWords(difference)}`;

function cellSection(cell, names, sources) {
  const signed = (value) => `${value >= 0 ? '+' : '−'}${Math.abs(value).toFixed(2)}`;
  const region = (name, change) => (change ? `<tr><th scope="row">${name}</th>${td(signed(change.lightness))}${td(signed(change.chroma))}</tr>` : '');
  const { all } = cell;
  return `<section><h3>${escaped(`${cell.target}, ${cell.light}`)}</h3>
<p>${escaped(names.to)} against ${escaped(names.from)}: ${escaped(differenceNote(all))}</p>
<div class="pictures">${picture(sources.from, names.from)}${picture(sources.to, names.to)}${picture(sources.map, 'FLIP', 'black 0, light yellow 1')}
${strongestIn(cell)
  .map((slot) => picture(sources[slot], `${names.from} with ${slot} swapped`, differenceNote(cell.terms[slot].alone)))
  .join('\n')}</div>
<table class="small"><thead><tr>${th('all')}${th('L*')}${th('C*')}</tr></thead><tbody>${region('cloth', all.cloth)}${region('limb', all.limb)}${region('centre', all.centre)}${region('highlights', all.highlight)}</tbody></table>
</section>`;
}

/** Plots of one target: {name: SVG}. */
export function plotsOf({ target, lobes, albedo }, names) {
  const plots = lobes.map(({ viewAngle, from, to }) => [
    `lobes-${viewAngle}`,
    lobePlot({ title: `${target}: lobes, viewer at ${viewAngle}°`, names, viewAngle, angles: LIGHT_ANGLES, from, to }),
  ]);
  return Object.fromEntries([...plots, ['albedo', albedoPlot({ title: `${target}: directional albedo`, names, angles: ALBEDO_ANGLES, ...albedo })]]);
}

function plotSection(curves, names) {
  return `<section><h3>${escaped(curves.target)}</h3><div class="plots">${Object.values(plotsOf(curves, names))
    .map((plot) => `<figure>${plot}</figure>`)
    .join('\n')}</div></section>`;
}

const HOW_TERMS = `Alone: the first shading with this one term of the second. Last: the second against itself with this one term of the first put
back. Effect: the mean of both, by which the terms are ranked. Ranks: best and worst in a single picture, and below by CIEDE2000.`;
const HOW = `FLIP (0..1) and CIEDE2000 are means over the pixels that the cloth covers by half or more, over middle grey. Limb: cloth whose normal and viewer meet at a cosine below ${LIMB_BELOW}; centre: above ${CENTRE_ABOVE};
highlights: the brightest ${HIGHLIGHT_SHARE * 100} % of either picture. L* and C* are CIELAB, second shading less first.`;

/**
 * @param {import('./analyse.mjs').Analysis} analysis
 * @param {Array<Record<string, string>>} sources - For each cell the URLs of its pictures: from, to, map, and each of strongestIn.
 * @returns {string} HTML
 */
export function analysisPage(analysis, sources) {
  const { names, rows, cells, curves, shot, swaps } = analysis;
  const title = `${names.to} against ${names.from}${rows.length > 0 ? ', term by term' : ''}`;
  const { width, height } = shot.size;
  return `<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width,initial-scale=1"><meta name="color-scheme" content="light dark">
<title>${escaped(title)}</title><style>${STYLE}</style></head>
<body><h1>${escaped(title)}</h1>
<p>${cells.length} views of ${width} x ${height} pixels, each with ${Object.keys(swaps.shadings).length} shadings; quality ${escaped(JSON.stringify(shot.quality))}; ${rows.length > 0 ? `${rows.length} terms differ. ${HOW_TERMS} ` : ''}${HOW}</p>
${
  rows.length === 0
    ? ''
    : `<h2>Which terms change the picture most</h2>
${rankTable(analysis)}
<h2>By fabric and light</h2>
${cellTable(analysis)}
`
}<h2>Lobes and albedo</h2>
<p>Lobes: light that leaves towards the viewer (BRDF times cosine), for light from each direction in the plane of the normal and the viewer; distance from the centre is its
square root, rings are labelled with the value. Albedo: the share of light from everywhere that leaves towards the viewer; above 1 a surface gives more than it takes. Textures are left out.</p>
${curves.map((item) => plotSection(item, names)).join('\n')}
<h2>Pictures</h2>
${cells.map((cell, i) => cellSection(cell, names, sources[i])).join('\n')}
</body></html>
`;
}
