#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "image/bytes.h"

struct libdeflate_decompressor;

namespace telar::image {

/// A decoder of zlib streams, and what the last one gave.
class Inflater {
 public:
  Inflater();  ///< @throws std::bad_alloc

  /// Whether `packed` is a zlib stream of exactly `size` bytes, which bytes() then has. What claims more than a stream
  /// can grow to is refused before memory is taken for it.
  bool gives(Bytes packed, std::uint64_t size);
  Bytes bytes() const { return bytes_; }

 private:
  struct Free {
    void operator()(libdeflate_decompressor* decompressor) const;
  };
  std::unique_ptr<libdeflate_decompressor, Free> decompressor_;
  std::vector<std::byte> bytes_;
};

/// Whether `packed`, runs as OpenEXR writes them, gives exactly `expected` bytes.
bool runsGive(Bytes packed, std::uint64_t expected);

}  // namespace telar::image
