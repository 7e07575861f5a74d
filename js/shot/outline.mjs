/**
 * The points of a model that lie farthest out: what a camera needs to frame the model itself and not its box.
 * The 98 directions end on the surface of an integer cube, the same as in renderer/asset/scene/outline.cpp, so that browser and
 * server frame alike.
 */
const GRID = 2;
const STEPS = Array.from({ length: 2 * GRID + 1 }, (_, i) => i - GRID);
const onSurface = (direction) => Math.max(...direction.map(Math.abs)) === GRID;
/** One of each opposite pair. */
const inHalf = ([x, y, z]) => x > 0 || (x === 0 && (y > 0 || (y === 0 && z > 0)));
const AXES = STEPS.flatMap((x) => STEPS.flatMap((y) => STEPS.map((z) => [x, y, z]))).filter((d) => onSurface(d) && inHalf(d));

/** Collects points one by one and keeps those that lie farthest out. */
export class Outline {
  #low = AXES.map(() => ({ along: Infinity, point: null }));
  #high = AXES.map(() => ({ along: -Infinity, point: null }));

  /** World space, metres. */
  add(x, y, z) {
    AXES.forEach(([dx, dy, dz], i) => {
      const along = x * dx + y * dy + z * dz;
      if (along > this.#high[i].along) this.#high[i] = { along, point: [x, y, z] };
      if (along < this.#low[i].along) this.#low[i] = { along, point: [x, y, z] };
    });
  }

  /** @returns {[number, number, number][]} without repeats; empty when nothing was added */
  points() {
    const all = AXES.flatMap((_, i) => [this.#high[i].point, this.#low[i].point]).filter((point) => point !== null);
    return [...new Map(all.map((point) => [point.join(), point])).values()];
  }
}
