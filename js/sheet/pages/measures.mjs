import { CAPTION_GAP, HEADING, emptyFigure } from '../layout.mjs';
import { placeDimensions } from '../place/dimensions.mjs';
import { distance, segmentsOf } from '../place/geometry.mjs';
import { specifiedIn } from '../specified.mjs';
import { differenceText, lengthText, millimetresOf, printedOf, printedText } from '../units.mjs';
import { column, shared, widthFor } from './cells.mjs';

/** Pages of the points of measure: dimension lines on views, and the table. */

/** Room around the picture for dimension lines. */
const ROOM = { x: 26, y: 15 };

/** Of an arrow head. */
const ARROW = { length: 2.4, half: 0.65 };

/** An arrow head at the end of a line that comes from `from`. */
function arrow(tip, from) {
  const length = distance(tip, from);
  if (length < 1e-6) return undefined;
  const [dx, dy] = [(from[0] - tip[0]) / length, (from[1] - tip[1]) / length];
  const [x, y] = [tip[0] + ARROW.length * dx, tip[1] + ARROW.length * dy];
  return [tip, [x - ARROW.half * dy, y + ARROW.half * dx], [x + ARROW.half * dy, y - ARROW.half * dx]];
}

/** The two points of a loop that a view shows farthest apart, along its longer side: a loop is drawn as the width that it shows. */
function widthOf(points) {
  const range = (axis) => [-1, 1].map((sign) => points.reduce((best, point) => (sign * point[axis] > sign * best[axis] ? point : best)));
  const [level, upright] = [range(0), range(1)];
  return distance(...level) >= distance(...upright) ? level : upright;
}

/** What is drawn of a point of measure. */
function dimensionOf({ id, path, isLoop, along }, onPaper, [width, height]) {
  const points = path.map(onPaper);
  return { id, points: isLoop ? widthOf(points) : points, width, height, isPath: !isLoop && (along === 'surface' || path.length > 2) };
}

function draw(figure, { line, witness, label, outside }, measure) {
  const kind = outside || line.length === 2 ? 'dimension' : 'along';
  for (const points of witness) figure.lines.push({ kind: 'witness', points });
  figure.lines.push({ kind, points: line });
  const isShort = distance(line[0], line.at(-1)) < 2.5 * ARROW.length;
  const ends = segmentsOf(line).filter(([a, b]) => distance(a, b) > 0);
  if (ends.length > 0) {
    const [first, last] = [ends[0], ends.at(-1)];
    const heads = isShort ? [] : [arrow(first[0], first[1]), arrow(last[1], last[0])];
    figure.arrows.push(...heads.filter(Boolean));
  }
  figure.codes.push({ ...label, code: measure.code, value: '' });
}

async function figuresOfView(layout, view, measures) {
  const { page, words } = layout;
  const height = page.box.height - HEADING;
  const area = { x: 0, y: 0, width: page.box.width, height: height - layout.captionRoom([view], page.box.width) };
  const ratio = layout.ratio(view, { width: area.width - 2 * ROOM.x, height: area.height - 2 * ROOM.y });
  const extent = layout.extent(view);
  const how = { ratio, ...layout.seen(view) };
  const { file, width, height: high, view: seen } = layout.pictures.ask(extent, how);
  const mask = await layout.pictures.mask(extent, how);
  const [x, y] = [(area.width - width) / 2, (area.height - high) / 2];
  const garment = { covers: (px, py) => mask.covers(px - x, py - y) };
  const onPaper = (point) => {
    const [px, py] = seen.paperOf(point);
    return [px + x, py + y];
  };
  const sizes = layout.measure(measures.map(({ code }) => ({ kind: 'code', text: code, value: '', width: 0 })));
  const byId = new Map(measures.map((measure) => [measure.id, measure]));
  let left = measures.map((measure, i) => dimensionOf(measure, onPaper, sizes[i]));
  const sections = [];
  while (left.length > 0) {
    const { drawn, rest } = placeDimensions(left, { area, garment });
    if (drawn.length === 0) {
      for (const { id } of left)
        layout.warn('W_SHEET_FIT', `spec.measures[${id}]: its line finds no room in the view "${view.name}"; it is in the table alone`, `/measures/${id}`);
      break;
    }
    const figure = emptyFigure(page.box.width, height);
    figure.pictures.push({ file, x, y, width, height: high, alt: layout.altOf(view, ratio), round: false, frame: false });
    for (const each of drawn) draw(figure, each, byId.get(each.id));
    // Close beneath what is lowest: the garment, a line or a code.
    const low = Math.max(y + high, ...figure.lines.flatMap(({ points }) => points.map(([, py]) => py)), ...figure.codes.map((code) => code.y + code.height));
    figure.captions.push(layout.caption(view, ratio, { x: 0, y: Math.min(low, area.height) + CAPTION_GAP, width: area.width }));
    const note = sections.length === 0 ? layout.titleOf(view) : `${layout.titleOf(view)} (${words('continued')})`;
    sections.push({ kind: 'figure', break: true, title: words('measures'), note, figure });
    left = rest;
  }
  return sections;
}

/** What a row prints of the spec, and what it is told where that is another length. */
function printedRow(layout, measure) {
  const { spec } = layout;
  const print = (length, key, isMost, size) => {
    if (length === undefined) return undefined;
    const printed = printedOf(length, spec, isMost);
    if (!printed.isKept) layout.roundedAt(['measures', measure.id, ...key], length, printed, key[0] === 'grade' ? ` of size ${JSON.stringify(size)}` : '');
    return printed;
  };
  const lengths = new Map(
    spec.header.sizes.map((size) => {
      const key = Object.hasOwn(measure.values, size) ? ['values', size] : ['grade'];
      return [size, print(specifiedIn(measure, size, spec.header), key, false, size)];
    }),
  );
  return { measure, tolerance: print(measure.tolerance, ['tolerance'], true), lengths };
}

/** Decimals that all of a column's lengths have, so that they stand beneath each other. @param {(import('../units.mjs').Printed | undefined)[]} list */
const digitsOf = (list) => Math.max(0, ...list.map((printed) => printed?.digits ?? 0));

/** A row of the table: what is specified by size, what the model measures, and how far that is off. */
function rowOf(layout, { measure, tolerance, lengths }, { hasHow, isMeasured, sizes, digits }) {
  const { spec } = layout;
  const { baseSize } = spec.header;
  const unit = spec.printedUnits;
  const text = (printed, least) => (printed === undefined ? '' : printedText(printed, least));
  const base = specifiedIn(measure, baseSize, spec.header);
  const difference = measure.length === undefined || base === undefined ? undefined : measure.length - millimetresOf(base, spec.units);
  const most = measure.tolerance === undefined ? undefined : millimetresOf(measure.tolerance, spec.units);
  const isOut = difference !== undefined && most !== undefined && Math.abs(difference) > most + 1e-6;
  const cells = [{ kind: 'strong', text: measure.code }, measure.description];
  if (hasHow) cells.push(measure.how ?? '');
  cells.push(text(tolerance, digits.tolerance));
  for (const size of sizes) {
    const shown = text(lengths.get(size), digits.lengths);
    cells.push(size === baseSize ? { kind: 'strong', text: shown } : shown);
  }
  if (isMeasured) {
    const shown = difference === undefined ? '' : differenceText(difference, unit);
    cells.push(measure.length === undefined ? '' : lengthText(measure.length, unit), isOut ? { kind: 'out', text: shown } : shown);
  }
  return { changed: layout.isChanged('measures', measure.id), cells };
}

/** Most sizes in one table. */
const SIZES = { wide: 12, upright: 7 };

/** The table, or several where there are many sizes. */
function tablesOf(layout, measures) {
  const { spec, words, page } = layout;
  const hasHow = measures.some(({ how }) => how);
  const measured = measures.some(({ length }) => length !== undefined);
  const lists = shared(spec.header.sizes, page.isWide ? SIZES.wide : SIZES.upright);
  const note = `${words('units')} ${words(`unit.${spec.printedUnits}`)}`;
  const told = measured && spec.header.baseSize ? `${note}. ${words('measured.note', { size: spec.header.baseSize })}` : note;
  const codes = measures.map(({ code }) => code);
  const printed = measures.map((measure) => printedRow(layout, measure));
  const digits = { tolerance: digitsOf(printed.map(({ tolerance }) => tolerance)), lengths: digitsOf(printed.flatMap(({ lengths }) => [...lengths.values()])) };
  return lists.map((sizes, i) => {
    // What was measured stands beside the base size.
    const isMeasured = measured && (sizes.includes(spec.header.baseSize) || (spec.header.baseSize === undefined && i === 0));
    const own = { hasHow: hasHow && i === 0, isMeasured, sizes, digits };
    const columns = [
      column(words('code'), { width: widthFor({ name: '' }, codes) }),
      column(words('description'), { width: 3 }),
      ...(own.hasHow ? [column(words('how'), { width: 4 })] : []),
      column(words('tolerance'), { number: true }),
      ...sizes.map((size) => column(size, { width: size.length > 8 ? 0.8 : 0, number: true, strong: size === spec.header.baseSize })),
      ...(isMeasured ? [column(words('measured'), { number: true }), column(words('difference'), { number: true })] : []),
    ];
    const title = i === 0 ? words('measures.table') : `${words('measures.table')} (${words('continued')})`;
    return { kind: 'table', break: true, title, note: told, columns, rows: printed.map((row) => rowOf(layout, row, own)) };
  });
}

export async function measurePages(layout) {
  const { spec } = layout;
  if (spec.measures.length === 0) return [];
  const measures = [];
  for (const [id, measure] of spec.measures.entries()) measures.push({ ...measure, id, ...(await layout.lengthOf(measure, id)) });
  const pages = [];
  for (const view of spec.views) {
    const own = measures.filter(({ view: name, path }) => name === view.name && path);
    if (own.length > 0) pages.push(...(await figuresOfView(layout, view, own)));
  }
  layout.measured = measures;
  return [...pages, ...tablesOf(layout, measures)];
}
