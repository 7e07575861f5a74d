// Energies of telar's cloth: what the gloss reflects after one bounce and after more, and what it leaves to the layers below.
// Each is given for one direction and for uniform light. No uniforms and no textures: also compiled as C++
// (renderer/brdf/shading.h), with every layer on. fabric.glsl comes after it.

#if WEAVE
// A shader has WEAVE for woven cloth alone; C++ has every layer on.
bool isWoven(SurfaceInfo s) {
#if ALL_TERMS
  return s.warp.coverage + s.weft.coverage > 0.0;
#else
  return true;
#endif
}

// Replaces the yarns by one lobe, with which the prefiltered environment is read. Its widths are the second moments of both sets
// of yarns along the axes of the frame.
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

// glossAlbedo() of one set of yarns for one direction.
// along, across, n  its frame: for lights as it lies, for the viewer as it leans      cosine  [0, 1], with n
vec2 yarnAlbedo(YarnLobe yarn, vec3 along, vec3 across, vec3 direction, float cosine) {
  return stretchedAlbedo(yarn.gloss, cosine, dot(across, direction), dot(along, direction));
}
#endif

#if FACETS
// A shader has FACETS for polished reliefs alone; C++ has every layer on.
bool hasEdges(SurfaceInfo s) {
#if ALL_TERMS
  return s.edges.share > 0.0;
#else
  return true;
#endif
}
#endif

#if ANISOTROPY
// Where a map takes the anisotropy away, the lobe and its curves are the isotropic ones.
bool isStretched(SurfaceInfo s) {
  return s.alphaT > s.alpha;
}
#endif

// Albedo of the gloss for one direction.   cosine  [0, 1], with n
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

// Lobe of multiple scattering between the microfacets, without the cosine of the light, [1/sr].   albedo  of the gloss towards it
vec3 returnedLobe(SurfaceInfo s, GlossAlbedo albedo) {
#if WEAVE
  if (isWoven(s)) return s.warp.returningLobe * albedo.base.x + s.weft.returningLobe * albedo.weft.x;
#endif
  return s.returningLobe * albedo.base.x;
}

// Makes the axes square to the normal, which a map may have turned, and to each other. On axes that lean, the lobe would have
// a second peak.
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
// Sets the energies of one set of yarns, by its own widths.
// f0Metal  normal reflectance of the metal
YarnLobe withYarnEnergies(SurfaceInfo s, YarnLobe yarn, vec3 f0Metal) {
  yarn.gloss = stretchedCurve(yarn.alphaB, yarn.alphaT);
#if WEAVE_MAP
  // A yarn that leans away from the viewer is turned until it just faces him.
  yarn.n = normalFacing(yarn.n, s.v);
  yarn.t = safeNormalize(cross(yarn.b, yarn.n), anyTangent(yarn.n));
  yarn.b = cross(yarn.n, yarn.t);
#endif
  yarn.albedo = yarnAlbedo(yarn, yarn.t, yarn.b, s.v, saturate(dot(yarn.n, s.v)));
  yarn.f0Dielectric = s.f0Dielectric * yarn.specularColor;
  yarn.f0 = mix(s.f0Dielectric, f0Metal, yarn.metallic) * yarn.specularColor;
  float average = yarn.gloss.average.x;
  yarn.returningDielectric = returningShare(yarn.f0Dielectric, s.f90, average);
  yarn.returning = mix(yarn.returningDielectric, returningShare(f0Metal * yarn.specularColor, s.f90, average), yarn.metallic);
  yarn.returningLobe = yarn.returning * (yarn.coverage * yarn.albedo.x * RECIPROCAL_PI / average);
  return yarn;
}
#endif

#if RELIEF
#if WEAVE
// Relief that hides what yarns reflect: they lean as the normals do, and once more about these. With these factors the gloss of satin,
// silk, denim and calendered nylon under a white sky is within 3 %, and that of brocade with its metal weft within 9 %.
float yarnRelief(SurfaceInfo s, YarnLobe yarn) {
  float leaning = 1.0 - inversesqrt(1.0 + yarn.slopeVariance.x + yarn.slopeVariance.y);
  return min((2.0 - yarn.metallic) * max(leaning, s.relief), 1.0);
}
#endif

// By how much more a relief reflects than its mean normal before a layer below is reached; at grazing angles, how much less.
// curve  of grazingCurve()
float grazingOfRelief(float relief, vec4 curve, float NoV) { return reliefGrazing(relief, curve, NoV) - glossGrazing(curve, NoV); }

// Albedo of the gloss towards the viewer, the mean over the normals of a relief. Facets lie too flat for it to differ.
GlossAlbedo albedoOfRelief(SurfaceInfo s) {
  GlossAlbedo albedo = s.albedo;
#if FACETS
  if (hasEdges(s)) return albedo;
#endif
#if WEAVE
  if (isWoven(s)) {
    albedo.base.y += grazingOfRelief(yarnRelief(s, s.warp), s.warp.gloss.even.grazing, s.NoV);
    albedo.weft.y += grazingOfRelief(yarnRelief(s, s.weft), s.weft.gloss.even.grazing, s.NoV);
    return albedo;
  }
#endif
  albedo.base.y += grazingOfRelief(s.relief, s.gloss.grazing, s.NoV);
  return albedo;
}
#endif

// Sets what the gloss reflects and what it leaves.   f0Metal  normal reflectance of the metal
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
#if RELIEF
  s.leaving = passingShare(s, albedoOfRelief(s));
#else
  s.leaving = passingShare(s, s.albedo);
#endif
  s.passing = s.leaving / max(passingShare(s, average), vec3(PASSING_MIN));
  return s;
}

// Parts of a gloss's albedo that belong to f0 and f90.
vec2 glossParts(vec2 albedo) { return vec2(1.0 - albedo.x - albedo.y, albedo.y); }

#if WEAVE
// Share of uniform light that one set of yarns reflects after one bounce, [0, 1].
vec3 yarnReflectance(SurfaceInfo s, YarnLobe yarn) {
  vec2 parts = glossParts(yarn.albedo);
#if RELIEF
  parts *= yarn.glossKept;
#endif
  return yarn.coverage * (yarn.f0 * parts.x + s.f90 * parts.y);
}
#endif

// Share of uniform light that the gloss reflects after one bounce, [0, 1].
vec3 glossReflectance(SurfaceInfo s) {
  vec2 albedo = s.albedo.base;
#if WEAVE
  if (isWoven(s)) return yarnReflectance(s, s.warp) + yarnReflectance(s, s.weft);
#endif
#if ANISOTROPY
  if (!isStretched(s))
#endif
    albedo.y = max(albedo.y - grazingExcess(s.glossRoughness, s.NoV), 0.0);
  vec2 parts = glossParts(albedo);
#if RELIEF
  parts *= s.glossKept;
#endif
  return s.f0 * parts.x + s.f90 * parts.y;
}

// Share that it reflects after more bounces, [0, 1].
vec3 glossReturn(SurfaceInfo s) {
#if WEAVE
  if (isWoven(s)) {
    return s.warp.returning * (s.warp.coverage * s.albedo.base.x) + s.weft.returning * (s.weft.coverage * s.albedo.weft.x);
  }
#endif
  return s.returning * s.albedo.base.x;
}
