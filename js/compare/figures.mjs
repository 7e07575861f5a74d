/** Figures as text, one way for the terminal, the page and JUnit. */

export const number = (value) => (value === null ? 'none' : String(Number(value.toPrecision(4))));

const UNITS = { max: '/255', p999: '/255', mean: '/255' };
const NAMES = {
  max: 'max',
  p999: 'p99.9',
  mean: 'mean',
  rmse: 'RMSE',
  rmseLinear: 'RMSE linear',
  'flip.mean': 'FLIP mean',
  'flip.max': 'FLIP max',
  'deltaE.mean': 'CIEDE2000 mean',
  'deltaE.p95': 'CIEDE2000 p95',
  'deltaE.max': 'CIEDE2000 max',
};

/** "interior max" */
export const checkName = ({ region, figure }) => `${region} ${NAMES[figure]}`;

/** "3/255, at most 2/255" */
export function checkText({ figure, limit, value }) {
  const unit = UNITS[figure] ?? '';
  return `${value === null ? 'no pixels to judge' : `${number(value)}${unit}`}, at most ${number(limit)}${unit}`;
}

/**
 * Lines of columns padded to one width.
 * @param {string[][]} rows - Of as many cells each; not empty.
 * @param {number[]} left - Columns of words, which begin at the left; the others, numbers, end at the right.
 * @returns {string[]}
 */
export function textTable(rows, left) {
  const widths = rows[0].map((_, column) => Math.max(...rows.map((row) => row[column].length)));
  return rows.map((row) =>
    row
      .map((cell, i) => (left.includes(i) ? cell.padEnd(widths[i]) : cell.padStart(widths[i])))
      .join('  ')
      .trimEnd(),
  );
}

export const COLUMNS = ['pixels', 'max', 'p99.9', 'RMSE', 'RMSE linear', 'FLIP mean', 'FLIP median', 'dE00 mean', 'dE00 p95'];

/**
 * @param {import('./compare.mjs').Comparison} comparison
 * @returns {string[][]} name of the region, then COLUMNS
 */
export function regionRows(comparison) {
  return ['frame', 'object', 'interior', 'edge'].map((name) => {
    const f = comparison[name];
    if (!f) return [name, '0', ...COLUMNS.slice(1).map(() => '')];
    return [
      name,
      ...[f.pixels, f.max, f.p999, f.rmse, f.rmseLinear, f.flip.mean, f.flip.weightedMedian, f.deltaE.mean, f.deltaE.p95].map((value, i) =>
        i === 0 ? String(value) : number(value),
      ),
    ];
  });
}
