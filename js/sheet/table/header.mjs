import { list, object } from '../../shot/table/rows.mjs';
import { MOST, image, name, nameIfAny, paragraph } from './basics.mjs';

/** Rows of `header`: what stands on every page, and on the first in full. */

const SIZES = `a list of at most ${MOST.sizes} names of sizes`;

export const header = object(
  'What the sheet is about; it stands at the head of every page',
  {
    style: nameIfAny('Style number'),
    name: nameIfAny('Name of the style'),
    season: nameIfAny('Season'),
    brand: nameIfAny('Brand'),
    category: nameIfAny('Category'),
    fabric: nameIfAny('Main fabric'),
    sizes: list('Sizes, smallest first', name('A size'), SIZES, { max: MOST.sizes, default: [] }),
    baseSize: nameIfAny('The size that is drawn and measured; one of `sizes`'),
    date: nameIfAny('Date, as it is to be printed'),
    revision: nameIfAny('Revision'),
    author: nameIfAny('Author'),
    logo: image('Logo'),
    description: paragraph('What the garment is, in a few sentences'),
  },
  { default: {} },
);
