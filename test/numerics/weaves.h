#pragma once
#include "materials.h"
#include "surface_point.h"

namespace telar::numerics {

/// White woven cloth of any two sets of yarns, and the side from which it is seen.
struct SeenWeave {
  Material material;
  Directions seen;

  /// Share of the surface that is yarn, 0.5..1.
  double coverage() const { return double{material.fabric.warp.coverage} + material.fabric.weft.coverage; }
  bool hasGaps() const { return coverage() < 0.9999; }
};

/// Dielectric, metal or between them; roughness and anisotropy 0..1, gaps 0..0.5, every azimuth.
SeenWeave randomWeave(std::uint64_t seed);

std::string describe(const SeenWeave& weave);

}  // namespace telar::numerics
