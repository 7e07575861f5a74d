#include "image/exr_unpack.h"

#include <libdeflate.h>

#include <memory>
#include <new>

namespace telar::image {
namespace {

struct FreeDecompressor {
  void operator()(libdeflate_decompressor* decompressor) const { libdeflate_free_decompressor(decompressor); }
};

}  // namespace

bool inflatesTo(Bytes packed, std::span<std::byte> out) {
  static thread_local const std::unique_ptr<libdeflate_decompressor, FreeDecompressor> decompressor(
      libdeflate_alloc_decompressor());
  if (!decompressor) throw std::bad_alloc();
  // Without a place for the length, fewer bytes are an error.
  return libdeflate_zlib_decompress(decompressor.get(), packed.data(), packed.size(), out.data(), out.size(),
                                    nullptr) == LIBDEFLATE_SUCCESS;
}

bool runsGive(Bytes packed, std::uint64_t expected) {
  const std::uint8_t* bytes = data(packed);
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < packed.size();) {
    // Below 0, so many bytes as they are; else one byte, once more than the code says.
    const int code = static_cast<std::int8_t>(bytes[i]);
    count += static_cast<std::uint64_t>(code < 0 ? -code : code + 1);
    i += static_cast<std::size_t>(code < 0 ? 1 - code : 2);
    if (i > packed.size() || count > expected) return false;
  }
  return count == expected;
}

}  // namespace telar::image
