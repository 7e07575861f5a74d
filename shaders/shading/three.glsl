// How the lobes of one surface add up as three.js 0.187 shades it. No uniforms and no textures: also compiled as C++
// (renderer/brdf/shading.h), with every layer on.
// GGX lobe of the base layer, [1/sr].
vec3 specularLobe(SurfaceInfo s, vec3 l, vec3 h, float NoL, float NoH, float LoH) {
#if ANISOTROPY || IRIDESCENCE
  vec3 fresnel = F_Schlick(s.f0, s.f90, LoH);
#if IRIDESCENCE
  fresnel = mix(fresnel, s.filmFresnel, s.iridescence);
#endif
#if ANISOTROPY
  float alphaT = max(s.alphaT, s.alpha);
  float visibility = V_SmithGGXCorrelatedAnisotropic(alphaT, s.alpha, s.NoV, NoL, dot(s.t, s.v), dot(s.b, s.v), dot(s.t, l), dot(s.b, l));
  float distribution = D_GGXAnisotropic(alphaT, s.alpha, NoH, dot(s.t, h), dot(s.b, h));
#else
  float visibility = V_SmithGGXCorrelated(s.alpha, s.NoV, NoL);
  float distribution = D_GGX(s.alpha, NoH);
#endif
  return fresnel * (visibility * distribution);
#else
  return Fr_GGX(s.f0, s.f90, s.alpha, s.NoV, NoL, NoH, LoH);
#endif
}

// The surface with what every light needs of it again.
SurfaceInfo preparedSurface(SurfaceInfo s) {
  s.compensation = directCompensation(s.f0, s.dfg);
  return s;
}

// Adds the light of one direction.
// l  unit, to the light; of length 0 it gives nothing      lightColor  irradiance on a surface that faces it, linear Rec.709
Reflected addPunctual(Reflected sum, SurfaceInfo s, vec3 l, vec3 lightColor) {
  float NoL = saturate(dot(s.n, l));
  vec3 h = halfVector(s.n, l, s.v);
  float NoH = saturate(dot(s.n, h));
  float LoH = saturate(dot(s.v, h));
  vec3 irradiance = NoL * lightColor;
#if CLEARCOAT
  float coatNoL = saturate(dot(s.coatNormal, l));
  float coatNoH = saturate(dot(s.coatNormal, h));
  sum.coat += coatNoL * lightColor *
              Fr_GGX(vec3(F0_DIELECTRIC), 1.0, alphaFromRoughness(s.clearcoatRoughness), s.clearcoatNoV, coatNoL, coatNoH, LoH);
#endif
#if SHEEN
  sum.sheen += irradiance * Fr_Sheen(s.sheenColor, s.sheenRoughness, s.NoV, NoL, NoH);
  irradiance *= 1.0 - max3(s.sheenColor) * max(sheenAlbedo(s.sheenRoughness, s.NoV), sheenAlbedo(s.sheenRoughness, NoL));
#endif
  sum.specular += irradiance * specularLobe(s, l, h, NoL, NoH, LoH) * s.compensation;
  // What the dielectric interface reflects does not reach the diffuse lobe.
#if DIFFUSE_ROUGHNESS
  vec3 diffuse = Fd_EON(s.baseColor, s.diffuseRoughness, s.NoV, NoL, dot(l, s.v)) * (1.0 - s.metallic);
#else
  vec3 diffuse = Fd_Lambert(s.diffuse);
#endif
  sum.diffuse += irradiance * diffuse * (1.0 - F_Schlick(s.f0Dielectric, s.f90, LoH));
  return sum;
}

// What the dielectric interface sends back of uniform light.
Scattering dielectricScattering(SurfaceInfo s) {
  vec3 f0 = s.f0Dielectric;
#if IRIDESCENCE
  f0 = mix(f0, s.filmF0Dielectric, s.iridescence);
#endif
  return multipleScattering(f0, s.f90, s.dfg);
}

// Light of ambient and hemisphere lights: it has no direction, and only the diffuse lobe and the sheen see it.
// irradiance  linear Rec.709
Reflected addDome(Reflected sum, SurfaceInfo s, vec3 irradiance) {
  Scattering dielectric = dielectricScattering(s);
#if DIFFUSE_ROUGHNESS
  vec3 diffuse = irradiance * RECIPROCAL_PI * (eonAlbedo(s.baseColor, s.diffuseRoughness, s.NoV) * (1.0 - s.metallic)) * diffuseShare(dielectric);
#else
  vec3 diffuse = irradiance * Fd_Lambert(s.diffuse) * diffuseShare(dielectric);
#endif
#if SHEEN
  float sheenE = sheenAlbedo(s.sheenRoughness, s.NoV);
  sum.sheen += irradiance * s.sheenColor * sheenE * RECIPROCAL_PI;
  diffuse *= 1.0 - max3(s.sheenColor) * sheenE;
#endif
  sum.diffuse += diffuse;
  return sum;
}

// Adds what the surface reflects of the prefiltered environment.
Reflected addEnvironment(Reflected sum, SurfaceInfo s, Incident incident) {
  vec3 f0Metal = s.baseColor;
#if IRIDESCENCE
  f0Metal = mix(f0Metal, s.filmF0Metal, s.iridescence);
#endif
  vec3 meanRadiance = incident.environmentIrradiance * RECIPROCAL_PI;
  Scattering dielectric = dielectricScattering(s);
  Scattering metal = multipleScattering(f0Metal, s.f90, s.dfg);
  vec3 specular = environmentSpecular(mixScattering(dielectric, metal, s.metallic), incident.radiance, meanRadiance);
#if DIFFUSE_ROUGHNESS
  vec3 diffuse = eonAlbedo(s.baseColor, s.diffuseRoughness, s.NoV) * (1.0 - s.metallic) * diffuseShare(dielectric) * meanRadiance;
#else
  vec3 diffuse = s.diffuse * diffuseShare(dielectric) * meanRadiance;
#endif
#if SHEEN
  float sheenE = sheenAlbedo(s.sheenRoughness, s.NoV);
  float underSheen = 1.0 - max3(s.sheenColor) * sheenE;
  sum.sheen += incident.environmentIrradiance * s.sheenColor * sheenE * RECIPROCAL_PI;
  specular *= underSheen;
  diffuse *= underSheen;
#endif
#if CLEARCOAT
  sum.coat += incident.coatRadiance * (vec3(F0_DIELECTRIC) * s.coatDfg.x + s.coatDfg.y);
#endif
  sum.specular += specular;
  sum.diffuse += diffuse;
  return sum;
}

// Radiance that leaves towards the viewer, linear Rec.709.
// diffuse  of both, or what is seen through a transmissive surface in its place      emitted  linear Rec.709
vec3 composedRadiance(SurfaceInfo s, vec3 diffuse, Reflected direct, Reflected indirect, vec3 emitted) {
  vec3 radiance = radianceBelowCoat(diffuse, direct, indirect, emitted);
#if CLEARCOAT
  radiance = radiance * (1.0 - s.clearcoat * F_Schlick(vec3(F0_DIELECTRIC), 1.0, s.clearcoatNoV)) +
             (direct.coat + indirect.coat) * s.clearcoat;
#endif
  return radiance;
}
