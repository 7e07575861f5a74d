#include "ktx2/zstd.h"

#include <zstd.h>

#include "core/lazy_library.h"

namespace telar::ktx2 {

void decompressZstd(Bytes frame, std::span<std::uint8_t> out) {
  const LazyLibrary library("libzstd.so.1", "libzstd1", "KTX2 textures that are compressed by zstd");
  const auto decompress = library.function<decltype(ZSTD_decompress)>("ZSTD_decompress");
  const auto isError = library.function<decltype(ZSTD_isError)>("ZSTD_isError");
  const std::size_t bytes = decompress(out.data(), out.size(), frame.data(), frame.size());
  if (isError(bytes) || bytes != out.size()) {
    throw corrupt("its zstd data is damaged or of another length than its size needs");
  }
}

}  // namespace telar::ktx2
