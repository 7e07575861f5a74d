// Inside main() of the vertex stage: see layer_varyings.glsl.
#if SPECULAR_MAP
vSpecularUv = vec2(specularUvTransform * vec3(SPECULAR_UV1 == 1 ? uv1 : uv0, 1.0));
#endif
#if SPECULAR_COLOR_MAP
vSpecularColorUv = vec2(specularColorUvTransform * vec3(SPECULAR_COLOR_UV1 == 1 ? uv1 : uv0, 1.0));
#endif
#if CLEARCOAT_MAP
vClearcoatUv = vec2(clearcoatUvTransform * vec3(CLEARCOAT_UV1 == 1 ? uv1 : uv0, 1.0));
#endif
#if CLEARCOAT_ROUGHNESS_MAP
vClearcoatRoughnessUv = vec2(clearcoatRoughnessUvTransform * vec3(CLEARCOAT_ROUGHNESS_UV1 == 1 ? uv1 : uv0, 1.0));
#endif
#if CLEARCOAT_NORMAL_MAP
vClearcoatNormalUv = vec2(clearcoatNormalUvTransform * vec3(CLEARCOAT_NORMAL_UV1 == 1 ? uv1 : uv0, 1.0));
#endif
#if SHEEN_COLOR_MAP
vSheenColorUv = vec2(sheenColorUvTransform * vec3(SHEEN_COLOR_UV1 == 1 ? uv1 : uv0, 1.0));
#endif
#if SHEEN_ROUGHNESS_MAP
vSheenRoughnessUv = vec2(sheenRoughnessUvTransform * vec3(SHEEN_ROUGHNESS_UV1 == 1 ? uv1 : uv0, 1.0));
#endif
#if ANISOTROPY_MAP
vAnisotropyUv = vec2(anisotropyUvTransform * vec3(ANISOTROPY_UV1 == 1 ? uv1 : uv0, 1.0));
#endif
#if IRIDESCENCE_MAP
vIridescenceUv = vec2(iridescenceUvTransform * vec3(IRIDESCENCE_UV1 == 1 ? uv1 : uv0, 1.0));
#endif
#if IRIDESCENCE_THICKNESS_MAP
vIridescenceThicknessUv = vec2(iridescenceThicknessUvTransform * vec3(IRIDESCENCE_THICKNESS_UV1 == 1 ? uv1 : uv0, 1.0));
#endif
#if TRANSMISSION_MAP
vTransmissionUv = vec2(transmissionUvTransform * vec3(TRANSMISSION_UV1 == 1 ? uv1 : uv0, 1.0));
#endif
#if THICKNESS_MAP
vThicknessUv = vec2(thicknessUvTransform * vec3(THICKNESS_UV1 == 1 ? uv1 : uv0, 1.0));
#endif
#if DIFFUSE_ROUGHNESS_MAP
vDiffuseRoughnessUv = vec2(diffuseRoughnessUvTransform * vec3(DIFFUSE_ROUGHNESS_UV1 == 1 ? uv1 : uv0, 1.0));
#endif
