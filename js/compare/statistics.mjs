/** Pooling of a map over pixels. */

/**
 * @param {Float32Array} sorted ascending, not empty
 * @param {number} share 0..1
 * @returns {number} the smallest value that at least this share of the values does not pass
 */
export const percentile = (sorted, share) => sorted[Math.max(0, Math.ceil(share * sorted.length) - 1)];

/** The lower one of two in the middle. @param {number[]} values not empty */
export const median = (values) =>
  percentile(
    values.toSorted((a, b) => a - b),
    0.5,
  );

/**
 * Percentile in which each value counts as much as it is large, so that the many pixels without an error do not hide it.
 * @param {Float32Array} sorted ascending, none negative, not empty
 * @param {number} share 0..1
 */
export function weightedPercentile(sorted, share) {
  const wanted = share * sorted.reduce((sum, value) => sum + value, 0);
  let sum = 0;
  for (const value of sorted) {
    sum += value;
    if (sum >= wanted) return value;
  }
  return sorted.at(-1);
}

/** @param {Float32Array | number[]} values not empty */
export const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;
