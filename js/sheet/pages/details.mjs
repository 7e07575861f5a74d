import { HEADING, emptyFigure } from '../layout.mjs';
import { fittingRatio, ratioOf, scaleText } from '../scale.mjs';

/** Pages of details: parts of a view drawn anew at a larger scale, with their places marked on the view. */

const GAP = 6;
/** Share of the page's width that the view takes. */
const PARENT = 0.34;
/** Side of a detail where its scale is to fit. */
const SIDE = { wide: 50, upright: 42 };

const KEYS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZ';
/** A, B, ... Z, AA, AB, ... */
const keyOf = (i) => (i < 26 ? KEYS[i] : keyOf(Math.floor(i / 26) - 1) + KEYS[i % 26]);

async function cellOf(layout, view, detail) {
  const { page, words, pictures } = layout;
  const room = page.isWide ? SIDE.wide : SIDE.upright;
  const size = { width: detail.size, height: detail.height ?? detail.size };
  const ratio = detail.scale === 'fit' ? fittingRatio([size], { width: room, height: room }) : ratioOf(detail.scale);
  const centre = await layout.pointOf(detail, view, ['details', detail.id]);
  const { basis } = layout.extent(view);
  const { file, width, height } = pictures.ask({ basis, centre, ...size }, { ratio, variant: view.variant, style: detail.style, margin: 0 });
  return {
    centre,
    picture: {
      file,
      width,
      height,
      alt: words('alt.detail', { title: detail.title, scale: scaleText(ratio) }),
      round: detail.shape === 'circle',
      frame: detail.shape !== 'circle',
    },
    key: detail.key,
    title: detail.title,
    note: layout.scaleNote(ratio),
    text: detail.text ?? '',
    changed: layout.isChanged('details', detail.id),
    size,
  };
}

/** The view with rings and frames at the places of its details. */
function parentOf(layout, view, cells, width) {
  const { page } = layout;
  const height = page.box.height - HEADING;
  const extent = layout.extent(view);
  const ratio = fittingRatio([extent], { width: width - 4, height: height - 14 });
  const { file, width: wide, height: high, view: seen } = layout.pictures.ask(extent, { ratio, variant: view.variant, style: view.style });
  const x = (width - wide) / 2;
  const figure = emptyFigure(width, high + 9);
  figure.pictures.push({ file, x, y: 0, width: wide, height: high, alt: layout.altOf(view, ratio), round: false, frame: false });
  figure.captions.push({ x: 0, y: high + 2, width, title: layout.titleOf(view), note: layout.scaleNote(ratio), text: '', centred: true });
  for (const { centre, key, size, picture } of cells) {
    const [px, py] = seen.paperOf(centre);
    const [halfWidth, halfHeight] = [size.width, size.height].map((side) => Math.max(1.5, (500 * side) / ratio));
    // Where the circle is nearest to the corner.
    const part = picture.round ? Math.SQRT1_2 : 1;
    const box = { x: x + px - halfWidth, y: py - halfHeight, width: 2 * halfWidth, height: 2 * halfHeight };
    figure.rings.push({ ...box, round: picture.round, key, keyX: x + px + halfWidth * part + 0.6, keyY: py - halfHeight * part - 2.6 });
  }
  return figure;
}

export async function detailPages(layout) {
  const { spec, words, page } = layout;
  const details = spec.details.map((detail, i) => ({ ...detail, id: i, key: keyOf(i) }));
  const sections = [];
  for (const view of spec.views) {
    const cells = [];
    for (const detail of details.filter((each) => each.view === view.name)) cells.push(await cellOf(layout, view, detail));
    if (cells.length === 0) continue;
    const width = Math.round(page.box.width * PARENT);
    const room = page.box.width - width - GAP;
    const widest = Math.max(...cells.map(({ picture }) => picture.width));
    const columns = Math.max(1, Math.floor((room + GAP) / (widest + GAP)));
    sections.push({
      kind: 'details',
      break: true,
      title: words('details'),
      note: layout.titleOf(view),
      gap: GAP,
      columns: Math.min(columns, cells.length),
      figure: parentOf(layout, view, cells, width),
      cells: cells.map(({ centre, size, ...cell }) => cell),
    });
  }
  return sections;
}
