// Light of one direction. Facets that are told one by one take it later, all lights at each place (light/facets.glsl).
#define FACET_LIGHTS (POINT_LIGHTS + SPOT_LIGHTS + DIRECTIONAL_LIGHTS)
#if FACETS && FACET_LIGHTS > 0
int facetLights = 0;  // so far: a spot has none beside its cone
vec3 facetLightDirection[FACET_LIGHTS];
vec3 facetLightColor[FACET_LIGHTS];
bool facetLightIsSun[FACET_LIGHTS];
#endif

Reflected addLight(Reflected sum, SurfaceInfo s, vec3 l, vec3 lightColor) {
#if FACETS && FACET_LIGHTS > 0
  facetLightDirection[facetLights] = l;
  facetLightColor[facetLights] = lightColor;
  facetLightIsSun[facetLights] = false;
  ++facetLights;
#endif
  return addPunctual(sum, s, l, lightColor);
}

// Light of suns that comes through a surface: ambient visibility of the side where it enters hides it.
#define SUNS_THROUGH (SUNS > 0 && SHADING_FABRIC && AMBIENT_VISIBILITY && DIFFUSE_TRANSMISSION)
#if SUNS_THROUGH
vec3 sunsThrough = vec3(0.0);  // radiance so far, of that of addSun()
#endif

#if SUNS > 0
// Light of a sun, which was taken out of the environment: what hides the environment from a surface hides it too.
Reflected addSun(Reflected sum, SurfaceInfo s, vec3 l, vec3 lightColor) {
  sum = addLight(sum, s, l, lightColor);
#if FACETS
  facetLightIsSun[facetLights - 1] = true;
#endif
#if SUNS_THROUGH
  sunsThrough += lightThrough(s, l, lightColor);
#endif
  return sum;
}
#endif
#if FACETS && FACET_LIGHTS > 0
#include "light/facets.glsl"
#endif
