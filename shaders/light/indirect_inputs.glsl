// What light/indirect.glsl reads of the renderer; of three.js: js/three/shading/host.glsl.
#if AMBIENT
uniform vec3 ambientIrradiance;  // linear Rec.709
#endif
#if HEMISPHERE_LIGHTS > 0
uniform vec3 hemisphereUp[HEMISPHERE_LIGHTS];  // view space, unit
uniform vec3 hemisphereSky[HEMISPHERE_LIGHTS];
uniform vec3 hemisphereGround[HEMISPHERE_LIGHTS];
#endif
#if ENVIRONMENT
uniform samplerCube environmentMap;       // level k prefiltered for roughness 1 - sqrt(1 - k / environmentMaxLod)
uniform float environmentMaxLod;
uniform float environmentIntensity;
uniform mat3 environmentRotation;         // world to environment
#endif
#if ENVIRONMENT || TRANSMISSION
uniform mat4 viewMatrix;
#endif

#if HEMISPHERE_LIGHTS > 0
HemisphereLight hemisphereLight(int i) { return HemisphereLight(hemisphereUp[i], hemisphereSky[i], hemisphereGround[i]); }
#endif

#if ENVIRONMENT && ENVIRONMENT_SAMPLES == 0
// Prefiltered radiance.   world  unit
vec3 environmentTexel(vec3 world, float lod) {
  return textureLod(environmentMap, environmentRotation * world, lod).rgb * environmentIntensity;
}
#endif
