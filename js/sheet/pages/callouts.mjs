import { CAPTION_GAP, HEADING, emptyFigure } from '../layout.mjs';
import { placeCallouts } from '../place/callouts.mjs';
import { wrongValue } from '../../shot/complain.mjs';
import { ABOUT } from '../read.mjs';
import { grown, isWithin, passes, segmentsOf } from '../place/geometry.mjs';

/** Pages of call-outs: a view with texts at both sides. */

const GAP = 4;
const STUB = 4;
const PAD = 1.6;
const AIR = 5;
/** From the top of a text to the middle of its first line. */
const PORT = 1.25;
/** So that a text that is measured breaks as it is set. */
const ROUNDING = 0.05;
/** A text that is higher than this part of the page is set as a note on a page of its own. */
const NOTE_PART = 0.5;

const columnWidth = (width) => Math.min(66, Math.max(38, width * 0.23));

/** Columns and the box of the picture on a page. */
function arrangement(layout, view) {
  const { page } = layout;
  const width = columnWidth(page.box.width);
  const height = page.box.height - HEADING;
  const columns = {
    height,
    left: { x: 0, width },
    right: { x: page.box.width - width, width },
    gap: GAP,
    port: PORT,
    pad: PAD,
    stub: STUB,
  };
  const inset = width + STUB + AIR;
  return { columns, box: { x: inset, y: 0, width: page.box.width - 2 * inset, height: height - layout.captionRoom([view], page.box.width - 2 * inset) } };
}

/** Texts with their heights; those that are too high become notes, and say where they are. */
function labelsOf(layout, callouts, columns) {
  const { words } = layout;
  const sizes = (texts) => layout.measure(texts.map((text) => ({ kind: 'callout', text, width: columns.left.width - ROUNDING, value: '' })));
  const full = sizes(callouts.map(({ text }) => text));
  const [short] = sizes([words('seeNote')]);
  return callouts.map((callout, i) => {
    const isNote = full[i][1] > columns.height * NOTE_PART;
    const [width, height] = isNote ? short : full[i];
    return { ...callout, isNote, shown: isNote ? words('seeNote') : callout.text, width: width + ROUNDING, height };
  });
}

/** Where the name of the view begins: close beneath the picture, else beneath all where a line would strike it. */
function captionTop(layout, { view, ratio, box, picture, placed }) {
  const y = picture.y + picture.height + CAPTION_GAP;
  const [[width, height]] = layout.measure([{ kind: 'caption', text: layout.titleOf(view), value: layout.scaleNote(ratio), width: 0 }]);
  const name = { x: box.x + Math.max(0, box.width - width) / 2, y, width: Math.min(width, box.width), height: 2 * height };
  const isStruck = placed.some(({ leader }) => segmentsOf(leader).some((segment) => passes(segment, grown(name, 1))));
  return isStruck || width > box.width ? box.height + CAPTION_GAP : y;
}

function figureOf(layout, { view, ratio, box, placed, labels, picture }) {
  const figure = emptyFigure(layout.page.box.width, layout.page.box.height - HEADING);
  figure.pictures.push({ ...picture, alt: layout.altOf(view, ratio), round: false, frame: false });
  figure.captions.push(layout.caption(view, ratio, { x: box.x, y: captionTop(layout, { view, ratio, box, picture, placed }), width: box.width }));
  const byId = new Map(labels.map((label) => [label.id, label]));
  for (const { id, x, y, width, height, leader } of placed) {
    const { number, shown, isChanged } = byId.get(id);
    figure.labels.push({ x, y, width, height, number, text: shown, changed: isChanged });
    figure.lines.push({ kind: 'leader', points: leader });
    figure.sites.push(leader.at(-1));
  }
  // A reader of the page hears them in their order.
  figure.labels.sort((a, b) => Number(a.number) - Number(b.number));
  return figure;
}

async function pagesOfView(layout, view, callouts) {
  const { words } = layout;
  const { columns, box } = arrangement(layout, view);
  const extent = layout.extent(view);
  const ratio = layout.ratio(view, { width: box.width - 4, height: box.height - 4 });
  const { file, width, height, view: seen } = layout.pictures.ask(extent, { ratio, ...layout.seen(view) });
  const picture = { file, width, height, x: box.x + (box.width - width) / 2, y: (box.height - height) / 2 };
  const labels = [];
  for (const label of labelsOf(layout, callouts, columns)) {
    const point = await layout.pointOf(label, view, { pointer: ['callouts', label.id], picture: seen });
    const [x, y] = seen.paperOf(point);
    const site = [picture.x + x, picture.y + y];
    if (!isWithin({ x: site[0], y: site[1], width: 0, height: 0 }, picture))
      throw wrongValue(['callouts', label.id], `a place in the view "${view.name}"`, label.point ?? label.picture, ABOUT);
    labels.push({ ...label, site });
  }
  const sections = [];
  let left = labels.map(({ id, site, width: wide, height: high, side }) => ({ id, site, width: wide, height: high, side }));
  while (left.length > 0) {
    const { placed, rest, moved } = placeCallouts(left, columns);
    for (const id of moved)
      layout.warn(
        'W_SHEET_SIDE',
        `spec.callouts[${id}].side: on that side lines would cross or texts not fit; the other one was taken`,
        `/callouts/${id}/side`,
      );
    const note = sections.length === 0 ? layout.titleOf(view) : `${layout.titleOf(view)} (${words('continued')})`;
    sections.push({ kind: 'figure', break: true, title: words('callouts'), note, figure: figureOf(layout, { view, ratio, box, placed, labels, picture }) });
    left = rest;
  }
  const notes = labels.filter(({ isNote }) => isNote).map(({ number, text, isChanged }) => ({ number, text, changed: isChanged }));
  if (notes.length > 0) sections.push({ kind: 'notes', break: true, title: words('callout.notes'), note: layout.titleOf(view), notes });
  return sections;
}

export async function calloutPages(layout) {
  const callouts = layout.spec.callouts.map((callout, i) => ({ ...callout, id: i, number: String(i + 1), isChanged: layout.isChanged('callouts', i) }));
  const pages = [];
  for (const view of layout.spec.views) {
    const own = callouts.filter((callout) => callout.view === view.name);
    if (own.length > 0) pages.push(...(await pagesOfView(layout, view, own)));
  }
  return pages;
}
