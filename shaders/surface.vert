// Transforms one primitive to view space. One varying a texture, because each has its own transform (KHR_texture_transform).
#define VARYING out

#include "material/vertex_inputs.glsl"
#include "material/visibility_vertex.glsl"
#include "shading/three_terms.glsl"
#include "shadow/coords.glsl"

void main() {
#if INSTANCING
  vec4 meshSpace = instanceMatrix * vec4(position, 1.0);
#else
  vec4 meshSpace = vec4(position, 1.0);
#endif
  vec4 viewSpace = modelViewMatrix * meshSpace;
  gl_Position = projectionMatrix * viewSpace;
  vViewPosition = -vec3(viewSpace);
#if !FLAT_SHADED && !UNLIT
#if INSTANCING
  // Right for any scale along the instance's axes, not for shear, as in three.js.
  mat3 instance = mat3(instanceMatrix);
  vec3 squaredScale = vec3(dot(instance[0], instance[0]), dot(instance[1], instance[1]), dot(instance[2], instance[2]));
  vec3 viewNormal = normalMatrix * (instance * (normal / squaredScale)) * NORMAL_SIGN;
#else
  vec3 viewNormal = normalMatrix * normal * NORMAL_SIGN;
#endif
  vNormal = dot(viewNormal, viewNormal) > 0.0 ? normalize(viewNormal) : vec3(0.0);
#if TANGENT
#if INSTANCING && THREE_INSTANCE_TANGENTS_TERM == THREE_INSTANCE_TANGENTS_TURNED
  vTangent = normalize(vec3(modelViewMatrix * vec4(instance * tangent.xyz, 0.0)));
#else
  vTangent = normalize(vec3(modelViewMatrix * vec4(tangent.xyz, 0.0)));
#endif
  vBitangent = normalize(cross(vNormal, vTangent) * tangent.w) * NORMAL_SIGN;
#if THREE_FLIPPED_TANGENTS_TERM == THREE_FLIPPED_TANGENTS_TURNED
  vTangent *= NORMAL_SIGN;
#endif
#endif
#endif
#if FLAT_SHADOWS + CUBE_SHADOWS > 0
#if FLAT_SHADED
  setShadowCoords(meshSpace.xyz, vec3(0.0));
#else
  setShadowCoords(meshSpace.xyz, viewNormal);
#endif
#endif
#if VERTEX_COLOR
#if INSTANCE_COLOR
  vColor = vec4(color.rgb * instanceColor, color.a);
#else
  vColor = color;
#endif
#endif
#include "material/uv_transforms.glsl"
#if TANGENT_FRAME_UV0
  vUv0 = uv0;
#endif
#if AMBIENT_VISIBILITY
  vVisibility = visibilityInView(visibility);
#endif
#if AMBIENT_VISIBILITY_BACK
  vVisibilityBack = visibilityInView(visibilityBack);
#endif
#if TRANSMISSION
  vWorldPosition = vec3(modelMatrix * meshSpace);
#endif
#if POINTS
  gl_PointSize = 1.0;
#endif
}
