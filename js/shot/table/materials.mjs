import { CLOTHS } from './cloths.mjs';
import { degrees } from './camera.mjs';
import { choice, colour, extents, number, object, record, union } from './rows.mjs';

/** Most selectors of a shot. */
const MOST = 256;

const METRES_PER_UV = 'metres in [0.000001, 1000000], [metres along u, metres along v], or null';
const RANGE = { min: 1e-6, max: 1e6, expected: METRES_PER_UV };

export const material = object('What a part is shown in', {
  preset: choice('Cloth of js/docs/fabric.md with its maps; null = its own material in another colour', CLOTHS, {
    expected: 'the name of a cloth in js/docs/cloths.md, as "denim", or null',
    nullable: true,
    default: null,
  }),
  color: colour("Its colour; null = the part's own, with its picture where the cloth has none", { nullable: true, default: null }),
  scale: number('Size of its pattern, 1 = true to the metres of the model', { unit: 'factor', min: 1e-3, max: 1e3, default: 1 }),
  metresPerUv: union(
    "Metres that one unit of the part's texture coordinates covers, or of u and of v [u, v], where the model is not in metres or its coordinates " +
      'are not evenly laid out; null = measured on the part',
    [number('Metres', { unit: 'metres', ...RANGE }), extents('', RANGE)],
    METRES_PER_UV,
    { nullable: true, default: null },
  ),
  rotation: degrees('Turns the grain line, which runs along v of the texture coordinates, counter-clockwise', -360, 360, { default: 0 }),
});

export const materials = record(
  'Parts in another cloth: by the name of a material or of a node with all beneath it, `*` standing for any characters; digits alone are ' +
    'the index of a material. A later one holds before an earlier one, an index before names, a node before a material',
  material,
  `cloths by the name of a part, at most ${MOST}`,
  { max: MOST, default: {}, drawn: false },
);
