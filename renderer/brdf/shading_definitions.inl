// The text of every shading; types are in shading_declarations.inl.
#include "../light/reflected.glsl"
#include "../shading/terms.glsl"
#include "../shading/three_terms.glsl"
#ifdef TELAR_WITH_VARIANTS
#include "brdf/shading_variants.inl"
#endif

// After the names of terms.
#include "../material/layers.glsl"

vec2 splitSum(const ThreeTerms& three, Real perceptualRoughness, Real NoV) {
  return vec2(brdf::dfgOf(three)(static_cast<decltype(0.0f)>(perceptualRoughness), static_cast<decltype(0.0f)>(NoV)));
}

#define TELAR_SHADING_TABLE(name) \
  { &name::preparedSurface, &name::addPunctual, &name::addDome, &name::addEnvironment, &name::composedRadiance }

namespace three {
#include "../shading/three.glsl"
}  // namespace three

namespace fabric {
#include "../shading/fabric_energy.glsl"
// Behind what it shares out.
#include "../shading/fabric.glsl"
}  // namespace fabric

namespace principled {
#include "../shading/principled_terms.glsl"
// After its terms.
#include "../shading/principled.glsl"
}  // namespace principled

// Yarns are fabric's alone.
using fabric::isWoven;
#include "../light/lobe_mixture.glsl"
#include "../light/visible.glsl"

ShadingFunctions shadingFunctions(ShadingModel shading) {
  switch (shading) {
    case ShadingModel::kThreeR115:
    case ShadingModel::kDisney2012: {
      ShadingFunctions functions = TELAR_SHADING_TABLE(principled);
      functions.addBehind = &principled::addBehind;
      return functions;
    }
    case ShadingModel::kFabric: {
      ShadingFunctions functions = TELAR_SHADING_TABLE(fabric);
      functions.addBehind = &fabric::addBehind;
      return functions;
    }
    default:
      return TELAR_SHADING_TABLE(three);
  }
}

#undef TELAR_SHADING_TABLE
