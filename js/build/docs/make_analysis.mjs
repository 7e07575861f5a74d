import { mkdir, rm, writeFile } from 'node:fs/promises';
import sharp from 'sharp';
import { analyse, analysisSteps, FABRICS, fabricTargets, lightsOf, picturesOf, plotsOf, strongestIn, swapsBetween } from '../../analyse/index.mjs';
import * as api from '../../index.mjs';
import { analysisMarkdown } from './analysis_page.mjs';
import { fuzzOf } from './fuzz_section.mjs';

// npm run analysis: js/docs/analysis.md and its pictures, three-r115 against disney-2012 on the bundled drape.

const FOLDER = new URL('../../docs/analysis/', import.meta.url);
/** Pixels on a side of a picture in the page; plots that it shows. */
const TILE = 170;
const PLOTS = ['lobes-65', 'albedo'];
const BACKDROP = '#777777';

const [from, to] = ['three-r115', 'disney-2012'];
const plan = {
  names: { from, to },
  swaps: swapsBetween(from, to),
  targets: fabricTargets(FABRICS),
  lights: lightsOf(['studio', 'sun']),
  shot: { size: { width: 320, height: 320 }, quality: 'standard' },
};

/** A row for each light: first shading, second, FLIP, the strongest term alone. */
async function sheet(cells) {
  const rows = await Promise.all(
    cells.map(async (cell) => {
      const files = await picturesOf(cell);
      return [files.from, files.to, files.map, files[strongestIn(cell)[0]] ?? files.from];
    }),
  );
  const tiles = await Promise.all(
    rows.flatMap((row, y) =>
      row.map(async (file, x) => ({
        input: await sharp(file).flatten({ background: BACKDROP }).resize(TILE, TILE).toBuffer(),
        left: x * TILE,
        top: y * TILE,
      })),
    ),
  );
  const canvas = { width: TILE * rows[0].length, height: TILE * rows.length, channels: 3, background: BACKDROP };
  return sharp({ create: canvas }).composite(tiles).png({ palette: true, quality: 90, effort: 10, dither: 0.6 }).toBuffer();
}

const renderer = await api.createRenderer();
let steps = 0;
let shown = '';
/** A line for each view. */
function step(name) {
  steps += 1;
  if (name === shown) return;
  shown = name;
  console.log(`${steps} of ${analysisSteps(plan)}: ${name}`);
}
const analysis = await analyse(api, renderer, plan, { step });
const fuzz = await fuzzOf(api, renderer, plan.shot);
await renderer.close();

await rm(FOLDER, { recursive: true, force: true });
await mkdir(FOLDER, { recursive: true });
const write = async (name, data) => {
  await writeFile(new URL(name, FOLDER), data);
  console.log(`js/docs/analysis/${name}  ${data.length} bytes`);
};
for (const curves of analysis.curves) {
  const plots = plotsOf(curves, plan.names);
  for (const plot of PLOTS) await write(`${curves.target}-${plot}.svg`, plots[plot]);
  await write(`${curves.target}.png`, await sheet(analysis.cells.filter(({ target }) => target === curves.target)));
}
await writeFile(new URL('../../docs/analysis.md', import.meta.url), analysisMarkdown(analysis, FABRICS, fuzz));
console.log('js/docs/analysis.md');
