import * as coated from './coated.mjs';
import * as fields from './fields.mjs';
import * as knitted from './knitted.mjs';
import * as napped from './napped.mjs';
import * as woven from './woven.mjs';

/**
 * How the cloths of js/assets/fabric_presets.json are made: what their maps are drawn from. Threads a centimetre are those of the preset;
 * `perCm` stands here where a field is measured otherwise: wales, grains, tufts, discs or, with 10, millimetres.
 *
 * field: the surface; threads: of one repeat; size: texels a side; weave: whether each yarn is a highlight of its own; shaded: whether
 * the surface has colours about its mean; glossy: whether its roughness varies; holes: whether light passes between the threads; sheer:
 * the same where threads are finer than a pixel in any picture of a garment, so that it is blended and has no grain.
 */
export const CONSTRUCTIONS = {
  'cotton-jersey': { field: knitted.singleJersey(24), threads: 24, shaded: true },
  denim: { field: woven.denim(48), threads: 48, size: 384, weave: true, shaded: true },
  'wool-felt': { field: napped.matted(32), threads: 32, perCm: [10, 10], shaded: true },
  towel: { field: napped.terryLoops(16), threads: 16, shaded: true },
  velvet: { field: napped.pile(80), threads: 80, size: 384, perCm: [10, 10], shaded: true },
  satin: { field: fields.satinWeave, threads: 8, weave: true },
  silk: { field: fields.habotai, threads: 8, weave: true },
  leather: { field: coated.grain(20), threads: 20, perCm: [9, 9], shaded: true, glossy: true },
  'waxed-cotton': { field: woven.waxed(64), threads: 64, shaded: true, glossy: true },
  'nylon-shell': { field: woven.ripstop(24), threads: 24, weave: true, shaded: true },
  tulle: { field: fields.net(0.2), threads: 4, holes: true },
  lace: { field: fields.laceFlowers(8), threads: 8, perCm: [4, 4], holes: true },
  'sequin-thread': { field: fields.sequins(8), threads: 8, perCm: [2.5, 2.5] },
  twill: { field: woven.gabardine(36), threads: 36, weave: true, shaded: true },
  linen: { field: woven.linen(48), threads: 48, size: 384, shaded: true },
  tweed: { field: woven.herringbone(32), threads: 32, shaded: true },
  seersucker: { field: woven.seersucker(40, 4), threads: 40, perCm: [10, 10], shaded: true },
  corduroy: { field: napped.cords(8), threads: 8, perCm: [4.3, 4.3], shaded: true },
  'rib-knit': { field: knitted.rib(16), threads: 16, shaded: true },
  'cable-knit': { field: knitted.cable(48), threads: 48, size: 384, shaded: true },
  boucle: { field: napped.boucle(16), threads: 16, perCm: [4, 4], shaded: true },
  fleece: { field: napped.pilled(32), threads: 32, perCm: [10, 10], shaded: true },
  suede: { field: napped.nap(60), threads: 60, size: 384, perCm: [10, 10], shaded: true },
  'patent-leather': { field: coated.lacquer(80), threads: 80, perCm: [10, 10] },
  'quilted-nylon': { field: coated.quilt(2, 14), threads: 2, size: 384, perCm: [0.25, 0.25], shaded: true },
  chiffon: { field: woven.sheer(32, 0.38, 0.14), threads: 32, sheer: true },
  organza: { field: woven.sheer(16, 0.3, 0.02), threads: 16, sheer: true },
  'athletic-mesh': { field: knitted.athletic(8), threads: 8, perCm: [3.6, 3.6], shaded: true, holes: true },
};
