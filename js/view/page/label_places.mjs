/** Pixels of the screen: from a point to the side of a label beside it, and to the line on which its text stands. */
const BESIDE = 9;
const ABOVE = -7;
const BELOW = 16;

/** How far letters of 12 px reach above that line and below it. */
const ASCENT = 11;
const DESCENT = 3;

/** A mark of a point reaches so far. */
const POINT = 6;

/** @returns {number[]} left, top, right, bottom */
const boxOf = ([x, y], width) => [x, y - ASCENT, x + width, y + DESCENT];

const shared = ([left, top, right, bottom], other) =>
  Math.max(0, Math.min(right, other[2]) - Math.max(left, other[0])) * Math.max(0, Math.min(bottom, other[3]) - Math.max(top, other[1]));

/**
 * Where labels stand: beside one of their points, to the right or to the left of it, above or below, where they cover no point and no label before
 * them and lie within the picture. Where there is no such place, where least is covered. Pixels of the screen.
 *
 * @param {{points: number[][], width: number}[]} labels - The first ones choose first; a point is [x, y] and there is one at least.
 * @param {number[][]} points - Those of all marks.
 * @param {number[]} picture - Width and height.
 * @returns {number[][]} [x, y] at which the text of each begins.
 */
export function labelPlaces(labels, points, [width, height]) {
  const taken = points.map(([x, y]) => [x - POINT, y - POINT, x + POINT, y + POINT]);
  return labels.map(({ points: own, width: wide }) => {
    const covered = (place) => {
      const box = boxOf(place, wide);
      const outside = wide * (ASCENT + DESCENT) - shared(box, [0, 0, width, height]);
      return taken.reduce((sum, other) => sum + shared(box, other), outside);
    };
    let best = { area: Infinity };
    for (const place of own.flatMap((point) => placesBeside(point, wide))) {
      const area = covered(place);
      if (area < best.area) best = { place, area };
    }
    taken.push(boxOf(best.place, wide));
    return best.place;
  });
}

const placesBeside = ([x, y], width) => [
  [x + BESIDE, y + ABOVE],
  [x + BESIDE, y + BELOW],
  [x - BESIDE - width, y + ABOVE],
  [x - BESIDE - width, y + BELOW],
];
