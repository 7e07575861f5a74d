// How the lobes of one surface add up as three.js shades it: 0.187, or another release by its terms (js/docs/families.md). No
// uniforms and no textures: also compiled as C++ (renderer/brdf/shading.h), with every layer on.

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
#if ALL_TERMS || THREE_ANISOTROPIC_VISIBILITY_TERM != THREE_ANISOTROPIC_VISIBILITY_FLOORED
  if (RELEASE(s, anisotropicVisibility, THREE_ANISOTROPIC_VISIBILITY_TERM) != THREE_ANISOTROPIC_VISIBILITY_FLOORED) {
    float smithSum = smithSumAnisotropic(alphaT, s.alpha, s.NoV, NoL, dot(s.t, s.v), dot(s.b, s.v), dot(s.t, l), dot(s.b, l));
#if ALL_TERMS
    // These releases draw black where they divide by 0. The path tracer and the analysis find no light there.
    smithSum = max(smithSum, COSINE_EPSILON);
#endif
    visibility = 0.5 / smithSum;
  }
  if (RELEASE(s, anisotropicVisibility, THREE_ANISOTROPIC_VISIBILITY_TERM) == THREE_ANISOTROPIC_VISIBILITY_SATURATED) {
    visibility = saturate(visibility);
  }
#endif
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
#if ALL_TERMS || THREE_DIRECT_MULTISCATTER_TERM != THREE_DIRECT_MULTISCATTER_TURQUIN
  if (RELEASE(s, directMultiscatter, THREE_DIRECT_MULTISCATTER_TERM) != THREE_DIRECT_MULTISCATTER_TURQUIN) {
    s.compensation = vec3(1.0);
  }
#endif
  return s;
}

#if ALL_TERMS || THREE_DIRECT_MULTISCATTER_TERM == THREE_DIRECT_MULTISCATTER_ADDED_LOBE || THREE_DIRECT_MULTISCATTER_TERM == THREE_DIRECT_MULTISCATTER_ADDED_LOBE_SQUARED
// Of the light of one direction, what bounces more than once, where a lobe of its own has it.
vec3 addedLobe(SurfaceInfo s, float NoL) {
#if ALL_TERMS
  if (s.three.directMultiscatter == THREE_DIRECT_MULTISCATTER_TURQUIN) return vec3(0.0);
  if (s.three.directMultiscatter == THREE_DIRECT_MULTISCATTER_NONE) return vec3(0.0);
  vec2 towardsLight = splitSum(s.three, s.perceptualRoughness, NoL);
#else
  vec2 towardsLight = splitSum(s.perceptualRoughness, NoL);
#endif
  vec3 passes = F_SchlickAverage(s.f0);
  if (RELEASE(s, directMultiscatter, THREE_DIRECT_MULTISCATTER_TERM) == THREE_DIRECT_MULTISCATTER_ADDED_LOBE_SQUARED) {
    passes = passes * passes;
  }
  return addedScattering(s.f0, s.f90, s.dfg, towardsLight, passes);
}
#endif

#if SHEEN
// Albedo of the sheen by which it is weighed against the layers beneath.
float sheenAlbedoTerm(SurfaceInfo s, float cosine) {
#if ALL_TERMS || THREE_SHEEN_ALBEDO_TERM == THREE_SHEEN_ALBEDO_TWO_RANGES
  if (RELEASE(s, sheenAlbedo, THREE_SHEEN_ALBEDO_TERM) == THREE_SHEEN_ALBEDO_TWO_RANGES) {
    return sheenAlbedoInRanges(s.sheenRoughness, cosine);
  }
#endif
  return sheenAlbedo(s.sheenRoughness, cosine);
}

// Share of the light that the sheen leaves to the layers beneath.
// albedo  of sheenAlbedoTerm()
float underSheenTerm(SurfaceInfo s, float albedo) {
#if ALL_TERMS || THREE_SHEEN_ENERGY_TERM == THREE_SHEEN_ENERGY_CONSTANT
  if (RELEASE(s, sheenEnergy, THREE_SHEEN_ENERGY_TERM) == THREE_SHEEN_ENERGY_CONSTANT) return 1.0;  // composedRadiance() takes it
#endif
  return 1.0 - max3(s.sheenColor) * albedo;
}
#endif

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
  irradiance *= underSheenTerm(s, max(sheenAlbedoTerm(s, s.NoV), sheenAlbedoTerm(s, NoL)));
#endif
  sum.specular += irradiance * specularLobe(s, l, h, NoL, NoH, LoH) * s.compensation;
#if ALL_TERMS || THREE_DIRECT_MULTISCATTER_TERM == THREE_DIRECT_MULTISCATTER_ADDED_LOBE || THREE_DIRECT_MULTISCATTER_TERM == THREE_DIRECT_MULTISCATTER_ADDED_LOBE_SQUARED
  sum.specular += irradiance * addedLobe(s, NoL);
#endif
#if DIFFUSE_ROUGHNESS
  vec3 diffuse = Fd_EON(s.baseColor, s.diffuseRoughness, s.NoV, NoL, dot(l, s.v)) * (1.0 - s.metallic);
#else
  vec3 diffuse = Fd_Lambert(s.diffuse);
#endif
#if ALL_TERMS || THREE_DIRECT_DIFFUSE_TERM == THREE_DIRECT_DIFFUSE_LAMBERT
  if (RELEASE(s, directDiffuse, THREE_DIRECT_DIFFUSE_TERM) == THREE_DIRECT_DIFFUSE_LAMBERT) {
    sum.diffuse += irradiance * diffuse;
    return sum;
  }
#endif
  // What the dielectric interface reflects does not reach the diffuse lobe.
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
  vec3 share = diffuseShare(dielectricScattering(s));
#if ALL_TERMS || THREE_AMBIENT_DIFFUSE_TERM == THREE_AMBIENT_DIFFUSE_LAMBERT
  if (RELEASE(s, ambientDiffuse, THREE_AMBIENT_DIFFUSE_TERM) == THREE_AMBIENT_DIFFUSE_LAMBERT) share = vec3(1.0);
#endif
#if DIFFUSE_ROUGHNESS
  vec3 diffuse = irradiance * RECIPROCAL_PI * (eonAlbedo(s.baseColor, s.diffuseRoughness, s.NoV) * (1.0 - s.metallic)) * share;
#else
  vec3 diffuse = irradiance * Fd_Lambert(s.diffuse) * share;
#endif
#if SHEEN
  float sheenE = sheenAlbedoTerm(s, s.NoV);
  vec3 fuzz = irradiance * s.sheenColor * sheenE * RECIPROCAL_PI;
#if ALL_TERMS || THREE_AMBIENT_SHEEN_TERM == THREE_AMBIENT_SHEEN_NONE
  if (RELEASE(s, ambientSheen, THREE_AMBIENT_SHEEN_TERM) == THREE_AMBIENT_SHEEN_NONE) fuzz = vec3(0.0);
#endif
  sum.sheen += fuzz;
  diffuse *= underSheenTerm(s, sheenE);
#endif
  sum.diffuse += diffuse;
  return sum;
}

#if ALL_TERMS || THREE_ENVIRONMENT_METAL_TERM == THREE_ENVIRONMENT_METAL_ONE_INTERFACE
// What the interface of the dielectric-metal blend sends back of uniform light.
Scattering blendedScattering(SurfaceInfo s) {
  vec3 f0 = s.f0;
#if IRIDESCENCE
  f0 = mix(f0, mix(s.filmF0Dielectric, s.filmF0Metal, s.metallic), s.iridescence);
#endif
  return multipleScattering(f0, s.f90, s.dfg);
}
#endif

// Adds what the surface reflects of the prefiltered environment.
Reflected addEnvironment(Reflected sum, SurfaceInfo s, Incident incident) {
  vec3 f0Metal = s.baseColor;
#if IRIDESCENCE
  f0Metal = mix(f0Metal, s.filmF0Metal, s.iridescence);
#endif
  vec3 meanRadiance = incident.environmentIrradiance * RECIPROCAL_PI;
  Scattering dielectric = dielectricScattering(s);
  Scattering metal = multipleScattering(f0Metal, s.f90, s.dfg);
  Scattering whole = mixScattering(dielectric, metal, s.metallic);
  vec3 share = diffuseShare(dielectric);
#if ALL_TERMS || THREE_ENVIRONMENT_METAL_TERM == THREE_ENVIRONMENT_METAL_ONE_INTERFACE
  if (RELEASE(s, environmentMetal, THREE_ENVIRONMENT_METAL_TERM) == THREE_ENVIRONMENT_METAL_ONE_INTERFACE) {
    whole = blendedScattering(s);
    share = diffuseShareOfLargest(whole);
  }
#endif
  vec3 specular = environmentSpecular(whole, incident.radiance, meanRadiance);
#if DIFFUSE_ROUGHNESS
  vec3 diffuse = eonAlbedo(s.baseColor, s.diffuseRoughness, s.NoV) * (1.0 - s.metallic) * share * meanRadiance;
#else
  vec3 diffuse = s.diffuse * share * meanRadiance;
#endif
#if SHEEN
  float sheenE = sheenAlbedoTerm(s, s.NoV);
  float underSheen = underSheenTerm(s, sheenE);
  vec3 fuzz = incident.environmentIrradiance * s.sheenColor * sheenE * RECIPROCAL_PI;
#if ALL_TERMS || THREE_SHEEN_ALBEDO_TERM == THREE_SHEEN_ALBEDO_TWO_RANGES
  // That albedo went with the irradiance itself.
  if (RELEASE(s, sheenAlbedo, THREE_SHEEN_ALBEDO_TERM) == THREE_SHEEN_ALBEDO_TWO_RANGES) fuzz *= PI;
#endif
  sum.sheen += fuzz;
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
#if SHEEN && (ALL_TERMS || THREE_SHEEN_ENERGY_TERM == THREE_SHEEN_ENERGY_CONSTANT)
  if (RELEASE(s, sheenEnergy, THREE_SHEEN_ENERGY_TERM) == THREE_SHEEN_ENERGY_CONSTANT) {
    vec3 base = diffuse + (direct.specular + indirect.specular) + emitted;
    radiance = base * underSheenOfColor(s.sheenColor) + (direct.sheen + indirect.sheen);
  }
#endif
#if CLEARCOAT
  radiance = radiance * (1.0 - s.clearcoat * F_Schlick(vec3(F0_DIELECTRIC), 1.0, s.clearcoatNoV)) +
             (direct.coat + indirect.coat) * s.clearcoat;
#endif
  return radiance;
}
