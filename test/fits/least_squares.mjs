// Levenberg-Marquardt with a numeric Jacobian, for fits of some ten numbers.

/** Solves a x = b for a symmetric positive matrix, in place; by Cholesky. */
function solve(a, b) {
  const n = b.length;
  for (let i = 0; i < n; i += 1) {
    for (let j = 0; j <= i; j += 1) {
      let sum = a[i][j];
      for (let k = 0; k < j; k += 1) sum -= a[i][k] * a[j][k];
      a[i][j] = i === j ? Math.sqrt(Math.max(sum, 1e-300)) : sum / a[j][j];
    }
  }
  const x = [...b];
  for (let i = 0; i < n; i += 1) {
    for (let k = 0; k < i; k += 1) x[i] -= a[i][k] * x[k];
    x[i] /= a[i][i];
  }
  for (let i = n - 1; i >= 0; i -= 1) {
    for (let k = i + 1; k < n; k += 1) x[i] -= a[k][i] * x[k];
    x[i] /= a[i][i];
  }
  return x;
}

const squares = (values) => values.reduce((sum, value) => sum + value * value, 0);

function jacobian(residuals, p, at) {
  return p.map((value, i) => {
    const step = 1e-6 * Math.max(Math.abs(value), 1e-3);
    const moved = [...p];
    moved[i] += step;
    return residuals(moved).map((r, k) => (r - at[k]) / step);
  });
}

/**
 * @param {(p: number[]) => number[]} residuals
 * @param {number[]} start
 * @param {number} steps at most
 * @returns {number[]} where the sum of the residuals' squares is least
 * src: Marquardt 1963, "An Algorithm for Least-Squares Estimation of Nonlinear Parameters"
 */
export function leastSquares(residuals, start, steps = 200) {
  let p = [...start];
  let at = residuals(p);
  let cost = squares(at);
  let damping = 1e-3;
  for (let step = 0; step < steps && damping < 1e12; step += 1) {
    const columns = jacobian(residuals, p, at);
    const gradient = columns.map((column) => -column.reduce((sum, d, k) => sum + d * at[k], 0));
    const normal = columns.map((a) => columns.map((b) => a.reduce((sum, d, k) => sum + d * b[k], 0)));
    for (; damping < 1e12; damping *= 4) {
      const matrix = normal.map((row, i) => row.map((d, j) => (i === j ? d * (1 + damping) + 1e-12 : d)));
      const next = solve(matrix, gradient).map((d, i) => p[i] + d);
      const there = residuals(next);
      const value = squares(there);
      if (!(value < cost)) continue;
      const settled = cost - value < 1e-9 * cost;
      [p, at, cost] = [next, there, value];
      damping /= 9;
      if (settled) return p;
      break;
    }
  }
  return p;
}
