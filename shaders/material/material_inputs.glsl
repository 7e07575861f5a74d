// Factors times texels of a fragment.
#include "material/layer_inputs.glsl"

#if BACK
// Whether the back of the cloth is seen. FLIP_SIDED draws back faces as if they were front faces.
bool seenFromBack() {
#if FLIP_SIDED
  return frontFacing();
#else
  return !frontFacing();
#endif
}

// Base colour of the back, linear Rec.709.
vec3 backColor() {
#if BACK_COLOR_MAP
  return backColorFactor * texture(backColorMap, vBackColorUv).rgb;
#else
  return backColorFactor;
#endif
}
#endif

#if WEAVE_MAP
vec4 weaveTexel() { return texture(weaveMap, vWeaveUv); }

// Yarns that lie within one pixel: warp, weft; 0 where the file does not tell, and where many samples see each of them.
vec2 threadsPerPixel() {
#if FULL_DETAIL
  return vec2(0.0);
#else
  return threadsPerUv * max(abs(dFdx(vWeaveUv)), abs(dFdy(vWeaveUv)));
#endif
}
#endif

MaterialInputs materialInputs(vec3 baseColor) {
  vec4 metallicRoughness = metallicRoughnessTexel();
  MaterialInputs m;
  m.baseColor = baseColor;
  m.metallic = metallicFactor * metallicRoughness.b;
  m.roughness = roughnessFactor * metallicRoughness.g;
  m = withLayerInputs(m, metallicRoughness);
#if WEAVE_MAP
  vec4 weave = weaveTexel();
  m = withWeaveTexel(m, weave, threadsPerPixel());
#if METAL_YARNS
  m.yarnCoverage = sharesOfTexel(m.yarnCoverage, weave);
#endif
#endif
#if BACK
  if (seenFromBack()) {
    m.baseColor = backColor();
    m.roughness = backRoughness;
  }
#endif
  return m;
}
