import { garmentPart } from '../../shot/table/parts.mjs';
import { boolean, choice, list, literal, number, object, record, vector } from '../../shot/table/rows.mjs';
import { MOST, cell, lengthIn, name, nameIfAny, place } from './basics.mjs';
import { anchor } from './views.mjs';

/** Rows of `anchors` and `measures`: the points of measure. */

export const anchors = record(
  'Named places in the model, metres: "hps", "cf-hem", ...',
  place('A place in the model, metres'),
  `an object of at most ${MOST.named} named points`,
  {
    max: MOST.named,
    default: {},
  },
);

const POINTS = 'a list of 2 to 64 points';

const part = garmentPart('The part of the garment on which it is measured; default all of it', { optional: true });

const girth = object(
  'Instead of `points`: around the part, in a plane',
  {
    point: anchor,
    normal: vector('Direction that the plane is across', { expected: 'three numbers [x, y, z]', default: [0, 1, 0] }),
    tight: boolean('Drawn tight over the surface, as a tape that slides to where the part is narrower; without it the way around in the plane', {
      default: false,
    }),
  },
  { optional: true },
);

const measure = object('A point of measure', {
  code: name('Its code, as in "A" or "10.1"; unique'),
  description: cell('What is measured', { optional: false }),
  how: cell('How to measure it'),
  view: nameIfAny('Name of the view that shows it; default the first'),
  points: list('From where to where, over the points between; none = it is not measured on the model', anchor, POINTS, { max: 64, optional: true }),
  girth,
  border: literal('Instead of `points`: the open edges of the part', true, 'true', { optional: true }),
  part,
  along: choice('"straight": from point to point; "surface": along the cloth', ['straight', 'surface'], { default: 'straight' }),
  closed: boolean('Whether the last point is joined to the first', { default: false }),
  join: number('Corners nearer than this are one: it closes gaps between parts', { what: 'a length in metres', unit: 'metres', min: 0, max: 1, default: 0 }),
  times: number('How often the length counts: 2 for a circumference measured flat', { what: 'a factor', unit: 'factor', above: 0, max: 100, default: 1 }),
  tolerance: lengthIn('How far a garment may be off', { min: 0 }),
  values: record('The specified length by size', lengthIn('A length', { optional: false, min: 0 }), `lengths by size, at most ${MOST.sizes}`, {
    max: MOST.sizes,
    default: {},
  }),
  grade: lengthIn('Instead of lengths for each size: what it grows by from one size to the next'),
});

export const measures = list('Points of measure', measure, `a list of at most ${MOST.measures} points of measure`, { max: MOST.measures, default: [] });
