import { fittingRatio } from '../scale.mjs';
import { hexOf } from './cells.mjs';

/** Pages of colourways: each in the views of the first page, with its colours. */

const GAP = 8;
const WIDEST = 132;
const HIGHEST = 100;

/** The views of the first page, those that show colours before flats. */
function shownOf(views) {
  const lists = [views.filter(({ cover, style }) => cover && style === 'render'), views.filter(({ cover }) => cover), views.slice(0, 1)];
  return lists.find((list) => list.length > 0).slice(0, 2);
}

/** Colours of a colourway: as the spec has them, or of a material in its variant. */
export async function chipsOf(layout, { swatches, variant = '' }, i) {
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
  const perRow = Math.max(1, Math.min(spec.colourways.length, Math.floor((page.box.width + GAP) / ((page.isWide ? 84 : 78) + GAP))));
  const width = Math.min(WIDEST, (page.box.width - GAP * (perRow - 1)) / perRow);
  const extents = views.map((view) => layout.extent(view));
  const together = { width: extents.reduce((sum, extent) => sum + extent.width, 0), height: Math.max(...extents.map(({ height }) => height)) };
  const ratio = fittingRatio([together], { width: width - 4 * views.length - 2, height: HIGHEST });
  const chips = [];
  for (const [i, colourway] of spec.colourways.entries()) chips.push(await chipsOf(layout, colourway, i));
  return [
    {
      kind: 'colourways',
      break: true,
      title: words('colourways'),
      note: layout.scaleNote(ratio),
      gap: GAP,
      columns: perRow,
      cells: spec.colourways.map(({ name, code, variant }, i) => ({
        name,
        code: code ?? '',
        // So many colours are higher than a page with pictures.
        long: chips[i].length > 6,
        changed: layout.isChanged('colourways', i),
        pictures: views.map((view, k) => {
          const { file, width: wide, height } = pictures.ask(extents[k], { ratio, variant: variant ?? view.variant });
          return { file, width: wide, height, alt: `${name}: ${layout.altOf(view, ratio)}` };
        }),
        swatches: chips[i],
      })),
    },
  ];
}
