// What shaders/light reads of three.js: in place of its *_inputs.glsl, behind the types.
#if HEMISPHERE_LIGHTS > 0
HemisphereLight hemisphereLight(int i) {
  return HemisphereLight(hemisphereLights[i].direction, hemisphereLights[i].skyColor, hemisphereLights[i].groundColor);
}
#endif
#if ENVIRONMENT
// direction  view space
vec3 environmentRadiance(vec3 direction, float lod) {
  vec3 world = normalize(vec3(vec4(direction, 0.0) * viewMatrix));
  return textureLod(envMap, envMapRotation * world, lod).rgb * envMapIntensity;
}
#endif
