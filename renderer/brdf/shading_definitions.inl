// The text of every shading; types are in shading_declarations.inl.
#include "../light/reflected.glsl"

#define TELAR_SHADING_TABLE(name) \
  { &name::preparedSurface, &name::addPunctual, &name::addDome, &name::addEnvironment, &name::composedRadiance }

namespace three {
#include "../shading/three.glsl"
}  // namespace three

namespace fabric {
#include "../shading/fabric.glsl"
}  // namespace fabric

ShadingFunctions shadingFunctions(ShadingModel shading) {
  switch (shading) {
    case ShadingModel::kFabric:
      return TELAR_SHADING_TABLE(fabric);
    default:
      return TELAR_SHADING_TABLE(three);
  }
}

#undef TELAR_SHADING_TABLE
