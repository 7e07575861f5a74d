// One mip level of a map of relief: RGB the mean of unit normals, A that of how flat they lie (relief.glsl).
precision highp float;
precision highp int;
precision highp sampler2D;

#include "texture/relief.glsl"

vec4 momentsOfTexel(vec3 texel, vec4 cover) { return reliefWithHoles(texel, cover); }

#include "texture/normal_level.glsl"
