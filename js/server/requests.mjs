import { GATES } from '../compare/gates.mjs';
import { FAIL_ON } from '../api/options.mjs';
import { SHEET_FORMATS } from '../sheet/options.mjs';
import { SHARED, checkShared } from '../sheet/shared_shot.mjs';
import { SHOT } from '../shot/table/index.mjs';
import { boolean, but, choice, list, number, object, record, text } from '../shot/table/rows.mjs';
import { SHEET } from '../sheet/table/index.mjs';

/**
 * What each route reads of a request, beside its files: keys of a JSON body, fields of a form, or parameters of the address.
 * `late`: the worker checks it; `check`: but for this, which is seen at once.
 */

const late = (row, doc) => ({ ...but(row, { optional: true, default: undefined, doc }), late: true });

const failOn = choice('What leaves a model without a picture', FAIL_ON, { default: 'error' });
const model = text(
  'Reference of the model, where it is no file of the request: what the owner of the service resolves, or an address on an allowed host',
  'text',
  {
    max: 2048,
    optional: true,
  },
);
const shot = late(SHOT, 'What to draw');
const ambientVisibility = {
  ...boolean('Darken folds: what each vertex sees of its surroundings is found by rays', { default: false }),
};

const measure = {
  ...list('Lengths, as Model.measure() takes them', object('A length', {}), 'a list of what to measure', { max: 64, optional: true }),
  late: true,
};

/** Files of a form: name, what it is, and whether there may be several. */
const MODEL_FILES = {
  model: { doc: 'The model: .glb or .gltf' },
  environment: { doc: 'Equirectangular .hdr or .exr map that lights it, in place of `shot.environment`' },
  part: { doc: 'A file that the model names, by its file name', many: true },
};

/** @type {Record<string, {doc: string, keys: Record<string, import('../shot/table/rows.mjs').Row>, files: Record<string, {doc: string, many?: boolean}>}>} */
export const REQUESTS = Object.freeze({
  thumbnail: { doc: 'Draws one picture of a model', keys: { model, shot, failOn, ambientVisibility }, files: MODEL_FILES },
  inspect: {
    doc: 'Says what is in a model, and what a render of it would compile and run',
    keys: { model, shot, failOn, measure },
    files: MODEL_FILES,
  },
  sheet: {
    doc: 'Makes the tech sheet of a model',
    keys: {
      model,
      spec: late(SHEET, 'What the sheet says; without it, it is made from the model'),
      previous: late(SHEET, 'The spec of the last revision: what differs is marked'),
      shot: { ...late(SHOT, `Light, shading and quality of the pictures: ${SHARED.join(', ')}`), check: checkShared },
      name: text('Name of the style where the spec is made from the model', 'text', { max: 200, default: '' }),
      format: choice('One PDF, or one SVG or PNG a page; by default as `accept` says', SHEET_FORMATS, { optional: true }),
    },
    files: {
      model: MODEL_FILES.model,
      image: { doc: 'An image that the spec names, by its file name', many: true },
      font: { doc: 'A TrueType or OpenType font', many: true },
    },
  },
  compare: {
    doc: 'Says how far two pictures are apart, and whether that is within a gate',
    keys: {
      gate: choice('Figures that must not be passed', Object.keys(GATES), { default: 'standard' }),
      thresholds: record(
        'Limits in place of the gate\'s or beside them, as in {"object.flip.mean": 0.02}',
        number('A limit', { min: 0 }),
        'an object of numbers',
        { max: 64, default: {} },
      ),
      resize: boolean('Shrink the larger picture to the size of the smaller one', { default: false }),
    },
    files: { expected: { doc: 'PNG, JPEG or WebP' }, actual: { doc: 'The same' } },
  },
});
