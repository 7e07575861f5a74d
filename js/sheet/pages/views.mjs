import { HEADING } from '../layout.mjs';
import { PLACES } from '../lengths.mjs';
import { ratioOf } from '../scale.mjs';
import { coverViews, roomOfRow, rowOfViews } from './cover.mjs';

/** Pages of the views that no other page shows, or none in the scale that they ask for, and of all flats beside each other behind them: rows of one scale. */

const ROW = 4;

/** Whether a view has a page of this kind: every flat, and what is shown nowhere else. */
function isLeft(spec, view) {
  if (view.style === 'flat') return true;
  const has = (items) => items.some((item) => item.view === view.name);
  const isMeasured = has(spec.measures.filter((measure) => PLACES.some((key) => measure[key] !== undefined)));
  if (has(spec.callouts) || isMeasured) return false;
  // The first page, and pages of details, show a view as large as it fits.
  return view.scale !== 'fit' || !(has(spec.details) || coverViews(spec).includes(view));
}

/** Views that share a row: neighbours of one style, and of one scale where it is given. */
function rowsOf(layout, views, box) {
  const rows = [];
  for (const view of views) {
    const row = rows.at(-1);
    const isLike = row && row.length < ROW && row[0].style === view.style && row[0].scale === view.scale;
    if (isLike && (view.scale === 'fit' || fits(layout, [...row, view], box))) row.push(view);
    else rows.push([view]);
  }
  return rows;
}

/** Whether views of a given scale stand side by side, each of them whole. */
function fits(layout, views, box) {
  const room = roomOfRow(layout, views, box);
  const onPaper = (length) => (1000 * length) / ratioOf(views[0].scale);
  const extents = views.map((view) => layout.extent(view));
  const width = extents.reduce((sum, extent) => sum + onPaper(extent.width), 0);
  return width <= room.width && extents.every(({ height }) => onPaper(height) <= room.height);
}

export function viewPages(layout) {
  const { spec, words, page } = layout;
  const left = ['render', 'flat'].flatMap((style) => spec.views.filter((view) => view.style === style && isLeft(spec, view)));
  const box = { width: page.box.width, height: page.box.height - HEADING };
  return rowsOf(layout, left, box).map((views) => {
    // Views that share a row fit; a view alone says what is wrong with its scale.
    const ratio = views[0].scale === 'fit' ? undefined : layout.ratio(views[0], roomOfRow(layout, views, box));
    const flat = views[0].style === 'flat';
    return { kind: 'figure', break: true, title: words(flat ? 'flats' : 'views'), note: null, figure: rowOfViews(layout, views, box, ratio) };
  });
}
