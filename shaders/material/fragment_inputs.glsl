// Material factors and textures. Factors are linear Rec.709; sRGB textures are decoded by the sampler.
uniform vec4 baseColorFactor;
uniform float alphaCutoff;
uniform float metallicFactor;
uniform float roughnessFactor;  // perceptual
uniform vec3 emissiveFactor;

in vec3 vViewPosition;
#if !FLAT_SHADED && !UNLIT
in vec3 vNormal;
#if TANGENT
in vec3 vTangent;
in vec3 vBitangent;
#endif
#endif
#if VERTEX_COLOR
in vec4 vColor;
#endif
#if BASE_COLOR_MAP
uniform sampler2D baseColorMap;  // sRGB
in vec2 vBaseColorUv;
#endif
#if METALLIC_ROUGHNESS_MAP
uniform sampler2D metallicRoughnessMap;  // linear, G roughness, B metalness
in vec2 vMetallicRoughnessUv;
#endif
#if NORMAL_MAP
uniform sampler2D normalMap;  // linear
uniform vec2 normalScale;
in vec2 vNormalUv;
#endif
#if OCCLUSION_MAP
uniform sampler2D occlusionMap;  // linear, R
uniform float occlusionStrength;
in vec2 vOcclusionUv;
#endif
#if EMISSIVE_MAP
uniform sampler2D emissiveMap;  // sRGB
in vec2 vEmissiveUv;
#endif
#if TANGENT_FRAME_UV0
in vec2 vUv0;
#endif
#include "material/layer_inputs.glsl"
#if SHADING_FABRIC || SHADING_PRINCIPLED
#include "material/fabric_inputs.glsl"
#endif
