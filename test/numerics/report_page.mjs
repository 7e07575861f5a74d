// The page of figures, from what the checks measured.

const INTRODUCTION = `# Numerics at the extremes

Every shading is one text, compiled for the GPU and as C++ in single and in double precision. These are its invariants,
measured on Mesa llvmpipe and on the CPU; \`npm run numerics\` measures them again and writes this page. \`npm test\`
asserts the same bars at fewer points. A figure without a bar is what a stock model does, kept as it is.

`;

/** What stands under each heading. */
const NOTES = {
  'Every point': 'A grid of edge values (roughness 0 to 1, cosines from 0, 1e-6 and 1e-4 to 1, reflectances 0 to 1, sheen, coat, stretch) and random materials, directions and frames with edge values forced. Errors are relative to the radiance of light of irradiance 1, absolute below 1e-4. Of the stock shadings, what rounding the directions explains is taken off, for their terms lose digits by the way they are written (an error below the bar is given as it is, so that the worst of many points lies just below it); on the grid fabric is measured as it is.',
  'GPU against double': 'The fragment shader\'s text into 32-bit float targets, over the same grid, against double precision.',
  Reciprocity: 'With viewer and light exchanged, by lobe.',
  'White furnace': 'What white cloth sends back of light of radiance 1 from everywhere: lights in all directions (by quadrature in double) and an environment. Each layer alone at eight roughnesses, and any mix of layers.',
  Smoothness: 'How far the peak of the GGX lobe rises when roughness does, and slopes by symmetric differences for roughness of 0.089 and above and cosines of 0.1 and above.',
  'Extremes, drawn': 'A ball of every layer at one extreme each, into 32-bit float targets: pixels that are NaN, infinite or negative, before anything caps them and in the picture.',
  'Random materials, drawn': 'Frames of 576 bodies, each of its own material with any value that the loader lets through, in random light.',
  Normalisation: 'Projected area of every distribution of normals, and the integral of the path tracer\'s density.',
  'Whole pictures': 'From a GLB file to 8-bit pixels.',
};

const rounded = (value) => {
  if (value === null) return 'not finite';
  return Number.isInteger(value) && Math.abs(value) < 1e6 ? String(value) : String(Number(value.toPrecision(3)));
};

/** The bar of a figure in words. */
function bar({ low, high }) {
  if (low === null && high === null) return '-';
  if (low === null) return high === 0 ? '0' : `<= ${rounded(high)}`;
  if (high === null) return `>= ${rounded(low)}`;
  return low === high ? rounded(low) : `${rounded(low)} .. ${rounded(high)}`;
}

const escaped = (text) => text.replaceAll('|', '\\|');
const cell = (figure) => (figure ? `${rounded(figure.measured)}${figure.holds ? '' : ' **over**'}` : '');

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
    lines.push(`| ${escaped(what)} | ${cells.join(' | ')} | ${bound} | ${Math.max(...list.map(({ points }) => points)).toLocaleString('en')} |`);
  }
  return lines.join('\n');
}

/** Where the worst of each asserted figure lies. */
function places(figures) {
  const known = figures.filter(({ where, high, measured, holds }) => where && (!holds || (high > 0 && measured > high / 4)));
  if (known.length === 0) return '';
  const lines = known.map(({ what, shading, measured, where }) => `- ${what}${shading && `, ${shading}`}: ${rounded(measured)} at ${where}`);
  return `\nWhere those near their bars lie:\n\n${lines.join('\n')}\n`;
}

/**
 * @param {{topic: string, name: string, seconds: number, figures: object[]}[]} checks
 * @returns {string} Markdown
 */
export function numericsPage(checks) {
  const topics = grouped(checks, ({ topic }) => topic);
  const sections = topics.map(([topic, list]) => {
    const figures = list.flatMap((check) => check.figures);
    return `## ${topic}\n\n${NOTES[topic]}\n\n${table(figures)}\n${places(figures)}`;
  });
  return `${INTRODUCTION}${sections.join('\n')}`;
}
