import { stitched } from '../../shot/table/flat.mjs';
import { number, object } from '../../shot/table/rows.mjs';

/** Rows of `flats`: what the technical flats of a sheet draw. */

export const flats = object(
  'What technical flats draw: the options of the same names of Model.flat',
  {
    stitched,
    join: number('Corners nearer than this are one', { what: 'a length in metres', unit: 'metres', min: 0, max: 1, default: 0 }),
    creaseAngle: number('Where two triangles bend more, there is a crease', { what: 'a number of degrees', unit: 'degrees', min: 1, max: 180, default: 60 }),
    foldDepth: number('A surface that lies less before another is a fold that is not drawn', {
      what: 'a length in metres',
      unit: 'metres',
      min: 0,
      max: 1000,
      default: 0.008,
    }),
    foldLength: number('Contours and creases within one part that are shorter are not drawn', {
      what: 'a length in metres',
      unit: 'metres',
      min: 0,
      max: 100,
      default: 0.015,
    }),
  },
  { default: {} },
);
