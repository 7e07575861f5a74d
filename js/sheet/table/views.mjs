import { VIEWS } from '../../shot/frame.mjs';
import { ghost } from '../../shot/table/parts.mjs';
import { boolean, choice, extents, indexOrName, list, number, object, text, union } from '../../shot/table/rows.mjs';
import { MOST, name, nameIfAny, paragraph, place } from './basics.mjs';

/** Rows of `views`, `callouts` and `details`: pictures of the garment, and what points at them. */

const degrees = (doc, min, max) => number(doc, { what: 'a number of degrees', unit: 'degrees', min, max, optional: true });
export const SCALE = '"fit" or a scale such as "1:5"';

/** Scales that a drawing may have: "1:5", "2:1", "1:2.5". */
export const SCALE_TEXT = /^(?:fit|0*[1-9]\d{0,3}(?:\.\d{1,3})?:0*[1-9]\d{0,3}(?:\.\d{1,3})?)$/u;

/** How a picture is drawn. */
const STYLES = ['render', 'flat'];

const view = object('A picture of the garment in true scale', {
  name: name('What other parts of the spec call it'),
  title: nameIfAny('What is printed beneath it'),
  view: choice('Named view; the front faces +Z, "right" is seen from +X', Object.keys(VIEWS), { optional: true }),
  azimuth: degrees('Instead of `view`: degrees about +Y, 0 = from +Z, 90 = from +X', -360, 360),
  elevation: degrees('Instead of `view`: degrees above the horizon', -90, 90),
  variant: nameIfAny('Name of a material variant of the model, or "": the materials that the file has without one; default that of the first colourway'),
  scale: text('Scale on paper; "fit": the largest usual one that fits', SCALE, { pattern: SCALE_TEXT, default: 'fit' }),
  style: choice('"render": as it looks; "flat": the technical flat, lines alone, as vectors', STYLES, { default: 'render' }),
  ghost,
  explode: number('Parts (nodes) are moved apart so far, along their mean normals', {
    what: 'a length in metres',
    unit: 'metres',
    min: 0,
    max: 10,
    default: 0,
  }),
  cover: boolean('Whether it is on the first page; default: the first two views', { optional: true }),
});

export const views = list('Pictures of the garment; default front and back', view, `a list of at most ${MOST.views} views`, {
  max: MOST.views,
  optional: true,
});

/** Keys that say where something is, of which one is given. */
export const WHERE = ['point', 'node', 'material', 'picture'];

const where = {
  point: place('A place in the model, metres', { optional: true }),
  node: indexOrName('Instead: index or name of a node, whose visible middle is meant', 'the index or the name of a node in the model', { optional: true }),
  material: indexOrName('Instead: index or name of a material', 'the index or the name of a material in the model', { optional: true }),
  picture: extents('Instead: a place in the picture of the view, parts of its width and height from the top left corner', {
    expected: 'two numbers [x, y] in (0, 1]',
    optional: true,
  }),
};

const callout = object('A text with a line to a place in a view', {
  view: nameIfAny('Name of the view; default the first'),
  ...where,
  text: paragraph('What it says', { optional: false }),
  side: choice('Side of the picture on which it stands; default where it fits best', ['left', 'right'], { optional: true }),
});
export const callouts = list('Texts with lines to places in a view', callout, `a list of at most ${MOST.callouts} call-outs`, {
  max: MOST.callouts,
  default: [],
});

const METRES = { what: 'a length in metres', unit: 'metres', min: 1e-4, max: 100 };

const detail = object('A part of a view, drawn anew at a larger scale', {
  title: name('What is printed beneath it'),
  view: nameIfAny('Name of the view; default the first'),
  ...where,
  size: number('Diameter or width of what is shown, metres of the garment', { ...METRES, default: 0.08 }),
  height: number('Height of a rectangle, metres of the garment; default `size`', { ...METRES, optional: true }),
  shape: choice('Shape of the crop', ['circle', 'rectangle'], { default: 'circle' }),
  scale: text('Scale on paper', SCALE, { pattern: SCALE_TEXT, default: 'fit' }),
  style: choice('How it is drawn; default as its view', STYLES, { optional: true }),
  text: paragraph('What it says'),
});
export const details = list('Enlarged parts of views', detail, `a list of at most ${MOST.details} details`, { max: MOST.details, default: [] });

const ANCHOR = 'a point [x, y, z] in metres or the name of one of `anchors`';
/** A point of the model, or the name of one. */
export const anchor = union('A place in the model', [place('', { expected: ANCHOR }), name('Name of one of `anchors`', { expected: ANCHOR })], ANCHOR);
