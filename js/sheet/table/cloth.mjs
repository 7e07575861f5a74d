import { boolean, choice, colour, indexOrName, list, object, record, text } from '../../shot/table/rows.mjs';
import { CARE_SYMBOLS } from '../care.mjs';
import { SCALE, SCALE_TEXT } from './views.mjs';
import { MOST, cell, image, lengthIn, name, nameIfAny, paragraph } from './basics.mjs';

/** Rows of what the garment is made of and how: colourways, bill of materials, construction, labels, care, artwork, revisions. */

const rows = (doc, of, what, max = MOST.notes) => list(doc, of, `a list of at most ${max} ${what}`, { max, default: [] });

const MATERIAL = 'the index or the name of a material in the model';

const swatch = object('A colour of a colourway', {
  part: nameIfAny('Where it is: "body", "rib"'),
  name: nameIfAny('Name of the colour'),
  code: nameIfAny('Its code in a colour system'),
  color: colour('The colour: CSS (sRGB) or linear [r, g, b]', { optional: true }),
  material: indexOrName('Instead of `color`: index or name of a material, whose mean albedo is meant', MATERIAL, { optional: true }),
});

const colourway = object('One colouring of the garment', {
  name: name('Its name; unique'),
  code: nameIfAny('Its code'),
  variant: nameIfAny('Material variant of the model that shows it; default "": the materials that the file has without one'),
  swatches: rows('Its colours', swatch, 'colours', MOST.symbols),
});
export const colourways = rows('Colourings of the garment', colourway, 'colourways', MOST.colourways);

const square = object('A square of a material, 10 cm wide, flat and draped, with its colour', {
  title: name('What is printed beneath it'),
  material: indexOrName('Index or name of the material', MATERIAL, { optional: true }),
  node: indexOrName('Instead: index or name of a node, of which the material that covers most of it is meant', 'the index or the name of a node in the model', {
    optional: true,
  }),
  variant: nameIfAny('Name of a material variant of the model, or "": the materials that the file has without one; default that of the first colourway'),
  scale: text('Scale on paper, at least 1:10', SCALE, { pattern: SCALE_TEXT, default: '1:2' }),
  draped: boolean('Whether it is shown draped too', { default: true }),
  text: paragraph('What else there is to say'),
});
export const swatches = rows('Materials as they look', square, 'squares', MOST.symbols);

export const colourList = object(
  'A list of colours: the nearest of them are named beside each swatch, with the distance CIEDE2000',
  {
    file: name('Name of a CSV file beside the spec: name, L, a, b'),
    light: choice('Light that its Lab values are of', ['D50', 'D65'], { default: 'D50' }),
  },
  { optional: true },
);

const material = object('A line of the bill of materials', {
  reference: nameIfAny('Reference number'),
  item: cell('What it is', { optional: false }),
  supplier: cell('Who makes or sells it'),
  composition: cell('What it is made of, percentages by mass'),
  weight: nameIfAny('Mass per area, or size, with its unit'),
  quantity: nameIfAny('How much a garment takes, with its unit'),
  placement: cell('Where on the garment it is'),
  colours: record('Its colour by the name of the colourway', name('Name of a colour'), `colours by colourway, at most ${MOST.colourways}`, {
    max: MOST.colourways,
    default: {},
  }),
  color: colour('What its swatch shows', { optional: true }),
  image: image('What its swatch shows'),
});
export const bill = rows('Bill of materials', material, 'lines', MOST.bill);

const operation = object('How a part is sewn', {
  part: cell('Seam or part', { optional: false }),
  stitch: nameIfAny('Stitch class'),
  seam: nameIfAny('Seam class'),
  density: nameIfAny('Stitches per length, with its unit'),
  allowance: nameIfAny('Seam allowance, with its unit'),
  thread: nameIfAny('Thread'),
  text: cell('What else there is to say'),
});
export const construction = rows('How the garment is sewn', operation, 'operations');

const label = object('A label, hangtag or packaging', {
  name: name('What it is'),
  text: paragraph('What it says'),
  placement: cell('Where it goes'),
  size: nameIfAny('Its size, with its unit'),
  image: image('What it looks like'),
});
export const labels = rows('Labels, hangtags and packaging', label, 'labels', MOST.symbols);

export const care = object(
  'Care of the garment, in symbols of ISO 3758 and in words',
  {
    symbols: list(
      'Symbols, in their order: washing, bleaching, drying, ironing, professional care',
      choice('A symbol', Object.keys(CARE_SYMBOLS)),
      `a list of at most ${MOST.symbols} symbols`,
      {
        max: MOST.symbols,
        default: [],
      },
    ),
    text: paragraph('The care in words'),
  },
  { default: {} },
);

const print = object('A print, embroidery or badge', {
  name: name('What it is'),
  image: image('The artwork itself; it is shown at 1:1 where `width` is given'),
  width: lengthIn('Width on the garment', { above: 0 }),
  height: lengthIn('Height on the garment; default by the proportions of the image', { above: 0 }),
  position: cell('Where it is on the garment, with distances'),
  technique: nameIfAny('How it is made'),
  colours: cell('Its colours'),
  text: paragraph('What else there is to say'),
});
export const artwork = rows('Artwork', print, 'prints', MOST.symbols);

const revision = object('A revision of this sheet', {
  revision: name('Its name or number'),
  date: nameIfAny('Its date, as it is to be printed'),
  author: nameIfAny('Who made it'),
  text: cell('What changed', { optional: false }),
});
export const revisions = rows('Revisions, oldest first', revision, 'revisions');
