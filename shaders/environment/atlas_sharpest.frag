// The sharpest level of an environment atlas: each texel one bilinear read of an equirectangular map, at a place in mediump.
precision mediump float;
precision mediump int;
#include "sampler_precision.glsl"

#include "brdf/constants.glsl"
#include "environment/equirect.glsl"

uniform sampler2D equirectMap;
in vec3 vDirection;
out highp vec4 fragmentColor;

void main() { fragmentColor = vec4(texture(equirectMap, equirectUv(normalize(vDirection))).rgb, 1.0); }
