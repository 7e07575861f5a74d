// Texture coordinates of the layers that the KHR_materials_* extensions add, vertex stage.
#if SPECULAR_MAP
uniform mat3 specularUvTransform;
out vec2 vSpecularUv;
#endif
#if SPECULAR_COLOR_MAP
uniform mat3 specularColorUvTransform;
out vec2 vSpecularColorUv;
#endif
#if CLEARCOAT_MAP
uniform mat3 clearcoatUvTransform;
out vec2 vClearcoatUv;
#endif
#if CLEARCOAT_ROUGHNESS_MAP
uniform mat3 clearcoatRoughnessUvTransform;
out vec2 vClearcoatRoughnessUv;
#endif
#if CLEARCOAT_NORMAL_MAP
uniform mat3 clearcoatNormalUvTransform;
out vec2 vClearcoatNormalUv;
#endif
#if SHEEN_COLOR_MAP
uniform mat3 sheenColorUvTransform;
out vec2 vSheenColorUv;
#endif
#if SHEEN_ROUGHNESS_MAP
uniform mat3 sheenRoughnessUvTransform;
out vec2 vSheenRoughnessUv;
#endif
#if ANISOTROPY_MAP
uniform mat3 anisotropyUvTransform;
out vec2 vAnisotropyUv;
#endif
#if IRIDESCENCE_MAP
uniform mat3 iridescenceUvTransform;
out vec2 vIridescenceUv;
#endif
#if IRIDESCENCE_THICKNESS_MAP
uniform mat3 iridescenceThicknessUvTransform;
out vec2 vIridescenceThicknessUv;
#endif
#if TRANSMISSION_MAP
uniform mat3 transmissionUvTransform;
out vec2 vTransmissionUv;
#endif
#if THICKNESS_MAP
uniform mat3 thicknessUvTransform;
out vec2 vThicknessUv;
#endif
#if TRANSMISSION
out vec3 vWorldPosition;  // metres
#endif
#if DIFFUSE_ROUGHNESS_MAP
uniform mat3 diffuseRoughnessUvTransform;
out vec2 vDiffuseRoughnessUv;
#endif
