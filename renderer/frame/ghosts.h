#pragma once
#include <map>
#include <memory>
#include <utility>

#include "telar/part_opacities.h"

namespace telar::frame {

/// What a shot draws translucent or leaves out: lining, pockets and the back neck show through the outer parts, and a
/// garment stands without the body that wears it. Such a part is a material blended over what lies behind it, its alpha
/// times the ghost's opacity. In the raster it casts no shadow; in the tracer as much of one as it is opaque.
class Ghosts {
 public:
  Ghosts() = default;  ///< of none
  /// @throws Error{E_FRAME} where the model draws no such part
  Ghosts(const Scene& scene, const Shot& shot) : opacities_(scene, shot.ghost) {}

  /// As PartOpacities::of().
  float opacity(const Node& node, int material) const { return opacities_.of(node, material); }
  /// A copy that may outlive this and the scene.
  std::shared_ptr<const Material> of(const Material& material, float opacity);

 private:
  PartOpacities opacities_;
  std::map<std::pair<const Material*, float>, std::shared_ptr<const Material>> made_;
};

}  // namespace telar::frame
