// Light that arrives from one direction: point, spot and directional lights, and the suns of an environment.
// View space; colours are linear Rec.709 times intensity (candela, candela, lux).
#if POINT_LIGHTS > 0
uniform vec3 pointPosition[POINT_LIGHTS];
uniform vec3 pointColor[POINT_LIGHTS];
uniform float pointRange[POINT_LIGHTS];
#endif
#if SPOT_LIGHTS > 0
uniform vec3 spotPosition[SPOT_LIGHTS];
uniform vec3 spotDirection[SPOT_LIGHTS];  // from the target to the light
uniform vec3 spotColor[SPOT_LIGHTS];
uniform float spotRange[SPOT_LIGHTS];
uniform float spotOuterCos[SPOT_LIGHTS];
uniform float spotInnerCos[SPOT_LIGHTS];
#endif
#if DIRECTIONAL_LIGHTS > 0
uniform vec3 directionalDirection[DIRECTIONAL_LIGHTS];  // to the light
uniform vec3 directionalColor[DIRECTIONAL_LIGHTS];
#endif

#include "light/one_light.glsl"
#if POINT_LIGHTS + SPOT_LIGHTS + DIRECTIONAL_LIGHTS > 0
// The direction to a light at the shaded point itself is 0: the light gives nothing there.
const vec3 NO_DIRECTION = vec3(0.0);

Reflected punctualLight(SurfaceInfo s) {
  Reflected sum = nothingReflected();
#if POINT_LIGHTS > 0
  for (int i = 0; i < POINT_LIGHTS; ++i) {
    vec3 toLight = pointPosition[i] + vViewPosition;
    vec3 color = pointColor[i] * distanceAttenuation(length(toLight), pointRange[i]);
#if CUBE_SHADOWS > 0
    color *= cubeShadowVisibility(i);
#endif
    sum = addLight(sum, s, safeNormalize(toLight, NO_DIRECTION), color);
  }
#endif
#if SPOT_LIGHTS > 0
  for (int i = 0; i < SPOT_LIGHTS; ++i) {
    vec3 toLight = spotPosition[i] + vViewPosition;
    vec3 l = safeNormalize(toLight, NO_DIRECTION);
    float cone = spotAttenuation(spotOuterCos[i], spotInnerCos[i], dot(l, spotDirection[i]));
    if (cone > 0.0) {
      vec3 color = spotColor[i] * cone * distanceAttenuation(length(toLight), spotRange[i]);
#if SPOT_SHADOWS > 0
      if (i < SPOT_SHADOWS) color *= flatShadowVisibility(i);
#endif
      sum = addLight(sum, s, l, color);
    }
  }
#endif
#if DIRECTIONAL_LIGHTS > 0
  for (int i = 0; i < DIRECTIONAL_LIGHTS - SUNS; ++i) {
    vec3 color = directionalColor[i];
#if FLAT_SHADOWS > SPOT_SHADOWS
    if (i < FLAT_SHADOWS - SPOT_SHADOWS) color *= flatShadowVisibility(SPOT_SHADOWS + i);
#endif
    sum = addLight(sum, s, directionalDirection[i], color);
  }
#endif
  return sum;
}

#if SUNS > 0
// Of the suns, which are the last directional lights.
Reflected sunLight(SurfaceInfo s) {
  Reflected sum = nothingReflected();
  for (int i = DIRECTIONAL_LIGHTS - SUNS; i < DIRECTIONAL_LIGHTS; ++i) sum = addSun(sum, s, directionalDirection[i], directionalColor[i]);
  return sum;
}
#endif
#endif
