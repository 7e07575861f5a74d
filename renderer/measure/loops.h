#pragma once
#include <vector>

#include "measure/geodesic.h"

namespace telar::measure {

struct Loop {
  std::vector<glm::dvec3> points;  ///< metres; of a closed one the first is not said again
  bool closed = false;
  double length() const;
  double distanceTo(const glm::dvec3& p) const;
};

/// Where a plane cuts the surface. A corner that lies in the plane counts as above it, so that no cut ends there.
/// Where the surface ends in the plane or comes back from it, as the hem of a skirt on that of the hem, it is cut there.
std::vector<Loop> sectionOf(const surface::Surface& surface, const glm::dvec3& point, const glm::dvec3& normal,
                            const CancelToken& cancel);

/// The open edges: of a part, its border, other parts left out.
std::vector<Loop> borderOf(const surface::Surface& surface, const CancelToken& cancel);

/// The loop drawn tight over the surface: a closed geodesic that it can be moved to.
/// Birkhoff's curve shortening (Birkhoff 1917, "Dynamical systems with two degrees of freedom"): every second of eight
/// places goes to the middle of the shortest way between its neighbours, until nothing changes.
Loop tightened(const surface::Surface& surface, const Loop& loop, const CancelToken& cancel);

}  // namespace telar::measure
