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

#if SHADING_FABRIC && ENVIRONMENT && ENVIRONMENT_SAMPLES == 0
// The same of cloth.   f0  [0, 1]      bending  perceptual roughness by which the lobe is bent
vec3 glossRadiance(float perceptualRoughness, float bending, float f0, vec3 n, vec3 v, float NoV) {
  return environmentRadiance(dominantReflection(bending, n, v), lobeLod(prefilteredRoughness(perceptualRoughness, f0, NoV)));
}
#endif

#if SHADING_FABRIC && SHEEN && ENVIRONMENT && ENVIRONMENT_SAMPLES == 0
// Radiance of the environment over the lobe of the sheen.
vec3 sheenRadiance(SurfaceInfo s) {
  float roughness = max(s.sheenRoughness, CLOTH_SHEEN_ROUGHNESS_MIN);
#if RELIEF
  SheenTaps taps = sheenTaps(s.relief, roughness, s.n, s.v, s.NoV);
#else
  SheenTaps taps = sheenTaps(0.0, roughness, s.n, s.v, s.NoV);
#endif
  float lod = lobeLod(taps.roughness);
  vec3 front = environmentRadiance(taps.front, lod);
  if (taps.aside == 0.0) return front;
  return mix(front, 0.5 * (environmentRadiance(taps.left, lod) + environmentRadiance(taps.right, lod)), 2.0 * taps.aside);
}
#endif

#if SHADING_FABRIC && (ANISOTROPY || WEAVE) && ENVIRONMENT && ENVIRONMENT_SAMPLES == 0
// Radiance of the environment over a GGX lobe of two widths. Where more taps begin they come apart from those before: relief changes
// the widths from pixel to pixel, and a step would show.
vec3 stretchedRadiance(vec3 n, vec3 axis, vec3 v, float wide, float narrow, float f0) {
  float taps = stretchedTaps(wide, narrow);
  float fewer = max(0.5 * taps, 1.0);
  float begun = taps > 2.0 ? saturate((wide / narrow - 1.6) / 0.2) : saturate((wide / narrow - 1.15) / 0.15);
  float roughness = mix(tapRoughness(wide, narrow, fewer), tapRoughness(wide, narrow, taps), begun);
  float lod = lobeLod(prefilteredRoughness(roughness, f0, saturate(dot(n, v))));
  float apart = sqrt(max(pow2(wide) - pow2(narrow), 0.0));  // each tap is as wide as the narrow axis by itself
  vec4 sum = vec4(0.0);
  for (float i = 0.5; i < taps; ++i) {
    float before = 2.0 * (floor(i * fewer / taps) + 0.5) / fewer - 1.0;
    vec4 tap = stretchedTap(n, axis, v, apart, mix(before, 2.0 * i / taps - 1.0, begun));
#if WEAVE
    vec3 l = vec3(tap);  // what widens the lobe of yarns is mostly relief, which bends it little
#else
    vec3 l = mix(vec3(tap), n, pow4(roughness));
#endif
    sum += vec4(environmentRadiance(l, lod), 1.0) * tap.w;
  }
  return vec3(sum) / max(sum.w, 1.0e-4);
}
#endif

#if SHADING_FABRIC && WEAVE && ENVIRONMENT && ENVIRONMENT_SAMPLES == 0
// The same over the lobe of one set of yarns. Relief may make it wider along the yarn than across.
vec3 yarnRadiance(YarnLobe yarn, vec3 v) {
  if (yarn.alphaB < yarn.alphaT) return stretchedRadiance(yarn.n, yarn.t, v, yarn.alphaT, yarn.alphaB, max3(yarn.f0));
  return stretchedRadiance(yarn.n, yarn.b, v, yarn.alphaB, yarn.alphaT, max3(yarn.f0));
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
#if ENVIRONMENT && ENVIRONMENT_SAMPLES == 0
// Texels of a relief that do not lie flat have a mean cosine of 1 - relief - RELIEF_LEANING; relief / (relief + RELIEF_LEANING) of all do
// not. So the mean cosine is the relief's, and that of squares about those of knits and nets.
const float RELIEF_LEANING = 0.15;

// Mean radiance of the environment on the other side of a surface, by the cosine.
vec3 environmentBehind(SurfaceInfo s) {
  float lod = cosineLod();
#if SHADING_FABRIC && RELIEF
  // Some texels of a relief lie flat and some lean, here three ways: light comes through from the sides too.
  float leaning = saturate(20.0 * s.relief - 1.0);
  vec3 behind = environmentRadiance(-s.n, lod);
  if (leaning > 0.0) {
    float upright = max(1.0 - s.relief - RELIEF_LEANING, 0.0);
    mat3 frame = basisAbout(s.n) * sqrt(1.0 - pow2(upright));
    vec3 back = s.n * -upright;
    vec3 x = frame[0];
    vec3 y = frame[1] * 0.8660254;
    vec3 sum = environmentRadiance(back + x, lod) + environmentRadiance(back - 0.5 * x + y, lod) + environmentRadiance(back - 0.5 * x - y, lod);
    behind = mix(behind, sum * (1.0 / 3.0), leaning * s.relief / (s.relief + RELIEF_LEANING));
  }
  return behind;
#else
  return environmentRadiance(-s.n, lod);
#endif
}
#endif

vec3 irradianceBehind(SurfaceInfo s) {
  vec3 irradiance = vec3(0.0);
#if AMBIENT || HEMISPHERE_LIGHTS > 0
  irradiance += domeIrradiance(-s.n);
#endif
#if ENVIRONMENT && ENVIRONMENT_SAMPLES == 0
  irradiance += PI * environmentBehind(s);
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
  incident.behind = irradianceBehind(s);
#endif
#if ENVIRONMENT && ENVIRONMENT_SAMPLES == 0
#if SHADING_FABRIC && NORMAL_MAP
  // A normal that leans takes no light from below the surface.
  vec3 lit = bumpBent(s.geometricNormal, s.n);
#if RELIEF
  lit = reliefBent(s.relief, lit, s.n, s.v, s.NoV);
#endif
  incident.environmentIrradiance = PI * environmentRadiance(lit, cosineLod());
#else
  incident.environmentIrradiance = PI * environmentRadiance(s.n, cosineLod());
#endif
#if SHADING_FABRIC && WEAVE
  incident.radiance = yarnRadiance(s.warp, s.v);
  incident.weftRadiance = yarnRadiance(s.weft, s.v);
#elif SHADING_FABRIC && ANISOTROPY
  incident.radiance = stretchedRadiance(s.n, s.t, s.v, s.alphaT, s.alpha, max3(s.f0));
#elif ANISOTROPY || WEAVE
  vec3 reflector = bentNormal(s.perceptualRoughness, s.anisotropyStrength, s.n, s.b, s.v);
  incident.radiance = specularRadiance(s.perceptualRoughness, reflector, s.v);
#elif SHADING_FABRIC && RELIEF
  // A relief blurs the lobe more than it bends it.
  float bending = roughnessWithSlopes(s.glossRoughness, 0.5 * s.slopeVariance);
#if FACETS
  // The facets' lobe is that of their level, fitted as it is.
  incident.radiance = environmentRadiance(dominantReflection(bending, s.n, s.v), lobeLod(s.perceptualRoughness));
  incident.edgeRadiance = specularRadiance(sqrt(EDGE_ALPHA), s.edges.n, s.v);
#else
  incident.radiance = glossRadiance(s.perceptualRoughness, bending, max3(s.f0), s.n, s.v, s.NoV);
#endif
#elif SHADING_FABRIC
  incident.radiance = glossRadiance(s.perceptualRoughness, s.perceptualRoughness, max3(s.f0), s.n, s.v, s.NoV);
#else
  incident.radiance = specularRadiance(s.perceptualRoughness, s.n, s.v);
#endif
#if SHADING_FABRIC && SHEEN
  incident.sheenRadiance = sheenRadiance(s);
#endif
#if CLEARCOAT && SHADING_FABRIC
  incident.coatRadiance = glossRadiance(s.clearcoatRoughness, s.clearcoatRoughness, F0_DIELECTRIC, s.coatNormal, s.v, s.clearcoatNoV);
#elif CLEARCOAT
  incident.coatRadiance = specularRadiance(s.clearcoatRoughness, s.coatNormal, s.v);
#endif
#endif
  return incident;
}

#if SHADING_FABRIC && AMBIENT_VISIBILITY
#include "light/visible.glsl"
#endif
// suns  what the surface reflects of them: they are a part of the environment
Reflected indirectLight(SurfaceInfo s, Incident incident, Reflected suns) {
  Reflected sum = suns;
#if AMBIENT || HEMISPHERE_LIGHTS > 0
  sum = addDome(sum, s, incident.irradiance);
#endif
#if ENVIRONMENT && ENVIRONMENT_SAMPLES > 0
  sum = addSampledEnvironment(sum, s);
#elif ENVIRONMENT
  sum = addEnvironment(sum, s, incident);
#endif
#if SHADING_FABRIC && AMBIENT_VISIBILITY
#if OCCLUSION_MAP
  // The map and the vertices may tell of the same folds: the darker of them counts. occluded() takes what the map says.
  s.visibility = visibilityBesideMap(s.visibility, diffuseOcclusion(occlusionTexel(), occlusionStrength));
#endif
  sum = visibleLight(sum, s);
#if DIFFUSE_TRANSMISSION
  incident.behind *= s.visibilityBehind;
  // What samples and suns have sent through from the other side is hidden as that side is, not as this one.
#if ENVIRONMENT && ENVIRONMENT_SAMPLES > 0
  sum = addBehind(sum, s, environmentIrradiance(-s.n) * (s.visibilityBehind - multiBounceVisibility(s.visibility, s.diffuse)));
#elif SUNS_THROUGH
  sum.diffuse += sunsThrough * (s.visibilityBehind - multiBounceVisibility(s.visibility, s.diffuse));
#endif
#endif
#endif
#if DIFFUSE_TRANSMISSION
  sum = addBehind(sum, s, incident.behind);
#endif
  return sum;
}
