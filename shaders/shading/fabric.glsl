// telar's cloth: every lobe takes its energy from the ones below it, alike under lights and under the environment. What
// it models and why is in shaders/shading/README.md. No uniforms and no textures: also compiled as C++
// (renderer/brdf/shading.h), with every layer on.

// D of GGX about n, without cancellation at the peak, [1/sr].
float glossDistribution(vec3 n, vec3 h, float alpha) {
  vec3 x = cross(n, h);
  return D_GGXRobust(alpha, saturate(dot(n, h)), dot(x, x));
}

// GGX lobe of the base layer times NoL, after one bounce, [1/sr].
vec3 glossLobe(SurfaceInfo s, vec3 l, vec3 h, float NoL) {
  vec3 fresnel = mix(s.f0, vec3(s.f90), F_SchlickWeight5(dot(s.v, h)));
#if ANISOTROPY
  float alphaT = max(s.alphaT, s.alpha);
  float visibility = V_SmithGGXAnisotropicCosine(alphaT, s.alpha, s.NoV, NoL, dot(s.t, s.v), dot(s.b, s.v), dot(s.t, l), dot(s.b, l));
  float distribution = D_GGXAnisotropic(alphaT, s.alpha, saturate(dot(s.n, h)), dot(s.t, h), dot(s.b, h));
#else
  float visibility = V_SmithGGXCosine(s.alpha, s.NoV, NoL);
  float distribution = glossDistribution(s.n, h, s.alpha);
#endif
  return fresnel * (visibility * distribution);
}

// The surface with what every light needs of it again.
SurfaceInfo preparedSurface(SurfaceInfo s) {
#if ANISOTROPY
  // Square with the normal, from which a map may have turned: on axes that lean, the lobe would have a second peak.
  vec3 across = cross(s.n, s.t);
  s.t = safeNormalize(dot(across, across) > 1.0e-6 ? cross(across, s.n) : cross(s.b, s.n), s.t);
  s.b = cross(s.n, s.t);
#endif
#if IRIDESCENCE
  s.f0Dielectric = mix(s.f0Dielectric, saturate(s.filmF0Dielectric), s.iridescence);
  vec3 f0Metal = mix(s.baseColor, saturate(s.filmF0Metal), s.iridescence);
#else
  vec3 f0Metal = s.baseColor;
#endif
  s.f0 = mix(s.f0Dielectric, f0Metal, s.metallic);
  s.gloss = glossCurve(s.perceptualRoughness);
  s.albedo = glossAlbedo(s.gloss, s.NoV);
  float missing = s.gloss.averages.x;
  s.returningDielectric = returningShare(s.f0Dielectric, s.f90, missing);
  s.returning = mix(s.returningDielectric, returningShare(f0Metal, s.f90, missing), s.metallic);
  s.returningLobe = s.returning * (s.albedo.x * RECIPROCAL_PI / missing);
  s.leaving = max(1.0 - interfaceAlbedo(s.f0Dielectric, s.f90, s.returningDielectric, s.albedo), 0.0);
  s.passing = s.leaving / max(1.0 - interfaceAlbedo(s.f0Dielectric, s.f90, s.returningDielectric, s.gloss.averages), PASSING_MIN);
#if SHEEN
  vec3 fit = sheenFit(max(s.sheenRoughness, CLOTH_SHEEN_ROUGHNESS_MIN), s.NoV);
  s.sheenAlbedo = fit.x;
  s.sheenView = sheenView(fit, s.NoV);
#endif
#if CLEARCOAT
  vec2 coat = glossAlbedo(glossCurve(s.clearcoatRoughness), s.clearcoatNoV);
  s.coatAlbedo = F0_DIELECTRIC * (1.0 - coat.x - coat.y) + coat.y;
#endif
  return s;
}

// Adds the light of one direction.
// l  unit, to the light; of length 0 it gives nothing      lightColor  irradiance on a surface that faces it, linear Rec.709
Reflected addPunctual(Reflected sum, SurfaceInfo s, vec3 l, vec3 lightColor) {
  float NoL = saturate(dot(s.n, l));
  vec3 h = halfVector(s.n, l, s.v);
#if CLEARCOAT
  float coatNoL = saturate(dot(s.coatNormal, l));
  float coatAlpha = alphaFromRoughness(s.clearcoatRoughness);
  sum.coat += lightColor * (mix(F0_DIELECTRIC, 1.0, F_SchlickWeight5(dot(s.v, h))) *
                            (V_SmithGGXCosine(coatAlpha, s.clearcoatNoV, coatNoL) * glossDistribution(s.coatNormal, h, coatAlpha)));
#endif
#if SHEEN
  sum.sheen += lightColor * s.sheenColor * sheenCosine(s.sheenView, s.NoV, NoL, dot(l, s.v));
#endif
  vec2 albedo = glossAlbedo(s.gloss, NoL);
  sum.specular += lightColor * (glossLobe(s, l, h, NoL) + s.returningLobe * (albedo.x * NoL));
#if DIFFUSE_ROUGHNESS
  vec3 diffuse = Fd_EON(s.baseColor, s.diffuseRoughness, s.NoV, NoL, dot(l, s.v)) * (1.0 - s.metallic);
#else
  vec3 diffuse = Fd_Lambert(s.diffuse);
#endif
  vec3 entering = max(1.0 - interfaceAlbedo(s.f0Dielectric, s.f90, s.returningDielectric, albedo), 0.0);
  sum.diffuse += lightColor * NoL * diffuse * s.passing * entering;
  return sum;
}

// Albedo of what lies under the dielectric interface, towards the viewer.
vec3 innerAlbedo(SurfaceInfo s) {
#if DIFFUSE_ROUGHNESS
  return eonAlbedo(s.baseColor, s.diffuseRoughness, s.NoV) * (1.0 - s.metallic);
#else
  return s.diffuse;
#endif
}

// What the gloss reflects at once of light from everywhere, [0, 1].
vec3 glossReflectance(SurfaceInfo s) {
  return s.f0 * (1.0 - s.albedo.x - s.albedo.y) + s.f90 * s.albedo.y;
}

// Light from everywhere of which only the mean is known: that of ambient and hemisphere lights.
// irradiance  linear Rec.709
Reflected addDome(Reflected sum, SurfaceInfo s, vec3 irradiance) {
  vec3 radiance = irradiance * RECIPROCAL_PI;
#if CLEARCOAT
  sum.coat += radiance * s.coatAlbedo;
#endif
#if SHEEN
  sum.sheen += radiance * s.sheenColor * s.sheenAlbedo;
#endif
  sum.specular += radiance * (glossReflectance(s) + s.returning * s.albedo.x);
  sum.diffuse += radiance * innerAlbedo(s) * s.leaving;
  return sum;
}

// Adds what the surface reflects of the prefiltered environment.
Reflected addEnvironment(Reflected sum, SurfaceInfo s, Incident incident) {
  vec3 meanRadiance = incident.environmentIrradiance * RECIPROCAL_PI;
#if CLEARCOAT
  sum.coat += incident.coatRadiance * s.coatAlbedo;
#endif
#if SHEEN
  sum.sheen += meanRadiance * s.sheenColor * s.sheenAlbedo;
#endif
  sum.specular += incident.radiance * glossReflectance(s) + meanRadiance * s.returning * s.albedo.x;
  sum.diffuse += meanRadiance * innerAlbedo(s) * s.leaving;
  return sum;
}

// Radiance that leaves towards the viewer, linear Rec.709.
// diffuse  of both, or what is seen through a transmissive surface in its place      emitted  linear Rec.709
vec3 composedRadiance(SurfaceInfo s, vec3 diffuse, Reflected direct, Reflected indirect, vec3 emitted) {
  vec3 radiance = diffuse + (direct.specular + indirect.specular);
#if SHEEN
  radiance = radiance * (1.0 - max3(s.sheenColor) * s.sheenAlbedo) + (direct.sheen + indirect.sheen);
#endif
  radiance += emitted;
#if CLEARCOAT
  radiance = radiance * (1.0 - s.clearcoat * s.coatAlbedo) + (direct.coat + indirect.coat) * s.clearcoat;
#endif
  return radiance;
}
