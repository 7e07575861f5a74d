import { createRequire } from 'node:module';
import { encodePng, readImage, shrinkImage } from '../compare/index.mjs';
import { escaped } from '../compare/markup.mjs';
import { ellipsized, FONTS, needsSystemFonts } from './text_width.mjs';

/** One picture of many: a grid of thumbnails with their names. Lengths are pixels. */

const { resolve } = createRequire(import.meta.url);

const SIDE_MAX = 8192;
const CELL = { default: 320, min: 48 };

/** Lengths for a cell of 320; they shrink with it. */
const AT_320 = { margin: 48, gap: 24, name: 15, detail: 13, toName: 26, toDetail: 46 };
const CAPTION = { nameAlone: 40, both: 60 };

/** Most pictures that a row is made wide for, so that they stand together. */
const GROUP_MAX = 9;

/** So few pictures stand in one row. */
const ROW = 4;
const COLOURS = { page: '#ffffff', card: '#f5f4f2', name: '#1c1b19', detail: '#8b8780' };

/** A little wider than high, in rows that hold whole groups: the views of one garment stand beside each other. */
function columnsFor(count, group, aspect) {
  if (count <= ROW) return count;
  const wide = Math.max(1, Math.round(Math.sqrt((count * (1 + (CAPTION.both / CELL.default) * aspect)) / aspect) * 1.15));
  const columns = Math.min(count, wide);
  return group > 1 && group <= Math.min(count, GROUP_MAX) ? Math.max(1, Math.round(columns / group)) * group : columns;
}

/** Column and row of each item, row by row; one that begins something new begins a row. */
function gridOf(items, columns) {
  let [column, row] = [-1, 0];
  return items.map(({ begins }) => {
    column += 1;
    if (column === columns || (begins && column > 0)) [column, row] = [0, row + 1];
    return { column, row };
  });
}

/**
 * Places of the cells.
 * @param {SheetItem[]} items
 * @param {number} group so many pictures belong together
 * @param {number} aspect width over height of a picture
 */
export function layoutOf(items, group, aspect) {
  const columns = columnsFor(items.length, group, aspect);
  const grid = gridOf(items, columns);
  const rows = grid.at(-1).row + 1;
  const caption = items.some(({ detail }) => detail) ? CAPTION.both : CAPTION.nameAlone;
  const sizes = (cell) => {
    const scale = cell / CELL.default;
    const of = Object.fromEntries(Object.entries({ ...AT_320, caption }).map(([name, length]) => [name, Math.round(length * scale)]));
    const picture = { width: cell, height: Math.round(cell / aspect) };
    const step = { x: cell + of.gap, y: picture.height + of.caption + of.gap };
    return { ...of, picture, step, grid, width: 2 * of.margin + columns * step.x - of.gap, height: 2 * of.margin + rows * step.y - of.gap };
  };
  let cell = CELL.default;
  while (cell > CELL.min && Math.max(sizes(cell).width, sizes(cell).height) > SIDE_MAX) cell -= 8;
  return sizes(cell);
}

const placeOf = ({ margin, step, grid }, index) => ({ x: margin + grid[index].column * step.x, y: margin + grid[index].row * step.y });

function caption(layout, { name, detail }, index) {
  const { x, y } = placeOf(layout, index);
  const bottom = y + layout.picture.height;
  const line = (text, size, weight, colour, below) =>
    `<text x="${x}" y="${bottom + below}" font-size="${size}" font-weight="${weight}" fill="${colour}">${escaped(ellipsized(text, size, weight, layout.picture.width))}</text>`;
  return `<rect x="${x}" y="${y}" width="${layout.picture.width}" height="${layout.picture.height}" rx="2" fill="${COLOURS.card}"/>
${line(name, layout.name, 500, COLOURS.name, layout.toName)}
${detail ? line(detail, layout.detail, 400, COLOURS.detail, layout.toDetail) : ''}`;
}

function missing(layout, reason, index) {
  const { x, y } = placeOf(layout, index);
  return `<text x="${x + layout.picture.width / 2}" y="${y + layout.picture.height / 2}" text-anchor="middle" font-size="${layout.detail}" fill="${COLOURS.detail}">${escaped(reason)}</text>`;
}

/** Cards and captions, without the pictures: RGBA. */
async function drawnPage(layout, items) {
  const { Resvg } = await import('@resvg/resvg-js');
  const texts = items.flatMap(({ name, detail = '', error }) => [name, detail, error ?? '']);
  const svg = `<svg xmlns="http://www.w3.org/2000/svg" width="${layout.width}" height="${layout.height}" font-family="Inter">
${items.map((item, i) => caption(layout, item, i) + (item.error ? missing(layout, item.error, i) : '')).join('\n')}</svg>`;
  const font = { fontFiles: Object.values(FONTS).map((file) => resolve(file)), defaultFontFamily: 'Inter', loadSystemFonts: texts.some(needsSystemFonts) };
  const page = new Resvg(svg, { background: COLOURS.page, font, fitTo: { mode: 'original' } }).render();
  return { width: page.width, height: page.height, data: new Uint8Array(page.pixels) };
}

/** Largest size of an image within a box; never larger than the image. */
function fitted({ width, height }, box) {
  const scale = Math.min(1, box.width / width, box.height / height);
  return { width: Math.max(1, Math.round(width * scale)), height: Math.max(1, Math.round(height * scale)) };
}

/** Lays a picture over the opaque page, as a browser does: in encoded values. */
function lay(page, image, left, top) {
  for (let y = 0; y < image.height; y++) {
    for (let x = 0; x < image.width; x++) {
      const [from, to] = [(y * image.width + x) * 4, ((top + y) * page.width + left + x) * 4];
      const alpha = image.data[from + 3] / 255;
      for (let c = 0; c < 3; c++) page.data[to + c] = Math.round(page.data[to + c] * (1 - alpha) + image.data[from + c] * alpha);
    }
  }
}

/**
 * @typedef {object} SheetItem
 * @property {string} name first line
 * @property {string} [detail] second line
 * @property {string} [file] of the picture
 * @property {string} [error] stands where there is no picture
 * @property {boolean} [begins] stands at the begin of a row
 *
 * @param {SheetItem[]} items
 * @param {{group: number, limits: object, signal?: AbortSignal}} options group: so many pictures belong together
 * @returns {Promise<Buffer>} a PNG
 */
export async function contactSheet(items, { group, limits, signal }) {
  const aspect = await aspectOf(items, { limits, signal });
  const layout = layoutOf(items, group, aspect);
  const page = await drawnPage(layout, items);
  for (const [index, { file }] of items.entries()) {
    if (file === undefined) continue;
    const image = await readImage(file, { limits, signal });
    const small = shrinkImage(image, fitted(image, layout.picture));
    const { x, y } = placeOf(layout, index);
    lay(page, small, x + Math.round((layout.picture.width - small.width) / 2), y + Math.round((layout.picture.height - small.height) / 2));
  }
  return encodePng(page, { signal });
}

/** Of the first picture; from 1:2 to 2:1, so that one banner makes no strip of the sheet. */
async function aspectOf(items, options) {
  const file = items.find((item) => item.file !== undefined)?.file;
  if (file === undefined) return 1;
  const { width, height } = await readImage(file, options);
  return Math.min(2, Math.max(0.5, width / height));
}
