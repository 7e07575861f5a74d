import { length, subtract, viewBasis } from './frame.mjs';

/**
 * The soft shadow under a model where no light of the shot casts one: lights from nearly straight above that shine on
 * nothing (intensity 0), so that only the ground shows their shadows.
 *
 * three.js blends the four texels around each of its five taps. A filter that is wide against the texels shows the taps as
 * noise; here the texels are wide instead, and the taps close together. Three maps, each turned against the others, hide
 * the grid, and where all three shadows meet, at the foot of the model, the ground is darkest.
 */
const AZIMUTHS = [0, 120, 240];

/** Degrees above the horizon: higher parts of the model spread a little. */
const ELEVATION = 85;

/** Texels to the length of the ground plan, where it is as narrow as that of a shirt: a texel is a fifth of its width. */
const TEXELS_PER_ASPECT = 6.4;
const [FEWEST, MOST] = [16, 128];

/** Radius in texels, and part of the light that one shadow takes: of three, 7/8 are left to the ground's opacity. */
const FILTER = { radius: 0.6, intensity: 0.5 };

/** Added to the compared depth: what lies on the ground shadows it. There is no acne, as the ground casts nothing. */
const BIASES = { bias: 1e-3, normalBias: 0 };

/** Texels on a side of the map, so that also a narrow model covers several. */
function mapSizeFor([width, height, depth]) {
  // Seen from a few degrees off, an upright sheet has a width too.
  const narrow = Math.max(Math.min(width, depth), 0.1 * height);
  const aspect = narrow > 0 ? Math.max(width, depth) / narrow : 1;
  return Math.round(Math.min(Math.max(TEXELS_PER_ASPECT * aspect, FEWEST), MOST));
}

/**
 * @param {{bounds?: import('./frame.mjs').Bounds}} facts of the model
 * @returns {object[]} lights of a shot, resolved but for the fit of their shadows; none where there is no model
 */
export function contactLights({ bounds }) {
  if (!bounds) return [];
  const extent = subtract(bounds.max, bounds.min);
  const target = bounds.min.map((low, axis) => low + extent[axis] / 2);
  const distance = length(extent) || 1;
  return AZIMUTHS.map((azimuth) => ({
    type: 'directional',
    color: [1, 1, 1],
    intensity: 0,
    position: viewBasis(azimuth, ELEVATION).back.map((direction, axis) => target[axis] + distance * direction),
    target: [...target],
    castShadow: true,
    shadow: { mapSize: mapSizeFor(extent), ...FILTER, ...BIASES },
  }));
}
