import { INCH } from '../../shot/true_scale.mjs';
import { choice, number, object, record, text } from '../../shot/table/rows.mjs';
import { MOST, cell, paragraph } from './basics.mjs';
import { artwork, bill, care, colourList, colourways, construction, labels, revisions, swatches } from './cloth.mjs';
import { flats } from './flats.mjs';
import { header } from './header.mjs';
import { anchors, measures } from './measures.mjs';
import { callouts, details, views } from './views.mjs';

/**
 * The spec of a tech sheet: the one declaration of its keys. What checks a spec, its JSON Schema, its TypeScript types and its page of
 * docs are made of it.
 */

/** Papers, millimetres, upright. */
export const PAPERS = Object.freeze({ A4: [210, 297], A3: [297, 420], Letter: [215.9, 279.4] });

/** Lengths of one unit, millimetres. */
export const UNITS = Object.freeze({ cm: 10, mm: 1, inch: INCH });

const LANGUAGE = 'a language tag such as "en", "es" or "pt-BR"';

/** @type {import('../../shot/table/rows.mjs').Row} */
export const SHEET = object('What a tech sheet says', {
  language: text('Language of its headings; en and es are known, others by `words`', LANGUAGE, { pattern: /^[a-z]{2,3}(?:-[A-Z]{2})?$/u, default: 'en' }),
  words: record(
    'Headings in place of those of the language, by the keys of js/sheet/strings/en.json; "" leaves it as it is',
    cell('A heading', { optional: false }),
    `at most ${MOST.named} headings`,
    {
      max: MOST.named,
      default: {},
    },
  ),
  units: choice('Unit of the lengths in this spec, but for points and `size`, which are metres', Object.keys(UNITS), { default: 'cm' }),
  printedUnits: choice('Unit that the sheet prints, inches as fractions; default `units`', Object.keys(UNITS), { optional: true }),
  paper: object(
    'Paper',
    {
      size: choice('Format', Object.keys(PAPERS), { default: 'A4' }),
      orientation: choice('How it lies', ['landscape', 'portrait'], { default: 'landscape' }),
    },
    { expected: '{size, orientation}', default: {} },
  ),
  ppi: number('Resolution of the pictures', { what: 'a number', unit: 'pixels per inch of paper', min: 36, max: 600, default: 200 }),
  template: text('Name of the template', 'a name of letters, digits, - and _', { pattern: /^[\w-]{1,64}$/u, default: 'telar' }),
  header,
  views,
  flats,
  anchors,
  callouts,
  details,
  measures,
  colourways,
  swatches,
  colourList,
  bill,
  construction,
  labels,
  care,
  artwork,
  notes: paragraph('Comments on the last page'),
  revisions,
});
