// What the layers of a material make of a surface: pure functions from factors times texels (MaterialInputs) to SurfaceInfo.
// No uniforms and no textures: also compiled as C++ (renderer/brdf/shading.h), with every layer on. The caller fetches
// texels, knows the frame of the surface, and looks up the split sum. The layers are in the order of three r187.

// Roughnesses to shade with: at least the floor, and higher where the normal turns within a pixel. The principled shadings take
// roughness as authored.
// geometric  geometricRoughness()
MaterialInputs withShadedRoughness(MaterialInputs m, float geometric) {
#if ALL_TERMS || THREE_ROUGHNESS_MIN_TERM == THREE_ROUGHNESS_MIN_0_0525
  if (RELEASE(m, roughnessMin, THREE_ROUGHNESS_MIN_TERM) == THREE_ROUGHNESS_MIN_0_0525) {
    m.roughness = max(m.roughness, PERCEPTUAL_ROUGHNESS_MIN_R186);
#if CLEARCOAT
    m.clearcoatRoughness = max(m.clearcoatRoughness, PERCEPTUAL_ROUGHNESS_MIN_R186);
#endif
  }
#endif
  m.roughness = shadedRoughness(m.roughness, geometric);
#if CLEARCOAT
  m.clearcoatRoughness = shadedRoughness(m.clearcoatRoughness, geometric);
#endif
#if WEAVE
  m.yarnRoughness = vec2(shadedRoughness(m.yarnRoughness.x, geometric), shadedRoughness(m.yarnRoughness.y, geometric));
#endif
  return m;
}

#if NORMAL_VARIANCE && CLEARCOAT
// Widens the coat by what its normal map has within the pixel. The other lobes: withRelief() of the shading "fabric".
MaterialInputs withCoatRelief(MaterialInputs m, Normals normals) {
  m.clearcoatRoughness = roughnessWithSlopes(m.clearcoatRoughness, normals.coatRelief.y);
  return m;
}
#endif

#if WEAVE_MAP
// Shares of warp and weft as a texel of a weave map has them.   coverage  of the material
vec2 sharesOfTexel(vec2 coverage, vec4 texel) { return (coverage.x + coverage.y) * vec2(texel.w, 1.0 - texel.w); }

// From YARNS_SEEN yarns a pixel on, the mean of the yarns is blended in; from YARNS_BLENDED on, nothing else is shown.
const float YARNS_SEEN = 0.25;
const float YARNS_BLENDED = 0.5;

// The yarn on top at a texel of a weave map.
// texel    RG = (cos, sin) / 2 + 1/2 of the angle by which the yarn is turned counter-clockwise out of its own axis (warp v,
//          weft u), B = sin / 2 + 1/2 of its slope along it, A = 0 weft .. 1 warp; averages of mip levels are shorter where the
//          yarns of a texel differ
// threads  yarns that lie within a pixel: warp, weft; 0 where many samples see each of them
MaterialInputs withWeaveTexel(MaterialInputs m, vec4 texel, vec2 threads) {
  vec2 coverage = sharesOfTexel(m.yarnCoverage, texel);
  m.yarnTurn = 2.0 * vec2(texel) - 1.0;
  m.yarnSlope = 2.0 * texel.z - 1.0;
  // Near, a texel is one yarn or the other. From afar both are shown as they lie on average.
  float blend = smoothstep(YARNS_SEEN, YARNS_BLENDED, max(threads.x, threads.y));
  m.yarnCoverage = mix(coverage, m.yarnCoverage, blend);
  m.yarnTurn = mix(m.yarnTurn, vec2(1.0, 0.0), blend);
  m.yarnSlope *= 1.0 - blend;
  return m;
}
#endif

#if BUMP
// EXT_materials_bump: the change of height from one pixel to the next tilts the normal. As in three.js the unit of height is the
// width of a pixel. So a map is as deep at every scale of the model, and shallower in a larger picture.
// dpdx, dpdy  change of place to the right and upwards, any length
// rise        change of height likewise
// face        1 on the front, -1 on the back
// src: Mikkelsen 2010, "Bump Mapping Unparametrized Surfaces on the GPU"
vec3 bumpedNormal(vec3 n, vec3 dpdx, vec3 dpdy, vec2 rise, float face) {
  vec3 right = safeNormalize(dpdx, n);
  vec3 up = safeNormalize(dpdy, n);
  vec3 alongRight = cross(up, n);
  float area = face * dot(right, alongRight);
  vec3 slope = rise.x * alongRight + rise.y * cross(n, right);
  return safeNormalize(abs(area) * n - (area < 0.0 ? -1.0 : 1.0) * slope, n);
}
#endif

#if SHADING_FABRIC
// Turns normals that face away from the viewer until they just face him, as cloth is shaded.
Normals facingViewer(Normals normals, vec3 v) {
#if NORMAL_MAP || BUMP
  normals.shading = normalFacing(normals.shading, v);
#endif
#if CLEARCOAT_NORMAL_MAP
  normals.coat = normalFacing(normals.coat, v);
#endif
  return normals;
}
#endif

// Metallic-roughness alone.
// v  unit, to the viewer
SurfaceInfo baseSurface(MaterialInputs m, Normals normals, vec3 v) {
#if ALL_TERMS
  SurfaceInfo s = SurfaceInfo();  // in C++, where no layer may be left out: all are 0
  s.three = m.three;
#else
  SurfaceInfo s;
#endif
  s.n = normals.shading;
  s.v = v;
  s.NoV = saturate(dot(s.n, s.v));
  s.baseColor = m.baseColor;
  s.metallic = m.metallic;
  s.diffuse = diffuseAlbedo(m.baseColor, m.metallic);
  s.f0Dielectric = vec3(F0_DIELECTRIC);
  s.f90 = 1.0;
  s.perceptualRoughness = m.roughness;
  s.alpha = alphaFromRoughness(m.roughness);
#if SHADING_FABRIC
  s.metalColor = m.baseColor;
#if NORMAL_MAP
  s.geometricNormal = normals.geometric;
#endif
#endif
#if SHADING_FABRIC && RELIEF
  s.relief = normals.relief.x;
  s.slopeVariance = normals.relief.y;
  s.reliefAxis = normals.reliefAxis;
#endif
#if SHADING_FABRIC && FACETS
  s.edges.share = normals.edgeShare;
  s.facetsTold = normals.facetsTold;
#endif
#if SHADING_FABRIC && AMBIENT_VISIBILITY
  s.faceNormal = s.openDirection = normals.geometric;
  s.visibility = s.visibilityBehind = 1.0;
#endif
  return s;
}

#if SHADING_FABRIC && AMBIENT_VISIBILITY
// What of light from everywhere reaches the point.
// side, other  of the side that is seen and of the other: xyz mean open direction, any length, 0 = the normal; w open part
SurfaceInfo withVisibility(SurfaceInfo s, vec4 side, vec4 other) {
  s.openDirection = safeNormalize(vec3(side), s.faceNormal);
  s.visibility = saturate(side.w);
  s.visibilityBehind = saturate(other.w);
  return s;
}
#endif

#if SHADING_FABRIC && METAL_MEANS
const float PART_MIN = 0.002;  // of metal or of the rest, below which its colour is not told

// Of a pixel in which metal and the rest differ in colour: means of base colour and metalness are no longer of one material.
// share  of the base colour that is metal's, [0, 1] a channel
SurfaceInfo withMetalMeans(SurfaceInfo s, vec3 share) {
  vec3 color = s.baseColor;
  s.metalColor = min(color * share / max(s.metallic, PART_MIN), vec3(1.0));
  s.baseColor = min(color * (1.0 - share) / max(1.0 - s.metallic, PART_MIN), vec3(1.0));
  s.diffuse = diffuseAlbedo(s.baseColor, s.metallic);
  return s;
}
#endif

#if SPECULAR
// KHR_materials_specular and KHR_materials_ior.
SurfaceInfo withSpecular(SurfaceInfo s, MaterialInputs m) {
  s.f90 = mix(m.specular, 1.0, s.metallic);
  s.f0Dielectric = min(pow2((m.ior - 1.0) / (m.ior + 1.0)) * m.specularColor, vec3(1.0)) * m.specular;
  return s;
}
#endif

#if ANISOTROPY
// KHR_materials_anisotropy: the highlight is stretched along the vector. A texel turns and shortens the vector.
SurfaceInfo withAnisotropy(SurfaceInfo s, MaterialInputs m, mat3 frame) {
  vec2 axis = 2.0 * vec2(m.anisotropyTexel) - 1.0;
  axis = dot(axis, axis) > 0.0 ? normalize(axis) : vec2(1.0, 0.0);
  vec2 stretch = m.anisotropyVector;
  vec2 direction = vec2(stretch.x * axis.x - stretch.y * axis.y, stretch.y * axis.x + stretch.x * axis.y) * m.anisotropyTexel.z;
#if ALL_TERMS
  if (m.three.anisotropyDirection == THREE_ANISOTROPY_DIRECTION_NONE) direction = vec2(0.0);
#endif
  s.anisotropyStrength = length(direction);
  direction = s.anisotropyStrength == 0.0 ? vec2(1.0, 0.0) : direction / s.anisotropyStrength;
  s.anisotropyStrength = saturate(s.anisotropyStrength);
  s.alphaT = alphaAlongTangent(s.perceptualRoughness, s.anisotropyStrength);
  s.t = frame[0] * direction.x + frame[1] * direction.y;
  s.b = frame[1] * direction.x - frame[0] * direction.y;
#if ALL_TERMS || THREE_ANISOTROPY_DIRECTION_TERM == THREE_ANISOTROPY_DIRECTION_TURNED_BACK
  if (RELEASE(m, anisotropyDirection, THREE_ANISOTROPY_DIRECTION_TERM) == THREE_ANISOTROPY_DIRECTION_TURNED_BACK) {
    s.t = frame[0] * direction.x - frame[1] * direction.y;
    s.b = frame[1] * direction.x + frame[0] * direction.y;
  }
#endif
  return s;
}
#endif

#if IRIDESCENCE
// KHR_materials_iridescence: a thin film.
SurfaceInfo withFilm(SurfaceInfo s, MaterialInputs m) {
  s.iridescence = m.iridescenceThickness == 0.0 ? 0.0 : saturate(m.iridescence);
#if ALL_TERMS
  // C++ has every layer on, so it skips a film that is not there: it costs much.
  s.filmFresnel = s.filmF0Dielectric = s.filmF0Metal = vec3(0.0);
  if (s.iridescence == 0.0) return s;
#endif
  vec3 dielectric = F_Iridescence(m.iridescenceIor, m.iridescenceThickness, s.NoV, s.f0Dielectric);
#if SHADING_FABRIC
  vec3 metal = F_Iridescence(m.iridescenceIor, m.iridescenceThickness, s.NoV, s.metalColor);
#else
  vec3 metal = F_Iridescence(m.iridescenceIor, m.iridescenceThickness, s.NoV, s.baseColor);
#endif
#if ALL_TERMS || THREE_FILM_METAL_TERM == THREE_FILM_METAL_ONE_FILM
  if (RELEASE(m, filmMetal, THREE_FILM_METAL_TERM) == THREE_FILM_METAL_ONE_FILM) {
    dielectric = metal = F_Iridescence(m.iridescenceIor, m.iridescenceThickness, s.NoV, s.f0);
  }
#endif
  s.filmFresnel = mix(dielectric, metal, s.metallic);
  s.filmF0Dielectric = f0FromSchlick(dielectric, s.NoV);
  s.filmF0Metal = f0FromSchlick(metal, s.NoV);
#if ALL_TERMS || THREE_FILM_ENVIRONMENT_TERM == THREE_FILM_ENVIRONMENT_REFLECTANCE
  if (RELEASE(m, filmEnvironment, THREE_FILM_ENVIRONMENT_TERM) == THREE_FILM_ENVIRONMENT_REFLECTANCE) {
    s.filmF0Dielectric = dielectric;
    s.filmF0Metal = metal;
  }
#endif
  return s;
}
#endif

#if SHEEN
// KHR_materials_sheen.
SurfaceInfo withSheen(SurfaceInfo s, MaterialInputs m) {
  s.sheenColor = m.sheenColor;
  // Above 0 after the texture too: three.js gives NaN for a texel of 0.
  s.sheenRoughness = clamp(m.sheenRoughness, SHEEN_ROUGHNESS_MIN, 1.0);
  return s;
}
#endif

#if CLEARCOAT
// KHR_materials_clearcoat.
SurfaceInfo withCoat(SurfaceInfo s, MaterialInputs m, vec3 normal) {
  s.coatNormal = normal;
  s.clearcoat = saturate(m.clearcoat);
  s.clearcoatRoughness = m.clearcoatRoughness;
  s.clearcoatNoV = saturate(dot(normal, s.v));
  return s;
}
#endif

#if WEAVE
// One set of yarns as it lies at a point.
// axis          its own axis in the tangent plane, unit: warp +Y, weft +X of the tangent frame (n, axis and aside = +Y for
//               weft and -X for warp are a right-handed frame)
// turn          cosine and sine of the angle by which it is turned out of its axis towards `aside`
// slope         sine of the angle by which it rises along itself
// roughness     perceptual, along it, (0, 1]      anisotropy  [0, 1], how much rougher across it
YarnLobe yarnLobe(vec3 n, vec3 axis, vec3 aside, vec2 turn, float slope, float coverage, float roughness, float anisotropy,
                  vec3 specularColor) {
#if ALL_TERMS
  YarnLobe yarn = YarnLobe();  // as in baseSurface(): what no layer sets is 0
#else
  YarnLobe yarn;
#endif
  yarn.lying = safeNormalize(axis * turn.x + aside * turn.y, axis);
  float rise = clamp(slope, -0.95, 0.95);
  float level = sqrt(1.0 - pow2(rise));
  yarn.t = yarn.lying * level + n * rise;
  yarn.n = n * level - yarn.lying * rise;
  yarn.b = cross(n, yarn.lying);
  yarn.coverage = coverage;
  yarn.alphaT = alphaFromRoughness(roughness);
  yarn.alphaB = mix(yarn.alphaT, 1.0, pow2(anisotropy));
  yarn.specularColor = specularColor;
  return yarn;
}

#if YARN_RELIEF
// Below this share of a pixel, the measured normals of a set of yarns count less and less, as few texels tell them.
const float YARN_SHARE_TOLD = 0.1;

// Variances of slopes. From the first on, relief turns so many normals below the horizon that the yarns' axis fades; from the second on
// there is none.
const float YARN_RELIEF_LOW = 0.083;
const float YARN_RELIEF_HIGH = 0.25;

// YarnLobe::slopeVariance of one set of yarns: the variance of all normals, shared out along it and across it as its own are.
// flatness   means of 1 / (1 + 4 slope^2) along and across it, times its share      meanSlope  of the pixel, likewise
// variance   of the slopes of all normals, the sum of both axes
vec2 yarnSlopeVariance(float variance, vec2 flatness, float share, vec2 meanSlope) {
  vec2 squares = 0.25 * share / max(flatness, vec2(1.0e-3)) - 0.25;
  vec2 own = max(squares - meanSlope * meanSlope, vec2(0.0)) + 0.05 * variance;  // a small one is not told exactly
  vec2 shares = own * (2.0 / max(own.x + own.y, 1.0e-5));
  float axis = saturate((YARN_RELIEF_HIGH - variance) / (YARN_RELIEF_HIGH - YARN_RELIEF_LOW)) * saturate(share / YARN_SHARE_TOLD);
  return variance * mix(vec2(1.0), shares, axis);
}

// Tells the relief of warp and weft apart.
// texel  of texture/yarns.glsl      warp  share of the pixel, [0, 1]      slope  mean of the normal map's, +Y up the texture
SurfaceInfo withYarnRelief(SurfaceInfo s, MaterialInputs m, vec4 texel, float warp, vec2 slope) {
  vec2 turn = vec2(safeNormalize(vec3(m.yarnTurn, 0.0), vec3(1.0, 0.0, 0.0)));
  float rise = clamp(m.yarnSlope, -0.95, 0.95);
  rise *= inversesqrt(1.0 - rise * rise);
  float inTurn = dot(slope, turn);
  float aside = slope.y * turn.x - slope.x * turn.y;
  s.warp.slopeVariance = yarnSlopeVariance(s.slopeVariance, vec2(texel.x, texel.y), warp, vec2(aside - rise, inTurn));
  s.weft.slopeVariance = yarnSlopeVariance(s.slopeVariance, vec2(texel.z, texel.w), 1.0 - warp, vec2(inTurn - rise, aside));
  return s;
}
#endif

#if METAL_YARNS
// Metal that lies in one set of yarns alone is theirs.   warp  metalness of a pixel that lies in the warp, times its share, [0, 1]
SurfaceInfo withMetalYarns(SurfaceInfo s, float warp) {
  vec2 shares = vec2(s.warp.coverage, s.weft.coverage) / max(s.warp.coverage + s.weft.coverage, PART_MIN);
  s.warp.metallic = saturate(warp / max(shares.x, PART_MIN));
  s.weft.metallic = saturate((s.metallic - warp) / max(shares.y, PART_MIN));
  return s;
}
#endif

// The two sets of yarns of TELAR_materials_fabric, along the frame on the shading normal.
SurfaceInfo withWeave(SurfaceInfo s, MaterialInputs m, Normals normals) {
  vec3 weft = safeNormalize(normals.frame[0] - s.n * dot(s.n, normals.frame[0]), anyTangent(s.n));
  vec3 warp = cross(s.n, weft);
  warp *= dot(warp, normals.frame[1]) * normals.upward < 0.0 ? -1.0 : 1.0;
  s.t = weft;
  s.b = warp;
  s.alphaT = s.alpha;
  s.anisotropyStrength = 0.0;
  s.warp = yarnLobe(s.n, warp, -weft, m.yarnTurn, m.yarnSlope, m.yarnCoverage.x, m.yarnRoughness.x, m.yarnAnisotropy.x, m.warpSpecularColor);
  s.weft = yarnLobe(s.n, weft, warp, m.yarnTurn, m.yarnSlope, m.yarnCoverage.y, m.yarnRoughness.y, m.yarnAnisotropy.y, m.weftSpecularColor);
  s.warp.metallic = s.weft.metallic = s.metallic;
#if RELIEF
  s.warp.slopeVariance = s.weft.slopeVariance = vec2(s.slopeVariance);
#endif
  return s;
}
#endif

// Adds every other layer.
SurfaceInfo withLayers(SurfaceInfo s, MaterialInputs m, Normals normals) {
  s.f0 = mix(s.f0Dielectric, s.baseColor, s.metallic);
#if DIFFUSE_ROUGHNESS
  s.diffuseRoughness = saturate(m.diffuseRoughness);
#if ALL_TERMS
  if (m.three.diffuseRoughness == THREE_DIFFUSE_ROUGHNESS_NONE) s.diffuseRoughness = 0.0;
#endif
#endif
#if ANISOTROPY
  s = withAnisotropy(s, m, normals.frame);
#endif
#if IRIDESCENCE
  s = withFilm(s, m);
#endif
#if SHEEN
  s = withSheen(s, m);
#endif
#if CLEARCOAT
  s = withCoat(s, m, normals.coat);
#endif
#if DIFFUSE_TRANSMISSION
  s.transmittedColor = m.diffuseTransmissionColor;
  s.diffuseTransmission = saturate(m.diffuseTransmission);
#endif
#if FLATNESS
  s.flatness = m.flatness;
#endif
  return s;
}
