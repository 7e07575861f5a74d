// SurfaceInfo of a fragment, from factors and textures.
#include "material/layers.glsl"
#include "material/material_inputs.glsl"
#include "material/normal.glsl"

#if SHADING_FABRIC && AMBIENT_VISIBILITY
// Of the side that is seen, or of the other one.
vec4 visibilityOf(bool seenSide) {
#if FLIP_SIDED
  bool front = !seenSide;
#else
  bool front = frontFacing() == seenSide;
#endif
  if (front) return vVisibility;
#if AMBIENT_VISIBILITY_BACK
  return vVisibilityBack;
#else
  return vec4(0.0, 0.0, 0.0, 1.0);
#endif
}
#endif

SurfaceInfo surfaceInfo(vec3 baseColor) {
  MaterialInputs m = materialInputs(baseColor);
  Normals normals = shadingNormals();
#if BUMP && !NORMAL_MAP
  float height = m.bump * bumpTexel(bumpUv()).r;
  vec2 rise = vec2(m.bump * bumpTexel(bumpUv() + dFdx(bumpUv())).r - height, m.bump * bumpTexel(bumpUv() + dFdy(bumpUv())).r - height);
  normals.shading = bumpedNormal(normals.geometric, -dFdx(vViewPosition), -dFdy(vViewPosition), rise, frontFacing() ? 1.0 : -1.0);
#endif
#if NORMAL_VARIANCE && CLEARCOAT
  m = withCoatRelief(m, normals);
#endif
#if !SHADING_PRINCIPLED
  m = withShadedRoughness(m, geometricRoughness(dFdx(normals.geometric), dFdy(normals.geometric)));
#endif
  vec3 v = viewDirection();
#if SHADING_FABRIC
  normals = facingViewer(normals, v);
#endif
  SurfaceInfo s = baseSurface(m, normals, v);
#if METAL_MEANS
  vec4 metal = metalTexel();
#if BACK
  if (!seenFromBack())
#endif
    s = withMetalMeans(s, saturate(metallicFactor * vec3(metal) / max(colorTexel(), vec3(PART_MIN))));
#endif
#if SHADING_FABRIC && AMBIENT_VISIBILITY
  s = withVisibility(s, visibilityOf(true), visibilityOf(false));
#endif
#if SPECULAR
  s = withSpecular(s, m);
#endif
  s = withLayers(s, m, normals);
#if WEAVE
  s = withWeave(s, m, normals);
#if YARN_RELIEF
  s = withYarnRelief(s, m, yarnReliefTexel(), weaveTexel().a, normals.meanSlope);
#endif
#if METAL_YARNS
  s = withMetalYarns(s, metallicFactor * metal.a);
#endif
#endif
#if !SHADING_FABRIC
  s.dfg = splitSum(s.perceptualRoughness, s.NoV);
#if CLEARCOAT
  s.coatDfg = splitSum(s.clearcoatRoughness, s.clearcoatNoV);
#endif
#endif
  return preparedSurface(s);
}
