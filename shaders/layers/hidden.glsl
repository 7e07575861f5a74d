// How much of the light of lights with a shadow something hides; their uniforms are those of light/punctual.glsl.
float luminanceOf(vec3 color) { return dot(color, vec3(0.2126, 0.7152, 0.0722)); }

// Part of the light of the lights with a shadow that does not arrive: the model hides it, or the surface turns away.
// n  unit, of the surface's side that is seen
float hiddenPart(vec3 n) {
  float sent = 0.0;
  float arrives = 0.0;
#if CUBE_SHADOWS > 0
  for (int i = 0; i < CUBE_SHADOWS; ++i) {
    vec3 toLight = pointPosition[i] + vViewPosition;
    float light = luminanceOf(pointColor[i]) * distanceAttenuation(length(toLight), pointRange[i]);
    sent += light;
    if (dot(n, toLight) > 0.0) arrives += light * cubeShadowVisibility(i);
  }
#endif
#if SPOT_SHADOWS > 0
  for (int i = 0; i < SPOT_SHADOWS; ++i) {
    vec3 toLight = spotPosition[i] + vViewPosition;
    float cone = spotAttenuation(spotOuterCos[i], spotInnerCos[i], dot(safeNormalize(toLight, NO_DIRECTION), spotDirection[i]));
    float light = luminanceOf(spotColor[i]) * cone * distanceAttenuation(length(toLight), spotRange[i]);
    sent += light;
    if (dot(n, toLight) > 0.0) arrives += light * flatShadowVisibility(i);
  }
#endif
#if FLAT_SHADOWS > SPOT_SHADOWS
  for (int i = 0; i < FLAT_SHADOWS - SPOT_SHADOWS; ++i) {
    float light = luminanceOf(directionalColor[i]);
    sent += light;
    if (dot(n, directionalDirection[i]) > 0.0) arrives += light * flatShadowVisibility(SPOT_SHADOWS + i);
  }
#endif
  return sent > 0.0 ? 1.0 - arrives / sent : 0.0;
}
