// An equirectangular map to a cube face: SUPERSAMPLE takes the mean of four points of the texel, which keeps small bright
// lights; without it one point is taken, as three.js does for a background.
precision highp float;
precision highp sampler2D;

#include "brdf/constants.glsl"
#include "environment/equirect.glsl"

uniform sampler2D equirectMap;
in vec3 vDirection;
out vec4 fragmentColor;

void main() {
  vec3 direction = normalize(vDirection);
#if SUPERSAMPLE
  vec3 dx = dFdx(direction) * 0.25;
  vec3 dy = dFdy(direction) * 0.25;
  vec4 color = textureLod(equirectMap, equirectUv(normalize(direction - dx - dy)), 0.0);
  color += textureLod(equirectMap, equirectUv(normalize(direction + dx - dy)), 0.0);
  color += textureLod(equirectMap, equirectUv(normalize(direction - dx + dy)), 0.0);
  color += textureLod(equirectMap, equirectUv(normalize(direction + dx + dy)), 0.0);
  fragmentColor = color * 0.25;
#else
  fragmentColor = vec4(texture(equirectMap, equirectUv(direction)).rgb, 1.0);
#endif
}
