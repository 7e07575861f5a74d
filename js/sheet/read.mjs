import { TelarError } from '../error/index.mjs';
import { complaint, nearest, pathText, pointerText, shown, wrongValue } from '../shot/complain.mjs';
import { PLACES } from './lengths.mjs';
import { ratioOf } from './scale.mjs';
import { specSchema } from './schema.mjs';
import { specifiedIn } from './specified.mjs';
import { WHERE } from './table/views.mjs';

/** Reads a spec: its values by the table, then what the table cannot say of one value alone. */

/** What complaints are about. */
export const ABOUT = Object.freeze({ name: 'spec', code: 'E_SPEC' });

/** Most characters of a spec, all texts together: some 100 pages. */
export const TEXT_MAX = 300_000;

const wrong = (path, expected, value) => wrongValue(path, expected, value, ABOUT);

/** Characters of all texts; what is nested deeper than any spec is the schema's to refuse. */
function textLength(value, depth = 0) {
  if (typeof value === 'string') return value.length;
  if (typeof value !== 'object' || value === null || ArrayBuffer.isView(value) || depth > 12) return 0;
  return Object.values(value).reduce((sum, inner) => sum + textLength(inner, depth + 1), 0);
}

/** That names differ and are some. @param {string[]} names @param {(i: number) => (string | number)[]} pathOf */
function checkNames(names, pathOf) {
  const seen = new Set();
  names.forEach((name, i) => {
    if (name === '') throw wrong(pathOf(i), 'a name of at least one character', name);
    if (seen.has(name)) throw wrong(pathOf(i), 'a name that no other has', name);
    seen.add(name);
  });
}

/** Names of a list by which other parts of a spec, or its readers, tell the items apart. */
const checkUnique = (list, key, path) =>
  checkNames(
    list.map((item) => item[key]),
    (i) => [...path, i, key],
  );

/** That a name is one of a list's. @param {string[]} [told] those that a complaint names */
function checkName(path, name, known, what, told = known) {
  if (name === undefined || known.includes(name)) return;
  const near = nearest(name, told);
  const hint = near ? `did you mean ${shown(near)}?` : told.length > 0 ? `there are ${told.slice(0, 8).map(shown).join(', ')}` : 'there is none';
  throw new TelarError(ABOUT.code, `${pathText(path, ABOUT)}: there is no ${what} ${shown(name)}; ${hint}`, {
    pointer: pointerText(path),
  });
}

/** The one name of a value that zod leaves out. */
const LOST = '__proto__';

/** That no named value is lost. @param {object} given that the schema accepts */
function checkKeys({ words, anchors, measures = [], bill = [] }) {
  const records = [
    [['words'], words],
    [['anchors'], anchors],
    ...measures.map(({ values }, i) => [['measures', i, 'values'], values]),
    ...bill.map(({ colours }, i) => [['bill', i, 'colours'], colours]),
  ];
  for (const [path, record = {}] of records) if (Object.hasOwn(record, LOST)) throw wrong([...path, LOST], 'another name', record[LOST]);
}

/** A variant is one of the model's, or "": the file's own materials. */
const checkVariant = (path, { variant }, variants) => checkName([...path, 'variant'], variant, ['', ...variants], 'material variant', variants);

/** A place of the whole model is another once parts have moved: lengths, and points given in metres. */
function checkPlaces(spec) {
  const exploded = new Set(spec.views.filter(({ explode }) => explode > 0).map(({ name }) => name));
  const refuse = (list, isOfWhole) =>
    spec[list].forEach((item, i) => {
      if (exploded.has(item.view) && isOfWhole(item))
        throw wrong([list, i, 'view'], 'a view that is not exploded, or a node, a material or a picture', item.view);
    });
  refuse('callouts', ({ point }) => point);
  refuse('details', ({ point }) => point);
  spec.measures.forEach((measure, i) => {
    const isMeasured = PLACES.some((key) => measure[key] !== undefined);
    if (exploded.has(measure.view) && isMeasured) throw wrong(['measures', i, 'view'], 'a view that is not exploded', measure.view);
  });
}

function checkWhere(item, path) {
  const given = WHERE.filter((key) => item[key] !== undefined);
  if (given.length !== 1) throw wrong(path, `one of ${WHERE.join(', ')}`, Object.fromEntries(given.map((key) => [key, item[key]])));
  if (item.picture?.some((part) => part > 1)) throw wrong([...path, 'picture'], 'two numbers [x, y] in (0, 1]', item.picture);
}

function checkView(view, path, { variants }) {
  if (view.view !== undefined && (view.azimuth !== undefined || view.elevation !== undefined))
    throw wrong([...path, 'view'], 'a named view, or azimuth and elevation, not both', view.view);
  checkVariant(path, view, variants);
}

/** The smallest and the largest scale of a square of 10 cm: 1 cm and its own size fit into any paper. */
const SQUARE_RATIOS = [1, 10];

function checkSwatch({ material, node, variant, scale }, path, { variants }) {
  if ((material === undefined) === (node === undefined))
    throw wrong(path, 'one of material, node', Object.fromEntries(Object.entries({ material, node }).filter(([, value]) => value !== undefined)));
  checkVariant(path, { variant }, variants);
  const ratio = scale === 'fit' ? SQUARE_RATIOS[0] : ratioOf(scale);
  if (ratio < SQUARE_RATIOS[0] || ratio > SQUARE_RATIOS[1]) throw wrong([...path, 'scale'], 'a scale from "1:1" to "1:10"', scale);
}

function checkDetail({ shape, height }, path) {
  if (height !== undefined && shape === 'circle') throw wrong([...path, 'height'], 'none where `shape` is not "rectangle"', height);
}

function checkMeasure(measure, path, { header, anchors }) {
  const { sizes, baseSize } = header;
  measure.points?.forEach((point, k) => {
    if (typeof point === 'string') checkName([...path, 'points', k], point, Object.keys(anchors), 'anchor');
  });
  const given = PLACES.filter((key) => measure[key] !== undefined);
  if (given.length > 1) throw wrong(path, `at most one of ${PLACES.join(', ')}`, Object.fromEntries(given.map((key) => [key, measure[key]])));
  if (typeof measure.girth?.point === 'string') checkName([...path, 'girth', 'point'], measure.girth.point, Object.keys(anchors), 'anchor');
  if (measure.girth && !(Math.hypot(...measure.girth.normal) > 0))
    throw wrong([...path, 'girth', 'normal'], 'a direction, not [0, 0, 0]', measure.girth.normal);
  if (measure.points && measure.points.length < 2) throw wrong([...path, 'points'], 'a list of 2 to 64 points', measure.points);
  for (const size of Object.keys(measure.values)) checkName([...path, 'values', size], size, sizes, 'size in spec.header.sizes');
  if (measure.grade !== undefined && !(baseSize !== undefined && Object.hasOwn(measure.values, baseSize)))
    throw wrong([...path, 'grade'], 'a length in `values` for the size spec.header.baseSize, from which it grows', measure.grade);
  const negative = sizes.find((size) => specifiedIn(measure, size, header) < 0);
  if (negative !== undefined)
    throw wrong(
      [...path, 'grade'],
      `one that leaves a length of at least 0 in size ${shown(negative)}, not ${specifiedIn(measure, negative, header)}`,
      measure.grade,
    );
}

const DEFAULT_VIEWS = [
  { name: 'front', view: 'front', scale: 'fit', style: 'render', ghost: [], explode: 0 },
  { name: 'back', view: 'back', scale: 'fit', style: 'render', ghost: [], explode: 0 },
];

/** The variant that pictures show where nothing says another: that of the first colourway; "" where it has none: the file's own materials. */
const shownVariant = ({ colourways }) => colourways[0]?.variant ?? '';

/** A copy with the defaults that depend on other keys. */
function completed(spec) {
  const views = (spec.views?.length ? spec.views : DEFAULT_VIEWS).map((view, i) => ({
    ...view,
    ...(view.view === undefined && view.azimuth === undefined && view.elevation === undefined && { view: 'front' }),
    cover: view.cover ?? (spec.views?.some(({ cover }) => cover !== undefined) ? false : i < 2),
    variant: view.variant ?? shownVariant(spec),
  }));
  const first = views[0].name;
  const seen = (list) => list.map((item) => ({ ...item, view: item.view ?? first }));
  return {
    ...spec,
    printedUnits: spec.printedUnits ?? spec.units,
    views,
    callouts: seen(spec.callouts),
    details: seen(spec.details).map((detail) => ({ ...detail, style: detail.style ?? views.find(({ name }) => name === detail.view)?.style })),
    measures: seen(spec.measures),
    colourways: spec.colourways.map((colourway) => ({ ...colourway, variant: colourway.variant ?? '' })),
    swatches: spec.swatches.map((swatch) => ({ ...swatch, variant: swatch.variant ?? shownVariant(spec) })),
  };
}

/**
 * Checks a spec and writes out its defaults.
 * @param {object} given
 * @param {{variants?: string[]}} facts of the model
 * @returns {object} nothing of it is shared with `given`
 * @throws {TelarError} E_SPEC with the JSON pointer, what is expected and what was given
 */
export function readSpec(given, { variants = [] } = {}) {
  if (textLength(given) > TEXT_MAX)
    throw new TelarError(ABOUT.code, `spec: expected at most ${TEXT_MAX} characters of text in all, got ${textLength(given)}`, { pointer: '' });
  const result = specSchema.safeParse(given);
  if (!result.success) throw complaint(result.error.issues, given, specSchema, { about: ABOUT });
  checkKeys(given);
  const spec = completed(result.data);
  const names = spec.views.map(({ name }) => name);
  checkUnique(spec.views, 'name', ['views']);
  checkUnique(spec.measures, 'code', ['measures']);
  checkUnique(spec.colourways, 'name', ['colourways']);
  checkNames(spec.header.sizes, (i) => ['header', 'sizes', i]);
  checkNames(Object.keys(spec.anchors), () => ['anchors', '']);
  checkName(['header', 'baseSize'], spec.header.baseSize, spec.header.sizes, 'size in spec.header.sizes');
  result.data.views?.forEach((view, i) => checkView(view, ['views', i], { variants }));
  for (const list of ['callouts', 'details']) {
    spec[list].forEach((item, i) => {
      checkName([list, i, 'view'], item.view, names, 'view');
      checkWhere(item, [list, i]);
    });
  }
  spec.details.forEach((detail, i) => checkDetail(detail, ['details', i]));
  spec.measures.forEach((measure, i) => {
    checkName(['measures', i, 'view'], measure.view, names, 'view');
    checkMeasure(measure, ['measures', i], spec);
  });
  checkPlaces(spec);
  const colourways = spec.colourways.map(({ name }) => name);
  spec.colourways.forEach((colourway, i) => checkVariant(['colourways', i], colourway, variants));
  result.data.swatches.forEach((swatch, i) => checkSwatch(swatch, ['swatches', i], { variants }));
  spec.colourways.forEach(({ swatches }, i) =>
    swatches.forEach(({ color, material }, k) => {
      if (color !== undefined && material !== undefined) throw wrong(['colourways', i, 'swatches', k], 'one of color, material', { color, material });
    }),
  );
  spec.bill.forEach(({ colours }, i) => {
    for (const name of Object.keys(colours)) checkName(['bill', i, 'colours', name], name, colourways, 'colourway');
  });
  return spec;
}
