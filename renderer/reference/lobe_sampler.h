#pragma once
#include <array>

#include "brdf/shading.h"
#include "core/random.h"

namespace telar::reference {

/// Importance sampling of the BSDF. It is a mixture of a cosine lobe for diffuse and sheen, the same on the other side
/// for diffuse transmission, the GGX lobe of the base or those of warp and weft, and the GGX lobe of the clearcoat.
/// Wherever the BSDF is above 0 the pdf is too, in every shading. The shares of the lobes only change the noise.
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
  glm::vec3 sampleDirection(float choice, const glm::vec2& u) const;
  struct MicrofacetLobe {
    glm::mat3 frame{1.0f};
    glm::vec2 alpha{1.0f};
    glm::vec3 v{0, 0, 1};  ///< the viewer in `frame`
    float share = 0;
  };
  glm::mat3 cosineFrame_{1.0f};
  float cosineShare_ = 1, uniformShare_ = 0, transmissionShare_ = 0;
  static MicrofacetLobe yarnLobe(const brdf_f::YarnLobe& yarn, const glm::vec3& v);
  bool isYarn(const MicrofacetLobe& lobe) const;
  /// A yarn that leans reflects below the surface too. The shading mirrors that light back, and so does the sampler.
  glm::vec3 mirrored(const glm::vec3& l) const;
  std::array<MicrofacetLobe, 4> specular_;  ///< base, coat, warp, weft
};

}  // namespace telar::reference
