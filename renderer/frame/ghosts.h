#pragma once
#include <map>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "telar/scene.h"
#include "telar/shot.h"

namespace telar::frame {

/// What a shot draws translucent or leaves out: lining, pockets and the back neck show through the outer parts, and a
/// garment stands without the body that wears it. Such a part is a material blended over what lies behind it, its alpha
/// times the ghost's opacity. In the raster it casts no shadow; in the tracer as much of one as it is opaque.
class Ghosts {
 public:
  Ghosts() = default;  ///< of none
  /// @throws Error{E_FRAME} where the model draws no such part
  Ghosts(const Scene& scene, const Shot& shot);

  /// 0..1. 1 = as the file has it, 0 = not drawn; of several that mean a node, or a material, the last one counts.
  /// @param material  index of materialIndex()
  float opacity(const Node& node, int material) const;
  /// A copy that may outlive this and the scene.
  std::shared_ptr<const Material> of(const Material& material, float opacity);

 private:
  const Scene* scene_ = nullptr;
  std::vector<float> nodes_, materials_;  ///< by index; below 0 = none
  std::map<std::pair<const Material*, float>, std::shared_ptr<const Material>> made_;
};

/// A name as a ghost gives it: * stands for any characters.
bool matchesName(std::string_view pattern, std::string_view name);

}  // namespace telar::frame
