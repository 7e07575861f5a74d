#pragma once
#include <cstdint>

#include "telar/image.h"

namespace telar::ktx2 {

/// One format of blocks that GPUs read, and that three.js 0.187 hands to them as it is.
struct BlockLayout {
  std::uint32_t vkFormat;
  const char* name;
  BlockFormat format;
  unsigned side;   ///< texels of a block, in both directions
  unsigned bytes;  ///< of a block
  bool coloured;   ///< has an sRGB twin in GL; the others are linear in every use

  /// WebGL takes BC textures in whole blocks only. src: WEBGL_compressed_texture_s3tc, EXT_texture_compression_bptc,
  /// _rgtc
  bool wholeBlocks() const { return format <= BlockFormat::kBc7; }
};

/// null for a format that three.js's KTX2Loader does not know either, or of PowerVR and HDR.
/// src: examples/jsm/loaders/KTX2Loader.js of three.js 0.187, FORMAT_MAP
const BlockLayout* blockLayoutOf(std::uint32_t vkFormat);

}  // namespace telar::ktx2
