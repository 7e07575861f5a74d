// Transforms one primitive to view space. One varying a texture, because each has its own transform (KHR_texture_transform).

#include "material/vertex_inputs.glsl"
#include "shadow/coords.glsl"

void main() {
  vec4 viewSpace = modelViewMatrix * vec4(position, 1.0);
  gl_Position = projectionMatrix * viewSpace;
  vViewPosition = -vec3(viewSpace);
#if !FLAT_SHADED && !UNLIT
  vNormal = normalize(normalMatrix * normal) * NORMAL_SIGN;
#if TANGENT
  vTangent = normalize(vec3(modelViewMatrix * vec4(tangent.xyz, 0.0)));
  vBitangent = normalize(cross(vNormal, vTangent) * tangent.w) * NORMAL_SIGN;
#endif
#endif
#if FLAT_SHADOWS + CUBE_SHADOWS > 0
#if FLAT_SHADED
  setShadowCoords(position, vec3(0.0));
#else
  setShadowCoords(position, normalMatrix * normal * NORMAL_SIGN);
#endif
#endif
#if VERTEX_COLOR
  vColor = color;
#endif
#if BASE_COLOR_MAP
  vBaseColorUv = vec2(baseColorUvTransform * vec3(BASE_COLOR_UV1 == 1 ? uv1 : uv0, 1.0));
#endif
#if METALLIC_ROUGHNESS_MAP
  vMetallicRoughnessUv = vec2(metallicRoughnessUvTransform * vec3(METALLIC_ROUGHNESS_UV1 == 1 ? uv1 : uv0, 1.0));
#endif
#if NORMAL_MAP
  vNormalUv = vec2(normalUvTransform * vec3(NORMAL_UV1 == 1 ? uv1 : uv0, 1.0));
#endif
#if OCCLUSION_MAP
  vOcclusionUv = vec2(occlusionUvTransform * vec3(OCCLUSION_UV1 == 1 ? uv1 : uv0, 1.0));
#endif
#if EMISSIVE_MAP
  vEmissiveUv = vec2(emissiveUvTransform * vec3(EMISSIVE_UV1 == 1 ? uv1 : uv0, 1.0));
#endif
#if TANGENT_FRAME_UV0
  vUv0 = uv0;
#endif
#if TRANSMISSION
  vWorldPosition = vec3(modelMatrix * vec4(position, 1.0));
#endif
#include "material/layer_uvs.glsl"
#if POINTS
  gl_PointSize = 1.0;
#endif
}
