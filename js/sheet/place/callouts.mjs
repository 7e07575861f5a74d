import { linesCross } from './geometry.mjs';
import { spread, stacked } from './stack.mjs';

/**
 * Boundary labelling: texts in two columns beside a picture, with a line from each to its place (its site) in the picture. No two
 * lines cross (Bekos, Kaufmann, Symvonis & Wolff 2007, "Boundary labeling: models and efficient algorithms for rectangular maps").
 * A line is level beside its text, then straight to the site. Lengths are millimetres, y down.
 *
 * @typedef {import('./geometry.mjs').Point} Point
 * @typedef {{id: string | number, site: Point, width: number, height: number, side?: 'left' | 'right'}} Label
 * @typedef {object} Columns
 * @property {number} height - Of both columns, whose tops are at 0.
 * @property {{x: number, width: number}} left
 * @property {{x: number, width: number}} right
 * @property {number} gap - Least gap between two texts.
 * @property {number} port - From the top of a text to where its line begins.
 * @property {number} pad - White between a text and its line.
 * @property {number} stub - From a column to where its lines leave the level; every site lies further in than that.
 */

/** Where the line of a text begins, and where its level part ends. */
function portOf(side, { pad, stub, [side]: { x, width } }, y) {
  const [edge, inwards] = side === 'left' ? [x + width, 1] : [x, -1];
  return [
    [edge + inwards * pad, y],
    [edge + inwards * stub, y],
  ];
}

/**
 * The order, from the top, in which the lines from given ports to the sites do not cross: each port takes the site above whose line
 * no other site lies, so that all further lines stay beneath it.
 */
function orderFor(side, labels, columns) {
  const left = [...labels];
  const ordered = [];
  // Equal gaps: where a port is depends on the heights above it alone.
  const wide = labels.length > 1 ? (columns.height - labels.reduce((sum, { height }) => sum + height, 0)) / (labels.length - 1) : 0;
  let top = 0;
  while (left.length > 0) {
    const [, [x, y]] = portOf(side, columns, top + columns.port);
    const slope = ({ site }) => (site[1] - y) / Math.abs(site[0] - x);
    const far = ({ site }) => Math.abs(site[0] - x);
    const first = left.reduce((best, label) => (slope(label) < slope(best) || (slope(label) === slope(best) && far(label) < far(best)) ? label : best));
    left.splice(left.indexOf(first), 1);
    ordered.push(first);
    top += first.height + wide;
  }
  return ordered;
}

function drawn(side, labels, tops, columns) {
  const { x, width: room } = columns[side];
  return labels.map(({ id, site, width, height }, i) => {
    const [port, bend] = portOf(side, columns, tops[i] + columns.port);
    // A narrow text stands beside its line.
    return { id, side, x: side === 'left' ? x + room - width : x, y: tops[i], width, height, leader: [port, bend, site] };
  });
}

const anyCross = (placed) => placed.some((a, i) => placed.slice(i + 1).some((b) => linesCross(a.leader, b.leader)));

/** The texts of one column, near to their sites where that leaves no crossing, else over the whole column. */
function column(side, labels, columns) {
  const near = (order) => {
    const tops = stacked(
      order.map(({ height, site }) => ({ height, wanted: site[1] - columns.port })),
      columns,
    );
    return tops && drawn(side, order, tops, columns);
  };
  const plain = near([...labels].sort((a, b) => a.site[1] - b.site[1]));
  if (!plain || !anyCross(plain)) return plain;
  const order = orderFor(side, labels, columns);
  const nearer = near(order);
  return anyCross(nearer) ? drawn(side, order, spread(order, columns), columns) : nearer;
}

const heightOf = (labels, { gap }) => labels.reduce((sum, { height }) => sum + height + gap, -gap);
const fits = (labels, columns) => heightOf(labels, columns) <= columns.height + 1e-9;

/**
 * Which side each text goes to: as wished, else by its site, shared out where a column is full. Those of free choice are split by
 * one upright line, so that their lines cannot cross over it.
 * @returns {{left: Label[], right: Label[]} | undefined} undefined where they do not fit
 */
function sides(labels, columns) {
  const wished = (side) => labels.filter((label) => label.side === side);
  const free = labels.filter(({ side }) => !side).sort((a, b) => a.site[0] - b.site[0]);
  const middle = (columns.left.x + columns.left.width + columns.right.x) / 2;
  const natural = free.filter(({ site }) => site[0] < middle).length;
  const splits = Array.from({ length: free.length + 1 }, (_, i) => i).sort((a, b) => Math.abs(a - natural) - Math.abs(b - natural) || a - b);
  for (const split of splits) {
    const left = [...wished('left'), ...free.slice(0, split)];
    const right = [...wished('right'), ...free.slice(split)];
    if (fits(left, columns) && fits(right, columns)) return { left, right };
  }
  return undefined;
}

function placedOn(both, columns) {
  const left = column('left', both.left, columns);
  const right = column('right', both.right, columns);
  return left && right && [...left, ...right];
}

/**
 * Places as many of the texts, in their order, as fit beside one picture.
 * @param {Label[]} labels
 * @param {Columns} columns
 * @returns {{placed: {id: string | number, side: 'left' | 'right', x: number, y: number, width: number, height: number, leader: Point[]}[],
 *   rest: Label[], moved: (string | number)[]}} rest: those that need another picture; moved: those whose wish for a side would have
 *   made lines cross, or left no room
 */
export function placeCallouts(labels, columns) {
  let [some, none] = [labels.length, 0];
  // The most, from the first on, that fit: fewer always do.
  const free = labels.map(({ side, ...label }) => label);
  while (none < some) {
    const count = Math.ceil((none + some) / 2);
    if (sides(free.slice(0, count), columns)) none = count;
    else some = count - 1;
  }
  const shown = labels.slice(0, none);
  const rest = labels.slice(none);
  for (const given of [shown, free.slice(0, none)]) {
    const both = sides(given, columns);
    const placed = both && placedOn(both, columns);
    if (placed && !anyCross(placed)) return { placed, rest, moved: given === shown ? [] : movedFrom(shown, placed) };
  }
  throw new Error(`no layout of ${none} call-outs`);
}

const movedFrom = (labels, placed) => labels.filter(({ id, side }) => side && placed.find((label) => label.id === id).side !== side).map(({ id }) => id);
