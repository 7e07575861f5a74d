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

export function colourwayPages(layout) {
  const { spec, words, page, pictures } = layout;
  if (spec.colourways.length === 0) return [];
  const views = shownOf(spec.views).map((view) => ({ ...view, style: 'render' }));
  const perRow = Math.max(1, Math.min(spec.colourways.length, Math.floor((page.box.width + GAP) / ((page.isWide ? 84 : 78) + GAP))));
  const width = Math.min(WIDEST, (page.box.width - GAP * (perRow - 1)) / perRow);
  const extents = views.map((view) => layout.extent(view));
  const together = { width: extents.reduce((sum, extent) => sum + extent.width, 0), height: Math.max(...extents.map(({ height }) => height)) };
  const ratio = fittingRatio([together], { width: width - 4 * views.length - 2, height: HIGHEST });
  return [
    {
      kind: 'colourways',
      break: true,
      title: words('colourways'),
      note: layout.scaleNote(ratio),
      gap: GAP,
      columns: perRow,
      cells: spec.colourways.map(({ name, code, variant, swatches }, i) => ({
        name,
        code: code ?? '',
        changed: layout.isChanged('colourways', i),
        pictures: views.map((view, k) => {
          const { file, width: wide, height } = pictures.ask(extents[k], { ratio, variant: variant ?? view.variant });
          return { file, width: wide, height, alt: `${name}: ${layout.altOf(view, ratio)}` };
        }),
        swatches: swatches.map((swatch) => ({
          colour: swatch.color ? hexOf(swatch.color) : null,
          part: swatch.part ?? '',
          name: swatch.name ?? '',
          code: swatch.code ?? '',
        })),
      })),
    },
  ];
}
