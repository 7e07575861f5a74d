#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "telar/cancel.h"

namespace telar::surface {

/// Nodes in the order of a walk; closed = the last one is joined to the first.
struct Chain {
  std::vector<std::uint32_t> nodes;
  bool closed = false;
};

/// Joins links between nodes into as few walks as have each link once: those with ends first. Where more than two links
/// meet, a walk takes the first that is left.
/// @throws Error{X_CANCELLED, X_TIMEOUT}
std::vector<Chain> chainLinks(const std::vector<std::array<std::uint32_t, 2>>& links, const CancelToken& cancel);

}  // namespace telar::surface
