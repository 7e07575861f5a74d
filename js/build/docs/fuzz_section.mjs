import { analyse, fabricTargets, inWords, lightsOf, shortFigure, swapsBetween } from '../../analyse/index.mjs';
import { heading, row } from './tables.mjs';

/** The part of js/docs/analysis.md on one sheen term beside others: pictures of fuzzy cloth, and what the lobes conserve. */

const TERM = 'uncharted-4';
const BESIDE = ['charlie-estevez-kulla', 'zeltner'];
const FUZZY = ['towel', 'velvet', 'wool'];

const withSheen = (sheen) => ({ base: 'disney-2012', sheen });

/** White cloth under a white sheen: what the surface gives of light from everywhere. */
const WHITE = {
  pbrMetallicRoughness: { baseColorFactor: [1, 1, 1, 1], metallicFactor: 0, roughnessFactor: 1 },
  extensions: { KHR_materials_sheen: { sheenColorFactor: [1, 1, 1], sheenRoughnessFactor: 0.5 } },
};
const ANGLES = [0, 60, 85];

/** Two directions in one plane, degrees from the normal: a reciprocal lobe is the same with viewer and light swapped. */
const SWAPPED = [20, 70];

const radians = (degrees) => (degrees * Math.PI) / 180;
const towards = (degrees) => [Math.sin(radians(degrees)), 0, Math.cos(radians(degrees))];

async function lobesOf(api, sheen) {
  const shading = withSheen(sheen);
  const seen = (viewAngle, rest) => api.evaluateShading({ material: WHITE, shading, viewAngle: radians(viewAngle), ...rest });
  const lobe = async (view, light) => (await seen(view, { directions: [towards(-light)] })).radiance[0].sheen[0] / Math.cos(radians(light));
  const [near, far] = SWAPPED;
  const albedos = await Promise.all(ANGLES.map(async (angle) => (await seen(angle, { albedo: true })).albedo));
  return { sheen, albedos, swapped: [await lobe(near, far), await lobe(far, near)] };
}

/**
 * @param {object} api the package
 * @param {object} renderer of api.createRenderer
 * @param {object} shot keys that all pictures share
 */
export async function fuzzOf(api, renderer, shot) {
  const comparisons = [];
  for (const other of BESIDE) {
    const plan = {
      names: { from: other, to: TERM },
      swaps: swapsBetween(withSheen(other), withSheen(TERM)),
      targets: fabricTargets(FUZZY),
      lights: lightsOf(['studio', 'sun']),
      shot,
    };
    const { cells } = await analyse(api, renderer, plan);
    comparisons.push(...cells.map((cell) => ({ other, ...cell })));
  }
  return { comparisons, lobes: await Promise.all([...BESIDE, TERM].map((sheen) => lobesOf(api, sheen))) };
}

/**
 * @param {Awaited<ReturnType<typeof fuzzOf>>} found
 * @returns {string} Markdown
 */
export function fuzzMarkdown({ comparisons, lobes }) {
  const [near, far] = SWAPPED;
  const pictures = comparisons.map(({ other, target, light, all }) => [
    `\`${other}\``,
    `${target}, ${light}`,
    shortFigure(all.flip.mean),
    all.deltaE.mean.toFixed(2),
    all.deltaE.p95.toFixed(2),
    inWords(all),
  ]);
  const conserved = lobes.map(({ sheen, albedos, swapped }) => [
    `\`${sheen}\``,
    ...albedos.map(({ sheen: own }) => own[0].toFixed(3)),
    ...albedos.map(({ total }) => total[0].toFixed(3)),
    `${swapped[0].toFixed(4)}, ${swapped[1].toFixed(4)}`,
  ]);
  return `## The fuzz of Uncharted 4 beside Charlie and Zeltner

The sheen \`${TERM}\` in \`disney-2012\`, against two others in its place; also written by \`npm run analysis\`. The fuzz goes by the viewer's angle
alone: it is not darker where the light grazes along the fibres, and not brighter towards it.

${[...heading(['against', 'view', 'FLIP', 'CIEDE2000', 'p95', `\`${TERM}\` makes the cloth`]), ...pictures.map(row)].join('\n')}

What white cloth of roughness 1 with a white sheen of roughness 0.5 sends back of light from everywhere, seen at ${ANGLES.join(', ')} degrees: the sheen alone, and
all lobes, which Disney's layering sums as they are. Above 1 it gives more than it takes: none of the three takes from the cloth below in that
layering. Last, the sheen seen at ${near} degrees in light from ${far}, and the other way round: a reciprocal lobe has
one value.

${[...heading(['sheen', ...ANGLES.map((angle) => `sheen, ${angle}`), ...ANGLES.map((angle) => `all, ${angle}`), 'lobe, swapped']), ...conserved.map(row)].join('\n')}
`;
}
