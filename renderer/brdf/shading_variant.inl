// The shadings for one set of layers: TELAR_LAYERS, in a namespace of the name TELAR_VARIANT. shading_variants.inl includes it.
namespace TELAR_VARIANT {
namespace {

#if TELAR_LAYERS == LAYER_ALL
#include "by_reference/material/layers.glsl"
#endif

namespace three {
#include "by_reference/shading/three.glsl"
}  // namespace three

namespace fabric {
#include "by_reference/shading/fabric_energy.glsl"
// Behind what it shares out.
#include "by_reference/shading/fabric.glsl"
}  // namespace fabric

#if TELAR_LAYERS == LAYER_ALL
namespace principled {
#include "by_reference/shading/principled_terms.glsl"
// After its terms.
#include "by_reference/shading/principled.glsl"
}  // namespace principled
#endif

// Yarns are fabric's alone.
#if WEAVE
using fabric::isWoven;
#endif
#include "by_reference/light/lobe_mixture.glsl"

[[gnu::flatten]] void lobesOf(const SurfaceInfo& s, LobeMixture& lobes) { lobes = TELAR_VARIANT::lobeMixture(s); }
[[gnu::flatten]] vec3 directionOf(const LobeMixture& lobes, const vec2& u) { return TELAR_VARIANT::sampleMixture(lobes, u); }
[[gnu::flatten]] Real pdfOf(const LobeMixture& lobes, const vec3& l) { return TELAR_VARIANT::pdfMixture(lobes, l); }

#define TELAR_VARIANT_BEHIND(shading)                                                                  \
  [[gnu::flatten]] Reflected shading##Behind(const Reflected& lit, const SurfaceInfo& s, const vec3& irradiance) { \
    return shading::addBehind(lit, s, irradiance);                                                     \
  }
#define TELAR_VARIANT_FUNCTIONS(shading, behind)                                                       \
  [[gnu::flatten]] void shading##Prepare(SurfaceInfo& s) { s = shading::preparedSurface(s); }          \
  [[gnu::flatten]] Reflected shading##Punctual(const SurfaceInfo& s, const vec3& l) {                  \
    return shading::addPunctual(nothingReflected(), s, l, vec3(1.0));                                  \
  }                                                                                                    \
  [[gnu::flatten]] Reflected shading##Dome(const SurfaceInfo& s, const vec3& irradiance) {             \
    return shading::addDome(nothingReflected(), s, irradiance);                                        \
  }                                                                                                    \
  [[gnu::flatten]] vec3 shading##Composed(const SurfaceInfo& s, const vec3& diffuse, const Reflected& lit) { \
    return shading::composedRadiance(s, diffuse, lit, nothingReflected(), vec3(0.0));                  \
  }                                                                                                    \
  [[gnu::flatten]] vec3 shading##Bsdf(const SurfaceInfo& s, const vec3& l, Real diffuse) {             \
    Reflected lit = shading::addPunctual(nothingReflected(), s, l, vec3(1.0));                         \
    return shading::composedRadiance(s, lit.diffuse * diffuse, lit, nothingReflected(), vec3(0.0));    \
  }                                                                                                    \
  constexpr ShadingVariant shading##Variant = {TELAR_LAYERS,    shading##Prepare,  shading##Punctual, \
                                               shading##Dome,   behind,            shading##Composed, \
                                               shading##Bsdf,   lobesOf,           directionOf,       pdfOf};
TELAR_VARIANT_FUNCTIONS(three, nullptr)
#if DIFFUSE_TRANSMISSION
TELAR_VARIANT_BEHIND(fabric)
TELAR_VARIANT_FUNCTIONS(fabric, fabricBehind)
#else
TELAR_VARIANT_FUNCTIONS(fabric, nullptr)
#endif
#if TELAR_LAYERS == LAYER_ALL
TELAR_VARIANT_BEHIND(principled)
TELAR_VARIANT_FUNCTIONS(principled, principledBehind)
#endif
#undef TELAR_VARIANT_BEHIND
#undef TELAR_VARIANT_FUNCTIONS

}  // namespace
}  // namespace TELAR_VARIANT
#undef TELAR_VARIANT
#undef TELAR_LAYERS
