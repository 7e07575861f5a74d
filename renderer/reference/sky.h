#pragma once
#include <optional>

#include "core/random.h"
#include "reference/environment_light.h"
#include "telar/shot.h"

namespace telar::reference {

/// What stands behind everything: nothing, a colour, or the environment, sharp or as a matt surface sees it.
class Sky {
 public:
  /// @param environment  kept by pointer; null where the shot has none
  Sky(const Shot& shot, const EnvironmentLight* environment);

  bool shown() const { return environment_ != nullptr; }
  /// The colour of the background, linear Rec.709: the picture is laid over it later, but glass shows it now.
  const std::optional<glm::vec3>& color() const { return color_; }
  /// One sample of what is seen in a direction, linear Rec.709; where shown() only.
  /// @param direction  world, unit
  glm::vec3 radiance(const glm::vec3& direction, Random& random) const;

 private:
  const EnvironmentLight* environment_ = nullptr;
  std::optional<glm::vec3> color_;
  float alpha_ = 0;  ///< of the GGX lobe that blurs
};

}  // namespace telar::reference
