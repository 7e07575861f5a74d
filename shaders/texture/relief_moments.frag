// Means of a normal map's unit normals and of how flat they lie, from one mip level to the next.
precision highp float;
precision highp int;
precision highp sampler2D;

#include "texture/relief.glsl"

vec4 momentsOfTexel(vec3 texel, vec4 cover) { return reliefWithHoles(texel, cover); }

// With all four it takes twice as long, and pictures of cloth are as near to the path tracer's, within 0.0003 of FLIP.
#define POINTS_PER_TEXEL 1
#include "texture/normal_moments.glsl"
