// One level of an environment atlas: six tiles, each with the directions of its face and of the border about it.
// In mediump the directions of the corners are half floats in Mesa, as in three r150 to r185.
precision mediump float;
precision mediump int;

#include "shading/three_terms.glsl"

layout(location = 0) in highp vec2 corner;  // clip space
#if THREE_PREFILTER_TERM == THREE_PREFILTER_GGX_CHAIN_INTERPOLATED
layout(location = 2) in vec3 cornerDirection;
#else
layout(location = 1) in highp vec2 cornerPlace;  // on the face, which is [0, 1]^2
#endif
out vec3 vDirection;  // not unit; linear over the face

#if THREE_PREFILTER_TERM != THREE_PREFILTER_GGX_CHAIN_INTERPOLATED
// Columns: how the direction changes across the face and upwards, and its centre.
const mat3 FACES[6] = mat3[6](mat3(0, 0, 1, 0, 1, 0, 1, 0, 0), mat3(-1, 0, 0, 0, 0, -1, 0, 1, 0), mat3(-1, 0, 0, 0, 1, 0, 0, 0, 1),
                              mat3(0, 0, -1, 0, 1, 0, -1, 0, 0), mat3(-1, 0, 0, 0, 0, 1, 0, -1, 0), mat3(1, 0, 0, 0, 1, 0, 0, 0, -1));

vec3 directionOn(int face, vec2 place) { return FACES[face] * vec3(2.0 * place - 1.0, 1.0); }
#endif

void main() {
#if THREE_PREFILTER_TERM == THREE_PREFILTER_GGX_CHAIN_INTERPOLATED
  vDirection = cornerDirection;
#else
  vDirection = directionOn(gl_VertexID / 6, cornerPlace);
#endif
  gl_Position = vec4(corner, 0.0, 1.0);
}
