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

/** Texts of more characters than this are let run on over pages: a block of them might be higher than one. */
const LONG = 600;

export const isLong = (text = '') => text.length > LONG || text.split('\n').length > 12;

/** A column. @param {string} name @param {object} [how] width: share of what is left; 0 = as wide as it needs */
export const column = (name, { width = 0, number = false, strong = false } = {}) => ({ name, width, number, strong });

const textOf = (cell) => (typeof cell === 'string' ? cell : (cell?.text ?? ''));

/** Characters up to which a column may be as wide as its longest text. */
const NARROW = 16;

/** Width of a column: what asks for no share gets one where a text of it is long. */
export const widthFor = ({ name, width = 0 }, texts) => (width === 0 && [name, ...texts].some((text) => text.length > NARROW) ? 1 : width);

/** Parts of a list of at most so many items, as even as they go. */
export function shared(list, most) {
  const count = Math.max(1, Math.ceil(list.length / most));
  return Array.from({ length: count }, (_, i) => list.slice(Math.floor((i * list.length) / count), Math.floor(((i + 1) * list.length) / count)));
}

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
      columns: used.map((each) =>
        column(each.name, {
          width: widthFor(
            each,
            items.map((item) => textOf(value(each, item))),
          ),
        }),
      ),
      rows: items.map((item, i) => ({ changed: layout.isChanged(list, i), cells: used.map((each) => value(each, item)) })),
    },
  ];
}
