#pragma once
#include "core/random.h"
#include "reference/surface.h"

namespace telar::reference {

/// Light through a transmissive surface, as the raster has it. A thin surface lets it pass straight on. A surface with
/// a thickness shifts it along the refracted path. Roughness blurs it, the material tints and attenuates it. Where it
/// leaves a volume it is not refracted again.
struct TransmissionSample {
  glm::vec3 path{0};       ///< through the volume, metres; 0 = thin
  glm::vec3 direction{0};  ///< unit, beyond it
  glm::vec3 share{0};      ///< of that light that reaches the viewer, linear Rec.709; without the clearcoat's part
};

/// Draws where the light comes from. @param surface  prepared, with `glass.weight` above 0
TransmissionSample sampleTransmission(const Surface& surface, Random& random);

}  // namespace telar::reference
