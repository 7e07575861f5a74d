import { BASES, SLOTS, WITHOUT_TERMS } from '../shading_terms.mjs';
import { REVISION, REVISION_MIN, THREE_SLOTS } from '../three_terms.mjs';
import { camera } from './camera.mjs';
import { flat, style } from './flat.mjs';
import { layers } from './layers.mjs';
import { lights } from './lights.mjs';
import { look } from './looks.mjs';
import { materials } from './materials.mjs';
import { output } from './output.mjs';
import { ghost } from './parts.mjs';
import { quality } from './quality.mjs';
import { boolean, but, choice, literal, number, object, text, union } from './rows.mjs';
import { POSE, background, environment, ground, lens, metering } from './stage.mjs';
import { TONE_MAPPINGS } from './tone_mappings.mjs';

/**
 * The shot: the one declaration of its keys. What checks a shot and a resolved shot, the JSON Schema, the TypeScript types, the page of
 * options, and the C++ that reads a resolved shot are made of it. Values that depend on other keys or on the model are written by
 * js/shot/resolve.mjs.
 */

const pixels = number('Pixels', { what: 'a whole number of pixels', unit: 'pixels', min: 1, max: 8192, integer: true, default: 512 });

const SHADING = `${[...WITHOUT_TERMS, ...BASES].map((name) => `"${name}"`).join(', ')}, {base, <slot>: <term>} or {base: "three", revision}`;
const slotRows = (slots, page) =>
  Object.fromEntries(Object.entries(slots).map(([slot, terms]) => [slot, choice(`Term of the slot: js/docs/${page}.md`, terms, { optional: true })]));
const base = choice('Shading that the other slots are taken from', BASES);
const swapped = object('A principled shading with terms swapped', { base, ...slotRows(SLOTS, 'shading') });
const threeTerms = Object.fromEntries(Object.entries(THREE_SLOTS).map(([slot, terms]) => [slot, Object.keys(terms)]));
const release = object('What a release of stock three.js shows', {
  base: literal('Stock three.js', 'three', '"three"'),
  revision: number(`The release: N of 0.N. Known are ${REVISION_MIN} to ${REVISION}; others are drawn as the nearest of these, with a warning`, {
    what: 'a whole number',
    unit: 'release',
    min: 1,
    max: 9999,
    integer: true,
    otherwise: REVISION,
  }),
  ...slotRows(threeTerms, 'families'),
});
const shading = union(
  '"three": what stock three.js shows, of another release than 0.187 by {base: "three", revision}; "fabric": telar\'s model of cloth; ' +
    '"three-r115": what three.js showed in 2020; "disney-2012": Burley\'s principled model; or terms of these by name',
  [choice('', [...WITHOUT_TERMS, ...BASES], { expected: SHADING }), swapped, release],
  SHADING,
  {
    default: 'three',
    resolved: union('', [choice('', WITHOUT_TERMS), swapped, release], SHADING),
  },
);

const SCALE = text(
  'True scale: "1:5" is a fifth of the model\'s size on paper, at `output.ppi`, "none" no scale. The camera is orthographic then, and where no `size` is ' +
    'given, the picture is as large as the model needs',
  '"none", or a scale as in "1:5", numbers from 0.001 to 10000',
  { pattern: /^(?:none|\d{1,5}(?:\.\d{1,3})?:\d{1,5}(?:\.\d{1,3})?)$/, default: 'none' },
);

/** @type {import('./rows.mjs').Row} */
export const SHOT = object(
  'What to draw',
  {
    look,
    size: object('Size of the image', { width: pixels, height: pixels }, { name: 'Size', default: {} }),
    camera,
    lens,
    environment,
    lights,
    modelLights: boolean('Use the lights in the model', { default: true }),
    background,
    ground,
    shading,
    toneMapping: choice('As in three.js', Object.keys(TONE_MAPPINGS), { name: 'ToneMapping', isShared: true, default: 'neutral' }),
    exposure: number('Factor on radiance before tone mapping', { unit: 'factor', min: 0, default: 1 }),
    metering,
    quality,
    variant: text('Name of a material variant of the model (KHR_materials_variants); "" = none', 'the name of a variant', { default: '' }),
    materials,
    pose: POSE,
    ghost,
    layers,
    style,
    flat,
    scale: but(SCALE, { drawn: false }),
    output,
  },
  { name: 'Values' },
);
