// The layers of KHR_materials_* in SurfaceInfo. Order of three r187.

// Perceptual roughness that the model shades with. The principled ones have floors of their own, and curvature widens nothing.
// geometric  geometricRoughness()
float modelRoughness(float perceptualRoughness, float geometric) {
#if SHADING_PRINCIPLED
  return perceptualRoughness;
#else
  return shadedRoughness(perceptualRoughness, geometric);
#endif
}

#if SPECULAR
void addSpecular(inout SurfaceInfo s) {
  float factor = specularFactor;
  vec3 color = specularColorFactor;
#if SPECULAR_COLOR_MAP
  color *= texture(specularColorMap, vSpecularColorUv).rgb;
#endif
#if SPECULAR_MAP
  factor *= texture(specularMap, vSpecularUv).a;
#endif
  s.f90 = mix(factor, 1.0, s.metallic);
  s.f0Dielectric = min(pow2((ior - 1.0) / (ior + 1.0)) * color, vec3(1.0)) * factor;
}
#endif

#if ANISOTROPY
void addAnisotropy(inout SurfaceInfo s, mat3 frame) {
#if ANISOTROPY_MAP
  mat2 rotation = mat2(anisotropyVector.x, anisotropyVector.y, -anisotropyVector.y, anisotropyVector.x);
  vec3 texel = texture(anisotropyMap, vAnisotropyUv).rgb;
  vec2 axis = 2.0 * texel.rg - 1.0;
  vec2 direction = rotation * (dot(axis, axis) > 0.0 ? normalize(axis) : vec2(1.0, 0.0)) * texel.b;
#else
  vec2 direction = anisotropyVector;
#endif
  s.anisotropyStrength = length(direction);
  direction = s.anisotropyStrength == 0.0 ? vec2(1.0, 0.0) : direction / s.anisotropyStrength;
  s.anisotropyStrength = saturate(s.anisotropyStrength);
  s.alphaT = alphaAlongTangent(s.perceptualRoughness, s.anisotropyStrength);
  s.t = frame[0] * direction.x + frame[1] * direction.y;
  s.b = frame[1] * direction.x - frame[0] * direction.y;
}
#endif

#if IRIDESCENCE
void addIridescence(inout SurfaceInfo s) {
  s.iridescence = iridescenceFactor;
#if IRIDESCENCE_MAP
  s.iridescence *= texture(iridescenceMap, vIridescenceUv).r;
#endif
  float thickness = iridescenceThickness.y;
#if IRIDESCENCE_THICKNESS_MAP
  thickness = (iridescenceThickness.y - iridescenceThickness.x) * texture(iridescenceThicknessMap, vIridescenceThicknessUv).g +
              iridescenceThickness.x;
#endif
  s.iridescence = thickness == 0.0 ? 0.0 : saturate(s.iridescence);
  vec3 dielectric = F_Iridescence(iridescenceIor, thickness, s.NoV, s.f0Dielectric);
  vec3 metal = F_Iridescence(iridescenceIor, thickness, s.NoV, s.baseColor);
  s.filmFresnel = mix(dielectric, metal, s.metallic);
  s.filmF0Dielectric = f0FromSchlick(dielectric, s.NoV);
  s.filmF0Metal = f0FromSchlick(metal, s.NoV);
}
#endif

#if SHEEN
void addSheen(inout SurfaceInfo s) {
  s.sheenColor = sheenColorFactor;
#if SHEEN_COLOR_MAP
  s.sheenColor *= texture(sheenColorMap, vSheenColorUv).rgb;
#endif
  s.sheenRoughness = clamp(sheenRoughnessFactor, SHEEN_ROUGHNESS_MIN, 1.0);
#if SHEEN_ROUGHNESS_MAP
  // Held above 0 after the texture too: three.js gives NaN for a texel of 0.
  s.sheenRoughness = max(s.sheenRoughness * texture(sheenRoughnessMap, vSheenRoughnessUv).a, SHEEN_ROUGHNESS_MIN);
#endif
}
#endif

#if CLEARCOAT
void addClearcoat(inout SurfaceInfo s, Normals normals, float geometric) {
  s.coatNormal = normals.coat;
  s.clearcoat = clearcoatFactor;
  float roughness = clearcoatRoughnessFactor;
#if CLEARCOAT_MAP
  s.clearcoat *= texture(clearcoatMap, vClearcoatUv).r;
#endif
#if CLEARCOAT_ROUGHNESS_MAP
  roughness *= texture(clearcoatRoughnessMap, vClearcoatRoughnessUv).g;
#endif
#if NORMAL_VARIANCE
  roughness = roughnessWithSlopes(roughness, normals.coatSlopeVariance);
#endif
  s.clearcoat = saturate(s.clearcoat);
  s.clearcoatRoughness = modelRoughness(roughness, geometric);
  s.clearcoatNoV = saturate(dot(s.coatNormal, s.v));
#if !SHADING_FABRIC
  s.coatDfg = texture(dfgMap, vec2(s.clearcoatRoughness, s.clearcoatNoV)).rg;
#endif
}
#endif

void addLayers(inout SurfaceInfo s, Normals normals, float geometric) {
#if DIFFUSE_ROUGHNESS
  s.diffuseRoughness = diffuseRoughnessFactor;
#if DIFFUSE_ROUGHNESS_MAP
  s.diffuseRoughness *= texture(diffuseRoughnessMap, vDiffuseRoughnessUv).r;
#endif
  s.diffuseRoughness = saturate(s.diffuseRoughness);
#endif
#if ANISOTROPY
  addAnisotropy(s, normals.frame);
#endif
#if IRIDESCENCE
  addIridescence(s);
#endif
#if SHEEN
  addSheen(s);
#endif
#if CLEARCOAT
  addClearcoat(s, normals, geometric);
#endif
}
