/**
 * Differences of single channels, in 1/255, over the pixels of a region.
 * @typedef {object} ChannelFigures
 * @property {number} pixels
 * @property {number} max largest difference of any channel, in 1/255
 * @property {number} mean over pixels of the largest channel difference, in 1/255
 * @property {number} p999 99.9th percentile over pixels of the largest channel difference, in 1/255
 * @property {number} atLeast1 pixels that differ by 1 or more
 * @property {number} atLeast2
 * @property {[number, number] | null} worst pixel of `max`, counted from the top left
 */

/** Largest difference of the four channels at a byte offset. */
export function channelDifference(a, b, offset) {
  let most = 0;
  for (let c = 0; c < 4; c++) most = Math.max(most, Math.abs(a[offset + c] - b[offset + c]));
  return most;
}

/** Counts differences of pixels; its figures are exact. */
export class DifferenceHistogram {
  #counts = new Uint32Array(256);
  #worst = null;
  #max = -1;

  /** @param {number} difference 0..255 @param {number} index of the pixel */
  add(difference, index) {
    this.#counts[difference]++;
    if (difference > this.#max) [this.#max, this.#worst] = [difference, index];
  }

  #above(value) {
    return this.#counts.subarray(value).reduce((sum, count) => sum + count, 0);
  }

  /** @param {number} width of the picture @returns {ChannelFigures} */
  figures(width) {
    const pixels = this.#above(0);
    let p999 = 0;
    while (p999 < 255 && this.#above(p999 + 1) > 0.001 * pixels) p999++;
    return {
      pixels,
      max: Math.max(0, this.#max),
      mean: pixels === 0 ? 0 : this.#counts.reduce((sum, count, difference) => sum + count * difference, 0) / pixels,
      p999,
      atLeast1: this.#above(1),
      atLeast2: this.#above(2),
      worst: this.#worst === null ? null : [this.#worst % width, Math.floor(this.#worst / width)],
    };
  }
}
