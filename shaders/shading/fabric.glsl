// telar's cloth: every lobe takes its energy from the ones below it, alike under lights and under the environment. What
// it models and why is in shaders/shading/README.md. No uniforms and no textures: also compiled as C++
// (renderer/brdf/shading.h), with every layer on.

#if ANISOTROPY || WEAVE
// One bounce off a GGX lobe of two widths, times the cosine to its normal, [1/sr].
// t, b, n  unit, square to each other; the widths go along t and b
vec3 stretchedLobe(SurfaceInfo s, vec3 t, vec3 b, vec3 n, float alphaT, float alphaB, vec3 f0, vec3 l, vec3 h) {
  float NoV = saturate(dot(n, s.v));
  float NoL = saturate(dot(n, l));
  float visibility = V_SmithGGXAnisotropicCosine(alphaT, alphaB, NoV, NoL, dot(t, s.v), dot(b, s.v), dot(t, l), dot(b, l));
  float distribution = D_GGXAnisotropic(alphaT, alphaB, saturate(dot(n, h)), dot(t, h), dot(b, h));
  return mix(f0, vec3(s.f90), F_SchlickWeight5(dot(s.v, h))) * (visibility * distribution);
}
#endif

// One bounce off a GGX lobe of one width, times the cosine to its normal, [1/sr].
vec3 evenLobe(vec3 n, vec3 v, float NoV, float NoL, float alpha, vec3 f0, float f90, vec3 h) {
  vec3 x = cross(n, h);
  float distribution = D_GGXRobust(alpha, saturate(dot(n, h)), dot(x, x));
  return mix(f0, vec3(f90), F_SchlickWeight5(dot(v, h))) * (V_SmithGGXCosine(alpha, NoV, NoL) * distribution);
}

#if WEAVE
// A shader has WEAVE for woven cloth alone; C++ has every layer on.
bool isWoven(SurfaceInfo s) {
#if ALL_TERMS
  return s.warp.coverage + s.weft.coverage > 0.0;
#else
  return true;
#endif
}

// The surface with the one lobe that stands for its yarns where a lobe of one width reads the environment: the second moments
// of both, which lie square to each other, along the frame's axes.
SurfaceInfo withMeanYarn(SurfaceInfo s) {
  float warp = s.warp.coverage / (s.warp.coverage + s.weft.coverage);
  float along = mix(pow2(s.weft.alphaT), pow2(s.warp.alphaB), warp);
  float across = mix(pow2(s.weft.alphaB), pow2(s.warp.alphaT), warp);
  vec3 color = mix(s.weft.specularColor, s.warp.specularColor, warp);
  s.f0Dielectric *= color;
  s.f0 *= color;
  s.alphaT = sqrt(max(along, across));
  s.alpha = sqrt(min(along, across));
  if (across > along) {
    vec3 weft = s.t;
    s.t = s.b;
    s.b = -weft;
  }
  s.perceptualRoughness = sqrt(s.alpha);
  s.anisotropyStrength = sqrt(saturate((s.alphaT - s.alpha) / max(1.0 - s.alpha, 1.0e-6)));
  return s;
}

// stretchedLobe() of both sets of yarns.
vec3 yarnsLobe(SurfaceInfo s, vec3 l, vec3 h) {
  return s.warp.coverage * stretchedLobe(s, s.warp.t, s.warp.b, s.warp.n, s.warp.alphaT, s.warp.alphaB, s.warp.f0, l, h) +
         s.weft.coverage * stretchedLobe(s, s.weft.t, s.weft.b, s.weft.n, s.weft.alphaT, s.weft.alphaB, s.weft.f0, l, h);
}
#endif

// GGX lobe of the base layer times NoL, after one bounce, [1/sr].
vec3 glossLobe(SurfaceInfo s, vec3 l, vec3 h, float NoL) {
#if WEAVE
  if (isWoven(s)) {
    vec3 lobe = yarnsLobe(s, l, h);
#if WEAVE_MAP
    // What a leaning yarn sends below the surface meets the cloth beside it, which lies flat on average, and leaves mirrored.
    vec3 below = l - (2.0 * NoL) * s.n;
    lobe += yarnsLobe(s, below, halfVector(s.n, below, s.v));
#endif
    return NoL > 0.0 ? lobe : vec3(0.0);
  }
#endif
#if ANISOTROPY
  return stretchedLobe(s, s.t, s.b, s.n, s.alphaT, s.alpha, s.f0, l, h);
#else
  return evenLobe(s.n, s.v, s.NoV, NoL, s.alpha, s.f0, s.f90, h);
#endif
}

#if WEAVE
// glossAlbedo() of one set of yarns for one direction.
// along, across, n  its frame: for lights as it lies, for the viewer as it leans      cosine  [0, 1], with n
vec2 yarnAlbedo(YarnLobe yarn, vec3 along, vec3 across, vec3 direction, float cosine) {
  return stretchedAlbedo(yarn.gloss, cosine, dot(across, direction), dot(along, direction));
}
#endif

#if ANISOTROPY
// Where a map leaves no stretch the lobe is the even one, with the curves of it.
bool isStretched(SurfaceInfo s) {
  return s.alphaT > s.alpha;
}
#endif

// Of light of one direction.   cosine  [0, 1], with n
GlossAlbedo albedoTowards(SurfaceInfo s, vec3 direction, float cosine) {
  GlossAlbedo albedo;
#if WEAVE
  if (isWoven(s)) {
    return GlossAlbedo(yarnAlbedo(s.warp, s.warp.lying, cross(s.n, s.warp.lying), direction, cosine),
                       yarnAlbedo(s.weft, s.weft.lying, cross(s.n, s.weft.lying), direction, cosine));
  }
#endif
#if ANISOTROPY
  if (isStretched(s)) {
    albedo.base = stretchedAlbedo(s.stretched, cosine, dot(s.t, direction), dot(s.b, direction));
    return albedo;
  }
#endif
  albedo.base = glossAlbedo(s.gloss, cosine);
  return albedo;
}

// Share of the light of one direction that passes the dielectric interface, either way.   albedo  of the gloss there
vec3 passingShare(SurfaceInfo s, GlossAlbedo albedo) {
#if WEAVE
  if (isWoven(s)) {
    vec3 warp = interfaceAlbedo(s.warp.f0Dielectric, s.f90, s.warp.returningDielectric, albedo.base);
    vec3 weft = interfaceAlbedo(s.weft.f0Dielectric, s.f90, s.weft.returningDielectric, albedo.weft);
    return max(1.0 - s.warp.coverage * warp - s.weft.coverage * weft, 0.0);
  }
#endif
  return max(1.0 - interfaceAlbedo(s.f0Dielectric, s.f90, s.returningDielectric, albedo.base), 0.0);
}

// What the microfacets return of a light after more bounces, without its cosine, [1/sr].   albedo  of the gloss towards it
vec3 returnedLobe(SurfaceInfo s, GlossAlbedo albedo) {
#if WEAVE
  if (isWoven(s)) return s.warp.returningLobe * albedo.base.x + s.weft.returningLobe * albedo.weft.x;
#endif
  return s.returningLobe * albedo.base.x;
}

// Axes square to the normal, from which a map may have turned, and to each other: on axes that lean the lobe would have a
// second peak.
#if ANISOTROPY || WEAVE
SurfaceInfo withSquareFrame(SurfaceInfo s) {
  vec3 across = cross(s.n, s.t);
  s.t = safeNormalize(dot(across, across) > 1.0e-6 ? cross(across, s.n) : cross(s.b, s.n), anyTangent(s.n));
  s.b = cross(s.n, s.t);
#if ANISOTROPY
  s.alphaT = max(s.alphaT, s.alpha);
#endif
  return s;
}
#endif

#if WEAVE
// A set of yarns with what it reflects and what it leaves to the rest of the surface: each by its own width.
// f0Metal  normal reflectance of the metal
YarnLobe withYarnEnergies(SurfaceInfo s, YarnLobe yarn, vec3 f0Metal) {
  yarn.gloss = stretchedCurve(yarn.alphaB, yarn.alphaT);
#if WEAVE_MAP
  // Yarns that lean away from the viewer are seen where they just face him.
  yarn.n = normalFacing(yarn.n, s.v);
  yarn.t = safeNormalize(cross(yarn.b, yarn.n), anyTangent(yarn.n));
  yarn.b = cross(yarn.n, yarn.t);
#endif
  yarn.albedo = yarnAlbedo(yarn, yarn.t, yarn.b, s.v, saturate(dot(yarn.n, s.v)));
  yarn.f0Dielectric = s.f0Dielectric * yarn.specularColor;
  yarn.f0 = s.f0 * yarn.specularColor;
  float average = yarn.gloss.average.x;
  yarn.returningDielectric = returningShare(yarn.f0Dielectric, s.f90, average);
  yarn.returning = mix(yarn.returningDielectric, returningShare(f0Metal * yarn.specularColor, s.f90, average), s.metallic);
  yarn.returningLobe = yarn.returning * (yarn.coverage * yarn.albedo.x * RECIPROCAL_PI / average);
  return yarn;
}
#endif

// What the gloss reflects and what it leaves.   f0Metal  normal reflectance of the metal
SurfaceInfo withEnergies(SurfaceInfo s, vec3 f0Metal) {
  GlossAlbedo average;
#if WEAVE
  if (isWoven(s)) {
    s.warp = withYarnEnergies(s, s.warp, f0Metal);
    s.weft = withYarnEnergies(s, s.weft, f0Metal);
    s.albedo = GlossAlbedo(s.warp.albedo, s.weft.albedo);
    average = GlossAlbedo(s.warp.gloss.average, s.weft.gloss.average);
    s = withMeanYarn(s);
  } else
#endif
  {
    s.gloss = glossCurve(s.perceptualRoughness);
    average.base = glossAverage(s.gloss);
#if ANISOTROPY
    if (isStretched(s)) {
      s.stretched = stretchedCurve(s.alphaT, s.alpha);
      average.base = s.stretched.average;
    }
#endif
    s.albedo = albedoTowards(s, s.v, s.NoV);
    s.returningDielectric = returningShare(s.f0Dielectric, s.f90, average.base.x);
    s.returning = mix(s.returningDielectric, returningShare(f0Metal, s.f90, average.base.x), s.metallic);
    s.returningLobe = s.returning * (s.albedo.base.x * RECIPROCAL_PI / average.base.x);
  }
  s.leaving = passingShare(s, s.albedo);
  s.passing = s.leaving / max(passingShare(s, average), vec3(PASSING_MIN));
  return s;
}

// The surface with what every light needs of it again.
SurfaceInfo preparedSurface(SurfaceInfo s) {
#if IRIDESCENCE
  s.f0Dielectric = mix(s.f0Dielectric, saturate(s.filmF0Dielectric), s.iridescence);
  vec3 f0Metal = mix(s.baseColor, saturate(s.filmF0Metal), s.iridescence);
#else
  vec3 f0Metal = s.baseColor;
#endif
  s.f0 = mix(s.f0Dielectric, f0Metal, s.metallic);
#if ANISOTROPY || WEAVE
  s = withSquareFrame(s);
#endif
  s = withEnergies(s, f0Metal);
#if NORMAL_MAP
  s.bumpAlpha2 = bumpAlpha2(s.geometricNormal, s.n, s.slopeVariance);
#endif
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

// Diffuse lobe times NoL under no interface, of what stays on the lit side, [1/sr].
vec3 innerLobe(SurfaceInfo s, vec3 l, float NoL) {
#if DIFFUSE_ROUGHNESS
  // It sends a little more of its light where the interface lets it pass than the average that it is coupled by.
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

// Its albedo towards the viewer.
vec3 innerAlbedo(SurfaceInfo s) {
#if DIFFUSE_ROUGHNESS
  vec3 albedo = eonAlbedo(s.baseColor, s.diffuseRoughness, s.NoV) * (1.0 - s.metallic);
#else
  vec3 albedo = s.diffuse;
#endif
#if FLATNESS
  albedo = mix(albedo, sheetReflectance(s.baseColor, s.NoV) * (1.0 - s.metallic), s.flatness);
#endif
#if DIFFUSE_TRANSMISSION
  albedo *= 1.0 - s.diffuseTransmission;
#endif
  return albedo;
}

#if DIFFUSE_TRANSMISSION
// Albedo of the light that goes through.
vec3 transmittedAlbedo(SurfaceInfo s) {
  return s.transmittedColor * (s.diffuseTransmission * (1.0 - s.metallic));
}

// Light from everywhere on the other side, of which only the mean is known.
// irradiance  linear Rec.709
Reflected addBehind(Reflected sum, SurfaceInfo s, vec3 irradiance) {
  sum.diffuse += irradiance * RECIPROCAL_PI * transmittedAlbedo(s) * s.leaving;
  return sum;
}
#endif

#if CLEARCOAT
vec3 coatLobe(SurfaceInfo s, vec3 l, vec3 h) {
  float NoL = saturate(dot(s.coatNormal, l));
  return evenLobe(s.coatNormal, s.v, s.clearcoatNoV, NoL, alphaFromRoughness(s.clearcoatRoughness), vec3(F0_DIELECTRIC), 1.0, h);
}
#endif

// Adds the light of one direction.
// l  unit, to the light; of length 0 it gives nothing      lightColor  irradiance on a surface that faces it, linear Rec.709
Reflected addPunctual(Reflected sum, SurfaceInfo s, vec3 l, vec3 lightColor) {
  float cosine = dot(s.n, l);
  vec3 h = halfVector(s.n, l, s.v);
#if CLEARCOAT
  sum.coat += lightColor * coatLobe(s, l, h);
#endif
#if DIFFUSE_TRANSMISSION
  float behind = saturate(-cosine);
  sum.diffuse += lightColor * (behind * RECIPROCAL_PI) * transmittedAlbedo(s) * s.passing * passingShare(s, albedoTowards(s, l, behind));
#endif
#if NORMAL_MAP
  lightColor *= bumpTerminator(s.bumpAlpha2, dot(s.geometricNormal, l));
#endif
  float NoL = saturate(cosine);
#if SHEEN
  sum.sheen += lightColor * s.sheenColor * sheenCosine(s.sheenView, s.NoV, NoL, dot(l, s.v));
#endif
  GlossAlbedo albedo = albedoTowards(s, l, NoL);
  sum.specular += lightColor * (glossLobe(s, l, h, NoL) + returnedLobe(s, albedo) * NoL);
  sum.diffuse += lightColor * innerLobe(s, l, NoL) * s.passing * passingShare(s, albedo);
  return sum;
}

// What the gloss reflects at once of light from everywhere, [0, 1].
vec3 glossReflectance(SurfaceInfo s) {
  vec2 base = s.albedo.base;
#if WEAVE
  if (isWoven(s)) {
    vec2 weft = s.albedo.weft;
    return s.warp.coverage * (s.warp.f0 * (1.0 - base.x - base.y) + s.f90 * base.y) +
           s.weft.coverage * (s.weft.f0 * (1.0 - weft.x - weft.y) + s.f90 * weft.y);
  }
#endif
  return s.f0 * (1.0 - base.x - base.y) + s.f90 * base.y;
}

// What it reflects later, [0, 1].
vec3 glossReturn(SurfaceInfo s) {
#if WEAVE
  if (isWoven(s)) {
    return s.warp.returning * (s.warp.coverage * s.albedo.base.x) + s.weft.returning * (s.weft.coverage * s.albedo.weft.x);
  }
#endif
  return s.returning * s.albedo.base.x;
}

// Light from everywhere of which only the mean is known: that of ambient and hemisphere lights.
// irradiance  linear Rec.709
Reflected addDome(Reflected sum, SurfaceInfo s, vec3 irradiance) {
  vec3 radiance = irradiance * RECIPROCAL_PI;
#if CLEARCOAT
  sum.coat += radiance * s.coatAlbedo;
#endif
#if NORMAL_MAP
  radiance *= bumpMean(s.bumpAlpha2);
#endif
#if SHEEN
  sum.sheen += radiance * s.sheenColor * s.sheenAlbedo;
#endif
  sum.specular += radiance * (glossReflectance(s) + glossReturn(s));
  sum.diffuse += radiance * innerAlbedo(s) * s.leaving;
  return sum;
}

// Adds what the surface reflects of the prefiltered environment.
Reflected addEnvironment(Reflected sum, SurfaceInfo s, Incident incident) {
  vec3 meanRadiance = incident.environmentIrradiance * RECIPROCAL_PI;
#if CLEARCOAT
  sum.coat += incident.coatRadiance * s.coatAlbedo;
#endif
#if NORMAL_MAP
  float unhidden = bumpMean(s.bumpAlpha2);
  meanRadiance *= unhidden;
  incident.radiance *= unhidden;
#endif
#if SHEEN
  sum.sheen += meanRadiance * s.sheenColor * s.sheenAlbedo;
#endif
  sum.specular += incident.radiance * glossReflectance(s) + meanRadiance * glossReturn(s);
  sum.diffuse += meanRadiance * innerAlbedo(s) * s.leaving;
  return sum;
}

// The fits of the coat's albedo and of what lies under it may both be short: so much more is taken off below the coat.
const float COAT_MARGIN = 0.001;

// Radiance that leaves towards the viewer, linear Rec.709.
// diffuse  of both, or what is seen through a transmissive surface in its place      emitted  linear Rec.709
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
