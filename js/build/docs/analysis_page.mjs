import { inWords, LIGHTS, percent, ranksText, shortFigure, strongestIn } from '../../analyse/index.mjs';
import { fuzzMarkdown } from './fuzz_section.mjs';
import { heading, row } from './tables.mjs';

/** js/docs/analysis.md: how to use telar analyse, and what it found; every figure and word of the second part is from the run. */

const USAGE = `# Two shadings, term by term

\`telar analyse\` says which difference between two shadings changes pictures of cloth most. It draws each fabric in each light with
the first shading, with the second, with each single term of the second in the first, and with each single term of the first put
back into the second; compares them on the cloth alone; and ranks the terms.

\`\`\`sh
telar analyse --from three-r115 --to disney-2012 --report report
telar analyse --to '{"base": "three-r115", "sheen": "zeltner", "diffuse": "eon"}' --fabrics velvet,towel --lights rim,sky
telar analyse shirt.glb --lights studio,church.hdr --json
telar analyse --from three@180 --to three@187 --fabrics wool
telar analyse --terms
\`\`\`

| option | does |
|---|---|
| \`MODEL...\` | what to draw; without models the bundled drape, a cloth over a ball |
| \`--from\`, \`--to\` | the shadings: \`three-r115\` (default of \`--from\`), \`disney-2012\` (of \`--to\`), or JSON of one with terms swapped; two releases of three.js (\`three@180\`) are compared slot by slot ([releases.md](releases.md)); of \`fabric\`, and of \`three\` beside another shading, the whole difference alone |
| \`--fabrics NAMES\` | of the bundled drape: \`leather,wool,towel,velvet\`, all by default; glTF materials of numbers typical of the class |
| \`--lights NAMES\` | $LIGHTS or environments (.hdr, .exr); \`studio,sun\` by default; lights in the model are left out |
| \`--view VIEW\` | in place of the drape's own camera, or of the front of a model |
| \`--size WxH\`, \`--quality Q\` | of each picture, 320x320 and \`standard\` by default; \`--quality reference\` path traces them |
| \`--report DIR\` | writes \`index.html\`, one file with ranking, lobe plots, albedo curves and pictures, and \`analysis.json\` |
| \`--terms\` | lists the slots and their terms ([shading.md](shading.md) says what each is), and draws nothing |
| \`--backend\`, \`--limit\`, \`--json\`, \`--quiet\` | as in other commands |

Exit codes are those of all commands: 0 done, 2 usage, 3 bad input, 4 a limit, 5 time, memory or a signal, 6 this machine.

## How to read it

- FLIP (0 none, 1 largest) and CIEDE2000 (1 is about what is just seen side by side) are over the pixels that the cloth covers by half
  or more; the pictures stand before middle grey.
- *Alone*: the first shading with one term swapped, against the first. *Last*: the second against itself with that term put back.
  Where the two differ by more than a quarter, the term works through others, and the interaction is told.
- The rank goes by the mean FLIP of both over all views; *ranks* are the best and the worst in a single view; *of the whole* is the same
  FLIP over that of all terms together. Shares need not add up to 100 %: differences can overlap, or cancel.
- The raster reads a prefiltered environment: the terms \`environment\` and \`scattering\` are how it does so, no part of the models. With
  \`--quality '{"preset": "reference", "samples": 64, "transport": "direct"}'\` the same pictures are path traced, these two terms change
  nothing, and what is left are the models alone; noise adds to FLIP, the less the more samples.
- The words come from CIELAB lightness and chroma of the whole cloth, of its limb (normal and viewer at a cosine below 0.4), of its centre
  (above 0.8) and of its highlights (the brightest 3 % of either picture).
- Lobe plots: light that leaves towards the viewer (BRDF times cosine) for light from each direction in the plane of normal and viewer; the
  distance from the centre is its square root. Albedo: the share of light from everywhere that leaves towards the viewer; above 1 the
  surface gives more than it takes. Both are in double precision, by the text that the shaders are made of (\`evaluateShading\`).
`.replace(
  '$LIGHTS',
  Object.entries(LIGHTS)
    .map(([name, { about }]) => `\`${name}\` (${about})`)
    .join(', '),
);

const table = (headings, rows) => [...heading(headings), ...rows.map(row)].join('\n');

function ranking({ rows }) {
  return table(
    [
      'rank',
      'term',
      'swap',
      'FLIP alone',
      'range',
      'last',
      'dE00 mean',
      'p95',
      'of the whole',
      'rank by dE00',
      'ranks',
      'alone, it makes the cloth',
      'interaction',
    ],
    rows.map((term) => [
      term.rank,
      `**${term.slot}**`,
      `${term.from} → ${term.to}`,
      `${shortFigure(term.alone.flip.mean)} ± ${shortFigure(term.alone.flip.deviation)}`,
      `${shortFigure(term.alone.flip.min)} to ${shortFigure(term.alone.flip.max)}`,
      shortFigure(term.rest.flip.mean),
      term.alone.deltaE.mean.toFixed(2),
      term.alone.deltaEp95.mean.toFixed(2),
      percent(term.share),
      term.rankByColour,
      ranksText(term.ranks),
      term.words,
      term.interaction,
    ]),
  );
}

const byView = ({ rows, cells }) =>
  table(
    ['FLIP alone', ...cells.map(({ target, light }) => `${target}, ${light}`)],
    [
      ...rows.map(({ slot }) => [slot, ...cells.map(({ terms }) => shortFigure(terms[slot].alone.flip.mean))]),
      ['**all terms**', ...cells.map(({ all }) => shortFigure(all.flip.mean))],
    ],
  );

/** One fabric: what all terms do in each light, which terms lead there, its pictures and plots. */
function fabricSection(target, { cells, names }) {
  const own = cells.filter((cell) => cell.target === target);
  const lines = own.map((cell) => {
    const leading = strongestIn(cell).map((slot) => `${slot} (${shortFigure(cell.terms[slot].alone.flip.mean)}: ${inWords(cell.terms[slot].alone)})`);
    return `- ${cell.light}: FLIP ${shortFigure(cell.all.flip.mean)}, CIEDE2000 ${cell.all.deltaE.mean.toFixed(2)} (p95 ${cell.all.deltaE.p95.toFixed(2)}). ${names.to}: ${inWords(cell.all)}. Most by ${leading.join(', then ')}.`;
  });
  const sheet = `${names.from}, ${names.to}, FLIP between them, ${names.from} with the strongest term swapped`;
  const swapped = own.map((cell) => `${cell.light} (${strongestIn(cell)[0]})`).join(', ');
  return `### ${target}

${lines.join('\n')}

![${target}: ${sheet}](analysis/${target}.png)

Left to right: ${sheet}. Top to bottom, with that term: ${swapped}.

![${target}: lobes seen from 65 degrees](analysis/${target}-lobes-65.svg) ![${target}: directional albedo](analysis/${target}-albedo.svg)
`;
}

/**
 * What changed between two releases of three.js: the terms that show.
 * @param {import('../../analyse/analyse.mjs').Analysis} analysis
 * @returns {string} Markdown
 */
export function upgradeMarkdown({ names, shot, cells, rows }) {
  const [shown, unseen] = [rows.filter(({ effect }) => effect > 0), rows.filter(({ effect }) => effect === 0)];
  const { width, height } = shot.size;
  return `${table(
    ['rank', 'term', 'swap', 'FLIP alone', 'range', 'last', 'of the whole', 'alone, it makes the cloth'],
    shown.map((term) => [
      term.rank,
      `**${term.slot}**`,
      `${term.from} → ${term.to}`,
      shortFigure(term.alone.flip.mean),
      `${shortFigure(term.alone.flip.min)} to ${shortFigure(term.alone.flip.max)}`,
      shortFigure(term.rest.flip.mean),
      percent(term.share),
      term.words,
    ]),
  )}

${table(
  [`${names.to} against ${names.from}`, 'FLIP', 'CIEDE2000', 'p95', 'in words'],
  cells.map(({ target, light, all }) => [
    `${target}, ${light}`,
    shortFigure(all.flip.mean),
    all.deltaE.mean.toFixed(2),
    all.deltaE.p95.toFixed(2),
    inWords(all),
  ]),
)}

${width} x ${height} pixels, quality ${JSON.stringify(shot.quality)}; written by \`npm run analysis\`. These models do not show ${unseen.map(({ slot }) => slot).join(', ')}.
`;
}

/**
 * @param {import('../../analyse/analyse.mjs').Analysis} analysis
 * @param {string[]} targets
 * @param {Awaited<ReturnType<typeof import('./fuzz_section.mjs').fuzzOf>>} fuzz
 * @returns {string} Markdown
 */
export function analysisMarkdown(analysis, targets, fuzz) {
  const { names, shot, cells, rows } = analysis;
  const { width, height } = shot.size;
  return `${USAGE}
## ${names.to} against ${names.from}

This part is written by \`npm run analysis\`: ${targets.join(', ')} in ${[...new Set(cells.map(({ light }) => light))].join(' and ')}, ${width} x ${height} pixels,
quality ${JSON.stringify(shot.quality)}. ${rows.filter(({ effect }) => effect > 0).length} of the ${rows.length} terms that differ change these pictures.

${ranking(analysis)}

${byView(analysis)}

${targets.map((target) => fabricSection(target, analysis)).join('\n')}
${fuzzMarkdown(fuzz)}`;
}
