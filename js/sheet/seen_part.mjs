/** Where a view shows a part of the model: of the pixels in which it is seen, the one that a line points to. Pure. */

/**
 * How far each pixel is from the nearest one that is not seen, up to `most`: steps to one of eight neighbours. With a rim, which is not seen.
 * @returns {Uint16Array} rows of `width` + 2
 */
function clearances(seen, { width, height }, most) {
  const row = width + 2;
  const clear = new Uint16Array(row * (height + 2));
  for (let i = 0; i < seen.length; ++i) if (seen[i]) clear[row * (Math.floor(i / width) + 1) + (i % width) + 1] = most;
  const relax = (i, side) => {
    if (clear[i] > 0)
      clear[i] = Math.min(clear[i], 1 + Math.min(clear[i - side], clear[i - side * (row + 1)], clear[i - side * row], clear[i - side * (row - 1)]));
  };
  for (let i = row; i < clear.length - row; ++i) relax(i, 1);
  for (let i = clear.length - row - 1; i >= row; --i) relax(i, -1);
  return clear;
}

/**
 * The pixel nearest to the middle of those that are seen, off their edge by so many pixels. Of what is narrower, off it as far as there is room: to a
 * pixel, by which the edges of a band vary.
 * @param {ArrayLike<boolean | number>} seen row by row
 * @param {{width: number, height: number}} size
 * @param {number} most
 * @returns {[number, number] | undefined} undefined where none is seen
 */
export function middlePixel(seen, size, most) {
  const row = size.width + 2;
  const clear = clearances(seen, size, most + 1);
  let [widest, count, x, y] = [0, 0, 0, 0];
  for (let i = 0; i < clear.length; ++i) {
    if (clear[i] === 0) continue;
    widest = Math.max(widest, clear[i]);
    count += 1;
    x += i % row;
    y += Math.floor(i / row);
  }
  if (count === 0) return undefined;
  const enough = Math.max(1, widest - 1);
  const best = { distance: Infinity, at: 0 };
  for (let i = 0; i < clear.length; ++i) {
    if (clear[i] < enough) continue;
    const distance = Math.hypot((i % row) - x / count, Math.floor(i / row) - y / count);
    if (distance < best.distance) Object.assign(best, { distance, at: i });
  }
  return [(best.at % row) - 1, Math.floor(best.at / row) - 1];
}
