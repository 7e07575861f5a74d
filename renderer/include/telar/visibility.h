#pragma once
#include <cstdint>
#include <memory>
#include <string>

#include "telar/cancel.h"
#include "telar/limits.h"
#include "telar/scene.h"

namespace telar {

/// Rays of each side of a vertex.
struct VisibilityRays {
  static constexpr int LEAST = 16, MOST = 4096, USUAL = 256;
};

/// Where what rays have found is kept, by the content of the model's file.
struct VisibilityCache {
  std::string directory;    ///< empty = nothing is kept
  std::uint64_t bytes = 0;  ///< of all that telar keeps there; what was used longest ago goes first
  std::string version;      ///< of telar: what another one has found is not taken
};

/// The model with Primitive::visibility of every triangle mesh, on both sides, by rays among its own surfaces as
/// loaded: in the pose at rest, in the variant that is shown first. A mesh that is drawn in several places has the mean
/// of them; one that deforms has no directions, since those of one pose are wrong in another. Needs
/// libtelar_reference.so.
/// @param rays   of each side of a vertex, VisibilityRays::LEAST..MOST
/// @param cache  gives the same numbers as the rays; a file that cannot be read or written is as none
/// @throws Error{X_LIBRARY_MISSING, X_REFERENCE, X_MEMORY, X_CANCELLED, L_VISIBILITY_RAYS, L_MEMORY_BYTES}
std::shared_ptr<const Scene> withAmbientVisibility(const std::shared_ptr<const Scene>& model, int rays,
                                                   const VisibilityCache& cache, const Limits& limits,
                                                   const CancelToken& cancel);

}  // namespace telar
