#pragma once
#include "reference/random.h"
#include "reference/surface.h"

namespace telar::reference {

/// Light that comes through a glassy surface, as the raster has it: straight on through a thin one, shifted by the
/// refracted path through one with a thickness, blurred by the roughness, tinted and attenuated. Where it leaves a
/// volume it is not refracted again.
struct Passage {
  Ray ray;             ///< on the other side
  glm::vec3 share{0};  ///< of the light that comes along it, linear Rec.709; the coat's part is not in it
};

/// One draw of where the light comes from. @param surface  prepared, with `transmission` above 0
/// @param offset  metres, by which a ray starts off the surface
Passage drawPassage(const Surface& surface, float offset, Random& random);

}  // namespace telar::reference
