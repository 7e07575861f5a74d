#pragma once
#include "materials.h"
#include "telar/shot.h"

namespace telar::numerics {

/// A frame of many small bodies, each of its own random material, in random light. The frame's number is its seed; all
/// materials of a frame have the same layers, so that they share a program or a few.
struct FuzzFrame {
  static constexpr int SIDE = 24;    ///< bodies on a side
  static constexpr int PIXELS = 20;  ///< a body
  static constexpr int MATERIALS = SIDE * SIDE;

  std::shared_ptr<Scene> scene;
  Shot shot;  ///< draws radiance as it is, neither exposed nor capped
  std::vector<std::byte> environment;

  FuzzFrame(std::uint64_t seed, ShadingModel shading);

  /// The material under a pixel.
  const Material& materialAt(std::size_t pixel) const;
};

}  // namespace telar::numerics
