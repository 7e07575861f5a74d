// Means of the slopes of a normal map's flat texels, from one mip level to the next.
precision highp float;
precision highp int;
precision highp sampler2D;

#include "texture/facets.glsl"

vec4 momentsOfTexel(vec3 texel, vec4 beside) { return facetOfTexel(texel); }

#define POINTS_PER_TEXEL 4
#include "texture/normal_moments.glsl"
