// Light that arrives from everywhere: ambient, hemisphere, environment.
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

#if ENVIRONMENT
// Environment in a view-space direction, prefiltered.
vec3 environmentRadiance(vec3 direction, float lod) {
  vec3 world = normalize(vec3(vec4(direction, 0.0) * viewMatrix));
  return textureLod(environmentMap, environmentRotation * world, lod).rgb * environmentIntensity;
}

// What a GGX lobe of this roughness about n sees.
vec3 specularRadiance(float perceptualRoughness, vec3 n, vec3 v) {
  return environmentRadiance(dominantReflection(perceptualRoughness, n, v),
                             lodFromRoughness(perceptualRoughness, environmentMaxLod));
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
    irradiance += hemisphereIrradiance(hemisphereSky[i], hemisphereGround[i], dot(n, hemisphereUp[i]));
  }
#endif
  return irradiance;
}
#endif

// Light from everywhere that arrives at a surface, linear Rec.709.
struct Incident {
  vec3 irradiance;             // ambient and hemisphere
  vec3 environmentIrradiance;
  vec3 radiance;               // environment, as the lobe of the base layer sees it
};

Incident incidentLight(SurfaceInfo s) {
  Incident incident;
  incident.irradiance = incident.environmentIrradiance = incident.radiance = vec3(0.0);
#if AMBIENT || HEMISPHERE_LIGHTS > 0
  incident.irradiance = domeIrradiance(s.n);
#endif
#if ENVIRONMENT
  incident.environmentIrradiance = PI * environmentRadiance(s.n, environmentMaxLod);
#if ANISOTROPY
  vec3 reflector = bentNormal(s.perceptualRoughness, s.anisotropyStrength, s.n, s.b, s.v);
#else
  vec3 reflector = s.n;
#endif
  incident.radiance = specularRadiance(s.perceptualRoughness, reflector, s.v);
#endif
  return incident;
}

Reflected indirectLight(SurfaceInfo s, Incident incident) {
  Reflected sum = nothingReflected();
#if AMBIENT || HEMISPHERE_LIGHTS > 0 || ENVIRONMENT
  Scattering dielectric = dielectricScattering(s);
#endif
#if AMBIENT || HEMISPHERE_LIGHTS > 0
  sum = addDome(sum, s, dielectric, incident.irradiance);
#endif
#if ENVIRONMENT
#if SHEEN
  float sheenE = sheenAlbedo(s.sheenRoughness, s.NoV);
  float underSheen = 1.0 - max3(s.sheenColor) * sheenE;
#endif
  vec3 f0Metal = s.baseColor;
#if IRIDESCENCE
  f0Metal = mix(f0Metal, s.filmF0Metal, s.iridescence);
#endif
  vec3 meanRadiance = incident.environmentIrradiance * RECIPROCAL_PI;
  Scattering metal = multipleScattering(f0Metal, s.f90, s.dfg);
  vec3 specular = environmentSpecular(mixScattering(dielectric, metal, s.metallic), incident.radiance, meanRadiance);
#if DIFFUSE_ROUGHNESS
  vec3 environmentDiffuse =
      eonAlbedo(s.baseColor, s.diffuseRoughness, s.NoV) * (1.0 - s.metallic) * diffuseShare(dielectric) * meanRadiance;
#else
  vec3 environmentDiffuse = s.diffuse * diffuseShare(dielectric) * meanRadiance;
#endif
#if SHEEN
  sum.sheen += incident.environmentIrradiance * s.sheenColor * sheenE * RECIPROCAL_PI;
  specular *= underSheen;
  environmentDiffuse *= underSheen;
#endif
#if CLEARCOAT
  vec2 coatDfg = texture(dfgMap, vec2(s.clearcoatRoughness, s.clearcoatNoV)).rg;
  sum.coat += specularRadiance(s.clearcoatRoughness, s.coatNormal, s.v) * (vec3(F0_DIELECTRIC) * coatDfg.x + coatDfg.y);
#endif
  sum.specular += specular;
  sum.diffuse += environmentDiffuse;
#endif
  return sum;
}
