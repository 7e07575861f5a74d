// The text of every shading; types are in shading_declarations.inl.
#include "../light/reflected.glsl"

#define TELAR_SHADING_TABLE(name) \
  { &name::preparedSurface, &name::addPunctual, &name::addDome, &name::addEnvironment, &name::composedRadiance }

namespace three {
#include "../shading/three.glsl"
}  // namespace three

ShadingFunctions shadingFunctions(ShadingModel shading) {
  switch (shading) {
    default:
      return TELAR_SHADING_TABLE(three);
  }
}

#undef TELAR_SHADING_TABLE
