// What surface.frag declares, as a shader of three.js has it; FAMILY is one of three, principled, fabric.
#include "brdf/constants.glsl"
#include "brdf/types.glsl"
#include "brdf/math.glsl"
#include "pixel_noise.glsl"
#include "material/fragment_inputs.glsl"
#include "shading/includes_common.glsl"
#include "shading/includes_FAMILY.glsl"
#include "material/surface_info.glsl"
#include "light/one_light.glsl"
#include "light/area.glsl"
#include "light/indirect.glsl"
#include "light/occluded.glsl"
#if ALPHA_MEANS
#include "material/straight_texel.glsl"
#endif
#if ALPHA_TO_COVERAGE
#include "material/coverage.glsl"
#endif
