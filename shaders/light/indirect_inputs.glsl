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
#if THREE_PREFILTER_TERM == THREE_PREFILTER_CUBE
uniform samplerCube environmentMap;       // level k prefiltered for roughness 1 - sqrt(1 - k / environmentMaxLod)
#else
uniform sampler2D environmentMap;         // an atlas
uniform vec2 environmentAtlasTexel;        // 1 / its size
#endif
uniform float environmentMaxLod;          // of the cube's roughest level, of the atlas's sharpest
uniform float environmentIntensity;
#if ENVIRONMENT_SAMPLES == 0
uniform mat3 viewToEnvironment;
#endif
#endif
#if TRANSMISSION
uniform mat4 viewMatrix;
#endif

#if HEMISPHERE_LIGHTS > 0
HemisphereLight hemisphereLight(int i) { return HemisphereLight(hemisphereUp[i], hemisphereSky[i], hemisphereGround[i]); }
#endif

#if ENVIRONMENT && ENVIRONMENT_SAMPLES == 0
// Prefiltered radiance.   direction  view space, any length
#if THREE_PREFILTER_TERM == THREE_PREFILTER_CUBE
vec3 environmentRadiance(vec3 direction, float lod) {
  return textureLod(environmentMap, viewToEnvironment * direction, lod).rgb * environmentIntensity;
}
#else
vec3 environmentRadiance(vec3 direction, float lod) {
  vec3 unit = normalize(viewToEnvironment * direction);
  return atlasRadiance(environmentMap, environmentAtlasTexel, environmentMaxLod, unit, lod) * environmentIntensity;
}
#endif
#endif
