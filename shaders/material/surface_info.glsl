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
#include "material/layer_info.glsl"
#if SHADING_FABRIC || SHADING_PRINCIPLED
#include "material/fabric_textures.glsl"
#endif

#if SHADING_FABRIC
#include "material/fabric_info.glsl"
#endif

SurfaceInfo surfaceInfo(vec3 baseColor) {
  SurfaceInfo s;
  float roughness = roughnessFactor;
  s.metallic = metallicFactor;
#if METALLIC_ROUGHNESS_MAP
  vec4 texel = texture(metallicRoughnessMap, vMetallicRoughnessUv);
  roughness *= texel.g;
  s.metallic *= texel.b;
#endif
#if BACK
  if (seenFromBack()) {
    baseColor = backColor();
    roughness = backRoughness;
  }
#endif
  Normals normals = shadingNormals();
  float geometric = geometricRoughness(dFdx(normals.geometric), dFdy(normals.geometric));
#if NORMAL_VARIANCE
  roughness = roughnessWithSlopes(roughness, normals.slopeVariance);
#endif
  s.n = normals.shading;
#if ORTHOGRAPHIC
  s.v = vec3(0.0, 0.0, 1.0);
#else
  s.v = normalize(vViewPosition);
#endif
#if SHADING_FABRIC
  turnToViewer(s, normals);
#endif
  s.baseColor = baseColor;
  s.diffuse = diffuseAlbedo(baseColor, s.metallic);
  s.f0Dielectric = vec3(F0_DIELECTRIC);
  s.f90 = 1.0;
#if SPECULAR
  addSpecular(s);
#endif
  s.f0 = mix(s.f0Dielectric, baseColor, s.metallic);
  s.perceptualRoughness = modelRoughness(roughness, geometric);
  s.alpha = alphaFromRoughness(s.perceptualRoughness);
  s.NoV = saturate(dot(s.n, s.v));
#if !SHADING_FABRIC
  s.dfg = texture(dfgMap, vec2(s.perceptualRoughness, s.NoV)).rg;
#endif
  addLayers(s, normals, geometric);
#if SHADING_FABRIC || SHADING_PRINCIPLED
  addThin(s);
#endif
#if WEAVE
  addWeave(s, normals, geometric);
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
