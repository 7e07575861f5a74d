// Depth of what casts a shadow, seen from a light.
layout(location = 0) in vec3 position;  // mesh space, metres
#if ALPHA_MAP
layout(location = 3) in vec2 uv0;
layout(location = 4) in vec2 uv1;
uniform mat3 baseColorUvTransform;
out vec2 vBaseColorUv;
#endif
#if INSTANCING
layout(location = 6) in mat4 instanceMatrix;  // instance to mesh space
#endif
#if PACKED_DEPTH
out vec2 vDepth;  // z and w of clip space
#endif
#if PACKED_DISTANCE
uniform mat4 modelMatrix;
out vec3 vWorldPosition;  // metres
#endif

uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;

void main() {
#if INSTANCING
  vec4 point = instanceMatrix * vec4(position, 1.0);
#else
  vec4 point = vec4(position, 1.0);
#endif
  gl_Position = projectionMatrix * (modelViewMatrix * point);
#if PACKED_DEPTH
  vDepth = gl_Position.zw;
#endif
#if PACKED_DISTANCE
  vWorldPosition = vec3(modelMatrix * point);
#endif
#if ALPHA_MAP
  vBaseColorUv = vec2(baseColorUvTransform * vec3(BASE_COLOR_UV1 == 1 ? uv1 : uv0, 1.0));
#endif
}
