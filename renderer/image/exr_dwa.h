#pragma once
#include <cstdint>
#include <vector>

#include "image/bytes.h"
#include "image/exr_header.h"
#include "image/exr_unpack.h"

namespace telar::image {

/// Counts what chunks of DWAA and DWAB hold, as DwaCompressor::uncompress of OpenEXR 3.1 takes them apart: it believes
/// their own counts, and reads on in memory where there is less.
class DwaChunks {
 public:
  /// Whether the chunk has every texel of `channels`, ordered by name, in a picture of width x height.
  bool fills(Bytes packed, const std::vector<ExrChannel>& channels, std::uint64_t width, std::uint64_t height);

 private:
  Inflater inflater_;
  std::vector<std::uint16_t> symbols_;
};

}  // namespace telar::image
