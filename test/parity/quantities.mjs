import { DEBUG_QUANTITIES } from '../../js/shot/table/debug_quantities.mjs';

/** What is left of rounding: of the value, plus a floor. Texture units filter with 8 bits, environments are stored as halfs. */
const UNIT = { share: 0, floor: 1e-4 };
const LIGHT = { share: 1e-3, floor: 2e-5 };
const PICTURE = { share: 0, floor: 1e-3 };

/**
 * Quantities of the shading of one pixel, in the order in which to look for the cause of a difference: each is made of
 * those before it. Names as in the table of debug quantities and in browser/terms.mjs.
 * @type {Record<string, {look: string, rounding: {share: number, floor: number}}>} where to `look` when it is the first that
 *   differs by more than `rounding`.
 */
const TRACED = {
  n: { look: 'camera, transforms, vertex normals, tangent frame, normal map', rounding: UNIT },
  baseColor: { look: 'base colour texture and its colour space, vertex colours, factors, texture coordinates', rounding: UNIT },
  alpha: { look: 'alpha mode, alpha of the base colour texture or of vertex colours', rounding: UNIT },
  metallic: { look: 'metallic-roughness texture (blue), factor', rounding: UNIT },
  perceptualRoughness: { look: 'metallic-roughness texture (green), factor, floor, roughness from the curvature', rounding: UNIT },
  f0: { look: 'ior, specular factor and colour, blend with the metal', rounding: UNIT },
  viewDirection: { look: 'camera, projection, position in view space', rounding: UNIT },
  NoV: { look: 'normal against the view direction: which side is seen, where it is cut off at 0', rounding: UNIT },
  dfg: { look: 'DFG table and how it is read', rounding: UNIT },
  radiance: { look: 'prefiltering, level of detail, rotation or intensity of the environment, anisotropy', rounding: LIGHT },
  irradiance: { look: 'last level of the environment, ambient and hemisphere lights', rounding: LIGHT },
  direct: { look: 'D, V, F, diffuse term, attenuation, shadows, light colours', rounding: LIGHT },
  indirect: { look: 'energy between the bounces, occlusion, sheen, clearcoat, iridescence', rounding: LIGHT },
  transmitted: { look: 'what is drawn behind, refraction, thickness, level of detail, attenuation, dispersion', rounding: LIGHT },
  linear: { look: 'emission, transmission, sum and cover of the layers', rounding: LIGHT },
  encoded: { look: 'exposure, tone mapping, sRGB encoding', rounding: PICTURE },
};

/** The same with what each is. */
export const QUANTITIES = Object.fromEntries(Object.entries(TRACED).map(([name, traced]) => [name, { what: DEBUG_QUANTITIES[name].doc, ...traced }]));

export const QUANTITY_NAMES = Object.keys(QUANTITIES);
