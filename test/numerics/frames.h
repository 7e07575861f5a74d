#pragma once
#include <memory>
#include <span>

#include "renderer/scenes.h"
#include "telar/renderer.h"

/// Scenes and frames of the checks that draw.
namespace telar::numerics {

/// A renderer with the bundled studio at hand.
std::unique_ptr<Renderer> makeRenderer();

Frame drawn(Renderer& renderer, const std::shared_ptr<const Scene>& scene, const Shot& shot,
            std::span<const std::byte> environment = {});

/// What a frame has that no picture may have.
struct BadPixels {
  std::uint64_t notFinite = 0, negative = 0, covered = 0;
  std::size_t first = 0;  ///< index of the first pixel that is not finite; where all are, of the first that is negative
};
/// @param frame  of 32-bit floats
BadPixels badPixels(const Frame& frame);

/// Largest difference of two 8-bit frames in any channel; 256 where their sizes differ.
int largestDifference(const Frame& a, const Frame& b);

/// Radiance 1 everywhere, as a Radiance .hdr.
std::vector<std::byte> evenSky();

/// A Radiance .hdr, as bytes.
std::vector<std::byte> encodeHdr(int width, int height, const std::vector<glm::vec3>& texels);

/// The same of width x width / 2 texels; radiance(x, y) gives RGB.
template <class Radiance>
std::vector<std::byte> hdrOf(int width, Radiance radiance) {
  std::vector<glm::vec3> texels;
  for (int y = 0; y < width / 2; ++y)
    for (int x = 0; x < width; ++x) texels.push_back(radiance(x, y));
  return encodeHdr(width, width / 2, texels);
}

}  // namespace telar::numerics
