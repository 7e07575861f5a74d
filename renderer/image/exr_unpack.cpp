#include "image/exr_unpack.h"

#include <libdeflate.h>

#include <new>

namespace telar::image {
namespace {

/// A stream of deflate grows by less than this.
constexpr std::uint64_t INFLATE_MOST = 1032;

}  // namespace

void Inflater::Free::operator()(libdeflate_decompressor* decompressor) const {
  libdeflate_free_decompressor(decompressor);
}

Inflater::Inflater() : decompressor_(libdeflate_alloc_decompressor()) {
  if (!decompressor_) throw std::bad_alloc();
}

bool Inflater::gives(Bytes packed, std::uint64_t size) {
  if (size > packed.size() * INFLATE_MOST) return false;
  bytes_.resize(static_cast<std::size_t>(size));
  // Without a place for the length, fewer bytes are an error.
  return libdeflate_zlib_decompress(decompressor_.get(), packed.data(), packed.size(), bytes_.data(), bytes_.size(),
                                    nullptr) == LIBDEFLATE_SUCCESS;
}

bool runsGive(Bytes packed, std::uint64_t expected) {
  const std::uint8_t* bytes = data(packed);
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < packed.size();) {
    // A code below 0, of 8 bits: so many bytes as they are; else one byte, once more than the code says.
    const std::size_t code = bytes[i], plain = code < 128 ? 0 : 256 - code;
    count += plain ? plain : code + 1;
    i += plain ? 1 + plain : 2;
    if (i > packed.size() || count > expected) return false;
  }
  return count == expected;
}

}  // namespace telar::image
