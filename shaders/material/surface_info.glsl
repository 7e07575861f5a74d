// SurfaceInfo of a fragment, from factors and textures.

uniform sampler2D dfgMap;  // RG = (A, B) of the split sum; x = perceptualRoughness, y = NoV, texel centres at (i + 0.5) / 16

vec4 baseColorAndAlpha() {
  vec4 color = baseColorFactor;
#if BASE_COLOR_MAP
  color *= texture(baseColorMap, vBaseColorUv);
#endif
#if VERTEX_COLOR
  color *= vColor;
#endif
  return color;
}

#if !UNLIT
#include "material/layers.glsl"
#include "material/material_inputs.glsl"

SurfaceInfo surfaceInfo(vec3 baseColor) {
  MaterialInputs m = materialInputs(baseColor);
  Normals normals = shadingNormals();
#if NORMAL_VARIANCE
  m = withSlopes(m, normals);
#endif
#if !SHADING_PRINCIPLED
  m = withShadedRoughness(m, geometricRoughness(dFdx(normals.geometric), dFdy(normals.geometric)));
#endif
  vec3 v = viewDirection();
#if SHADING_FABRIC
  normals = facingViewer(normals, v);
#endif
  SurfaceInfo s;
  s = withBase(s, m, normals, v);
#if SPECULAR
  s = withSpecular(s, m);
#endif
  s = withLayers(s, m, normals);
#if WEAVE
  s = withWeave(s, m, normals);
#endif
#if !SHADING_FABRIC
  s.dfg = texture(dfgMap, vec2(s.perceptualRoughness, s.NoV)).rg;
#if CLEARCOAT
  s.coatDfg = texture(dfgMap, vec2(s.clearcoatRoughness, s.clearcoatNoV)).rg;
#endif
#endif
  return preparedSurface(s);
}

vec3 emittedRadiance() {
#if EMISSIVE_MAP
  return emissiveFactor * texture(emissiveMap, vEmissiveUv).rgb;
#else
  return emissiveFactor;
#endif
}
#endif
