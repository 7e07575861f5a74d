// The terms that more than one shading takes: a file is included once, wherever that is.
#include "shading/terms.glsl"
#include "shading/three_terms.glsl"
#include "shading/release.glsl"
#include "brdf/roughness.glsl"
#include "brdf/distribution.glsl"
#include "brdf/visibility.glsl"
#include "brdf/fresnel.glsl"
#include "brdf/specular.glsl"
#include "brdf/diffuse.glsl"
#include "brdf/multiscatter.glsl"
#include "brdf/light.glsl"
#include "brdf/occlusion.glsl"
#include "brdf/environment.glsl"
#if THREE_DFG_TERM == THREE_DFG_KARIS || (SHADING_PRINCIPLED && ENVIRONMENT_TERM != ENVIRONMENT_THREE_TABLE)
#include "brdf/environment_fit.glsl"
#endif
#if THREE_REFLECTION_DIRECTION_TERM + THREE_ENVIRONMENT_METAL_TERM + THREE_DIRECT_MULTISCATTER_TERM + THREE_SHEEN_ALBEDO_TERM + THREE_SHEEN_ENERGY_TERM + THREE_ANISOTROPIC_VISIBILITY_TERM + THREE_ROUGHNESS_MIN_TERM + THREE_RECT_F90_TERM + THREE_GLASS_ALPHA_TERM > 0
#include "brdf/three_releases.glsl"
#endif
#if RECT_LIGHTS + DISK_LIGHTS > 0
#include "brdf/area.glsl"
#endif
#if ANISOTROPY || WEAVE
#include "brdf/anisotropic.glsl"
#endif
#if SHEEN && !SHADING_FABRIC
#include "brdf/sheen.glsl"
#endif
#if SHADING_FABRIC || (SHADING_PRINCIPLED && (SHEEN_TERM != SHEEN_CHARLIE_NEUBELT || DISTRIBUTION_TERM == DISTRIBUTION_GTR2_ANISOTROPIC))
#include "brdf/cloth.glsl"
#endif
#if IRIDESCENCE
#include "brdf/iridescence.glsl"
#endif
#if DIFFUSE_ROUGHNESS || (SHADING_PRINCIPLED && DIFFUSE_TERM == DIFFUSE_EON)
#include "brdf/rough_diffuse.glsl"
#endif
#include "material/input_types.glsl"
#include "material/surface_types.glsl"
#include "light/reflected.glsl"
