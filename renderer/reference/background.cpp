#include "reference/background.h"

#include "brdf/brdf.h"

namespace telar::reference {

Background::Background(const Shot& shot, const EnvironmentLight* environment) {
  if (shot.background.type == Shot::Background::Type::kColor) color_ = shot.background.color;
  if (shot.background.type != Shot::Background::Type::kEnvironment) return;
  environment_ = environment;
  const auto blur = static_cast<float>(shot.background.blur);  // a perceptual roughness
  alpha_ = blur * blur;
}

glm::vec3 Background::radiance(const glm::vec3& direction, Random& random) const {
  if (alpha_ <= 0) return environment_->radiance(direction);
  // The raster reads a prefiltered map: the mean over the GGX lobe at n = v = direction, weighted with NoL. Here a
  // sample is accepted with the probability NoL.
  const glm::mat3 frame = brdf_f::basisAbout(direction);
  constexpr int MAX_TRIES = 64;
  glm::vec3 l = direction;
  for (int i = 0; i < MAX_TRIES; ++i) {
    const glm::vec3 h = brdf_f::sampleVisibleNormal({0, 0, 1}, glm::vec2(alpha_), random.uniform2());
    const float NoL = 2 * h.z * h.z - 1;
    l = frame * (2 * h.z * h - glm::vec3(0, 0, 1));
    if (random.uniform() < NoL) break;
  }
  return environment_->radiance(l);
}

}  // namespace telar::reference
