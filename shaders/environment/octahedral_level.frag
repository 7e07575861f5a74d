// One level of an octahedral map: each texel is the mean of four points of the level before, or of an equirectangular map.
precision highp float;
precision highp sampler2D;

#include "brdf/constants.glsl"
#include "environment/equirect.glsl"
#include "environment/octahedral_map.glsl"

uniform sampler2D source;
uniform float sourceSize;  // texels on its edge
uniform float size;        // on that of the level
out vec4 fragmentColor;

vec4 sourceAt(vec2 place) {
  vec3 direction = octahedronDirection(octahedralWrapped(place));
#if EQUIRECT
  return textureLod(source, equirectUv(normalize(direction)), 0.0);
#else
  return textureLod(source, octahedralUv(direction, sourceSize), 0.0);
#endif
}

void main() {
  float inner = size - 2.0;
  vec2 place = (2.0 * gl_FragCoord.xy - size) / inner;
  float quarter = 0.5 / inner;
  vec4 sum = sourceAt(place + vec2(-quarter, -quarter));
  sum += sourceAt(place + vec2(quarter, -quarter));
  sum += sourceAt(place + vec2(-quarter, quarter));
  sum += sourceAt(place + vec2(quarter, quarter));
  fragmentColor = 0.25 * sum;
}
