#pragma once
#include <cstdint>
#include <span>

#include "ktx2/byte_reader.h"
#include "telar/image.h"

namespace telar::ktx2 {

/// How an uncompressed texel stands in a file.
enum class Stored {
  kByte,   ///< 8 bits a component, 0..1
  kWord,   ///< 16 bits a component, 0..1
  kHalf,   ///< 16-bit floats
  kFloat,  ///< 32-bit floats
  kSmall,  ///< B10G11R11: three floats without sign in 32 bits, red lowest
  kShared  ///< E5B9G9R9: three mantissas with one exponent in 32 bits, red lowest
};

/// One uncompressed format that three.js 0.187 draws.
struct RawFormat {
  std::uint32_t vkFormat;
  const char* name;
  unsigned components;
  Stored stored;

  /// Bytes of a texel in the file.
  unsigned bytes() const;
  /// What a decoded texel is: the smallest type that holds every value exactly (16 bits of 0..1 need fp32).
  TexelType type() const;
  /// A file's levels that hold numbers of several bytes start at a multiple of them, or three.js cannot read them.
  unsigned alignment() const;
};

/// null for a format that three.js's KTX2Loader does not know either.
/// src: examples/jsm/loaders/KTX2Loader.js of three.js 0.187, FORMAT_MAP and TYPE_MAP
const RawFormat* rawFormatOf(std::uint32_t vkFormat);

/// Expands texels to RGBA: components that the format lacks are 0, alpha 1, as GL reads such a texture.
/// @param from texels as in the file
/// @param to as many texels of format.type()
/// @return false where a float is infinite or not a number: what a browser shows of those depends on its GPU
bool expandRaw(const RawFormat& format, Bytes from, std::span<std::uint8_t> to);

}  // namespace telar::ktx2
