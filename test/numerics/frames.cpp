#include "frames.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace telar::numerics {

std::unique_ptr<Renderer> makeRenderer() {
  setenv("TELAR_LIBRARY_DIR", TELAR_BUILT_LIBRARIES, 0);  // where the build put what reads .hdr and .exr
  RendererOptions options;
  options.assetDirectory = TELAR_SOURCE_DIR "/js/assets";
  return Renderer::create(options);
}

Frame drawn(Renderer& renderer, const std::shared_ptr<const Scene>& scene, const Shot& shot,
            std::span<const std::byte> environment) {
  FrameInfo info;
  return renderer.draw(scene, shot, environment, CancelToken(), info);
}

BadPixels badPixels(const Frame& frame) {
  BadPixels bad;
  const auto* p = reinterpret_cast<const float*>(frame.pixels.data());
  const std::size_t count = frame.pixels.size() / sizeof(float) / 4;
  for (std::size_t i = 0; i < count; ++i, p += 4) {
    const bool finite = std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]) && std::isfinite(p[3]);
    const bool negative = p[0] < 0 || p[1] < 0 || p[2] < 0 || p[3] < 0;
    if ((!finite && bad.notFinite == 0) || (negative && bad.notFinite + bad.negative == 0)) bad.first = i;
    bad.notFinite += !finite;
    bad.negative += finite && negative;
    bad.covered += p[3] > 0;
  }
  return bad;
}

int largestDifference(const Frame& a, const Frame& b) {
  if (a.pixels.size() != b.pixels.size()) return 256;
  int most = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    most = std::max(most, std::abs(static_cast<int>(a.pixels[i]) - static_cast<int>(b.pixels[i])));
  return most;
}

std::vector<std::byte> evenSky() {
  std::string file = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 32 +X 64\n";
  // By three.js's rule mantissa 255 with exponent 128 is exactly 1.
  for (int i = 0; i < 64 * 32; ++i) file += std::string("\xff\xff\xff\x80", 4);
  const auto* bytes = reinterpret_cast<const std::byte*>(file.data());
  return {bytes, bytes + file.size()};
}

std::vector<std::byte> encodeHdr(int width, int height, const std::vector<glm::vec3>& texels) {
  std::string file =
      "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " + std::to_string(width) + "\n";
  for (const glm::vec3& c : texels) {
    int exponent = 0;
    const float most = std::max({c.x, c.y, c.z});
    const float scale = most > 1e-32f ? std::frexp(most, &exponent) * 256 / most : 0.0f;
    for (int i = 0; i < 3; ++i) file += static_cast<char>(static_cast<unsigned char>(std::min(255.0f, c[i] * scale)));
    file += static_cast<char>(static_cast<unsigned char>(most > 1e-32f ? exponent + 128 : 0));
  }
  const auto* bytes = reinterpret_cast<const std::byte*>(file.data());
  return {bytes, bytes + file.size()};
}

}  // namespace telar::numerics
