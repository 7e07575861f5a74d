/** What a spec says of a length. */

/**
 * The specified length of a size, in the units of the spec; undefined where there is none.
 * @param {{values: Record<string, number>, grade?: number}} measure
 * @param {string | undefined} size
 * @param {{sizes: string[], baseSize?: string}} header
 */
export function specifiedIn({ values, grade }, size, { sizes, baseSize }) {
  if (size === undefined) return undefined;
  if (Object.hasOwn(values, size)) return values[size];
  if (grade === undefined || baseSize === undefined || !Object.hasOwn(values, baseSize)) return undefined;
  // Without what sums of doubles leave: 0.1 + 0.2.
  return Number((values[baseSize] + grade * (sizes.indexOf(size) - sizes.indexOf(baseSize))).toFixed(9));
}
