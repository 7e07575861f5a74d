#pragma once
#include <array>

#include "brdf/shading.h"
#include "core/random.h"

namespace telar::reference {

/// Draws directions where a surface reflects: a mixture of a cosine lobe (diffuse and sheen), the same on the other
/// side (light that a thin cloth lets through), the GGX lobes of the base or of warp and weft, and of the coat's. Any
/// direction that the surface sends light from has a pdf above 0, in every shading: the shares of the lobes are guesses
/// that change the noise alone.
class LobeSampler {
 public:
  explicit LobeSampler(const brdf_f::SurfaceInfo& surface);
  struct Sample {
    glm::vec3 direction;
    float pdf;  ///< per steradian
  };
  Sample sample(Random& random) const;
  float pdf(const glm::vec3& l) const;

 private:
  glm::vec3 draw(float choice, const glm::vec2& u) const;
  /// Axes, width and share of one GGX lobe.
  struct Gloss {
    glm::mat3 frame{1.0f};
    glm::vec2 alpha{1.0f};
    glm::vec3 v{0, 0, 1};  ///< the viewer in `frame`
    float share = 0;
  };
  glm::mat3 cosineFrame_{1.0f};
  float cosineShare_ = 1, evenShare_ = 0, throughShare_ = 0;
  static Gloss yarnOf(const brdf_f::YarnLobe& yarn, const glm::vec3& v);
  bool isYarn(const Gloss& gloss) const;
  /// What leaning yarns send below the surface comes back mirrored at it.
  glm::vec3 mirrored(const glm::vec3& l) const;
  std::array<Gloss, 4> gloss_;  ///< base, coat, warp, weft
};

}  // namespace telar::reference
