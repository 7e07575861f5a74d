const ROUNDS = 2000;

/**
 * Coefficients, none negative, that bring the sum of squared relative errors to its least: coordinate descent on the normal equations
 * (Franc, Hlavac & Navara 2005, sequential coordinate-wise algorithm).
 * @param {{of: number[], is: number}[]} points `is` > 0 is to be the sum of `of` times the coefficients
 * @returns {number[]}
 */
export function leastSquares(points) {
  const size = points[0].of.length;
  const rows = points.map(({ of, is }) => of.map((value) => value / is));
  // Columns of one scale, so that the descent is even.
  const scales = Array.from({ length: size }, (_, j) => Math.max(...rows.map((row) => row[j])) || 1);
  const scaled = rows.map((row) => row.map((value, j) => value / scales[j]));
  const dots = scales.map((_, a) => scales.map((__, b) => scaled.reduce((sum, row) => sum + row[a] * row[b], 0)));
  const sums = scales.map((_, j) => scaled.reduce((sum, row) => sum + row[j], 0));
  const found = new Array(size).fill(0);
  for (let round = 0; round < ROUNDS; round++) {
    for (let j = 0; j < size; j++) {
      if (dots[j][j] === 0) continue;
      const gradient = dots[j].reduce((sum, value, k) => sum + value * found[k], 0) - sums[j];
      found[j] = Math.max(0, found[j] - gradient / dots[j][j]);
    }
  }
  return found.map((value, j) => value / scales[j]);
}
