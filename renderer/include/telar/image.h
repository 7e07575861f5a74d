#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace telar {

/// How texels become linear light when a material reads them.
enum class TexelCoding {
  kByUse,   ///< sRGB where the material uses the texture as a colour, else linear
  kSrgb,    ///< sRGB in every use: a KTX2 file that says so
  kLinear,  ///< linear in every use: R8 and RG8, which GL does not decode from sRGB
};

/// @param colorUse  the material uses the texture as a colour
constexpr bool decodesSrgb(TexelCoding coding, bool colorUse) {
  return coding == TexelCoding::kByUse ? colorUse : coding == TexelCoding::kSrgb;
}

/// 8-bit texture image as glTF gives it: RGBA, straight alpha, encoded as in the file (no colour conversion),
/// row 0 is the top row, rows are tightly packed: pixels.size() == width * height * 4.
struct Image8 {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint8_t> pixels;
  /// The file decides on the mip levels (KTX2): these, level 1 first, max(1, side >> level) texels a side, perhaps
  /// none. Otherwise all levels are generated.
  bool ownLevels = false;
  std::vector<std::vector<std::uint8_t>> smallerLevels;
  TexelCoding coding = TexelCoding::kByUse;
  std::string format;  ///< what the file is, for people: "PNG", "KTX2 UASTC zstd"
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
