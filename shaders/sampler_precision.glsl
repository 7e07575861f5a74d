// How exact is what samplers read. Before 0.161 three.js leaves it to GLSL ES, whose default is lowp (GLSL ES 3.00, section
// 4.5.4): Mesa rounds that to half floats.
#include "shading/three_terms.glsl"
#if THREE_SAMPLER_PRECISION_TERM == THREE_SAMPLER_PRECISION_LOWP
precision lowp sampler2D;
precision lowp samplerCube;
#else
precision highp sampler2D;
precision highp samplerCube;
#endif
