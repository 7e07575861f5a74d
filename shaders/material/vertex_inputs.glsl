// Vertex streams, and what the fragment stage takes over. Locations are those of renderer/pass/model/gpu_primitive.h.
layout(location = 0) in vec3 position;  // mesh space, metres
#if !FLAT_SHADED && !UNLIT
layout(location = 1) in vec3 normal;    // mesh space
#endif
#if TANGENT
layout(location = 2) in vec4 tangent;   // mesh space, w = handedness
#endif
layout(location = 3) in vec2 uv0;
layout(location = 4) in vec2 uv1;
layout(location = 5) in vec4 color;     // linear Rec.709
#if INSTANCING
layout(location = 6) in mat4 instanceMatrix;  // instance to mesh space
#endif
#if INSTANCE_COLOR
layout(location = 10) in vec3 instanceColor;  // linear Rec.709
#endif
#if AMBIENT_VISIBILITY
layout(location = 11) in vec4 visibility;  // of the front: Primitive::visibility
#endif
#if AMBIENT_VISIBILITY_BACK
layout(location = 12) in vec4 visibilityBack;
#endif

#if TRANSMISSION || FLAT_SHADOWS + CUBE_SHADOWS > 0
uniform mat4 modelMatrix;
#endif
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform mat3 normalMatrix;  // inverse transpose of modelViewMatrix

// Back faces that are drawn as front faces (the first half of a two-pass blend) turn their normals round.
#if FLIP_SIDED
#define NORMAL_SIGN (-1.0)
#else
#define NORMAL_SIGN 1.0
#endif

#include "material/varyings.glsl"
