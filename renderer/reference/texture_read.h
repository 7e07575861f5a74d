#pragma once
#include <array>
#include <glm/glm.hpp>

#include "telar/scene.h"

namespace telar::reference {

/// The textures of a scene at full resolution: many samples a pixel replace mip levels.
class Textures {
 public:
  /// @param scene  kept by reference
  explicit Textures(const Scene& scene);

  /// One use of a texture at a point.
  /// @param uv       as in the file: the reference's own transform is applied here
  /// @param srgb     decode to linear light before filtering
  /// @param byAlpha  colours count as much as they cover: what a hole would show has none between texels either
  /// @return white where the reference has no texture
  glm::vec4 read(const TextureRef& texture, const glm::vec2& uv, bool srgb, bool byAlpha = false) const;
  /// Asks the memory for the texel at a point that read() is about to read.
  void prefetch(const TextureRef& texture, const glm::vec2& uv) const;

 private:
  const Scene& scene_;
  std::array<float, 256> bytes_, linear_;  ///< value of a byte: linear, and decoded from sRGB
};

}  // namespace telar::reference
