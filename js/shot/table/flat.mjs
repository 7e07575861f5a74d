import { garmentPart } from './parts.mjs';
import { choice, list, number, object } from './rows.mjs';

/** Rows of `style` and `flat`: the technical flat. */

export const style = choice(
  '"shaded", or "flat": the technical flat of the same camera, black lines on the background, which is white where none is given',
  ['shaded', 'flat'],
  { name: 'Style', default: 'shaded' },
);

const weight = (kind, millimetres) =>
  number(`${kind}; 0 = not drawn`, { what: 'a number of millimetres', unit: 'millimetres', min: 0, max: 10, default: millimetres });

/** Line weights after ISO 128-2:2020: 0.7, 0.5, 0.35, 0.25 are neighbours in its series. The heaviest stand first. */
const weights = object(
  'Line weights in millimetres of the picture, at `output.ppi`, or 96 pixels an inch where that is 0',
  {
    silhouette: weight('Border between the model and what is behind it', 0.7),
    contour: weight('Where a surface turns away before another', 0.5),
    seam: weight('Where parts or materials meet, and open edges', 0.35),
    stitch: weight('Seams of parts that are stitched, dashed', 0.25),
    crease: weight('Sharp edges', 0.25),
  },
  { name: 'Weights', default: {} },
);

const STITCHED_MAX = 64;

export const stitched = list('Parts whose seams are stitches, which are dashed', garmentPart('A part'), `a list of at most ${STITCHED_MAX} parts`, {
  max: STITCHED_MAX,
  default: [],
});

export const flat = object(
  'How the lines of `style: "flat"` and of the layer "line" are found',
  {
    join: number('Points of the mesh that are nearer to one another are one; 0 = of rounding alone', { unit: 'metres', min: 0, max: 1, default: 0 }),
    creaseAngle: number('Least angle between two faces that is drawn as a crease', { unit: 'degrees', min: 1, max: 180, default: 60 }),
    foldDepth: number('A surface that lies less before another is a fold that is not drawn', { unit: 'metres', min: 0, max: 1e3, default: 0.008 }),
    foldLength: number('Contours and creases within one part that are shorter are not drawn, as a part of the height of the picture', {
      unit: 'part of the height',
      min: 0,
      max: 1,
      default: 0.02,
    }),
    tolerance: number('Pixels that a simplified line may leave the exact one', { unit: 'pixels', min: 0, max: 10, default: 0.3 }),
    stitched,
    weights,
  },
  { name: 'Flat', default: {} },
);

/** Dash of stitches and the gap after it, in line weights. */
export const DASH = Object.freeze([5, 3.5]);
