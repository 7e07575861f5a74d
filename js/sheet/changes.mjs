import { pointerText } from '../shot/complain.mjs';
import { specifiedIn } from './specified.mjs';
import { MOST } from './table/basics.mjs';
import { UNITS } from './table/index.mjs';
import { byRest, byTable, isObject, own } from './written_out.mjs';

/** What differs between two specs. They are as callers wrote them, and may be anything. */

/** What items of lists are told apart by, so that one that moves is not a change. */
const NAMES = {
  measures: ['code'],
  views: ['name'],
  colourways: ['name'],
  bill: ['reference', 'item'],
  construction: ['part'],
  labels: ['name'],
  artwork: ['name'],
  details: ['title'],
  callouts: ['text'],
};

/** A length as millimetres; what is no number stays. */
function millimetres(length, { units = 'cm' }) {
  const unit = own(UNITS, units);
  return typeof length === 'number' && unit ? Number((length * unit).toFixed(6)) : length;
}

/** The specified lengths of a point of measure by size. */
function lengthsOf({ values, grade }, spec) {
  const sizes = own(spec.header, 'sizes');
  // The last revision is compared as it was given: a spec has no more sizes.
  const header = { sizes: Array.isArray(sizes) ? sizes.slice(0, MOST.sizes) : [], baseSize: own(spec.header, 'baseSize') };
  const given = isObject(values) ? values : {};
  const isGraded = typeof grade === 'number' && typeof own(given, header.baseSize) === 'number' && header.sizes.includes(header.baseSize);
  const named = isGraded ? [...Object.keys(given), ...header.sizes] : Object.keys(given);
  return Object.fromEntries(named.map((size) => [size, millimetres(specifiedIn({ values: given, grade }, size, header), spec)]));
}

/** A point of measure by what it comes to: lengths in millimetres, and places for the names of anchors. */
function measureOf(measure, spec) {
  const place = (point) => (typeof point === 'string' ? (own(spec.anchors, point) ?? point) : point);
  const { points, girth, tolerance, values, grade, ...rest } = measure;
  return {
    ...rest,
    points: Array.isArray(points) ? points.map(place) : points,
    girth: isObject(girth) ? { ...girth, point: place(girth.point) } : girth,
    tolerance: millimetres(tolerance, spec),
    lengths: lengthsOf({ values, grade }, spec),
  };
}

const printOf = (print, spec) => ({ ...print, width: millimetres(print.width, spec), height: millimetres(print.height, spec) });

/** What items are compared by, where that depends on the rest of a spec. */
const RESOLVED = { measures: measureOf, artwork: printOf };

function isSame(a, b) {
  if (!isObject(a) || !isObject(b)) return Object.is(a, b);
  const keys = new Set([...Object.keys(a), ...Object.keys(b)]);
  return [...keys].every((key) => isSame(a[key], b[key]));
}

/** The item of the last revision that each item is compared with: the n-th of a name with the n-th. */
function matched(list, items, before) {
  if (!NAMES[list]) return items.map((_, i) => before[i]);
  const nameOf = (item) => NAMES[list].map((key) => own(item, key) ?? '').join('\u0000');
  const known = new Map();
  for (const item of [...before].reverse()) {
    const name = nameOf(item);
    if (known.has(name)) known.get(name).push(item);
    else known.set(name, [item]);
  }
  return items.map((item) => known.get(nameOf(item))?.pop());
}

/**
 * JSON pointers of what a spec has new or otherwise than the one before: items of lists by what they come to, and keys of objects.
 * @param {object} before as a caller wrote it
 * @param {object} after
 * @returns {string[]} of `after`; what is gone has none
 */
export function changesBetween(before, after) {
  const changes = [];
  for (const [list, value] of Object.entries(after)) {
    if (!Array.isArray(value)) {
      if (isObject(value)) for (const key of Object.keys(value)) if (!isSame(value[key], before[list]?.[key])) changes.push(pointerText([list, key]));
      if (!isObject(value) && !isSame(value, before[list])) changes.push(pointerText([list]));
      continue;
    }
    const resolved = (item, spec) => (isObject(item) ? (own(RESOLVED, list)?.(item, spec) ?? item) : item);
    const old = matched(list, value, Array.isArray(before[list]) ? before[list] : []);
    // What is as it was written stays, though the rest gives it another default, such as another first view.
    const isKept = (item, last) =>
      [byTable, byRest].some((whole) => isSame(resolved(whole(list, item, after), after), resolved(whole(list, last, before), before)));
    value.forEach((item, i) => {
      if (!isKept(item, old[i])) changes.push(pointerText([list, i]));
    });
  }
  return changes;
}
