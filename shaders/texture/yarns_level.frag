// One mip level of a map of how flat yarns lie (yarns.glsl).
precision highp float;
precision highp int;
precision highp sampler2D;

#include "texture/yarns.glsl"

vec4 momentsOfTexel(vec3 texel, vec4 weave) { return yarnsOfTexel(texel, weave); }

#include "texture/normal_level.glsl"
