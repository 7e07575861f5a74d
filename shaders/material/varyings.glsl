// What the vertex stage tells the fragments. VARYING is out in the one and in in the other; plain variables where fragments read them
// from a map. renderer/pass/plan/varyings.cpp has the same list.
VARYING vec3 vViewPosition;  // from the surface to the eye, view space
#if !FLAT_SHADED && !UNLIT
VARYING vec3 vNormal;  // view space
#if TANGENT
VARYING vec3 vTangent;
VARYING vec3 vBitangent;
#endif
#endif
#if VERTEX_COLOR
VARYING vec4 vColor;
#endif
#if TANGENT_FRAME_UV0
VARYING vec2 vUv0;
#endif
#if AMBIENT_VISIBILITY
VARYING vec4 vVisibility;  // xyz view space, not unit; w open part of the hemisphere
#if AMBIENT_VISIBILITY_BACK
VARYING vec4 vVisibilityBack;
#endif
#endif
#if TRANSMISSION
VARYING vec3 vWorldPosition;  // metres
#endif
#include "material/uv_varyings.glsl"
