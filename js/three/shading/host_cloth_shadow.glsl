// After three.js's own points in the shadow maps (shaders/shadow/coords.glsl). With its reversed depth buffer depth grows towards the
// light, and its own points stay.
#if defined(USE_SHADOWMAP) && !defined(USE_REVERSED_DEPTH_BUFFER)
#if NUM_DIR_LIGHT_SHADOWS > 0
#pragma unroll_loop_start
for (int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i++) {
  vDirectionalShadowCoord[i] = directionalShadowMatrix[i] * offsetToLight(worldPosition, shadowWorldNormal * directionalLightShadows[i].shadowNormalBias, toFlatLight(directionalShadowMatrix[i], worldPosition));
}
#pragma unroll_loop_end
#endif
#if NUM_SPOT_LIGHT_SHADOWS > 0
#pragma unroll_loop_start
for (int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i++) {
  vSpotLightCoord[i] = spotLightMatrix[i] * offsetToLight(worldPosition, shadowWorldNormal * spotLightShadows[i].shadowNormalBias, toFlatLight(spotLightMatrix[i], worldPosition));
}
#pragma unroll_loop_end
#endif
#if NUM_POINT_LIGHT_SHADOWS > 0
#pragma unroll_loop_start
for (int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i++) {
  vPointShadowCoord[i] = pointShadowMatrix[i] * offsetToLight(worldPosition, shadowWorldNormal * pointLightShadows[i].shadowNormalBias, -vec3(pointShadowMatrix[i] * worldPosition));
}
#pragma unroll_loop_end
#endif
#endif
