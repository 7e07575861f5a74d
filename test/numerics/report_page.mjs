// The page of figures, from what the checks measured, and back.
import { IMAGE_FAULTS } from './image_faults.mjs';

const INTRODUCTION = `# Numerics at the extremes

Every shading is one text, compiled for the GPU and as C++ in single and in double precision. These are its invariants,
measured on Mesa llvmpipe and on the CPU; \`npm run numerics\` measures them again and writes this page, some 20 minutes on two
quiet cores, and goes on where it was stopped. \`npm test\` asserts the same bars at fewer points, holds every row to the count
that it names, and plants the faults that stand at the end. A figure without a bar is what a stock model does, kept as it is.

`;

/** What stands under each heading. */
const NOTES = {
  'Every point':
    'A grid of edge values (roughness 0 to 1, cosines from 0, 1e-6 and 1e-4 to 1, reflectances 0 to 1, sheen, coat, stretch, yarns) and random materials, directions and frames with edge values forced. Errors are relative to the radiance of light of irradiance 1, absolute below 1e-4. Nothing is taken off them. At random, directions lie within a rounding of the horizon and of each other, where terms that are written as a distribution of a cosine lose digits: how many points are over the bar is told, and of their error what is left when the parts of v, n and l may move by four steps of single precision, which no arithmetic in single precision can tell apart.',
  'GPU against double': "The fragment shader's text into 32-bit float targets, over the same grid, against double precision. Nothing is taken off.",
  Reciprocity: 'With viewer and light exchanged, by lobe.',
  'White furnace':
    'What white cloth sends back of light of radiance 1 from everywhere: lights in all directions (by quadrature in double) and an environment. Each layer alone at eight roughnesses, and any mix of layers; what is stretched or woven from seven azimuths in a quarter turn, mixes from any. Where yarns leave gaps, the least is of what they cover: light that falls through the gaps of a metal weave does not come back.',
  'Woven cloth':
    'White cloth of any two sets of yarns: dielectric, metal and between, roughness and anisotropy 0 to 1, gaps of 0 to half of the surface, seen from any azimuth at cosines of 0.02 to 1, in light of radiance 1 from everywhere. Drawn under a sky of 1, each on a patch that the camera sees from that side: with the prefiltered environment, and with 8,192 directions a pixel.',
  Smoothness:
    'How far the peak of the GGX lobe rises when roughness does, and slopes by symmetric differences for roughness of 0.089 and above and cosines of 0.1 and above.',
  'Extremes, drawn':
    'A ball of every layer at one extreme each, into 32-bit float targets: pixels that are NaN, infinite or negative, before anything caps them and in the picture.',
  'Random materials, drawn': 'Frames of 576 bodies, each of its own material with any value that the loader lets through, in random light.',
  Normalisation:
    "Projected area of every distribution of normals, and the integral of the path tracer's density over the sphere, by cells that are halved until they agree.",
  'Whole pictures': 'From a GLB file to 8-bit pixels.',
};

const FAULTS_NOTE = `## Faults that the suite finds

Each is planted for real, in the text of the shadings, in the renderer, in the suite's own reading of a material or in the
shot; \`npm test\` runs the check named with it and without it. Every bar above is missed by one of them.`;

const exponent = (text) => text.replace('e+', 'e');

/** A bar as it is. */
const exact = (value) => (Math.abs(value) >= 1e6 ? exponent(value.toExponential()) : value.toLocaleString('en', { maximumSignificantDigits: 15 }));

/** A figure to so many digits that its distance from a bar shows two of them. */
function rounded(value, { low = null, high = null } = {}) {
  if (value === null) return 'not finite';
  const counts = [low, high].every((bar) => bar === null || Number.isInteger(bar));
  if (value === 0 || (counts && Number.isInteger(value))) return exact(value);
  const size = Math.floor(Math.log10(Math.abs(value)));
  const margins = [low, high].filter((bar) => bar !== null && bar !== value).map((bar) => Math.abs(bar - value));
  const least = margins.length > 0 ? size + 2 - Math.floor(Math.log10(Math.min(...margins))) : 0;
  const digits = Math.min(Math.max(least, size >= -1 ? 4 : 3), 9);
  return size < -3 || size > 5 ? exponent(value.toExponential(digits - 1)) : value.toPrecision(digits);
}

/** The bar of a figure in words. */
function bar({ low, high }) {
  if (low === null && high === null) return '-';
  if (low === null) return high === 0 ? '0' : `<= ${exact(high)}`;
  if (high === null) return `>= ${exact(low)}`;
  return low === high ? exact(low) : `${exact(low)} .. ${exact(high)}`;
}

const escaped = (text) => text.replaceAll('|', '\\|');
const cell = (figure) => (figure ? `${rounded(figure.measured, figure)}${figure.holds ? '' : ' **over**'}` : '');

/** [key, items][] in the order in which the keys come first. */
function grouped(list, keyOf) {
  const groups = new Map();
  for (const item of list) groups.set(keyOf(item), [...(groups.get(keyOf(item)) ?? []), item]);
  return [...groups];
}

/** A row a quantity, a column a shading; bars stand in a column of their own where they are the same for all. */
function table(figures) {
  const shadings = [...new Set(figures.map(({ shading }) => shading))];
  const rows = grouped(figures, ({ what }) => what);
  const heads = shadings.map((shading) => shading || 'measured');
  const lines = [`| what | ${heads.join(' | ')} | bar | points |`, `|---|${heads.map(() => '---|').join('')}---|---|`];
  for (const [what, list] of rows) {
    const cells = shadings.map((shading) => cell(list.find((figure) => figure.shading === shading)));
    const bars = [...new Set(list.map(bar))];
    const bound = bars.length === 1 ? bars[0] : list.map((figure) => `${figure.shading} ${bar(figure)}`).join(', ');
    lines.push(`| ${escaped(what)} | ${cells.join(' | ')} | ${bound} | ${Math.min(...list.map(({ points }) => points)).toLocaleString('en')} |`);
  }
  return lines.join('\n');
}

/** Where the worst of each asserted figure lies. */
function places(figures) {
  const near = ({ high, low, measured }) => (high > 0 && measured > high / 4) || (low > 0 && measured < low * 1.05);
  const known = figures.filter((figure) => figure.where && (!figure.holds || near(figure)));
  if (known.length === 0) return '';
  const lines = known.map(({ what, shading, where, ...figure }) => `- ${what}${shading && `, ${shading}`}: ${rounded(figure.measured, figure)} at ${where}`);
  return `\nWhere those near their bars lie:\n\n${lines.join('\n')}\n`;
}

function faultsTable(faults) {
  const rows = [...faults.map(({ name, found }) => [name, Object.keys(found)]), ...IMAGE_FAULTS.map(({ name, check }) => [name, [check]])];
  return ['| fault | found by |', '|---|---|', ...rows.map(([name, checks]) => `| ${escaped(name)} | ${checks.join(', ')} |`)].join('\n');
}

/**
 * @param {{topic: string, name: string, seconds: number, figures: object[]}[]} checks
 * @param {{name: string, found: Record<string, string[]>}[]} faults - faults.json
 * @returns {string} Markdown
 */
export function numericsPage(checks, faults) {
  const topics = grouped(checks, ({ topic }) => topic);
  const sections = topics.map(([topic, list]) => {
    const figures = list.flatMap((check) => check.figures);
    return `## ${topic}\n\n${NOTES[topic]}\n\n${table(figures)}\n${places(figures)}`;
  });
  return `${INTRODUCTION}${sections.join('\n')}\n${FAULTS_NOTE}\n\n${faultsTable(faults)}\n`;
}

/**
 * The rows of a page: what is measured, the cell of each shading ('measured' where it is of none), and of how many points.
 * @returns {Map<string, {cells: Record<string, string>, points: number}>}
 */
export function pageRows(page) {
  const rows = new Map();
  let heads = [];
  for (const line of page.split('\n')) {
    if (!line.startsWith('| ')) continue;
    const cells = line
      .replaceAll('\\|', '\0')
      .split('|')
      .slice(1, -1)
      .map((text) => text.trim().replaceAll('\0', '|'));
    if (cells[0] === 'what') heads = cells.slice(1, -2);
    else
      rows.set(cells[0], {
        cells: Object.fromEntries(heads.map((head, i) => [head, cells[i + 1]])),
        points: Number(cells.at(-1).replaceAll(',', '')),
      });
  }
  return rows;
}
