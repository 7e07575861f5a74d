import { wrongValue } from '../../shot/complain.mjs';
import { ABOUT } from '../read.mjs';
import { CAPTION_GAP, HEADING, emptyFigure } from '../layout.mjs';
import { isWithin, overlaps } from '../place/geometry.mjs';
import { isLong } from './cells.mjs';
import { fittingRatio, ratioOf, scaleText } from '../scale.mjs';

/** Pages of details: parts of a view drawn anew at a larger scale, with their places marked on the view. */

const GAP = 6;
/** Share of the page's width that the view takes. */
const PARENT = 0.34;
/** Side of a detail where its scale is to fit: least, where there are many, and most. */
const SIDE = { wide: 50, upright: 42, most: 120 };
/** Beneath a detail: its title, and what lies between it and the next row. */
const TITLE = 6.5;
const ROW_GAP = 7;

/**
 * How details stand beside their view: the way in which those whose scale is to fit are largest. Where there are many, they flow on to further pages.
 * @param {{sizes: {width: number, height: number}[], textHeight: (width: number) => number, room: {width: number, height: number}, least: number}} what
 *   sizes: metres of those that are to fit; textHeight: of the highest text beneath one
 * @returns {{width: number, height: number}} of one, at most
 */
export function roomOfDetail({ sizes, count, textHeight, room, least }) {
  let best;
  for (let columns = 1; columns <= count; ++columns) {
    const rows = Math.ceil(count / columns);
    const width = Math.min(SIDE.most, (room.width - GAP * (columns - 1)) / columns);
    if (width < least) break;
    const height = Math.min(SIDE.most, (room.height - ROW_GAP * (rows - 1)) / rows - TITLE - textHeight(width));
    if (height < least) continue;
    const value = sizes.reduce((sum, size) => sum + 1 / fittingRatio([size], { width, height }), 0);
    if (!best || value > best.value) best = { width, height, value };
  }
  return best ?? { width: least, height: least };
}

const KEYS = 'ABCDEFGHIJKLMNOPQRSTUVWXYZ';
/** A, B, ... Z, AA, AB, ... */
const keyOf = (i) => (i < 26 ? KEYS[i] : keyOf(Math.floor(i / 26) - 1) + KEYS[i % 26]);

/** @throws {TelarError} E_SPEC where a detail in a scale of its own is larger than its page has room for */
function checkFits({ id, size, height = size, scale }, ratio, room) {
  const [wide, high] = [size, height].map((length) => (1000 * length) / ratio);
  if (wide <= room.width && high <= room.height) return;
  const fitting = scaleText(fittingRatio([{ width: size, height }], room));
  throw wrongValue(
    ['details', id, 'scale'],
    `a scale at which ${Math.round(wide)} x ${Math.round(high)} mm fit into ${Math.floor(room.width)} x ${Math.floor(room.height)} mm beside the view, such as "${fitting}"`,
    scale,
    ABOUT,
  );
}

/** @param {{most: {width: number, height: number}, whole: {width: number, height: number}, parent: object}} rooms most: of one whose scale is to fit; whole: of one alone;
 *   parent: of parentOf */
async function cellOf(layout, view, detail, { most, whole, parent }) {
  const { words, pictures } = layout;
  const size = { width: detail.size, height: detail.height ?? detail.size };
  const ratio = detail.scale === 'fit' ? fittingRatio([size], most) : ratioOf(detail.scale);
  if (detail.scale !== 'fit') checkFits(detail, ratio, whole);
  const centre = await layout.pointOf(detail, view, { pointer: ['details', detail.id], picture: parent.picture.view });
  const { basis } = layout.extent(view);
  const { file, width, height } = pictures.ask({ basis, centre, ...size }, { ratio, ...layout.seen(view), style: detail.style, margin: 0 });
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
    long: isLong(detail.text),
    changed: layout.isChanged('details', detail.id),
    size,
  };
}

/** Of a letter of a key. */
const LETTER = { width: 2, height: 2.6 };

/** Where a ring's key stands: at its upper right, else round it and farther out, where no other key is. */
function keyPlace(box, { key, round, taken, figure }) {
  const size = { width: LETTER.width * key.length, height: LETTER.height };
  // Where the circle is nearest to the corner.
  const part = round ? Math.SQRT1_2 : 1;
  const [cx, cy] = [box.x + box.width / 2, box.y + box.height / 2];
  const paper = { x: 0, y: 0, width: figure.width, height: figure.height };
  for (let out = 0.6; out < 40; out += 1.5)
    for (const [sx, sy] of CORNERS) {
      const [ex, ey] = [cx + (sx * part * box.width) / 2 + sx * out, cy + (sy * part * box.height) / 2 + sy * (out - 0.6)];
      const place = { x: sx > 0 ? ex : ex - size.width, y: sy > 0 ? ey : ey - size.height, ...size };
      if (isWithin(place, paper) && !taken.some((other) => overlaps(place, other))) return place;
    }
  return { x: cx, y: cy, ...size };
}

const CORNERS = [
  [1, -1],
  [-1, -1],
  [1, 1],
  [-1, 1],
];

/** The picture of the view beside its details, with the room beneath it. */
function parentOf(layout, view, width) {
  const height = layout.page.box.height - HEADING;
  const extent = layout.extent(view);
  const caption = layout.captionRoom([view], width);
  const ratio = fittingRatio([extent], { width: width - 4, height: height - caption - 5 });
  return { caption, ratio, picture: layout.pictures.ask(extent, { ratio, ...layout.seen(view) }) };
}

/** The view with rings and frames at the places of its details. */
function markedOf(layout, view, cells, { width, parent: { caption, ratio, picture } }) {
  const { file, width: wide, height: high, view: seen } = picture;
  const x = (width - wide) / 2;
  const boxes = cells.map(({ centre, size }) => {
    const [px, py] = seen.paperOf(centre);
    const [halfWidth, halfHeight] = [size.width, size.height].map((side) => Math.max(1.5, (500 * side) / ratio));
    return { x: x + px - halfWidth, y: py - halfHeight, width: 2 * halfWidth, height: 2 * halfHeight };
  });
  // Rings may stand out of the picture: above it, they push it down.
  const top = Math.max(0, ...boxes.map(({ y }) => -y));
  const low = Math.max(high, ...boxes.map((box) => box.y + box.height));
  const figure = emptyFigure(width, top + low + caption);
  figure.pictures.push({ file, x, y: top, width: wide, height: high, alt: layout.altOf(view, ratio), round: false, frame: false });
  figure.captions.push(layout.caption(view, ratio, { x: 0, y: top + low + CAPTION_GAP, width }));
  const taken = [];
  cells.forEach(({ key, picture }, i) => {
    const box = { ...boxes[i], y: boxes[i].y + top };
    const at = keyPlace(box, { key, round: picture.round, taken, figure });
    taken.push(at);
    figure.rings.push({ ...box, round: picture.round, key, keyX: at.x, keyY: at.y });
  });
  return figure;
}

/** Of the highest text beneath a detail that is so wide; long ones may leave the page. */
function textHeight(layout, details, width) {
  const texts = details.filter(({ text }) => text && !isLong(text)).map(({ text }) => ({ kind: 'note', text, value: '', width }));
  return Math.max(0, ...layout.measure(texts).map(([, height]) => height));
}

export async function detailPages(layout) {
  const { spec, words, page } = layout;
  const details = spec.details.map((detail, i) => ({ ...detail, id: i, key: keyOf(i) }));
  const sections = [];
  for (const view of spec.views) {
    const own = details.filter((each) => each.view === view.name);
    if (own.length === 0) continue;
    const width = Math.round(page.box.width * PARENT);
    const room = page.box.width - width - GAP;
    const most = roomOfDetail({
      sizes: own.filter(({ scale }) => scale === 'fit').map(({ size, height = size }) => ({ width: size, height })),
      count: own.length,
      textHeight: (side) => textHeight(layout, own, side),
      room: { width: room, height: page.box.height - HEADING },
      least: page.isWide ? SIDE.wide : SIDE.upright,
    });
    const whole = { width: room, height: page.box.height - HEADING - TITLE };
    const parent = parentOf(layout, view, width);
    const cells = [];
    for (const detail of own) cells.push(await cellOf(layout, view, detail, { most, whole, parent }));
    const widest = Math.max(...cells.map(({ picture }) => picture.width));
    const columns = Math.min(cells.length, Math.max(1, Math.floor((room + GAP) / (widest + GAP))));
    const column = (room - GAP * (columns - 1)) / columns;
    // In a scale of its own a detail may leave its text no room: that goes on to a next page.
    const isHigh = ({ picture, text }) => picture.height + TITLE + textHeight(layout, [{ text }], column) > page.box.height - HEADING;
    sections.push({
      kind: 'details',
      break: true,
      title: words('details'),
      note: layout.titleOf(view),
      gap: GAP,
      columns,
      figure: markedOf(layout, view, cells, { width, parent }),
      cells: cells.map(({ centre, size, ...cell }) => ({ ...cell, long: cell.long || isHigh(cell) })),
    });
  }
  return sections;
}
