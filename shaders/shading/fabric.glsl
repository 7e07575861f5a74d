// telar's cloth: every lobe takes its energy from the lobes below it, under lights and under the environment alike.
// shaders/shading/README.md says what it models and why. Included after fabric_energy.glsl. No uniforms and no textures: also
// compiled as C++ (renderer/brdf/shading.h), with every layer on.

#if ANISOTROPY || WEAVE
// One bounce off a GGX lobe of two widths, times the cosine to its normal, [1/sr].
// t, b, n  unit, square to each other; the widths go along t and b
vec3 anisotropicLobe(SurfaceInfo s, vec3 t, vec3 b, vec3 n, float alphaT, float alphaB, vec3 f0, vec3 l, vec3 h) {
  float NoL = saturate(dot(n, l));
#if ALL_TERMS
  if (NoL == 0.0) return vec3(0.0);  // here and below: in C++ a branch takes less time than what gives nothing
#endif
  float NoV = saturate(dot(n, s.v));
  float visibility = V_SmithGGXAnisotropicCosine(alphaT, alphaB, NoV, NoL, dot(t, s.v), dot(b, s.v), dot(t, l), dot(b, l));
  float distribution = D_GGXAnisotropic(alphaT, alphaB, saturate(dot(n, h)), dot(t, h), dot(b, h));
  return mix(f0, vec3(s.f90), F_SchlickWeight5(dot(s.v, h))) * (visibility * distribution);
}
#endif

// One bounce off a GGX lobe of one width, times the cosine to its normal, [1/sr].
vec3 isotropicLobe(vec3 n, vec3 v, float NoV, float NoL, float alpha, vec3 f0, float f90, vec3 h) {
  vec3 x = cross(n, h);
  float distribution = D_GGXRobust(alpha, saturate(dot(n, h)), dot(x, x));
  return mix(f0, vec3(f90), F_SchlickWeight5(dot(v, h))) * (V_SmithGGXCosine(alpha, NoV, NoL) * distribution);
}

#if WEAVE
// anisotropicLobe() of both sets of yarns.
vec3 yarnsLobe(SurfaceInfo s, vec3 l, vec3 h) {
  return s.warp.coverage * anisotropicLobe(s, s.warp.t, s.warp.b, s.warp.n, s.warp.alphaT, s.warp.alphaB, s.warp.f0, l, h) +
         s.weft.coverage * anisotropicLobe(s, s.weft.t, s.weft.b, s.weft.n, s.weft.alphaT, s.weft.alphaB, s.weft.f0, l, h);
}
#endif

#if FACETS
// Highlight of the edges of a polished relief, [1/sr].
vec3 edgesLobe(SurfaceInfo s, vec3 l, vec3 h) {
  float kept = EDGE_KEPT * s.edges.share * (1.0 - s.facetsTold);
  return kept * isotropicLobe(s.edges.n, s.v, s.edges.NoV, saturate(dot(s.edges.n, l)), EDGE_ALPHA, s.f0, s.f90, h);
}
#endif

// Specular lobe of the base layer times NoL, single scattering, [1/sr].
vec3 specularLobe(SurfaceInfo s, vec3 l, vec3 h, float NoL) {
#if WEAVE
  if (isWoven(s)) {
    vec3 lobe = yarnsLobe(s, l, h);
#if WEAVE_MAP
    // A leaning yarn also reflects below the surface. That light meets the cloth beside it, which lies flat on average, and
    // leaves mirrored.
    vec3 below = l - (2.0 * NoL) * s.n;
    lobe += yarnsLobe(s, below, halfVector(s.n, below, s.v));
#endif
    return NoL > 0.0 ? lobe : vec3(0.0);
  }
#endif
#if ANISOTROPY
  vec3 lobe = anisotropicLobe(s, s.t, s.b, s.n, s.alphaT, s.alpha, s.f0, l, h);
#else
  vec3 lobe = isotropicLobe(s.n, s.v, s.NoV, NoL, s.alpha, s.f0, s.f90, h);
#endif
#if FACETS
  lobe *= (1.0 - s.edges.share) * (1.0 - s.facetsTold);
#endif
  return lobe;
}

#if RELIEF
#if WEAVE
// Sets what the gloss of one set of yarns keeps, and its widths.
YarnLobe inRelief(SurfaceInfo s, YarnLobe yarn) {
  float roughness = sqrt(sqrt(0.5 * (pow2(yarn.alphaT) + pow2(yarn.alphaB))));
  yarn.glossKept = reliefGloss(yarnRelief(s, yarn), roughness, s.NoV);
  yarn.alphaT = widthWithSlopes(yarn.alphaT, yarn.slopeVariance.x);
  yarn.alphaB = widthWithSlopes(yarn.alphaB, yarn.slopeVariance.y);
  return yarn;
}
#endif

// Takes from the lobes what a relief hides that is finer than the pixel, and widens them. Their energies are those of a texel.
SurfaceInfo withRelief(SurfaceInfo s) {
  s.glossKept = reliefGloss(s.relief, s.glossRoughness, s.NoV);
#if FACETS
  if (hasEdges(s)) s.glossKept = vec2(1.0 - s.edges.share);  // facets lie too flat to hide anything
#endif
  s.perceptualRoughness = roughnessWithSlopes(s.perceptualRoughness, s.slopeVariance);
  s.alpha = widthWithSlopes(s.alpha, s.slopeVariance);
#if ANISOTROPY || WEAVE
  s.alphaT = widthWithSlopes(s.alphaT, s.slopeVariance);
#endif
#if WEAVE
  s.warp = inRelief(s, s.warp);
  s.weft = inRelief(s, s.weft);
#endif
  return s;
}
#endif

#if FACETS
// Sets what lights need of the edges.
EdgeLobe preparedEdges(SurfaceInfo s) {
  EdgeLobe edges = s.edges;
  edges.n = normalFacing(s.geometricNormal, s.v);
  edges.NoV = saturate(dot(edges.n, s.v));
  edges.reflectance = s.f0 * (EDGE_KEPT * edges.share);
  return edges;
}
#endif

// Sets the members that every light needs.
SurfaceInfo preparedSurface(SurfaceInfo s) {
#if IRIDESCENCE
  s.f0Dielectric = mix(s.f0Dielectric, saturate(s.filmF0Dielectric), s.iridescence);
  vec3 f0Metal = mix(s.metalColor, saturate(s.filmF0Metal), s.iridescence);
#else
  vec3 f0Metal = s.metalColor;
#endif
  s.f0 = mix(s.f0Dielectric, f0Metal, s.metallic);
#if ANISOTROPY || WEAVE
  s = withSquareFrame(s);
#endif
  s = withEnergies(s, f0Metal);
#if NORMAL_MAP
  s.bumpAlpha2 = bumpAlpha2(s.geometricNormal, s.n);
#endif
  s.glossRoughness = s.perceptualRoughness;
#if FACETS
  if (hasEdges(s)) s.edges = preparedEdges(s);
#endif
#if RELIEF
  s.reliefSeen = reliefTowards(s.relief, s.reliefAxis, s.n, s.v);
  s = withRelief(s);
#endif
#if SHEEN
  float sheenRoughness = max(s.sheenRoughness, CLOTH_SHEEN_ROUGHNESS_MIN);
  vec3 fit = sheenFit(sheenRoughness, s.NoV);
  s.sheenAlbedo = fit.x;
#if RELIEF
  if (s.relief > 0.0) {
    s.sheenRing = sheenRing(s.relief, s.reliefAxis, sheenRoughness, s.n, s.v);
    s.sheenAlbedo = reliefSheenAlbedo(s.relief, s.reliefSeen, sheenRoughness, s.NoV);
  }
#endif
  s.sheenView = sheenView(fit, s.NoV);
#endif
#if CLEARCOAT
  vec2 coat = glossAlbedo(glossCurve(s.clearcoatRoughness), s.clearcoatNoV);
  s.coatAlbedo = F0_DIELECTRIC * (1.0 - coat.x - coat.y) + coat.y;
#endif
  return s;
}

// Diffuse lobe times NoL, [1/sr], without an interface above it. Light that is transmitted is left out.
vec3 diffuseLobe(SurfaceInfo s, vec3 l, float NoL) {
#if DIFFUSE_ROUGHNESS
  // The coupled average underestimates the cosine-weighted exit by up to 0.8 %.
  float kept = (1.0 - s.metallic) * (1.0 - 0.008 * s.diffuseRoughness);
  vec3 lobe = NoL * kept * Fd_EON(s.baseColor, s.diffuseRoughness, s.NoV, NoL, dot(l, s.v));
#else
  vec3 lobe = NoL * Fd_Lambert(s.diffuse);
#endif
#if FLATNESS
  lobe = mix(lobe, Fd_SheetCosine(s.baseColor, s.NoV, NoL) * (1.0 - s.metallic), s.flatness);
#endif
#if DIFFUSE_TRANSMISSION
  lobe *= 1.0 - s.diffuseTransmission;
#endif
  return lobe;
}

// Albedo of the diffuse lobe towards the viewer.
vec3 diffuseLobeAlbedo(SurfaceInfo s) {
#if DIFFUSE_ROUGHNESS
  vec3 albedo = eonAlbedo(s.baseColor, s.diffuseRoughness, s.NoV) * (1.0 - s.metallic);
#else
  vec3 albedo = s.diffuse;
#endif
#if FLATNESS
#if RELIEF
  float NoV = s.NoV * (1.0 - s.relief);
#else
  float NoV = s.NoV;
#endif
  albedo = mix(albedo, sheetReflectance(s.baseColor, NoV) * (1.0 - s.metallic), s.flatness);
#endif
#if DIFFUSE_TRANSMISSION
  albedo *= 1.0 - s.diffuseTransmission;
#endif
  return albedo;
}

#if DIFFUSE_TRANSMISSION
// Albedo of diffuse transmission.
vec3 transmittedAlbedo(SurfaceInfo s) {
  return s.transmittedColor * (s.diffuseTransmission * (1.0 - s.metallic));
}

// Adds uniform light that arrives on the other side.
// irradiance  linear Rec.709
Reflected addBehind(Reflected sum, SurfaceInfo s, vec3 irradiance) {
  sum.diffuse += irradiance * RECIPROCAL_PI * transmittedAlbedo(s) * s.leaving;
  return sum;
}
#endif

#if CLEARCOAT
vec3 clearCoatLobe(SurfaceInfo s, vec3 l, vec3 h) {
  float NoL = saturate(dot(s.coatNormal, l));
  return isotropicLobe(s.coatNormal, s.v, s.clearcoatNoV, NoL, alphaFromRoughness(s.clearcoatRoughness), vec3(F0_DIELECTRIC), 1.0, h);
}

// Share of uniform light that the coat reflects.
float coatReflectance(SurfaceInfo s) {
  return s.coatAlbedo - (1.0 - F0_DIELECTRIC) * grazingExcess(s.clearcoatRoughness, s.clearcoatNoV);
}
#endif

#if DIFFUSE_TRANSMISSION
// Radiance of the light of one direction that comes through from the other side; parameters as those of addPunctual().
vec3 lightThrough(SurfaceInfo s, vec3 l, vec3 lightColor) {
  float cosine = dot(s.n, l);
#if RELIEF
  float behind = reliefBehind(s.relief, cosine) * dot(l, l);  // of no direction, none
#else
  float behind = saturate(-cosine);
#endif
#if ALL_TERMS
  if (behind == 0.0) return vec3(0.0);
#endif
  return lightColor * (behind * RECIPROCAL_PI) * transmittedAlbedo(s) * s.passing * passingShare(s, albedoTowards(s, l, behind));
}
#endif

// Adds the light of one direction.
// l  unit, to the light; of length 0 it gives nothing      lightColor  irradiance on a surface that faces it, linear Rec.709
Reflected addPunctual(Reflected sum, SurfaceInfo s, vec3 l, vec3 lightColor) {
  float cosine = dot(s.n, l);
  vec3 h = halfVector(s.n, l, s.v);
#if CLEARCOAT
  sum.coat += lightColor * clearCoatLobe(s, l, h);
#endif
#if DIFFUSE_TRANSMISSION
  sum.diffuse += lightThrough(s, l, lightColor);
#endif
#if FACETS
  if (hasEdges(s)) sum.specular += lightColor * edgesLobe(s, l, h);
#endif
#if NORMAL_MAP
  lightColor *= bumpTerminator(s.bumpAlpha2, dot(s.geometricNormal, l));
#endif
  float NoL = saturate(cosine);
#if ALL_TERMS && !RELIEF
  if (NoL == 0.0) return sum;
#endif

#if SHEEN
  float sheen = sheenCosine(s.sheenView, s.NoV, NoL, dot(l, s.v));
#if RELIEF
  if (s.relief > 0.0) sheen = sheenRingCosine(s.sheenRing, l, NoL, dot(l, s.v));
#endif
  sum.sheen += lightColor * s.sheenColor * sheen;
#endif
  GlossAlbedo albedo = albedoTowards(s, l, NoL);
  sum.specular += lightColor * (specularLobe(s, l, h, NoL) + returnedLobe(s, albedo) * NoL);
#if RELIEF
  lightColor *= reliefDiffuseTowards(s.relief, reliefTowards(s.relief, s.reliefAxis, s.n, l), NoL) * reliefTurned(s.reliefSeen, s.NoV);
#endif
  sum.diffuse += lightColor * diffuseLobe(s, l, NoL) * s.passing * passingShare(s, albedo);
  return sum;
}

#if NORMAL_MAP
// Share of uniform light that a mapped normal keeps.   length  [0, 1], of the mean normal
float unhiddenDiffuse(SurfaceInfo s, float length) { return bumpMean(saturate(dot(s.geometricNormal, s.n)) * length); }

float unhiddenDiffuse(SurfaceInfo s) {
#if RELIEF
  return unhiddenDiffuse(s, 1.0 - s.relief) * reliefTurned(s.reliefSeen, s.NoV);
#else
  return unhiddenDiffuse(s, 1.0);
#endif
}

// The same of the gloss and of the sheen, but for what the relief within the pixel takes of these.
float unhiddenGloss(SurfaceInfo s) {
  float cosine = dot(s.geometricNormal, dominantReflection(s.perceptualRoughness, s.n, s.v));
  return bumpGloss(s.perceptualRoughness, s.bumpAlpha2, cosine, unhiddenDiffuse(s, 1.0));
}
float unhiddenSheen(SurfaceInfo s) { return unhiddenDiffuse(s, 1.0); }
#endif

// Adds uniform light: that of ambient and hemisphere lights.
// irradiance  linear Rec.709
Reflected addDome(Reflected sum, SurfaceInfo s, vec3 irradiance) {
  vec3 radiance = irradiance * RECIPROCAL_PI;
#if CLEARCOAT
  sum.coat += radiance * coatReflectance(s);
#endif
#if FACETS
  if (hasEdges(s)) sum.specular += radiance * s.edges.reflectance;
#endif
  vec3 ofDiffuse = radiance;
  vec3 ofSheen = radiance;
#if NORMAL_MAP
  radiance *= unhiddenGloss(s);
  ofDiffuse *= unhiddenDiffuse(s);
  ofSheen *= unhiddenSheen(s);
#endif
#if SHEEN
  sum.sheen += ofSheen * s.sheenColor * s.sheenAlbedo;
#endif
  sum.specular += radiance * glossReflectance(s) + ofDiffuse * glossReturn(s);
  sum.diffuse += ofDiffuse * diffuseLobeAlbedo(s) * s.leaving;
  return sum;
}

// Adds what the surface reflects of the prefiltered environment.
Reflected addEnvironment(Reflected sum, SurfaceInfo s, Incident incident) {
  vec3 meanRadiance = incident.environmentIrradiance * RECIPROCAL_PI;
#if FACETS
  if (hasEdges(s)) sum.specular += incident.edgeRadiance * s.edges.reflectance;
#endif
#if CLEARCOAT
  sum.coat += incident.coatRadiance * coatReflectance(s);
#endif
#if SHEEN
  vec3 sheenRadiance = incident.sheenRadiance;
#endif
#if NORMAL_MAP
  meanRadiance *= unhiddenDiffuse(s);
  float unhidden = unhiddenGloss(s);
  incident.radiance *= unhidden;
#if WEAVE
  incident.weftRadiance *= unhidden;
#endif
#if SHEEN
  sheenRadiance *= unhiddenSheen(s);
#endif
#endif
#if RELIEF && SHEEN
  sheenRadiance *= reliefSheen(s.relief, s.sheenRoughness);
#endif
#if SHEEN
  sum.sheen += sheenRadiance * s.sheenColor * s.sheenAlbedo;
#endif
#if WEAVE
  if (isWoven(s)) {
    sum.specular += incident.radiance * yarnReflectance(s, s.warp) + incident.weftRadiance * yarnReflectance(s, s.weft) + meanRadiance * glossReturn(s);
  } else
#endif
  sum.specular += incident.radiance * glossReflectance(s) + meanRadiance * glossReturn(s);
  sum.diffuse += meanRadiance * diffuseLobeAlbedo(s) * s.leaving;
  return sum;
}

// The fitted albedos of the coat and of the layers below may both be too low. The coat therefore takes this much more.
const float COAT_MARGIN = 0.001;

// Radiance that leaves towards the viewer, linear Rec.709.
// diffuse  of direct and indirect; of a transmissive surface, mixed with the light that comes through      emitted  linear Rec.709
vec3 composedRadiance(SurfaceInfo s, vec3 diffuse, Reflected direct, Reflected indirect, vec3 emitted) {
  vec3 radiance = diffuse + (direct.specular + indirect.specular);
#if SHEEN
  radiance = radiance * (1.0 - max3(s.sheenColor) * s.sheenAlbedo) + (direct.sheen + indirect.sheen);
#endif
  radiance += emitted;
#if CLEARCOAT
  radiance = radiance * (1.0 - s.clearcoat * min(s.coatAlbedo + COAT_MARGIN, 1.0)) + (direct.coat + indirect.coat) * s.clearcoat;
#endif
  return radiance;
}
