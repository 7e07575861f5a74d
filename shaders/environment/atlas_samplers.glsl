// Precision of samplers: to 0.160 three.js left the default of GLSL ES, lowp, which Mesa reads as half floats.
#include "shading/three_terms.glsl"
#if THREE_SAMPLER_PRECISION_TERM == THREE_SAMPLER_PRECISION_LOWP
precision lowp sampler2D;
#else
precision highp sampler2D;
#endif
