// Ambient light: ambient and hemisphere lights, and the environment.
#if HEMISPHERE_LIGHTS > 0
struct HemisphereLight {
  vec3 up;      // view space, unit
  vec3 sky;     // irradiance, linear Rec.709
  vec3 ground;
};
#endif
#if ENVIRONMENT && ENVIRONMENT_SAMPLES == 0 && THREE_PREFILTER_TERM != THREE_PREFILTER_CUBE
#include "environment/atlas.glsl"
#include "environment/atlas_levels.glsl"
#endif
#include "light/indirect_inputs.glsl"
#if ENVIRONMENT && ENVIRONMENT_SAMPLES > 0
#include "light/sampled_environment.glsl"
#endif

#if ENVIRONMENT && ENVIRONMENT_SAMPLES == 0
// Environment in a view-space direction, prefiltered.
vec3 environmentRadiance(vec3 direction, float lod) {
  return environmentTexel(normalize(vec3(vec4(direction, 0.0) * viewMatrix)), lod);
}

// Level of the environment for a lobe of this roughness, and for the cosine lobe.
#if THREE_PREFILTER_TERM == THREE_PREFILTER_CUBE
float lobeLod(float perceptualRoughness) { return lodFromRoughness(perceptualRoughness, environmentMaxLod); }
float cosineLod() { return environmentMaxLod; }
#else
float lobeLod(float perceptualRoughness) { return atlasMip(perceptualRoughness); }
float cosineLod() { return ATLAS_MIP_ROUGHEST; }
#endif

// Radiance of the environment over a GGX lobe of this roughness about n.
vec3 specularRadiance(float perceptualRoughness, vec3 n, vec3 v) {
#if THREE_REFLECTION_DIRECTION_TERM == THREE_REFLECTION_DIRECTION_ROUGHNESS_2
  vec3 direction = dominantReflectionByAlpha(perceptualRoughness, n, v);
#else
  vec3 direction = dominantReflection(perceptualRoughness, n, v);
#endif
  return environmentRadiance(direction, lobeLod(perceptualRoughness));
}
#endif

#if AMBIENT || HEMISPHERE_LIGHTS > 0
vec3 domeIrradiance(vec3 n) {
  vec3 irradiance = vec3(0.0);
#if AMBIENT
  irradiance += ambientIrradiance;
#endif
#if HEMISPHERE_LIGHTS > 0
  for (int i = 0; i < HEMISPHERE_LIGHTS; ++i) {
    HemisphereLight light = hemisphereLight(i);
    irradiance += hemisphereIrradiance(light.sky, light.ground, dot(n, light.up));
  }
#endif
  return irradiance;
}
#endif

#if DIFFUSE_TRANSMISSION
vec3 irradianceBehind(vec3 n) {
  vec3 irradiance = vec3(0.0);
#if AMBIENT || HEMISPHERE_LIGHTS > 0
  irradiance += domeIrradiance(-n);
#endif
#if ENVIRONMENT && ENVIRONMENT_SAMPLES == 0
  irradiance += PI * environmentRadiance(-n, cosineLod());
#endif
  return irradiance;
}
#endif

Incident incidentLight(SurfaceInfo s) {
  Incident incident;
  incident.irradiance = incident.environmentIrradiance = incident.radiance = vec3(0.0);
#if CLEARCOAT
  incident.coatRadiance = vec3(0.0);
#endif
#if AMBIENT || HEMISPHERE_LIGHTS > 0
  incident.irradiance = domeIrradiance(s.n);
#endif
#if DIFFUSE_TRANSMISSION
  incident.behind = irradianceBehind(s.n);
#endif
#if ENVIRONMENT && ENVIRONMENT_SAMPLES == 0
  incident.environmentIrradiance = PI * environmentRadiance(s.n, cosineLod());
#if ANISOTROPY || WEAVE
  vec3 reflector = bentNormal(s.perceptualRoughness, s.anisotropyStrength, s.n, s.b, s.v);
#else
  vec3 reflector = s.n;
#endif
  incident.radiance = specularRadiance(s.perceptualRoughness, reflector, s.v);
#if CLEARCOAT
  incident.coatRadiance = specularRadiance(s.clearcoatRoughness, s.coatNormal, s.v);
#endif
#endif
  return incident;
}

Reflected indirectLight(SurfaceInfo s, Incident incident) {
  Reflected sum = nothingReflected();
#if AMBIENT || HEMISPHERE_LIGHTS > 0
  sum = addDome(sum, s, incident.irradiance);
#endif
#if ENVIRONMENT && ENVIRONMENT_SAMPLES > 0
  sum = addSampledEnvironment(sum, s);
#elif ENVIRONMENT
  sum = addEnvironment(sum, s, incident);
#endif
#if DIFFUSE_TRANSMISSION
  sum = addBehind(sum, s, incident.behind);
#endif
  return sum;
}
