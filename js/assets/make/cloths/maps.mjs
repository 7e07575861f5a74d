/**
 * What textures of one repeat of a field hold, as functions of (u, v) in 0..1, v down, to channels in 0..1.
 * @param {import('./fields.mjs').Field} field
 * @param {number} size - Texels a side.
 * @param {number} threads - Of one repeat.
 */
export const mapPixels = {
  /** Tangent-space normals, +Y up as glTF has it. */
  normal(field, size, threads) {
    const step = threads / size / 2;
    return (u, v) => {
      const [x, y] = [u * threads, v * threads];
      const at = (dx, dy) => field(x + dx * step, y + dy * step).height;
      const n = [-(at(1, 0) - at(-1, 0)) / (2 * step), (at(0, 1) - at(0, -1)) / (2 * step), 1];
      const length = Math.hypot(...n);
      return n.map((c) => 0.5 + (0.5 * c) / length);
    };
  },

  /** Weave map of TELAR_materials_fabric. */
  weave: (field, size, threads) => (u, v) => {
    const { warp, slope, turn } = field(u * threads, v * threads);
    const rise = warp ? -slope : slope; // the warp's axis is the upward one of tangent space
    return [0.5 + 0.5 * Math.cos(turn), 0.5 + 0.5 * Math.sin(turn), 0.5 + (0.5 * rise) / Math.hypot(1, rise), warp];
  },

  /** Colour of the yarn on top, or of the surface. @param {number[][]} [colors] - Of weft and warp, linear. */
  color: (field, size, threads, colors) => (u, v) => {
    const { warp, shade, cover } = field(u * threads, v * threads);
    const color = (colors ? colors[warp] : [shade, shade, shade].flat().slice(-3)).map(encoded);
    return cover === undefined ? color : [...color, cover];
  },

  /** glTF's roughness in green; nothing is metal. */
  roughness: (field, size, threads) => (u, v) => [1, field(u * threads, v * threads).gloss, 0],

  /** White where there is thread, with the net's holes in the alpha channel. */
  cover: (field, size, threads) => (u, v) => [1, 1, 1, field(u * threads, v * threads).cover],
};

const encoded = (c) => (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055);
