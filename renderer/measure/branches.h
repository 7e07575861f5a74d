#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "surface/surface.h"

namespace telar::measure {

/// Where a plane cuts a face: from one crossing to another, each on an edge of it.
struct Cut {
  std::array<std::uint32_t, 2> crossings{};
  std::array<glm::dvec3, 2>
      away{};                ///< from each crossing into the face, in the plane: known also where both are one place
  std::uint32_t source = 0;  ///< of the face
};

/// Where more than two faces meet at an edge, as shell and lining do in a seam, or a pocket and the body beneath it, says which
/// cuts go on into which: those that bend least, of one part sooner than of two. Each such two, and one that is left, get a crossing of
/// their own at the same place.
void partBranches(std::vector<Cut>& cuts, std::vector<glm::dvec3>& points, const std::vector<surface::Source>& sources,
                  const CancelToken& cancel);

}  // namespace telar::measure
