// The principled shadings and their own terms.
#include "brdf/r115.glsl"
#include "brdf/disney.glsl"
#include "brdf/disney_parameters.glsl"
#include "brdf/principled_albedo.glsl"
#include "shading/principled_terms.glsl"
#include "shading/principled.glsl"
