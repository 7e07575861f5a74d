import { fittingRatio } from '../scale.mjs';
import { HEADING } from '../layout.mjs';
import { hexOf } from './cells.mjs';

/** Pages of colourways: each in the views of the first page, with its colours. */

const GAP = 8;
/** Narrowest column: names of colours stand beneath the pictures. */
const NARROWEST = 58;
/** Fewest colourways of a page, where there are so many: scale grows with pages. */
const FEWEST = 3;
/** Between the pictures of one colourway. */
const BETWEEN = 2;
/** Beneath the pictures: the rule with the name, and each row of colours. */
const NAME = 14;
const CHIP = { width: 42, height: 8.8 };
/** Of a colour: its square, and the white between columns, and between rows. */
const SQUARE = { width: 9, height: 7 };
const CHIP_GAP = { column: 2.4, row: 1.6 };
/** Most colours that are kept on one page. */
const LONG = 6;
/** White around a picture, and its rounding up to pixels. */
const WHITE = 4;

/** Colours beside each other in a column. */
const chipColumns = (width) => Math.max(1, Math.floor(width / CHIP.width));

/**
 * How colourways stand on a page: the way that shows them largest; of those, the views beside each other and the most columns.
 * @param {{count: number, chips: number, extents: {width: number, height: number}[], box: {width: number, height: number}}} what chips: most
 *   colours of one; extents: of the views, metres
 * @returns {{columns: number, width: number, isStacked: boolean, ratio: number}}
 */
export function arrangementOf({ count, chips, extents, box }) {
  const sum = (key) => extents.reduce((total, extent) => total + extent[key], 0);
  const most = (key) => Math.max(...extents.map((extent) => extent[key]));
  const within = (extents.length - 1) * BETWEEN + extents.length * WHITE;
  const ways = [];
  for (let columns = Math.min(count, Math.floor((box.width + GAP) / (NARROWEST + GAP))); columns >= 1; --columns)
    for (let rows = 1; rows <= Math.ceil(count / columns); ++rows) {
      if (columns * rows < Math.min(FEWEST, count)) continue;
      const width = (box.width - GAP * (columns - 1)) / columns;
      const height = (box.height - HEADING - GAP * rows) / rows - NAME - CHIP.height * Math.ceil(chips / chipColumns(width));
      for (const isStacked of extents.length > 1 ? [false, true] : [false]) {
        const together = isStacked ? { width: most('width'), height: sum('height') } : { width: sum('width'), height: most('height') };
        const room = isStacked ? { width: width - WHITE, height: height - within } : { width: width - within, height: height - WHITE };
        if (room.width > 0 && room.height > 0) ways.push({ columns, width, isStacked, ratio: fittingRatio([together], room) });
      }
    }
  return ways.reduce((best, way) => (way.ratio < best.ratio || (way.ratio === best.ratio && best.isStacked && !way.isStacked) ? way : best));
}

/** How high the colours beneath a colourway are, at most: their names, and parts and codes under them, wrap. */
function chipsHeight(layout, chips, width) {
  const count = chipColumns(width);
  const room = (width - count * SQUARE.width - (2 * count - 1) * CHIP_GAP.column) / count;
  const texts = chips.flatMap(({ name, part, code }) => [name || part, `${name ? part : ''} ${code}`]);
  const heights = layout.measure(texts.map((text) => ({ kind: 'note', text, value: '', width: room }))).map(([, height]) => height);
  const high = chips.map((_, i) => Math.max(SQUARE.height, heights[2 * i] + heights[2 * i + 1]) + CHIP_GAP.row);
  return high.reduce((sum, _, i) => (i % count === 0 ? sum + Math.max(...high.slice(i, i + count)) : sum), 0);
}

/** The views of the first page, those that show colours before flats. */
function shownOf(views) {
  const lists = [views.filter(({ cover, style }) => cover && style === 'render'), views.filter(({ cover }) => cover), views.slice(0, 1)];
  return lists.find((list) => list.length > 0).slice(0, 2);
}

/** Colours of a colourway: as the spec has them, or of a material in its variant. */
export async function chipsOf(layout, { swatches, variant }, i) {
  const chips = [];
  for (const [k, swatch] of swatches.entries()) {
    const { part = '', name, code = '', color, material } = swatch;
    const measured = material === undefined ? undefined : await layout.squares.colour({ material, variant }, ['colourways', i, 'swatches', k]);
    chips.push({ colour: color ? hexOf(color) : (measured?.srgb ?? null), part, name: name ?? measured?.nearest[0]?.name ?? '', code });
  }
  return chips;
}

export async function colourwayPages(layout) {
  const { spec, words, page, pictures } = layout;
  if (spec.colourways.length === 0) return [];
  const views = shownOf(spec.views).map((view) => ({ ...view, style: 'render' }));
  const extents = views.map((view) => layout.extent(view));
  const chips = [];
  for (const [i, colourway] of spec.colourways.entries()) chips.push(await chipsOf(layout, colourway, i));
  // So many colours are higher than a page with pictures.
  const isLong = ({ length }) => length > LONG;
  const { columns, width, isStacked, ratio } = arrangementOf({
    count: spec.colourways.length,
    chips: Math.max(...chips.filter((list) => !isLong(list)).map(({ length }) => length), 0),
    extents,
    box: page.box,
  });
  const onPaper = (key) => extents.map((extent) => (1000 * extent[key]) / ratio + WHITE);
  const picturesHeight = isStacked ? onPaper('height').reduce((sum, height) => sum + height + BETWEEN) : Math.max(...onPaper('height'));
  const isHigh = (list) => picturesHeight + NAME + chipsHeight(layout, list, width) > page.box.height - HEADING;
  return [
    {
      kind: 'colourways',
      break: true,
      title: words('colourways'),
      note: layout.scaleNote(ratio),
      gap: GAP,
      columns,
      chipColumns: chipColumns(width),
      isStacked,
      cells: spec.colourways.map(({ name, code, variant }, i) => ({
        name,
        code: code ?? '',
        // Names that wrap may leave no room beneath the pictures: colours go on to a next page.
        long: isLong(chips[i]) || isHigh(chips[i]),
        changed: layout.isChanged('colourways', i),
        pictures: views.map((view, k) => {
          const { file, width: wide, height } = pictures.ask(extents[k], { ratio, ...layout.seen(view), variant });
          return { file, width: wide, height, alt: `${name}: ${layout.altOf(view, ratio)}` };
        }),
        swatches: chips[i],
      })),
    },
  ];
}
