// What FabricLayers adds, in SurfaceInfo.

// A normal map must not turn the surface away from its viewer.
void turnToViewer(inout SurfaceInfo s, inout Normals normals) {
#if NORMAL_MAP
  s.n = normalFacing(s.n, s.v);
  s.geometricNormal = normals.geometric;
#if NORMAL_VARIANCE
  s.slopeVariance = normals.slopeVariance.x + normals.slopeVariance.y;
#else
  s.slopeVariance = 0.0;
#endif
#endif
#if CLEARCOAT_NORMAL_MAP
  normals.coat = normalFacing(normals.coat, s.v);
#endif
}

#if WEAVE
// Yarns within a pixel from which on their mean is shown, and from which on nothing else is.
#define YARNS_SEEN 0.25
#define YARNS_BLENDED 0.5

void addWeave(inout SurfaceInfo s, Normals normals, float geometric) {
  vec2 roughness = yarnRoughness;
#if METALLIC_ROUGHNESS_MAP
  roughness *= texture(metallicRoughnessMap, vMetallicRoughnessUv).g;
#endif
#if NORMAL_VARIANCE
  roughness = vec2(roughnessWithSlopes(roughness.x, normals.slopeVariance), roughnessWithSlopes(roughness.y, normals.slopeVariance));
#endif
  roughness = vec2(shadedRoughness(roughness.x, geometric), shadedRoughness(roughness.y, geometric));
  vec3 weft = safeNormalize(normals.frame[0] - s.n * dot(s.n, normals.frame[0]), anyTangent(s.n));
  vec3 warp = cross(s.n, weft);
  // Y of the tangent space runs against the derivatives' v, which follows the texture's rows downwards.
  float up = dot(warp, normals.frame[1]);
#if !TANGENT
  up = -up;
#endif
  warp *= up < 0.0 ? -1.0 : 1.0;
  vec2 coverage = yarnCoverage;
  vec2 turn = vec2(1.0, 0.0);
  float slope = 0.0;
#if WEAVE_MAP
  WeaveTexel texel = weaveTexel();
  coverage = (yarnCoverage.x + yarnCoverage.y) * vec2(texel.warp, 1.0 - texel.warp);
  turn = texel.turn;
  slope = texel.slope;
#if !FULL_DETAIL
  // The texel at hand is one thread or the other; from afar both are seen as they lie on average.
  vec2 threads = threadsPerPixel();
  float blend = smoothstep(YARNS_SEEN, YARNS_BLENDED, max(threads.x, threads.y));
  coverage = mix(coverage, yarnCoverage, blend);
  turn = mix(turn, vec2(1.0, 0.0), blend);
  slope *= 1.0 - blend;
#endif
#endif
  s.t = weft;
  s.b = warp;
  s.alphaT = s.alpha;
  s.anisotropyStrength = 0.0;
  s.warp = yarnLobe(s.n, warp, -weft, turn, slope, coverage.x, roughness.x, yarnAnisotropy.x, warpSpecularColor);
  s.weft = yarnLobe(s.n, weft, warp, turn, slope, coverage.y, roughness.y, yarnAnisotropy.y, weftSpecularColor);
}
#endif
