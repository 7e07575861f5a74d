// What shaders/light reads of three.js: in place of its *_inputs.glsl, behind the types.
#if HEMISPHERE_LIGHTS > 0
HemisphereLight hemisphereLight(int i) {
  return HemisphereLight(hemisphereLights[i].direction, hemisphereLights[i].skyColor, hemisphereLights[i].groundColor);
}
#endif
#if ENVIRONMENT
vec3 environmentTexel(vec3 world, float lod) {
  return textureLod(envMap, envMapRotation * world, lod).rgb * envMapIntensity;
}
#endif
