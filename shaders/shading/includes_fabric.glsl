// The shading "fabric" and its own terms.
#include "brdf/cloth_energy.glsl"
#include "brdf/bump.glsl"
#if RELIEF || SHEEN
#include "brdf/relief.glsl"
#endif
#if FACETS
#include "brdf/facets.glsl"
#include "brdf/facet_cell.glsl"
#endif
#if ANISOTROPY || WEAVE
#include "brdf/yarn_energy.glsl"
#include "brdf/stretched_taps.glsl"
#endif
#if AMBIENT_VISIBILITY
#include "brdf/ambient_visibility.glsl"
#endif
#if FLATNESS
#include "brdf/thin_sheet.glsl"
#endif
#include "shading/fabric_energy.glsl"
#include "shading/fabric.glsl"
