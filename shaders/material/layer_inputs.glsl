// Textures of the layers that the KHR_materials_* extensions add.
#if SPECULAR_MAP
uniform sampler2D specularMap;  // linear: A
in vec2 vSpecularUv;
#endif
#if SPECULAR_COLOR_MAP
uniform sampler2D specularColorMap;  // sRGB
in vec2 vSpecularColorUv;
#endif
#if CLEARCOAT_MAP
uniform sampler2D clearcoatMap;  // linear: R
in vec2 vClearcoatUv;
#endif
#if CLEARCOAT_ROUGHNESS_MAP
uniform sampler2D clearcoatRoughnessMap;  // linear: G
in vec2 vClearcoatRoughnessUv;
#endif
#if CLEARCOAT_NORMAL_MAP
uniform sampler2D clearcoatNormalMap;  // linear
in vec2 vClearcoatNormalUv;
#endif
#if SHEEN_COLOR_MAP
uniform sampler2D sheenColorMap;  // sRGB
in vec2 vSheenColorUv;
#endif
#if SHEEN_ROUGHNESS_MAP
uniform sampler2D sheenRoughnessMap;  // linear: A
in vec2 vSheenRoughnessUv;
#endif
#if ANISOTROPY_MAP
uniform sampler2D anisotropyMap;  // linear: RG direction, B strength
in vec2 vAnisotropyUv;
#endif
#if IRIDESCENCE_MAP
uniform sampler2D iridescenceMap;  // linear: R
in vec2 vIridescenceUv;
#endif
#if IRIDESCENCE_THICKNESS_MAP
uniform sampler2D iridescenceThicknessMap;  // linear: G
in vec2 vIridescenceThicknessUv;
#endif
#if DIFFUSE_ROUGHNESS_MAP
uniform sampler2D diffuseRoughnessMap;  // linear: R
in vec2 vDiffuseRoughnessUv;
#endif
#if TRANSMISSION_MAP
uniform sampler2D transmissionMap;  // linear: R
in vec2 vTransmissionUv;
#endif
#if THICKNESS_MAP
uniform sampler2D thicknessMap;  // linear: G
in vec2 vThicknessUv;
#endif
#if TRANSMISSION
in vec3 vWorldPosition;
#endif

// Factors are linear Rec.709.
#if SPECULAR || TRANSMISSION
uniform float ior;
#endif
#if SPECULAR
uniform float specularFactor;
uniform vec3 specularColorFactor;
#endif
#if CLEARCOAT
uniform float clearcoatFactor;
uniform float clearcoatRoughnessFactor;  // perceptual
#if CLEARCOAT_NORMAL_MAP
uniform vec2 clearcoatNormalScale;
#endif
#endif
#if SHEEN
uniform vec3 sheenColorFactor;
uniform float sheenRoughnessFactor;  // perceptual
#endif
#if ANISOTROPY
uniform vec2 anisotropyVector;  // strength (cos rotation, sin rotation)
#endif
#if IRIDESCENCE
uniform float iridescenceFactor;
uniform float iridescenceIor;
uniform vec2 iridescenceThickness;  // minimum, maximum, nanometres
#endif
#if DIFFUSE_ROUGHNESS
uniform float diffuseRoughnessFactor;
#endif
