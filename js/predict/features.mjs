import { isNamedEnvironment } from '../shot/table/environments.mjs';
import { outlinePixels } from './outline_area.mjs';

/** What of a scene decides how far a setting is off and what it costs, known before it is drawn. */

/** Kinds of surface by the features of their programs and the passes that draw them, the first that fits: the hardest of a scene decides. */
const SURFACES = {
  cut: ['alpha-mask', 'alpha-to-coverage', 'blend'],
  facets: ['normal-facets'],
  stretched: ['weave', 'anisotropy'],
  napped: ['sheen'],
  relief: ['normal-map', 'bump-map'],
};

/**
 * @typedef {object} Features
 * @property {string} shading - Its base.
 * @property {'cut' | 'facets' | 'stretched' | 'napped' | 'relief' | 'smooth'} surface
 * @property {'none' | 'studio' | 'file'} environment
 * @property {boolean} shadows - Whether a lamp casts them.
 * @property {number} triangles
 * @property {number} pixels - Of the picture.
 * @property {number} covered - Those that the model covers, at most.
 * @property {boolean} traceable - Whether the tracer shows what the raster does.
 */

/**
 * @param {object} resolved shot
 * @param {{features: string[], passes?: string[], fragments?: number, traceable?: boolean}} plan of inspect()
 * @param {{triangles: number, outline?: number[][]}} facts of the model
 * @returns {Features}
 */
export function featuresOf(resolved, { features, passes = [], fragments = Infinity, traceable = true }, { triangles, outline = [] }) {
  const { shading, environment, lights, size, layers, camera, lens } = resolved;
  const has = (names) => names.some((name) => features.includes(name) || passes.includes(name));
  const { map } = environment;
  const pixels = size.width * size.height;
  return {
    shading: shading.base ?? shading,
    surface: Object.keys(SURFACES).find((kind) => has(SURFACES[kind])) ?? 'smooth',
    environment: isNamedEnvironment(map) ? map : 'file',
    shadows: lights.some(({ castShadow }) => castShadow),
    triangles,
    pixels,
    covered: Math.round(Math.min(pixels, fragments, outline.length > 2 ? outlinePixels(outline, camera, size) : Infinity)),
    // A lens that blurs is the tracer's alone.
    traceable: traceable && layers.length === 1 && !lens?.focusDistance,
  };
}
