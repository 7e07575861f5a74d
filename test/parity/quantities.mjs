/** What is left of rounding: of the value, plus a floor. Texture units filter with 8 bits, environments are stored as halfs. */
const UNIT = { share: 0, floor: 1e-4 };
const LIGHT = { share: 1e-3, floor: 2e-5 };
const PICTURE = { share: 0, floor: 1e-3 };

/**
 * Quantities of the shading of one pixel, in the order in which to look for the cause of a difference: each is made of
 * those before it. Names as telar::DebugOutput and browser/terms.mjs have them.
 * @type {Record<string, {what: string, look: string, rounding: {share: number, floor: number}}>} `what` it is; where to
 *   `look` when it is the first that differs by more than `rounding`.
 */
export const QUANTITIES = {
  n: { what: 'shading normal, view space', look: 'camera, transforms, vertex normals, tangent frame, normal map', rounding: UNIT },
  baseColor: { what: 'base colour, linear', look: 'base colour texture and its colour space, vertex colours, factors, texture coordinates', rounding: UNIT },
  alpha: { what: 'opacity', look: 'alpha mode, alpha of the base colour texture or of vertex colours', rounding: UNIT },
  metallic: { what: 'metalness', look: 'metallic-roughness texture (blue), factor', rounding: UNIT },
  perceptualRoughness: { what: 'roughness as shaded', look: 'metallic-roughness texture (green), factor, floor, roughness from the curvature', rounding: UNIT },
  f0: { what: 'reflectance at normal incidence', look: 'ior, specular factor and colour, blend with the metal', rounding: UNIT },
  NoV: { what: 'normal times view direction', look: 'view direction, projection', rounding: UNIT },
  dfg: { what: 'split-sum terms of the environment', look: 'DFG table and how it is read', rounding: UNIT },
  radiance: { what: 'prefiltered environment along the reflection', look: 'prefiltering, level of detail, rotation or intensity of the environment, anisotropy', rounding: LIGHT },
  irradiance: { what: 'light from everywhere on the surface', look: 'last level of the environment, ambient and hemisphere lights', rounding: LIGHT },
  direct: { what: 'reflected light of the lights', look: 'D, V, F, diffuse term, attenuation, shadows, light colours', rounding: LIGHT },
  indirect: { what: 'reflected light of the environment', look: 'energy between the bounces, occlusion, sheen, clearcoat, iridescence', rounding: LIGHT },
  transmitted: { what: 'light from behind', look: 'what is drawn behind, refraction, thickness, level of detail, attenuation, dispersion', rounding: LIGHT },
  linear: { what: 'radiance before tone mapping', look: 'emission, transmission, sum and cover of the layers', rounding: LIGHT },
  encoded: { what: 'colour as the picture has it, 0..1', look: 'exposure, tone mapping, sRGB encoding', rounding: PICTURE },
};

export const QUANTITY_NAMES = Object.keys(QUANTITIES);
