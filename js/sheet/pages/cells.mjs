/** Parts of tables. */

const encoded = (x) => (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055);

/** Linear Rec.709 as "#rrggbb". @param {number[]} colour */
export const hexOf = (colour) =>
  `#${colour
    .map((x) =>
      Math.round(255 * Math.min(1, Math.max(0, encoded(x))))
        .toString(16)
        .padStart(2, '0'),
    )
    .join('')}`;

/** A column. @param {string} name @param {object} [how] width: share of what is left; 0 = as wide as it needs */
export const column = (name, { width = 0, number = false, strong = false } = {}) => ({ name, width, number, strong });

/**
 * A table of the rows of a list, with the columns that any row fills.
 * @param {object} layout
 * @param {{list: string, title: string, columns: {key: string, name: string, width?: number, cell?: (item: object) => unknown}[]}} table
 */
export function listTable(layout, { list, title, columns, breaks = true, note = null }) {
  const items = layout.spec[list];
  if (items.length === 0) return [];
  const value = ({ key, cell }, item) => (cell ? cell(item) : item[key]) ?? '';
  const used = columns.filter((each) => items.some((item) => value(each, item) !== ''));
  return [
    {
      kind: 'table',
      break: breaks,
      title,
      note,
      columns: used.map(({ name, width }) => column(name, { width })),
      rows: items.map((item, i) => ({ changed: layout.isChanged(list, i), cells: used.map((each) => value(each, item)) })),
    },
  ];
}
