import { CAPTION_GAP, emptyFigure } from '../layout.mjs';
import { fittingRatio } from '../scale.mjs';
import { chipsOf } from './colourways.mjs';

/** The first page: the garment in a few views of one scale, what it is, and its colourways. */

const GAP = 4;
/** White around a picture, and its rounding up to pixels. */
const WHITE = 4;

/** Fields of the header that the first page lists. */
const FIELDS = ['style', 'brand', 'season', 'category', 'fabric', 'baseSize', 'sizes', 'date', 'revision', 'author'];

/** The views of the first page. */
export function coverViews({ views }) {
  const wanted = views.filter(({ cover }) => cover);
  return (wanted.length > 0 ? wanted : views.slice(0, 1)).slice(0, 4);
}

const shareOf = (box, { length }) => (box.width - GAP * length) / length;

/** Room for what views side by side show, beside the white around their pictures and above their names: their widths together, and each of their heights. */
export function roomOfRow(layout, views, box) {
  const extents = views.map((view) => layout.extent(view));
  // The widths share the row: what counts is their sum.
  const sum = extents.reduce((all, { width }) => all + width, 0);
  const share = shareOf(box, views);
  const narrowest = Math.min(share, ...extents.map(({ width }) => (sum > 0 ? (box.width * width) / sum : share)));
  // Between pictures lies the white around them.
  const width = box.width - Math.max(WHITE, GAP * (views.length - 1) + 2 * views.length);
  return { width, height: box.height - layout.captionRoom(views, Math.max(narrowest, 20)) - WHITE };
}

/** Views side by side in one scale, the given one or the largest that fits, with their names beneath: a figure. */
export function rowOfViews(layout, views, box, given) {
  const extents = views.map((view) => layout.extent(view));
  const share = shareOf(box, views);
  const room = roomOfRow(layout, views, box);
  const together = { width: extents.reduce((all, { width }) => all + width, 0), height: Math.max(...extents.map(({ height }) => height)) };
  const ratio = given ?? fittingRatio([together], room);
  const figure = emptyFigure(box.width, box.height);
  const asked = views.map((view, i) => layout.pictures.ask(extents[i], { ratio, ...layout.seen(view) }));
  const free = (box.width - asked.reduce((all, { width }) => all + width, 0)) / (views.length + 1);
  // Each in an even share of the row where all are narrower, else with even white between.
  const isEven = asked.every(({ width }) => width <= share);
  const bottom = (room.height + WHITE + Math.max(...asked.map(({ height }) => height))) / 2;
  let x = free;
  asked.forEach(({ file, width, height }, i) => {
    const left = isEven ? GAP / 2 + i * (share + GAP) + (share - width) / 2 : x;
    const name = isEven ? { x: left - (share - width) / 2, width: share } : { x: left - free / 2, width: width + free };
    figure.pictures.push({ file, x: left, y: bottom - height, width, height, alt: layout.altOf(views[i], ratio), round: false, frame: false });
    figure.captions.push(layout.caption(views[i], ratio, { ...name, y: bottom + CAPTION_GAP }));
    x += width + free;
  });
  return figure;
}

export async function coverPage(layout) {
  const { spec, page, words } = layout;
  const { header } = spec;
  const views = coverViews(spec);
  const box = page.isWide
    ? { width: Math.round(page.box.width * 0.68), height: page.box.height }
    : { width: page.box.width, height: Math.round(page.box.height * 0.5) };
  const values = { ...header, sizes: header.sizes.join('  ') };
  const chips = [];
  for (const [i, colourway] of spec.colourways.entries()) {
    const colours = (await chipsOf(layout, colourway, i)).map(({ colour }) => colour).filter(Boolean);
    chips.push({ name: colourway.name, text: colourway.code ?? '', colours });
  }
  return [
    {
      kind: 'cover',
      break: false,
      stacked: !page.isWide,
      title: header.name || header.style || layout.facts.name || words('sheet'),
      description: header.description ?? '',
      figure: rowOfViews(layout, views, box),
      facts: FIELDS.filter((field) => values[field]).map((field) => [words(field), values[field]]),
      chips,
    },
  ];
}
