// Importance sampling of the BSDF: a mixture of the lobes of a surface, after preparedSurface(). The density is above 0
// wherever the BSDF is, in every shading. No uniforms and no textures: also compiled as C++ (renderer/brdf/shading.h), with
// every layer on.

// Least albedo that a lobe counts with: its albedo is estimated, and the estimate may be too low.
const float MIN_LOBE_ALBEDO = 0.1;

// About the albedo of a white sheen, mean of roughnesses and angles.
const float SHEEN_ALBEDO = 0.5;

// A shading or mapped normal may face away from a viewer who sees the surface. The viewer then counts as grazing.
const float MIN_VIEWER_COSINE = 1.0e-3;

// n  unit      t  the x axis of alpha; need not be orthogonal to n      v  unit, to the viewer
MicrofacetLobe microfacetLobe(vec3 n, vec3 t, vec2 alpha, vec3 v) {
  MicrofacetLobe lobe;
  vec3 across = t - n * dot(n, t);
  vec3 x = dot(across, across) > SQUARED_LENGTH_EPSILON ? normalize(across) : basisAbout(n)[0];
  lobe.frame = mat3(x, cross(n, x), n);
  lobe.v = v * lobe.frame;
  lobe.v = normalize(vec3(lobe.v.x, lobe.v.y, max(lobe.v.z, MIN_VIEWER_COSINE)));
  lobe.alpha = alpha;
  return lobe;
}

// The lobes of a surface, each with about the share that it has of the albedo at this view.
LobeMixture lobeMixture(SurfaceInfo s) {
  LobeMixture lobes;
  lobes.cosineFrame = basisAbout(s.n);
  lobes.cosineShare = max(max3(s.diffuse), MIN_LOBE_ALBEDO);
  lobes.baseShare = max(max3(F_Schlick(s.f0, s.f90, s.NoV)), MIN_LOBE_ALBEDO);
  float whole = lobes.cosineShare + lobes.baseShare;
#if CLEARCOAT
  lobes.coatShare = s.clearcoat * max(F_Schlick(vec3(F0_DIELECTRIC), 1.0, s.clearcoatNoV).x, MIN_LOBE_ALBEDO);
  whole += lobes.coatShare;
#endif
#if DIFFUSE_TRANSMISSION
  lobes.transmissionShare = s.diffuseTransmission * max(max3(s.diffuse), MIN_LOBE_ALBEDO);
  whole += lobes.transmissionShare;
#endif
#if SHEEN
  lobes.sheenShare = SHEEN_ALBEDO * max3(s.sheenColor);
  whole += lobes.sheenShare;
#endif
  lobes.cosineShare /= whole;
  lobes.baseShare /= whole;
#if CLEARCOAT
  lobes.coatShare /= whole;
  if (lobes.coatShare > 0.0) {
    lobes.coat = microfacetLobe(s.coatNormal, basisAbout(s.coatNormal)[0], vec2(alphaFromRoughness(s.clearcoatRoughness)), s.v);
  }
#endif
#if DIFFUSE_TRANSMISSION
  lobes.transmissionShare /= whole;
#endif
#if SHEEN
  lobes.sheenShare /= whole;
#if SHADING_FABRIC
  if (lobes.sheenShare > 0.0) {
    lobes.sheenFrame = microfacetLobe(s.n, s.v, vec2(1.0), s.v).frame;
    lobes.sheenLtc = sheenLtc(max(s.sheenRoughness, CLOTH_SHEEN_ROUGHNESS_MIN), s.NoV);
  }
#endif
#endif
#if WEAVE
  lobes.woven = isWoven(s);
  lobes.weftShare = 0.0;
  if (lobes.woven) {
    lobes.base = microfacetLobe(s.warp.n, s.warp.t, vec2(s.warp.alphaT, s.warp.alphaB), s.v);
    lobes.weft = microfacetLobe(s.weft.n, s.weft.t, vec2(s.weft.alphaT, s.weft.alphaB), s.v);
    lobes.weftShare = lobes.baseShare * s.weft.coverage / (s.warp.coverage + s.weft.coverage);
    lobes.baseShare -= lobes.weftShare;
    return lobes;
  }
#endif
#if ANISOTROPY
  lobes.base = microfacetLobe(s.n, s.t, vec2(max(s.alphaT, s.alpha), s.alpha), s.v);
#else
  lobes.base = microfacetLobe(s.n, lobes.cosineFrame[0], vec2(s.alpha), s.v);
#endif
  return lobes;
}

vec3 sampleLobe(MicrofacetLobe lobe, vec2 u) {
  return lobe.frame * sampleReflection(lobe.v, lobe.alpha, u);
}

float pdfLobe(MicrofacetLobe lobe, vec3 l) {
#if ALL_TERMS
  // No microfacet that the viewer sees reflects him to there.
  if (lobe.v.z + dot(lobe.frame[2], l) <= 0.0) return 0.0;
#endif
  return pdfReflection(lobe.v, l * lobe.frame, lobe.alpha);
}

// A lobe of the base. A yarn that leans reflects below the surface too; the shading mirrors that light back, and so do the
// samples.
vec3 sampleBase(LobeMixture lobes, MicrofacetLobe lobe, vec2 u) {
  vec3 l = sampleLobe(lobe, u);
#if WEAVE_MAP
  vec3 n = lobes.cosineFrame[2];
  if (lobes.woven) l -= (2.0 * min(dot(n, l), 0.0)) * n;
#endif
  return l;
}

float pdfBase(LobeMixture lobes, MicrofacetLobe lobe, vec3 l) {
  float pdf = pdfLobe(lobe, l);
#if WEAVE_MAP
  if (lobes.woven) {
    vec3 n = lobes.cosineFrame[2];
    float cosine = dot(n, l);
    pdf = cosine < 0.0 ? 0.0 : pdf + pdfLobe(lobe, l - (2.0 * cosine) * n);
  }
#endif
  return pdf;
}

#if SHEEN
// Sheen is brightest at grazing angles. The fabric's sheen has a lobe that can be sampled; for the others, directions are uniform.
vec3 sampleSheen(LobeMixture lobes, vec2 u) {
#if SHADING_FABRIC
  return lobes.sheenFrame * sampleSheenLtc(lobes.sheenLtc, u);
#else
  return lobes.cosineFrame * sampleHemisphere(u);
#endif
}

float pdfSheen(LobeMixture lobes, vec3 l) {
#if SHADING_FABRIC
  return sheenLtcCosine(vec3(1.0, lobes.sheenLtc.y, lobes.sheenLtc.z), l * lobes.sheenFrame);
#else
  return pdfHemisphere(dot(lobes.cosineFrame[2], l));
#endif
}
#endif

// u  [0, 1)^2; its x chooses the lobe
vec3 sampleMixture(LobeMixture lobes, vec2 u) {
  if (u.x < lobes.baseShare) return sampleBase(lobes, lobes.base, vec2(u.x / lobes.baseShare, u.y));
  u.x -= lobes.baseShare;
#if WEAVE
  if (u.x < lobes.weftShare) return sampleBase(lobes, lobes.weft, vec2(u.x / lobes.weftShare, u.y));
  u.x -= lobes.weftShare;
#endif
#if CLEARCOAT
  if (u.x < lobes.coatShare) return sampleLobe(lobes.coat, vec2(u.x / lobes.coatShare, u.y));
  u.x -= lobes.coatShare;
#endif
#if DIFFUSE_TRANSMISSION
  if (u.x < lobes.transmissionShare) return -(lobes.cosineFrame * sampleCosine(vec2(u.x / lobes.transmissionShare, u.y)));
  u.x -= lobes.transmissionShare;
#endif
#if SHEEN
  if (u.x < lobes.sheenShare) return sampleSheen(lobes, vec2(u.x / lobes.sheenShare, u.y));
  u.x -= lobes.sheenShare;
#endif
  return lobes.cosineFrame * sampleCosine(vec2(u.x / lobes.cosineShare, u.y));
}

// Density of sampleMixture(), per steradian.
// l  unit
float pdfMixture(LobeMixture lobes, vec3 l) {
  float pdf = lobes.baseShare * pdfBase(lobes, lobes.base, l) + lobes.cosineShare * pdfCosine(dot(lobes.cosineFrame[2], l));
#if WEAVE
  if (lobes.weftShare > 0.0) pdf += lobes.weftShare * pdfBase(lobes, lobes.weft, l);
#endif
#if CLEARCOAT
  if (lobes.coatShare > 0.0) pdf += lobes.coatShare * pdfLobe(lobes.coat, l);
#endif
#if DIFFUSE_TRANSMISSION
  pdf += lobes.transmissionShare * pdfCosine(-dot(lobes.cosineFrame[2], l));
#endif
#if SHEEN
  if (lobes.sheenShare > 0.0) pdf += lobes.sheenShare * pdfSheen(lobes, l);
#endif
  return pdf;
}
