import { pointerText } from '../shot/complain.mjs';

/** What differs between two specs. */

const isObject = (value) => typeof value === 'object' && value !== null;

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

function isSame(a, b) {
  if (!isObject(a) || !isObject(b)) return Object.is(a, b);
  const keys = new Set([...Object.keys(a), ...Object.keys(b)]);
  return [...keys].every((key) => isSame(a[key], b[key]));
}

/**
 * JSON pointers of what a spec has new or otherwise than the one before: items of lists, and keys of objects.
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
    const nameOf = (item) => (NAMES[list] ?? []).map((key) => item?.[key] ?? '').join('\u0000');
    const known = Array.isArray(before[list]) ? before[list] : [];
    value.forEach((item, i) => {
      const old = NAMES[list] ? known.find((each) => nameOf(each) === nameOf(item)) : known[i];
      if (!isSame(item, old)) changes.push(pointerText([list, i]));
    });
  }
  return changes;
}
