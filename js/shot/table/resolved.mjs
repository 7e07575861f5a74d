/** What a row of the table is in a resolved shot. */

/**
 * @param {import('./rows.mjs').Row} row
 * @returns {import('./rows.mjs').Row} Required and without a default, as its value is written out; what is there by another key (`when`) is optional.
 */
export function resolvedRow(row) {
  const { resolved = row, nullable, when, stays } = row;
  return { ...resolved, default: undefined, nullable, optional: stays || when !== undefined };
}

/**
 * The object that a key is in a resolved shot, in the order of the table: each value as given, else the one that the table knows.
 * @param {import('./rows.mjs').Row} row of an object
 * @param {object} values
 */
export function inOrder({ shape }, values) {
  const entries = Object.entries(shape).map(([key, row]) => [key, values[key] === undefined ? (row.otherwise ?? row.default) : values[key]]);
  return Object.fromEntries(entries.filter(([, value]) => value !== undefined));
}

/** The values that the resolver writes for the keys of an object which a caller leaves out. */
export const otherwiseOf = ({ shape }) =>
  Object.fromEntries(
    Object.entries(shape)
      .filter(([, row]) => row.otherwise !== undefined)
      .map(([key, row]) => [key, row.otherwise]),
  );

/** A value that shares nothing with another: zod hands out the arrays of the schema itself. Bytes stay the caller's. */
export function copied(value) {
  if (typeof value !== 'object' || value === null || ArrayBuffer.isView(value)) return value;
  return Array.isArray(value) ? value.map(copied) : Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, copied(inner)]));
}
