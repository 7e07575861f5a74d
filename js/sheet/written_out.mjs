import { MOST } from './table/basics.mjs';
import { SHEET } from './table/index.mjs';

/** Items of a spec with the values that they have where keys are left out: by the table, and by the rest of the spec. Specs may be anything. */

export const isObject = (value) => typeof value === 'object' && value !== null;
export const own = (object, key) => (isObject(object) && Object.hasOwn(object, key) ? object[key] : undefined);

/** A copy with the defaults of the table; what is of another kind than its row stays. */
function filled(row, value) {
  if (row.kind === 'list' && Array.isArray(value)) return value.map((inner) => filled(row.of, inner));
  if (row.kind !== 'object' || !isObject(value) || Array.isArray(value)) return value;
  const keys = Object.entries(row.shape).map(([key, inner]) => [key, filled(inner, own(value, key) ?? inner.default)]);
  return { ...value, ...Object.fromEntries(keys.filter(([, inner]) => inner !== undefined)) };
}

const firstOf = (spec, list) => own(own(spec, list), 0);

/** The variant that the first colourway shows. */
const shownVariant = (spec) => own(firstOf(spec, 'colourways'), 'variant') ?? '';

/** What stands in the first view where no other is named. */
const inView = (item, spec) => ({ view: own(firstOf(spec, 'views'), 'name') ?? 'front', ...item });

function detailOf(item, spec) {
  const detail = inView(item, spec);
  const views = own(spec, 'views');
  const view = Array.isArray(views) ? views.slice(0, MOST.views).find((each) => own(each, 'name') === detail.view) : undefined;
  return { style: own(view, 'style') ?? 'render', ...(detail.shape === 'rectangle' && { height: detail.size }), ...detail };
}

const isTurned = ({ azimuth, elevation }) => azimuth !== undefined || elevation !== undefined;

/** Defaults that depend on other keys: those of js/sheet/read.mjs. */
const BY_THE_REST = {
  callouts: inView,
  details: detailOf,
  measures: inView,
  colourways: (item) => ({ variant: '', ...item }),
  swatches: (item, spec) => ({ variant: shownVariant(spec), ...item }),
  views: (item, spec) => ({ variant: shownVariant(spec), ...(!isTurned(item) && { view: 'front' }), ...item }),
};

/**
 * An item with the defaults of the table.
 * @param {string} list key of a spec
 * @param {unknown} item of it
 */
export function byTable(list, item) {
  const row = own(SHEET.shape, list);
  if (row?.kind !== 'list' || !isObject(item)) return item;
  return filled(row.of, Object.fromEntries(Object.entries(item).filter(([, value]) => value !== undefined)));
}

/** The same with those that depend on the rest of the spec too. @param {object} spec */
export function byRest(list, item, spec) {
  const whole = byTable(list, item);
  return isObject(item) ? (own(BY_THE_REST, list)?.(whole, spec) ?? whole) : item;
}
