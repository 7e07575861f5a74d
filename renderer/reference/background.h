#pragma once
#include <optional>

#include "core/random.h"
#include "reference/environment_light.h"
#include "telar/shot.h"

namespace telar::reference {

/// What a ray sees that meets no surface: nothing, a colour, or the environment, sharp or blurred.
class Background {
 public:
  /// @param environment  kept by pointer; null where the shot has none
  Background(const Shot& shot, const EnvironmentLight* environment);

  bool shown() const { return environment_ != nullptr; }
  /// Colour of the background, linear Rec.709. The picture is composed over it later; a ray through glass reads it
  /// here.
  const std::optional<glm::vec3>& color() const { return color_; }
  /// One sample of the environment in a direction, linear Rec.709. Only where shown().
  /// @param direction  world, unit
  glm::vec3 radiance(const glm::vec3& direction, Random& random) const;

 private:
  const EnvironmentLight* environment_ = nullptr;
  std::optional<glm::vec3> color_;
  float alpha_ = 0;  ///< of the GGX lobe that blurs
};

}  // namespace telar::reference
