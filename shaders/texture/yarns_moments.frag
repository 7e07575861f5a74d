// Means of how flat yarns lie (yarns.glsl), from one mip level to the next.
precision highp float;
precision highp int;
precision highp sampler2D;

#include "texture/yarns.glsl"

vec4 momentsOfTexel(vec3 texel, vec2 at) { return yarnsOfTexel(texel, at); }

#include "texture/normal_moments.glsl"
