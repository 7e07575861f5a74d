// Means of how flat yarns lie (yarns.glsl), from one mip level to the next.
precision highp float;
precision highp int;
precision highp sampler2D;

#include "texture/yarns.glsl"

vec4 momentsOfTexel(vec3 texel, vec4 weave) { return yarnsOfTexel(texel, weave); }

// With all four, levels from 2 on differ by less than 0.01 (root mean square): weaves of denim, twill, satin, silk and nylon.
#define POINTS_PER_TEXEL 1
#include "texture/normal_moments.glsl"
