#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "telar/shot/layer.inc"
#include "telar/zeroed_bytes.h"

namespace telar {

/// How texels become linear light when a material reads them.
enum class TexelCoding {
  kByUse,   ///< sRGB where the material uses the texture as a colour, else linear
  kSrgb,    ///< sRGB in every use: a KTX2 file that says so
  kLinear,  ///< linear in every use: R8, RG8 and floats, which GL does not decode from sRGB
};

/// @param colorUse  the material uses the texture as a colour
constexpr bool decodesSrgb(TexelCoding coding, bool colorUse) {
  return coding == TexelCoding::kByUse ? colorUse : coding == TexelCoding::kSrgb;
}

/// What a component of a texel is.
enum class TexelType {
  kByte,   ///< 8 bits, 0..1
  kHalf,   ///< 16-bit float, native byte order
  kFloat,  ///< 32-bit float, native byte order
  kBlocks  ///< several texels together, as GPUs read them: BlockFormat
};

/// Bytes of an RGBA texel; of blocks what a texel takes where a driver unpacks them.
constexpr unsigned texelBytes(TexelType type) {
  return type == TexelType::kHalf ? 8 : type == TexelType::kFloat ? 16 : 4;
}

/// Blocks that a GPU reads as they are. Those up to kBc7 are what desktop GPUs have.
enum class BlockFormat {
  kBc1Rgb,
  kBc1Rgba,
  kBc3,
  kBc4,
  kBc4Signed,
  kBc5,
  kBc5Signed,
  kBc7,
  kEtc2Rgb,
  kEtc2Rgba,
  kEacR,
  kEacRSigned,
  kEacRg,
  kEacRgSigned,
  kAstc4x4,
  kAstc6x6
};

/// The mip levels that a file with its own levels does not have.
enum class MissingLevels {
  kNone,   ///< the smallest level of the file is the last
  kClear,  ///< are there all the same, and hold 0: what three.js makes of an uncompressed KTX2 file
  kBlack,  ///< the same with alpha 1: a format without alpha
};

/// Texture image as glTF gives it: RGBA, straight alpha, encoded as in the file (no colour conversion), row 0 is the
/// top row, rows are tightly packed: pixels.size() == width * height * texelBytes(type), or the bytes of its blocks.
/// All but some KTX2 files are 8-bit.
struct Image8 {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  ZeroedBytes pixels;
  /// The file decides on the mip levels (KTX2): these, level 1 first, max(1, side >> level) texels a side, perhaps
  /// none. Otherwise all levels are generated.
  bool ownLevels = false;
  std::vector<ZeroedBytes> smallerLevels;
  TexelCoding coding = TexelCoding::kByUse;
  std::string format;  ///< what the file is, for people: "PNG", "KTX2 UASTC zstd"
  TexelType type = TexelType::kByte;
  BlockFormat blocks = BlockFormat::kBc1Rgb;  ///< kBlocks: what `pixels` and `smallerLevels` hold
  MissingLevels missingLevels = MissingLevels::kNone;
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

/// An image beside the colour of a frame, as large as it: js/shot/table/layers.mjs says what it holds. 0 where nothing
/// is seen; row 0 is the top row.
struct LayerImage {
  shot::Layer layer;
  std::vector<float> pixels;  ///< width * height * channelCount(layer)
};

/// One drawn picture; row 0 is the top row, tightly packed.
struct Frame {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  PixelType type = PixelType::kRgba8;
  std::vector<std::byte> pixels;
  std::vector<LayerImage> layers;  ///< those that the shot asks for, in its order
};

}  // namespace telar
