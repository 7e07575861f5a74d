import { isLong } from './cells.mjs';
import { ratioOf, scaleText } from '../scale.mjs';
import { SIDE } from '../squares.mjs';

/** Pages of materials: each as a square in true scale, flat and draped, with its colour. */

const GAP = 9;
const BETWEEN = 3;

/** Digits that two instruments agree in. */
const labText = (lab) =>
  lab
    .map((value) =>
      value
        .toFixed(1)
        .replace(/^-(0\.0)$/, '$1')
        .replace('-', '\u2212'),
    )
    .join('  ');

/** A distance beside the name: below 1, eyes see none. */
const nearText = ({ name, difference }) => `${name}  ΔE\u2080\u2080 ${difference.toFixed(1)}`;

async function cellOf(layout, swatch, i) {
  const { words, pictures, squares, page } = layout;
  const path = ['swatches', i];
  const ratio = swatch.scale === 'fit' ? 1 : ratioOf(swatch.scale);
  const flat = await squares.model(swatch, path);
  const shown = [{ ...pictures.askSquare(flat, { size: SIDE, ratio }), alt: words('alt.square', { title: swatch.title, scale: scaleText(ratio) }) }];
  if (swatch.draped) {
    const draped = await squares.model(swatch, path, true);
    shown.push({ ...pictures.askSquare(draped, { size: SIDE, ratio }), alt: words('alt.draped', { title: swatch.title, scale: scaleText(ratio) }) });
  }
  const colour = await squares.colour(swatch, path);
  layout.colours.push({ title: swatch.title, srgb: colour.srgb, labD50: colour.labD50, labD65: colour.labD65, nearest: colour.nearest });
  const facts = [
    ['sRGB', colour.srgb],
    ['CIE Lab D50', labText(colour.labD50)],
    ['CIE Lab D65', labText(colour.labD65)],
    ...colour.nearest.map((near, k) => [k === 0 ? words('nearest') : '', nearText(near)]),
  ];
  const [beside, widest] = [shown.reduce((sum, { width }) => sum + width + BETWEEN, -BETWEEN), Math.max(...shown.map(({ width }) => width))];
  // Upright paper has no room for two whole squares beside each other.
  const isStacked = beside > page.box.width;
  return {
    title: swatch.title,
    note: layout.scaleNote(ratio),
    text: swatch.text ?? '',
    long: isLong(swatch.text) || isStacked,
    isStacked,
    changed: layout.isChanged('swatches', i),
    pictures: shown,
    colour: colour.srgb,
    facts,
    width: isStacked ? widest : beside,
  };
}

export async function swatchPages(layout) {
  const { spec, words, page } = layout;
  if (spec.swatches.length === 0) return [];
  const cells = [];
  for (const [i, swatch] of spec.swatches.entries()) cells.push(await cellOf(layout, swatch, i));
  const widest = Math.max(...cells.map(({ width }) => width));
  const columns = Math.max(1, Math.min(cells.length, Math.floor((page.box.width + GAP) / (widest + GAP))));
  return [{ kind: 'swatches', break: true, title: words('swatches'), note: words('swatches.note'), gap: GAP, between: BETWEEN, columns, cells }];
}
