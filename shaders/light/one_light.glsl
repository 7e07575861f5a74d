// Light of one direction. Facets that are told one by one take it later, all lights at each place (light/facets.glsl).
#define FACET_LIGHTS (POINT_LIGHTS + SPOT_LIGHTS + DIRECTIONAL_LIGHTS)
#if FACETS && FACET_LIGHTS > 0
int facetLights = 0;  // so far
vec3 facetLightDirection[FACET_LIGHTS];
vec3 facetLightColor[FACET_LIGHTS];
#endif

Reflected addLight(Reflected sum, SurfaceInfo s, vec3 l, vec3 lightColor) {
#if FACETS && FACET_LIGHTS > 0
  facetLightDirection[facetLights] = l;
  facetLightColor[facetLights] = lightColor;
  ++facetLights;
#endif
  return addPunctual(sum, s, l, lightColor);
}
#if FACETS && FACET_LIGHTS > 0
#include "light/facets.glsl"
#endif
