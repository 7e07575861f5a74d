#pragma once
#include <string_view>
#include <vector>

#include "telar/scene.h"
#include "telar/shot.h"

namespace telar {

/// How opaque a shot's `ghost` draws the parts of a model: 1 = as the file has it, 0 = left out.
class PartOpacities {
 public:
  PartOpacities() = default;  ///< none is named
  /// @param scene  outlives it
  /// @throws Error{E_FRAME} where the model draws no such part
  PartOpacities(const Scene& scene, const std::vector<Shot::Ghost>& ghost);

  /// 0..1. Of several that mean a node, or a material, the last one counts; a node's is times its material's.
  /// @param material  of the file, whatever is worn over it: materialIndex(primitive, variant)
  float of(const Node& node, int material) const;

 private:
  const Scene* scene_ = nullptr;
  std::vector<float> nodes_, materials_;  ///< by index; below 0 = none
};

/// A name as a ghost gives it: * stands for any characters.
bool matchesName(std::string_view pattern, std::string_view name);

/// @param json  key `ghost` of a resolved shot
/// @throws Error{E_SHOT}
std::vector<Shot::Ghost> parseGhosts(std::string_view json);

}  // namespace telar
