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
uniform mat4 viewMatrix;
#endif

Reflected indirectLight(SurfaceInfo s) {
  Reflected sum = Reflected(vec3(0.0), vec3(0.0));
#if AMBIENT || HEMISPHERE_LIGHTS > 0 || ENVIRONMENT
  Scattering dielectric = multipleScattering(vec3(F0_DIELECTRIC), 1.0, s.dfg);
#endif
#if AMBIENT || HEMISPHERE_LIGHTS > 0
  vec3 irradiance = vec3(0.0);
#if AMBIENT
  irradiance += ambientIrradiance;
#endif
#if HEMISPHERE_LIGHTS > 0
  for (int i = 0; i < HEMISPHERE_LIGHTS; ++i) {
    irradiance += hemisphereIrradiance(hemisphereSky[i], hemisphereGround[i], dot(s.n, hemisphereUp[i]));
  }
#endif
  sum.diffuse += irradiance * Fd_Lambert(s.diffuse) * diffuseShare(dielectric);
#endif
#if ENVIRONMENT
  vec3 worldNormal = normalize(vec3(vec4(s.n, 0.0) * viewMatrix));
  vec3 environmentIrradiance =
      PI * textureLod(environmentMap, environmentRotation * worldNormal, environmentMaxLod).rgb * environmentIntensity;
  vec3 direction = dominantReflection(s.perceptualRoughness, s.n, s.v);
  direction = normalize(vec3(vec4(direction, 0.0) * viewMatrix));
  vec3 radiance = textureLod(environmentMap, environmentRotation * direction,
                             lodFromRoughness(s.perceptualRoughness, environmentMaxLod)).rgb * environmentIntensity;
  Scattering metal = multipleScattering(s.baseColor, 1.0, s.dfg);
  vec3 meanRadiance = environmentIrradiance * RECIPROCAL_PI;
  sum.specular += environmentSpecular(mixScattering(dielectric, metal, s.metallic), radiance, meanRadiance);
  sum.diffuse += s.diffuse * diffuseShare(dielectric) * meanRadiance;
#endif
  return sum;
}
