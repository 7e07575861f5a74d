/**
 * Quantities of the shading that can be drawn in place of the colour (`renderQuantity`, the key `debugOutput` of what C++ reads), in the
 * order in which to look for the cause of a difference: each is made of those before it.
 *
 * `of`: what has it, and with it the names that `glsl` may use, an RGB in shaders/debug_output.glsl.
 *   "color"         every material: baseColor (rgb and alpha, linear Rec.709), radiance
 *   "shading"       lit ones: s (SurfaceInfo, vectors in view space), incident, direct, indirect
 *   "transmission"  those that transmit: transmitted
 */
export const DEBUG_QUANTITIES = Object.freeze({
  n: { doc: 'shading normal, view space', of: 'shading', glsl: 's.n' },
  baseColor: { doc: 'base colour, linear', of: 'color', glsl: 'baseColor.rgb' },
  alpha: { doc: 'opacity', of: 'color', glsl: 'vec3(baseColor.a)' },
  metallic: { doc: 'metalness', of: 'shading', glsl: 'vec3(s.metallic)' },
  perceptualRoughness: { doc: 'roughness as shaded: floor and geometric roughness applied', of: 'shading', glsl: 'vec3(s.perceptualRoughness)' },
  f0: { doc: 'reflectance at normal incidence', of: 'shading', glsl: 's.f0' },
  viewDirection: {
    doc: 'direction to the viewer, view space; where it differs in its last bits alone, the driver interpolates otherwise',
    of: 'shading',
    glsl: 's.v',
  },
  NoV: { doc: 'cosine between normal and viewer', of: 'shading', glsl: 'vec3(s.NoV)' },
  dfg: { doc: 'split-sum terms of the environment; of cloth its own table', of: 'shading', glsl: 'vec3(debugDfg(s), 0.0)' },
  radiance: { doc: 'prefiltered environment along the reflection', of: 'shading', glsl: 'incident.radiance' },
  irradiance: {
    doc: 'light from everywhere on the surface: ambient, hemisphere, environment',
    of: 'shading',
    glsl: 'incident.irradiance + incident.environmentIrradiance',
  },
  direct: { doc: 'reflected light of the lights', of: 'shading', glsl: 'debugSum(s, direct)' },
  indirect: { doc: 'reflected light of the environment and its suns, after occlusion', of: 'shading', glsl: 'debugSum(s, indirect)' },
  transmitted: { doc: "light from behind, before the material's weight", of: 'transmission', glsl: 'vec3(transmitted)' },
  linear: { doc: 'radiance before exposure and tone mapping', of: 'color', glsl: 'radiance' },
  encoded: { doc: 'colour as the picture has it, 0..1', of: 'color', glsl: 'outputColor(radiance, 1.0).rgb' },
});
