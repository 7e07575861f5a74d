import * as fields from './fields.mjs';

/**
 * How the cloths of js/assets/fabric_presets.json are made: what their maps are drawn from. Threads a centimetre are those of the preset;
 * `perCm` stands here where a class has no threads (grains, tufts, discs a centimetre).
 *
 * field: the surface; threads: of one repeat; size: texels a side; weave: whether each yarn is a highlight of its own; yarns: colours of
 * weft and warp about their mean, linear; holes: whether light passes between the threads.
 */
export const CONSTRUCTIONS = {
  'cotton-jersey': { field: fields.jersey, threads: 8 },
  denim: {
    field: fields.twill,
    threads: 8,
    weave: true,
    yarns: [
      [0.9, 0.9, 0.9],
      [0.22, 0.22, 0.22],
    ],
  },
  'wool-felt': { field: fields.fibres(16, 1.2), threads: 16, perCm: [10, 10] },
  towel: { field: fields.terry(8), threads: 8 },
  velvet: { field: fields.fibres(16, 0.8), threads: 16, perCm: [20, 20] },
  satin: { field: fields.satinWeave, threads: 8, weave: true },
  silk: { field: fields.habotai, threads: 8, weave: true },
  leather: { field: fields.pebbles(10), threads: 10, perCm: [9, 9] },
  'waxed-cotton': { field: fields.plainWeave, threads: 8 },
  'nylon-shell': { field: fields.calendered, threads: 8, weave: true },
  tulle: { field: fields.net(0.2), threads: 4, holes: true },
  lace: { field: fields.laceFlowers(8), threads: 8, perCm: [4, 4], holes: true },
  'sequin-thread': { field: fields.sequins(8), threads: 8, perCm: [2.5, 2.5] },
};
