// The part of a polished relief that lies flat, apart from its edges.
#include "brdf/constants.glsl"
#include "brdf/math.glsl"
#include "brdf/facets.glsl"
#include "texture/relief.glsl"

// RG the slope, A its square, each times the share B of the texel that counts as facet.
// texel  colour of a normal map
vec4 facetOfTexel(vec3 texel) {
  vec2 slope = slopeOfTexel(texel);
  float slope2 = dot(slope, slope);
  return facetShare(slope2) * vec4(slope, 1.0, slope2);
}
