#pragma once
#include "core/random.h"
#include "reference/surface.h"

namespace telar::reference {

/// Light that comes through a glassy surface, as the raster has it: straight on through a thin one, shifted by the
/// refracted path through one with a thickness, blurred by the roughness, tinted and attenuated. Where it leaves a
/// volume it is not refracted again.
struct Passage {
  glm::vec3 path{0};       ///< through the volume, metres; 0 = thin
  glm::vec3 direction{0};  ///< unit, beyond it
  glm::vec3 share{0};      ///< of the light that comes along it, linear Rec.709; the coat's part is not in it
};

/// One draw of where the light comes from. @param surface  prepared, with `glass.weight` above 0
Passage drawPassage(const Surface& surface, Random& random);

}  // namespace telar::reference
