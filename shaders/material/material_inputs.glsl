// Factors times texels of a fragment.

#if BACK
// Whether the back of the cloth is seen. FLIP_SIDED draws back faces as if they were front faces.
bool seenFromBack() {
#if FLIP_SIDED
  return gl_FrontFacing;
#else
  return !gl_FrontFacing;
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
  MaterialInputs m;
  m.baseColor = baseColor;
  m.metallic = metallicFactor;
  m.roughness = roughnessFactor;
#if METALLIC_ROUGHNESS_MAP
  vec4 metallicRoughness = texture(metallicRoughnessMap, vMetallicRoughnessUv);
  m.roughness *= metallicRoughness.g;
  m.metallic *= metallicRoughness.b;
#endif
#if SPECULAR
  m.ior = ior;
  m.specular = specularFactor;
  m.specularColor = specularColorFactor;
#if SPECULAR_MAP
  m.specular *= texture(specularMap, vSpecularUv).a;
#endif
#if SPECULAR_COLOR_MAP
  m.specularColor *= texture(specularColorMap, vSpecularColorUv).rgb;
#endif
#endif
#if CLEARCOAT
  m.clearcoat = clearcoatFactor;
  m.clearcoatRoughness = clearcoatRoughnessFactor;
#if CLEARCOAT_MAP
  m.clearcoat *= texture(clearcoatMap, vClearcoatUv).r;
#endif
#if CLEARCOAT_ROUGHNESS_MAP
  m.clearcoatRoughness *= texture(clearcoatRoughnessMap, vClearcoatRoughnessUv).g;
#endif
#endif
#if SHEEN
  m.sheenColor = sheenColorFactor;
  m.sheenRoughness = sheenRoughnessFactor;
#if SHEEN_COLOR_MAP
  m.sheenColor *= texture(sheenColorMap, vSheenColorUv).rgb;
#endif
#if SHEEN_ROUGHNESS_MAP
  m.sheenRoughness *= texture(sheenRoughnessMap, vSheenRoughnessUv).a;
#endif
#endif
#if ANISOTROPY
  m.anisotropyVector = anisotropyVector;
#if ANISOTROPY_MAP
  m.anisotropyTexel = texture(anisotropyMap, vAnisotropyUv).rgb;
#else
  m.anisotropyTexel = vec3(0.5, 0.5, 1.0);
#endif
#endif
#if IRIDESCENCE
  m.iridescence = iridescenceFactor;
  m.iridescenceIor = iridescenceIor;
#if IRIDESCENCE_MAP
  m.iridescence *= texture(iridescenceMap, vIridescenceUv).r;
#endif
#if IRIDESCENCE_THICKNESS_MAP
  m.iridescenceThickness = (iridescenceThickness.y - iridescenceThickness.x) * texture(iridescenceThicknessMap, vIridescenceThicknessUv).g +
                           iridescenceThickness.x;
#else
  m.iridescenceThickness = iridescenceThickness.y;
#endif
#endif
#if DIFFUSE_ROUGHNESS
  m.diffuseRoughness = diffuseRoughnessFactor;
#if DIFFUSE_ROUGHNESS_MAP
  m.diffuseRoughness *= texture(diffuseRoughnessMap, vDiffuseRoughnessUv).r;
#endif
#endif
#if DIFFUSE_TRANSMISSION
  m.diffuseTransmission = diffuseTransmissionFactor;
  m.diffuseTransmissionColor = diffuseTransmissionColorFactor;
#if DIFFUSE_TRANSMISSION_MAP
  m.diffuseTransmission *= texture(diffuseTransmissionMap, vDiffuseTransmissionUv).a;
#endif
#if DIFFUSE_TRANSMISSION_COLOR_MAP
  m.diffuseTransmissionColor *= texture(diffuseTransmissionColorMap, vDiffuseTransmissionColorUv).rgb;
#endif
#endif
#if FLATNESS
  m.flatness = flatness;
#endif
#if WEAVE
  m.yarnCoverage = yarnCoverage;
  m.yarnRoughness = yarnRoughness;
#if METALLIC_ROUGHNESS_MAP
  m.yarnRoughness *= metallicRoughness.g;
#endif
  m.yarnAnisotropy = yarnAnisotropy;
  m.warpSpecularColor = warpSpecularColor;
  m.weftSpecularColor = weftSpecularColor;
  m.yarnTurn = vec2(1.0, 0.0);
  m.yarnSlope = 0.0;
#if WEAVE_MAP
  m = withWeaveTexel(m, texture(weaveMap, vWeaveUv), threadsPerPixel());
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
