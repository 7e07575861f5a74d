#pragma once
#include <cstdint>
#include <vector>

#include "pass/plan/draw_list.h"
#include "pass/visible/visibility_buffer.h"

namespace telar::pass {

/// The largest mip levels of a plan's images that no fragment of a picture reads: they need not be uploaded.
class UnreadLevels {
 public:
  /// @param buffer  has found what is seen of the plan's opaque draws
  /// @param gpu  has textures of earlier pictures
  UnreadLevels(const FramePlan& plan, const Scene& scene, const GpuScene& gpu, const VisibilityBuffer& buffer);

  /// How many, from level 0 on.
  int of(int image) const { return levels_[static_cast<std::size_t>(image)]; }
  /// The same of what is made of an image: of a normal map, and of a base colour with metalness. The image itself is
  /// read whole then.
  int ofMade(int image) const { return made_[static_cast<std::size_t>(image)]; }

 private:
  std::vector<std::uint8_t> levels_, made_;  ///< by image
};

}  // namespace telar::pass
