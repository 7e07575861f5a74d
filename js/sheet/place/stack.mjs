/**
 * Boxes of given heights in a column, in their order, each as near to where it wants to be as the others let it: the least sum of
 * squared displacements, by pooling neighbours that push each other (isotonic regression; Barlow & Brunk 1972).
 * @param {{height: number, wanted: number}[]} items wanted: where its top wants to be
 * @param {{height: number, gap: number}} column
 * @returns {number[] | undefined} their tops; undefined where they do not fit
 */
export function stacked(items, { height, gap }) {
  const total = items.reduce((sum, item) => sum + item.height, 0) + gap * Math.max(0, items.length - 1);
  if (total > height + 1e-9) return undefined;
  let above = 0;
  const before = items.map((item) => {
    const here = above;
    above += item.height + gap;
    return here;
  });
  const pools = [];
  items.forEach(({ wanted }, i) => {
    pools.push({ mean: wanted - before[i], count: 1 });
    while (pools.length > 1 && pools.at(-2).mean > pools.at(-1).mean) {
      const [p, q] = pools.splice(-2);
      const count = p.count + q.count;
      pools.push({ mean: (p.mean * p.count + q.mean * q.count) / count, count });
    }
  });
  const room = Math.max(0, height - total);
  const shifts = pools.flatMap(({ mean, count }) => Array(count).fill(Math.min(room, Math.max(0, mean))));
  return shifts.map((shift, i) => shift + before[i]);
}

/** The same with equal gaps over the whole column. */
export function spread(items, { height, gap }) {
  const total = items.reduce((sum, item) => sum + item.height, 0);
  if (total + gap * Math.max(0, items.length - 1) > height + 1e-9) return undefined;
  const wide = items.length > 1 ? (height - total) / (items.length - 1) : 0;
  let above = 0;
  return items.map((item) => {
    const here = above;
    above += item.height + wide;
    return here;
  });
}
