#pragma once
#include "asset/geometry/geometry.h"

namespace telar::asset {

/// Reads a skin.
/// @param nodes by node of the file: its index in the scene, -1 = not in it
/// @throws Error{E_SKIN, E_SPARSE, X_CANCELLED}
Skin readSkin(int skin, const std::vector<int>& nodes, const GeometryReader::Sources& from);

}  // namespace telar::asset
