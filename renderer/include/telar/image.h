#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace telar {

/// 8-bit texture image as glTF gives it: RGBA, straight alpha, encoded as in the file (no colour conversion),
/// row 0 is the top row, rows are tightly packed: pixels.size() == width * height * 4.
struct Image8 {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint8_t> pixels;
};

/// Linear Rec.709 radiance, RGBA interleaved fp32, row 0 is the top row (+Y for an equirectangular map).
struct ImageF {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<float> pixels;  ///< width * height * 4
};

/// What a frame's pixels hold.
enum class PixelType {
  kRgba8,    ///< sRGB-encoded, straight alpha, after tone mapping
  kRgbaF32,  ///< linear Rec.709 scene radiance times exposure, before tone mapping, premultiplied alpha
};

/// One drawn picture; row 0 is the top row, tightly packed.
struct Frame {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  PixelType type = PixelType::kRgba8;
  std::vector<std::byte> pixels;
};

}  // namespace telar
